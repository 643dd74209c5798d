/* SPDX-License-Identifier: MIT */

/* The programs that a frame's draws have in common: each is made when the first of them asks. */

#include "render/chooser_parts.h"

static int frame_features(const struct csg_chooser *chooser)
{
    return (chooser->direct ? CSG_FEATURE_DIRECT : 0) |
           (chooser->request->same_inputs ? CSG_FEATURE_SHARED : 0);
}

static GLuint compile(struct csg_chooser *chooser, enum csg_resolver resolver,
                      const struct csg_structure *structure, int features)
{
    struct csg_programs *programs = &chooser->renderer->programs;
    features |= chooser->request->textbook ? CSG_FEATURE_TEXTBOOK : 0;
    features |= frame_features(chooser);
    const struct csg_stages stages =
        csg_source_geometry(resolver, features, structure, chooser->max_handed);
    if (!structure)
        return csg_programs_get(programs, stages);
    const GLuint program = chooser->request->after_edit ? csg_programs_known(programs, stages)
                                                        : csg_programs_get(programs, stages);
    csg_programs_note_straight(programs, program);
    return program;
}

/* What a program is noted under that needs no structure: a chain is a resolver of its own. */
static uint32_t name_of(const struct csg_chooser *chooser, enum csg_resolver resolver, int chain,
                        int features)
{
    const int all = features | frame_features(chooser) |
                    (chooser->request->textbook ? CSG_FEATURE_TEXTBOOK : 0);
    return (uint32_t)all << 16 | (uint32_t)(chain + 1) << 8 | ((uint32_t)resolver + 1);
}

/* What a program may be able to do that its draws do not ask for. Records of bands depend on
 * whether there are stiff ones. */
static uint32_t more_than(int features)
{
    const int more = CSG_FEATURE_QUADRIC | CSG_FEATURE_GAP | CSG_FEATURE_SURFACE |
                     CSG_FEATURE_NESTED | CSG_FEATURE_BANDS |
                     (features & CSG_FEATURE_BANDS ? 0 : CSG_FEATURE_STIFF);
    return (uint32_t)more << 16;
}

static GLuint find_shared(const struct csg_chooser *chooser, enum csg_resolver resolver,
                          int features)
{
    const struct csg_programs *programs = &chooser->renderer->programs;
    const uint32_t name = name_of(chooser, resolver, -1, features);
    return chooser->request->settled ? csg_programs_noted_above(programs, name, more_than(features))
                                     : csg_programs_noted(programs, name);
}

bool csg_chooser_knows(const struct csg_chooser *chooser, enum csg_resolver resolver, int features)
{
    return find_shared(chooser, resolver, features) != 0;
}

/* The program of a resolver that needs no structure. */
static GLuint compile_shared(struct csg_chooser *chooser, enum csg_resolver resolver, int features)
{
    struct csg_programs *programs = &chooser->renderer->programs;
    const GLuint known = find_shared(chooser, resolver, features);
    if (known)
        return known;
    const GLuint program = compile(chooser, resolver, NULL, features);
    csg_programs_note(programs, program, name_of(chooser, resolver, -1, features));
    return program;
}

GLuint csg_chooser_straight(struct csg_chooser *chooser, const struct csg_structure *structure,
                            bool stiff, int features)
{
    struct csg_known_structures *missing = &chooser->missing;
    const struct csg_known_structure *known =
        csg_structures_find(&chooser->straight, structure, stiff);
    if (known)
        return known->program;
    if (missing->num == CSG_MAX_STRAIGHT_PROGRAMS || csg_structures_find(missing, structure, stiff))
        return 0;
    const GLuint program = compile(chooser, CSG_RESOLVER_STRAIGHT, structure, features);
    csg_structures_add(program ? &chooser->straight : missing, structure, stiff, program);
    return program;
}

/* Whether a structure can have a program of its own: there is one, or room for one. */
bool csg_chooser_has_room(const struct csg_chooser *chooser, const struct csg_structure *structure,
                          bool stiff)
{
    return chooser->straight.num < CSG_MAX_STRAIGHT_PROGRAMS ||
           csg_structures_find(&chooser->straight, structure, stiff);
}

/* A program that any structure with these features can use. */
GLuint csg_chooser_shared(struct csg_chooser *chooser, enum csg_resolver resolver, int features,
                          enum csg_resolver *chosen)
{
    GLuint *shared = resolver == CSG_RESOLVER_REAR         ? chooser->rears
                     : resolver == CSG_RESOLVER_CELLS      ? chooser->cells
                     : resolver == CSG_RESOLVER_SURFACE    ? chooser->surfaces
                     : resolver == CSG_RESOLVER_ALGORITHM4 ? chooser->sorted
                                                           : chooser->loops;
    *chosen = resolver;
    if (!shared[features])
        shared[features] = compile_shared(chooser, resolver, features);
    return shared[features];
}

GLuint csg_chooser_cpu(struct csg_chooser *chooser, enum csg_resolver *resolver)
{
    *resolver = CSG_RESOLVER_CPU;
    if (!chooser->cpu)
        chooser->cpu = compile_shared(chooser, CSG_RESOLVER_CPU, 0);
    return chooser->cpu;
}

static GLuint compile_chain(struct csg_chooser *chooser, int chain)
{
    struct csg_programs *programs = &chooser->renderer->programs;
    const GLuint program =
        csg_programs_get(programs, csg_source_geometry_chain(chain, frame_features(chooser)));
    csg_programs_note(programs, program, name_of(chooser, CSG_RESOLVER_CHAIN, chain, 0));
    return program;
}

GLuint csg_chooser_known_chain(const struct csg_chooser *chooser, int chain)
{
    return csg_programs_noted(&chooser->renderer->programs,
                              name_of(chooser, CSG_RESOLVER_CHAIN, chain, 0));
}

GLuint csg_chooser_chain(struct csg_chooser *chooser, int chain)
{
    if (!chooser->chains[chain])
        chooser->chains[chain] = compile_chain(chooser, chain);
    return chooser->chains[chain];
}
