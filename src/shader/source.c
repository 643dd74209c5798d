/* SPDX-License-Identifier: MIT */
#include "shader/source.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shader/files.h"

const char *const csg_resolver_names[CSG_NUM_RESOLVERS] = {"straight", "chain",      "loop",
                                                           "cells",    "algorithm4", "double"};

const char *csgcast_variant_name(size_t index)
{
    if (index == 0)
        return "auto";
    if (index == CSG_NUM_RESOLVERS + 1)
        return CSG_SHARED_NAME;
    if (index == CSG_NUM_RESOLVERS + 2)
        return CSG_TEXTBOOK_NAME;
    return index <= CSG_NUM_RESOLVERS ? csg_resolver_names[index - 1] : NULL;
}

void csg_text_add(struct csg_text *text, const char *format, ...)
{
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    const int length = vsnprintf(NULL, 0, format, args);
    text->failed |= length < 0 || !csg_array_reserve(text, (size_t)length + 1);
    if (!text->failed) {
        vsnprintf(text->data + text->num, (size_t)length + 1, format, again);
        text->num += (size_t)length;
    }
    va_end(again);
    va_end(args);
}

/* So many holes are passed without a loop, whose end costs llvmpipe as much as some of them. */
#define MAX_STRAIGHT_HOLES 4

/* The largest of what the holes ask for, all of them at k: so none waits for another one. */
static void add_holes(struct csg_text *text, const char *format, const size_t *holes, size_t num)
{
    for (size_t i = 0; i < num; i++) {
        csg_text_add(text, "max(csg_outside(k, ");
        csg_text_add(text, format, holes[i]);
        csg_text_add(text, "), ");
    }
    csg_text_add(text, "-CSG_KEY_MAX");
    for (size_t i = 0; i < num; i++)
        csg_text_add(text, ")");
}

/* A ray leaves each hole once and for all, so it has left all of them when it has been asked as
 * often as there are holes. */
void csg_text_add_passing(struct csg_text *text, const char *format, const size_t *holes,
                          size_t num)
{
    const bool loops = num > MAX_STRAIGHT_HOLES;
    csg_text_add(text, "    k = whole.x;\n");
    if (loops)
        csg_text_add(text, "    float last;\n    do {\n    last = k;\n");
    for (size_t i = 0; i < (loops ? 1 : num); i++) {
        csg_text_add(text, "    k = ");
        add_holes(text, format, holes, num);
        csg_text_add(text, ";\n");
    }
    if (loops)
        csg_text_add(text, "    } while (last < k && k < whole.y);\n");
    csg_text_add(text, "    if (!(k < min(whole.y, csg_screen_key.z)))\n        return false;\n");
}

void csg_text_end_search(struct csg_text *text)
{
    csg_text_add(text, "        bool further = r0 > k && r0 < csg_screen_key.z;\n"
                       "        k = r0;\n        if (!further)\n            break;\n    }\n"
                       "    if (k >= csg_screen_key.z)\n        return false;\n");
}

/* As csg_text_add of a string, which would look for its end thrice. */
static void add_string(struct csg_text *text, const char *string)
{
    const size_t length = strlen(string);
    text->failed |= !csg_array_reserve(text, length + 1);
    if (text->failed)
        return;
    memcpy(text->data + text->num, string, length + 1);
    text->num += length;
}

static void add_file(struct csg_text *text, const char *name)
{
    for (size_t i = 0; i < csg_num_shader_files; i++)
        if (strcmp(csg_shader_files[i].name, name) == 0) {
            add_string(text, "#line 1\n");
            add_string(text, csg_shader_files[i].text);
        }
}

static char *finish_text(struct csg_text *text)
{
    if (!text->failed)
        return text->data;
    free(text->data);
    return NULL;
}

