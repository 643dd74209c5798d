/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* sched_setaffinity */
#endif
#include "gl/threads.h"

#include <dirent.h>
#include <sched.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Mesa names them llvmpipe-0 and so on. */
static bool is_rasterizer(const char *id)
{
    static const char prefix[] = "llvmpipe-";
    char path[64], name[32] = "";
    snprintf(path, sizeof path, "/proc/self/task/%.20s/comm", id);
    FILE *file = fopen(path, "re");
    if (!file)
        return false;
    const bool known = fgets(name, sizeof name, file) != NULL;
    fclose(file);
    return known && strncmp(name, prefix, sizeof prefix - 1) == 0;
}

void csg_gl_threads_list(struct csg_gl_threads *threads)
{
    DIR *tasks = opendir("/proc/self/task");
    threads->num = 0;
    if (!tasks)
        return;
    for (const struct dirent *task; (task = readdir(tasks)) && threads->num < CSG_GL_MAX_THREADS;)
        if (is_rasterizer(task->d_name))
            threads->ids[threads->num++] = (pid_t)atol(task->d_name);
    closedir(tasks);
}

static bool contains(const struct csg_gl_threads *threads, pid_t id)
{
    for (size_t i = 0; i < threads->num; i++)
        if (threads->ids[i] == id)
            return true;
    return false;
}

/* All but others. */
static void list_own(const struct csg_gl_threads *others, struct csg_gl_threads *own)
{
    struct csg_gl_threads all;
    csg_gl_threads_list(&all);
    own->num = 0;
    for (size_t i = 0; i < all.num; i++)
        if (!contains(others, all.ids[i]))
            own->ids[own->num++] = all.ids[i];
}

void csg_gl_threads_spread(const struct csg_gl_threads *others)
{
    cpu_set_t allowed;
    struct csg_gl_threads own;
    list_own(others, &own);
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0 || own.num < 2 ||
        (size_t)CPU_COUNT(&allowed) != own.num)
        return;
    size_t num = 0;
    for (size_t cpu = 0; cpu < CPU_SETSIZE && num < own.num; cpu++) {
        cpu_set_t one;
        if (!CPU_ISSET(cpu, &allowed))
            continue;
        CPU_ZERO(&one);
        CPU_SET(cpu, &one);
        sched_setaffinity(own.ids[num++], sizeof one, &one);
    }
}
