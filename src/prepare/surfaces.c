/* SPDX-License-Identifier: MIT */
#include "prepare/surfaces.h"

#include <stdlib.h>

#include "carrier/own_faces.h"
#include "common/parallel.h"

/* A surface, its box, and whether all went well. */
struct job {
    struct csg_surface *surface;
    struct csg_box box;
    int num_threads;
    bool ok;
};

static void measure(void *user, size_t task)
{
    struct job *job = (struct job *)user + task;
    job->box = csg_surface_box(job->surface);
    free(job->surface->extents); /* of an attempt that failed */
    job->surface->extents = csg_surface_extents(job->surface, &csg_map_identity);
}

static void build(void *user, size_t task)
{
    struct job *job = (struct job *)user + task;
    job->ok = job->surface->extents && csg_surface_build(job->surface) &&
              csg_own_faces_find(job->surface, &job->box, job->num_threads);
}

static int compare(const void *a, const void *b)
{
    const struct job *x = a, *y = b;
    return (x->surface > y->surface) - (x->surface < y->surface);
}

/* Each surface that is not ready, once; returns how many. */
static size_t collect(const struct csgcast_scene *scene, struct job *jobs)
{
    size_t num = 0, kept = 0;
    for (size_t i = 0; i < scene->num_leaves; i++) {
        struct csg_surface *surface = scene->leaves[i].shape.surface;
        if (surface && !surface->own)
            jobs[num++] = (struct job){.surface = surface, .num_threads = scene->num_threads};
    }
    if (num > 1)
        qsort(jobs, num, sizeof *jobs, compare);
    for (size_t i = 0; i < num; i++)
        if (i == 0 || jobs[i].surface != jobs[i - 1].surface)
            jobs[kept++] = jobs[i];
    return kept;
}

static size_t count_surfaces(const struct csgcast_scene *scene)
{
    size_t num = 0;
    for (size_t i = 0; i < scene->num_leaves; i++)
        num += scene->leaves[i].shape.surface != NULL;
    return num;
}

bool csg_surfaces_build(struct csgcast_scene *scene)
{
    const size_t room = count_surfaces(scene);
    scene->has_surfaces = room > 0;
    struct job *jobs = room ? malloc(room * sizeof *jobs) : NULL;
    if (!jobs)
        return room == 0;
    const size_t num = collect(scene, jobs);
    bool ok = true;
    if (num > 0) {
        csg_parallel(scene->num_threads, num, measure, jobs);
        csg_parallel(scene->num_threads, num, build, jobs);
    }
    for (size_t i = 0; i < num; i++)
        ok = ok && jobs[i].ok;
    free(jobs);
    return ok;
}