int csg_structure_features(const struct csg_structure *structure)
{
    int features = 0;
    for (size_t i = 0; i < structure->num; i++) {
        features |= structure->steps[i].flags & CSG_RECORD_QUADRIC ? CSG_FEATURE_QUADRIC : 0;
        features |= structure->steps[i].flags & CSG_RECORD_GAP ? CSG_FEATURE_GAP : 0;
        features |= structure->steps[i].flags & CSG_RECORD_SURFACE ? CSG_FEATURE_SURFACE : 0;
    }
    return features;
}

size_t csg_structure_crossings(const struct csg_structure *structure)
{
    size_t crossings = 0;
    for (size_t i = 0; i < structure->num; i++)
        if (!(structure->steps[i].flags & CSG_RECORD_POP))
            crossings += structure->steps[i].flags & CSG_RECORD_GAP ? 4 : 2;
    return crossings;
}

static void add_preamble(struct csg_text *text, int features)
{
    csg_text_add(text, "#version 330 core\n#extension GL_ARB_gpu_shader5 : enable\n");
    if (features & CSG_FEATURE_DOUBLE)
        csg_text_add(text, "#extension GL_ARB_gpu_shader_fp64 : require\n#define CSG_DOUBLE\n");
    csg_text_add(text, "precision highp float;\n");
    add_file(text, "common/layout.glsl");
}

/* Where programs of far sides are asked for without these, they are for one convex solid. */
#define NOT_CONVEX (CSG_FEATURE_GAP | CSG_FEATURE_SURFACE | CSG_FEATURE_BANDS)

static void add_rear(struct csg_text *text, int features)
{
    if (features & NOT_CONVEX)
        csg_text_add(text, "#define CSG_REAR\n");
    add_file(text, features & NOT_CONVEX ? "csg/resolve.glsl" : "csg/far.glsl");
}

static void add_resolver(struct csg_text *text, enum csg_resolver resolver, int features)
{
    if (resolver == CSG_RESOLVER_STRAIGHT)
        return;
    csg_text_add(text, "#define CSG_CAN_GIVE_UP\n");
    if (resolver == CSG_RESOLVER_SURFACE) {
        add_file(text, "csg/surface.glsl");
        return;
    }
    if (resolver == CSG_RESOLVER_CELLS) {
        add_file(text, "csg/cell_face.glsl");
        add_file(text, features & CSG_FEATURE_BUNCHES ? "csg/bunch.glsl" : "csg/cell.glsl");
        add_file(text, "csg/walk.glsl");
        return;
    }
    add_file(text, "csg/program.glsl");
    if (resolver == CSG_RESOLVER_CPU) {
        add_file(text, "csg/cpu.glsl");
    } else if (resolver == CSG_RESOLVER_ALGORITHM4) {
        csg_text_add(text, "#define CSG_MAX_CROSSINGS %d\n", CSG_ALGORITHM4_MAX_CROSSINGS);
        add_file(text, "csg/algorithm4.glsl");
    } else if (resolver == CSG_RESOLVER_REAR) {
        add_rear(text, features);
    } else {
        add_file(text, "csg/resolve.glsl");
    }
}

static struct csg_stages finish_stages(struct csg_text *vertex, struct csg_text *fragment)
{
    struct csg_stages stages = {finish_text(vertex), finish_text(fragment)};
    return stages;
}

static void define(struct csg_text *vertex, struct csg_text *fragment, const char *name)
{
    csg_text_add(vertex, "#define %s\n", name);
    csg_text_add(fragment, "#define %s\n", name);
}

static void define_features(struct csg_text *fragment, int features)
{
    static const struct {
        int feature;
        const char *name;
    } names[] = {{CSG_FEATURE_QUADRIC, "QUADRIC"}, {CSG_FEATURE_GAP, "GAP"},
                 {CSG_FEATURE_SURFACE, "SURFACE"}, {CSG_FEATURE_BANDS, "BANDS"},
                 {CSG_FEATURE_NESTED, "NESTED"},   {CSG_FEATURE_STIFF, "STIFF"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (features & names[i].feature)
            csg_text_add(fragment, "#define CSG_HAS_%s\n", names[i].name);
}

/* What all geometry programs begin with. */
static void start_geometry(struct csg_text *vertex, struct csg_text *fragment,
                           enum csg_resolver resolver, int features)
{
    const bool textbook = features & CSG_FEATURE_TEXTBOOK;
    add_preamble(vertex, 0);
    add_preamble(fragment, features);
    if (textbook)
        define(vertex, fragment, "CSG_TEXTBOOK");
    if (resolver == CSG_RESOLVER_CHAIN)
        define(vertex, fragment, "CSG_IS_CHAIN");
    add_file(vertex, "common/data.glsl");
    add_file(vertex, "common/screen.vert.glsl");
    add_file(vertex, "solids/sense.glsl");
    add_file(vertex, "csg/normals.glsl");
    define_features(fragment, features);
    add_file(fragment, "common/data.glsl");
    add_file(fragment, "common/real.glsl");
    add_file(fragment, "common/screen.glsl");
    add_file(fragment, "solids/span.glsl");
    add_file(fragment, "solids/sense.glsl");
    if (textbook)
        add_file(fragment, "solids/textbook.glsl");
    else
        add_file(fragment, "solids/planes.glsl");
    if (features & CSG_FEATURE_QUADRIC && !textbook)
        add_file(fragment, "solids/quadric.glsl");
    add_file(fragment, "csg/spans.glsl");
    if (resolver != CSG_RESOLVER_STRAIGHT && resolver != CSG_RESOLVER_CHAIN)
        add_file(fragment, "csg/turns.glsl");
    if (features & CSG_FEATURE_SURFACE)
        add_file(fragment, "solids/surface.glsl");
    if (features & CSG_FEATURE_BANDS)
        add_file(fragment, "solids/bands.glsl");
    add_file(fragment, "csg/change.glsl");
    if (resolver == CSG_RESOLVER_STRAIGHT || resolver == CSG_RESOLVER_CHAIN)
        add_file(fragment, "csg/normals.glsl");
}

/* What becomes of a visible face. curved: it may be one of a quadric's. */
static void add_visible(struct csg_text *fragment, bool direct, bool curved)
{
    if (direct) {
        csg_text_add(fragment, "#define CSG_DIRECT\n%s", curved ? "" : "#define CSG_ONLY_PLANES\n");
        add_file(fragment, "common/light.glsl");
    }
    add_file(fragment, "passes/visible.glsl");
}

static void add_inputs(struct csg_text *vertex, struct csg_text *fragment, int features)
{
    if (!(features & CSG_FEATURE_SHARED))
        return;
    define(vertex, fragment, "CSG_SHARED");
    add_file(fragment, "common/inputs.glsl");
}

static struct csg_stages finish_geometry(struct csg_text *vertex, struct csg_text *fragment,
                                         int features)
{
    add_visible(fragment, features & CSG_FEATURE_DIRECT,
                features & (CSG_FEATURE_QUADRIC | CSG_FEATURE_BANDS));
    add_inputs(vertex, fragment, features);
    add_file(vertex, "passes/geometry.vert.glsl");
    add_file(fragment, "passes/geometry.frag.glsl");
    return finish_stages(vertex, fragment);
}

struct csg_stages csg_source_geometry(enum csg_resolver resolver, int features,
                                      const struct csg_structure *structure, size_t max_handed)
{
    struct csg_text vertex = {0}, fragment = {0};
    start_geometry(&vertex, &fragment, resolver, features);
    add_resolver(&fragment, resolver, features);
    if (resolver == CSG_RESOLVER_CELLS)
        add_file(&vertex, "csg/walk.vert.glsl");
    if (resolver == CSG_RESOLVER_STRAIGHT)
        csg_source_straight(&vertex, &fragment, structure, features, max_handed);
    if (resolver == CSG_RESOLVER_CELLS || resolver == CSG_RESOLVER_STRAIGHT)
        features &= ~CSG_FEATURE_SHARED;
    return finish_geometry(&vertex, &fragment, features);
}

struct csg_stages csg_source_geometry_chain(int i, int features)
{
    const struct csg_chain chain = csg_chain_of(i, features & CSG_FEATURE_DIRECT);
    struct csg_text vertex = {0}, fragment = {0};
    features |= chain.quadrics ? CSG_FEATURE_QUADRIC : 0;
    start_geometry(&vertex, &fragment, CSG_RESOLVER_CHAIN, features);
    if (chain.clauses)
        define(&vertex, &fragment, "CSG_HAS_CLAUSES");
    csg_text_add(&vertex, "#define CSG_SLOT_PLANES %d\n", chain.planes);
    csg_text_add(&fragment, "#define CSG_SLOT_PLANES %d\n", chain.planes);
    add_file(&vertex, "csg/slots.glsl");
    if (chain.slots > chain.handed)
        add_file(&fragment, "csg/slots.glsl");
    add_file(&fragment, "csg/chain.glsl");
    if (chain.clauses)
        add_file(&fragment, "csg/clauses.glsl");
    csg_source_chain(&vertex, &fragment, &chain);
    return finish_geometry(&vertex, &fragment, features & ~CSG_FEATURE_SHARED);
}

struct csg_stages csg_source_single(const struct csg_crowd_run *run, bool direct)
{
    struct csg_text vertex = {0}, fragment = {0}, *texts[2] = {&vertex, &fragment};
    for (int i = 0; i < 2; i++) {
        add_preamble(texts[i], 0);
        csg_text_add(texts[i], "#define CSG_NUM_PLANES %u\n#define CSG_NUM_TEXELS %u\n",
                     run->num_planes, run->num_planes + (run->has_quadric ? 3 : 0));
    }
    if (run->has_quadric)
        csg_text_add(&fragment, "#define CSG_HAS_QUADRIC\n");
    if (run->ball)
        csg_text_add(&fragment, "#define CSG_IS_BALL\n");
    if (run->owned)
        csg_text_add(&fragment, "#define CSG_OWNED\n#define CSG_MEMBER_BLOCK %d\n",
                     CSG_BLOCK_TEXELS((int)run->has_quadric, (int)run->num_planes));
    add_file(&vertex, "common/screen.vert.glsl");
    add_file(&vertex, run->owned ? "passes/owned.vert.glsl" : "passes/single.vert.glsl");
    add_file(&fragment, "common/data.glsl");
    add_file(&fragment, "common/real.glsl");
    add_file(&fragment, "common/screen.glsl");
    add_file(&fragment, "solids/span.glsl");
    add_file(&fragment, "solids/planes.glsl");
    if (run->has_quadric)
        add_file(&fragment, "solids/quadric.glsl");
    add_visible(&fragment, direct, run->has_quadric);
    add_file(&fragment, "passes/single.frag.glsl");
    return finish_stages(&vertex, &fragment);
}

struct csg_stages csg_source_shade(bool want_leaf, bool want_bytes, int features)
{
    const bool textbook = features & CSG_FEATURE_TEXTBOOK;
    struct csg_text vertex = {0}, fragment = {0};
    add_preamble(&vertex, 0);
    add_file(&vertex, "common/screen.vert.glsl");
    add_preamble(&fragment, 0);
    if (want_leaf)
        csg_text_add(&fragment, "#define CSG_WANT_LEAF\n");
    if (want_bytes)
        csg_text_add(&fragment, "#define CSG_WANT_BYTES\n");
    if (textbook)
        csg_text_add(&fragment, "#define CSG_TEXTBOOK\n");
    add_file(&fragment, "common/data.glsl");
    add_file(&fragment, "common/real.glsl");
    add_file(&fragment, "common/screen.glsl");
    if (textbook) {
        add_file(&fragment, "solids/span.glsl");
        add_file(&fragment, "solids/textbook.glsl");
    }
    add_file(&fragment, "common/light.glsl");
    add_inputs(&vertex, &fragment, features);
    add_file(&vertex, "passes/shade.vert.glsl");
    add_file(&fragment, "passes/shade.frag.glsl");
    return finish_stages(&vertex, &fragment);
}
