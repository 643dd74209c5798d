/* SPDX-License-Identifier: MIT */

/*
 * Straight-line GLSL for one small tree: the steps of the machine in shaders/csg/program.glsl with
 * the loop, the stack and the headers compiled away. Parameters stay in the data texture.
 */

#include "shader/source.h"

#include <stdio.h>
#include <stdlib.h>

/* As CSG_NORMALS_MAX_PLANES of shaders/csg/normals.glsl. */
#define MAX_NORMALS 6

struct leaf_code {
    size_t record; /* offset of the record from the object's first */
    unsigned rank; /* among the object's leaves, in file order */
    size_t num_planes;
    bool paired; /* of opposite planes no ray enters by both */
    bool gap;
    bool normals; /* the places of its normals are handed over, as n0, n1, ... by step */
};

/* Number of the object's leaves that come earlier in the file. */
static unsigned rank_of(const struct csg_structure *structure, size_t step)
{
    unsigned rank = 0;
    for (size_t i = 0; i < structure->num; i++)
        rank += !csg_structure_is_pop(structure, i) &&
                structure->steps[i].leaf < structure->steps[step].leaf;
    return rank;
}

/* How fragments get at texels: the first ones of each object are handed over. */
struct parameters {
    struct csg_text *vertex, *fragment;
    size_t num_handed, max_handed;
};

static size_t count_texels(const struct csg_structure *structure, const struct leaf_code *leaves)
{
    size_t num = 0;
    for (size_t i = 0; i < structure->num; i++)
        num += leaves[i].num_planes + (structure->steps[i].flags & CSG_RECORD_QUADRIC ? 3 : 0);
    return num;
}

/* Whether there is room for the places of the normals. Two leaves take an input together. */
static bool can_hand_normals(const struct csg_structure *structure, const struct leaf_code *leaves,
                             size_t max_handed)
{
    for (size_t i = 0; i < structure->num; i++)
        if (leaves[i].num_planes > MAX_NORMALS)
            return false;
    return count_texels(structure, leaves) + (structure->num + 1) / 2 <= max_handed;
}

static void add_normals(struct parameters *parameters, const struct csg_structure *structure,
                        struct leaf_code *leaves)
{
    bool second = false;
    for (size_t i = 0; i < structure->num; i++) {
        if (csg_structure_is_pop(structure, i))
            continue;
        const size_t input = second ? parameters->num_handed - 1 : parameters->num_handed++;
        const char *format = second
                                 ? "    csg_handed[%zu].zw = csg_normals_of(begin + %zu, %zu);\n"
                                 : "    csg_handed[%zu] = vec4(csg_normals_of(begin + %zu, %zu), "
                                   "0.0, 0.0);\n";
        csg_text_add(parameters->vertex, format, input, leaves[i].record, leaves[i].num_planes);
        csg_text_add(parameters->fragment, "    vec2 n%zu = csg_handed[%zu].%s;\n", i, input,
                     second ? "zw" : "xy");
        second = !second;
        leaves[i].normals = true;
    }
}

/* A fragment's expression for the texel at offset from the object's first record, prepared by the
 * function of that name. */
static void add_texel(struct parameters *parameters, const char *prepare, size_t offset)
{
    if (parameters->num_handed == parameters->max_handed) {
        csg_text_add(parameters->fragment, "%s(csg_texel(begin + %zu))", prepare, offset);
        return;
    }
    csg_text_add(parameters->vertex, "    csg_handed[%zu] = %s(csg_texel(begin + %zu));\n",
                 parameters->num_handed, prepare, offset);
    csg_text_add(parameters->fragment, "csg_handed[%zu]", parameters->num_handed++);
}

/* The crossings of all quadrics, q1, q2, ... by step. */
static void add_quadrics(struct parameters *parameters, const struct csg_structure *structure,
                         const struct leaf_code *leaves)
{
    struct csg_text *text = parameters->fragment;
    for (size_t i = 0; i < structure->num; i++) {
        const size_t first = leaves[i].record + 1 + leaves[i].num_planes;
        if (!(structure->steps[i].flags & CSG_RECORD_QUADRIC))
            continue;
        csg_text_add(text, "    csg_crossings q%zu = csg_quadric(", i);
        for (size_t j = 0; j < 3; j++) {
            add_texel(parameters, "", first + j);
            csg_text_add(text, ", ");
        }
        csg_text_add(text, "d);\n");
    }
    csg_text_add(text, "#ifdef CSG_HAS_STIFF\n");
    for (size_t i = 0; i < structure->num; i++)
        if (structure->steps[i].flags & CSG_RECORD_QUADRIC)
            csg_text_add(text,
                         "    q%zu.key = (q%zu.code & CSG_QUADRIC_STIFF) != 0 ? "
                         "csg_stiff_quadric(begin + %zu, d) : q%zu.key;\n",
                         i, i, leaves[i].record + 1 + leaves[i].num_planes, i);
    csg_text_add(text, "#endif\n");
}

static void add_spans(struct parameters *parameters, const struct csg_structure *structure,
                      const struct leaf_code *leaves)
{
    struct csg_text *text = parameters->fragment;
    for (size_t i = 0; i < structure->num; i++) {
        if (csg_structure_is_pop(structure, i))
            continue;
        csg_text_add(text, "    csg_span s%zu = csg_whole_ray();\n", i);
        for (size_t plane = 0; plane < leaves[i].num_planes; plane++) {
            /* Entries come first. */
            const bool exit = leaves[i].paired && plane >= leaves[i].num_planes / 2;
            csg_text_add(text, "    csg_clip_%s(", exit ? "exit" : "plane");
            add_texel(parameters, "csg_plane_sense", leaves[i].record + 1 + plane);
            csg_text_add(text, ", d, %zu, s%zu);\n", plane, i);
        }
        if (leaves[i].gap)
            csg_text_add(text, "    vec2 g%zu = csg_gap_quadric(q%zu, %zu, s%zu);\n", i, i,
                         leaves[i].num_planes, i);
        else if (structure->steps[i].flags & CSG_RECORD_QUADRIC)
            csg_text_add(text, "    csg_clip_quadric(q%zu, %zu, s%zu);\n", i, leaves[i].num_planes,
                         i);
    }
}

static void fill_leaves(const struct csg_structure *structure, struct leaf_code *leaves)
{
    size_t record = 0;
    for (size_t i = 0; i < structure->num; i++) {
        const uint32_t flags = structure->steps[i].flags;
        leaves[i] = (struct leaf_code){.record = record++, .gap = flags & CSG_RECORD_GAP};
        if (csg_structure_is_pop(structure, i))
            continue;
        leaves[i].rank = rank_of(structure, i);
        const struct csg_shape *shape = &structure->scene->leaves[structure->steps[i].leaf].shape;
        leaves[i].num_planes = shape->num_planes;
        leaves[i].paired = csg_shape_is_paired(shape);
        record += leaves[i].num_planes + (flags & CSG_RECORD_QUADRIC ? CSG_QUADRIC_TEXELS : 0);
    }
}

static void add_next_value(struct csg_text *text, const struct csg_structure *structure, size_t i,
                           const struct leaf_code *leaves, const char *at)
{
    const char *side = structure->steps[i].flags & CSG_RECORD_NEGATED ? "outside" : "inside";
    if (leaves[i].gap)
        csg_text_add(text, "csg_%s_gap(%s, s%zu.key, g%zu)", side, at, i, i);
    else
        csg_text_add(text, "csg_%s(%s, s%zu.key)", side, at, i);
}

/* Runs the steps once more over registers r0, r1, ...; value writes a leaf's value. */
static void add_steps(struct csg_text *text, const struct csg_structure *structure,
                      const char *indent, const char *all, const char *any,
                      void (*value)(struct csg_text *, const struct csg_structure *, size_t,
                                    const struct leaf_code *, const char *at),
                      const struct leaf_code *leaves)
{
    int top = 0;
    for (size_t i = 0; i < structure->num; i++) {
        const uint32_t flags = structure->steps[i].flags;
        const char *op = flags & CSG_RECORD_AND ? all : any;
        if (flags & CSG_RECORD_POP) {
            csg_text_add(text, "%sr%d = %s(r%d, r%d);\n", indent, top - 1, op, top - 1, top);
            top--;
            continue;
        }
        top += flags & CSG_RECORD_PUSH ? 1 : 0;
        /* What is asked at r is never before r: there is no maximum to take. */
        const bool alone =
            flags & CSG_RECORD_START || (flags & CSG_RECORD_AND && value == add_next_value);
        if (alone)
            csg_text_add(text, "%sr%d = ", indent, top);
        else
            csg_text_add(text, "%sr%d = %s(r%d, ", indent, top, op, top);
        /* In an intersection nothing before what the operands so far ask for can be true. */
        char at[16] = "k";
        if (flags & CSG_RECORD_AND && !(flags & CSG_RECORD_START))
            snprintf(at, sizeof at, "r%d", top);
        value(text, structure, i, leaves, at);
        csg_text_add(text, alone ? ";\n" : ");\n");
    }
}

/* The place of the leaf's face of which face is the number, in text. */
static void add_place(struct csg_text *text, const struct leaf_code *leaves, size_t i,
                      const char *face)
{
    if (leaves[i].normals)
        csg_text_add(text, "csg_normal_at(n%zu, %s)", i, face);
    else
        csg_text_add(text, "ivec2(begin + %zu, %s)", leaves[i].record, face);
}

static void add_change_value(struct csg_text *text, const struct csg_structure *structure, size_t i,
                             const struct leaf_code *leaves, const char *at)
{
    (void)at; /* a change is looked for at k alone */
    const bool negated = structure->steps[i].flags & CSG_RECORD_NEGATED;
    csg_text_add(text, "csg_literal(%s", negated ? "not(" : "");
    if (leaves[i].gap)
        csg_text_add(text, "csg_around_gap(k, s%zu.key, g%zu)", i, i);
    else
        csg_text_add(text, "csg_around(k, s%zu.key)", i);
    csg_text_add(text, "%s, %u%s, ", negated ? ")" : "", leaves[i].rank,
                 negated ? " + CSG_RANK_NEGATED" : "");
    char face[96];
    if (leaves[i].gap)
        snprintf(face, sizeof face, "csg_face_at_gap(k, s%zu, g%zu, %zu, %s)", i, i,
                 leaves[i].num_planes, negated ? "false" : "true");
    else
        snprintf(face, sizeof face, "s%zu.face.%s", i, negated ? "y" : "x");
    add_place(text, leaves, i, face);
    csg_text_add(text, ")");
}

static void declare_registers(struct csg_text *text, const struct csg_structure *structure,
                              const char *indent, const char *type)
{
    int top = 0, num = 0;
    for (size_t i = 0; i < structure->num; i++) {
        top += structure->steps[i].flags & CSG_RECORD_PUSH ? 1 : 0;
        num = top > num ? top : num;
        top -= structure->steps[i].flags & CSG_RECORD_POP ? 1 : 0;
    }
    csg_text_add(text, "%s%s r0", indent, type);
    for (int i = 1; i <= num; i++)
        csg_text_add(text, ", r%d", i);
    csg_text_add(text, ";\n");
}

static void add_loop(struct csg_text *text, const struct csg_structure *structure,
                     const struct leaf_code *leaves)
{
    csg_text_add(text, "    k = -CSG_KEY_MAX;\n    for (;;) {\n");
    declare_registers(text, structure, "        ", "float");
    add_steps(text, structure, "        ", "max", "min", add_next_value, leaves);
    csg_text_end_search(text);
}

static void add_flat_search(struct csg_text *text, const struct csg_structure *structure)
{
    size_t holes[CSG_STRAIGHT_MAX_STEPS], num = 0;
    csg_text_add(text, "    vec2 whole = vec2(-CSG_KEY_MAX, CSG_NEVER);\n");
    for (size_t i = 0; i < structure->num; i++)
        if (structure->steps[i].flags & CSG_RECORD_NEGATED)
            holes[num++] = i;
        else
            csg_text_add(text,
                         "    whole.x = max(whole.x, s%zu.key.x);\n"
                         "    whole.y = min(whole.y, s%zu.key.y);\n",
                         i, i);
    csg_text_add_passing(text, "s%zu.key", holes, num);
}

/* Solids and complements, all convex, that must all be true. */
static bool is_flat(const struct csg_structure *structure)
{
    for (size_t i = 0; i < structure->num; i++)
        if (structure->steps[i].flags & (CSG_RECORD_GAP | CSG_RECORD_POP) ||
            !(structure->steps[i].flags & (CSG_RECORD_START | CSG_RECORD_AND)))
            return false;
    return true;
}

static void add_search(struct csg_text *text, const struct csg_structure *structure,
                       const struct leaf_code *leaves)
{
    if (is_flat(structure))
        add_flat_search(text, structure);
    else
        add_loop(text, structure, leaves);
}

/* Where all must be true, whichever of them became so at k is responsible, and which of several is
 * known by their order: the step that comes last in csg_choose's, but for those that have come
 * before. */
static size_t last_choice(const struct csg_structure *structure, const struct leaf_code *leaves,
                          const bool *placed)
{
    size_t last = structure->num;
    for (size_t i = 0; i < structure->num; i++) {
        const bool negated = structure->steps[i].flags & CSG_RECORD_NEGATED;
        if (placed[i])
            continue;
        const bool than =
            last < structure->num && structure->steps[last].flags & CSG_RECORD_NEGATED;
        if (last == structure->num || (negated && !than) ||
            (negated == than && leaves[i].rank > leaves[last].rank))
            last = i;
    }
    return last;
}

static void add_flat_change(struct csg_text *text, const struct csg_structure *structure,
                            const struct leaf_code *leaves)
{
    bool placed[CSG_STRAIGHT_MAX_STEPS] = {false};
    for (size_t num = 0; num < structure->num; num++) {
        const size_t i = last_choice(structure, leaves, placed);
        const bool negated = structure->steps[i].flags & CSG_RECORD_NEGATED;
        char face[32];
        snprintf(face, sizeof face, "s%zu.face.%s", i, negated ? "y" : "x");
        csg_text_add(text, "    place = ");
        if (num > 0)
            csg_text_add(text, "!csg_%s(k, s%zu.key) ? place : ", negated ? "ends" : "begins", i);
        add_place(text, leaves, i, face);
        csg_text_add(text, ";\n");
        placed[i] = true;
    }
    csg_text_add(text, "    return true;\n}\n");
}

static void add_change(struct csg_text *text, const struct csg_structure *structure,
                       const struct leaf_code *leaves)
{
    if (is_flat(structure)) {
        add_flat_change(text, structure, leaves);
        return;
    }
    declare_registers(text, structure, "    ", "csg_change");
    add_steps(text, structure, "    ", "csg_all", "csg_any", add_change_value, leaves);
    csg_text_add(text, "    place = r0.place;\n    return true;\n}\n");
}

void csg_source_straight(struct csg_text *vertex, struct csg_text *fragment,
                         const struct csg_structure *structure, int features, size_t max_handed)
{
    struct leaf_code *leaves = calloc(structure->num, sizeof *leaves);
    struct csg_text handing = {0}, code = {0};
    struct parameters parameters = {&handing, &code, 0, max_handed};
    if (leaves) {
        fill_leaves(structure, leaves);
        if (!(features & CSG_FEATURE_TEXTBOOK) && can_hand_normals(structure, leaves, max_handed))
            add_normals(&parameters, structure, leaves);
        add_quadrics(&parameters, structure, leaves);
        add_spans(&parameters, structure, leaves);
        add_search(&code, structure, leaves);
        add_change(&code, structure, leaves);
        csg_text_add(vertex, "#define CSG_NUM_HANDED %zu\n", parameters.num_handed);
        if (leaves[0].normals)
            csg_text_add(fragment, "#define CSG_KNOWS_NORMALS\n");
        csg_text_add(fragment,
                     "#define CSG_NUM_HANDED %zu\nflat in vec4 csg_handed[CSG_NUM_HANDED];\n\n"
                     "bool csg_resolve(ivec3 object, vec2 d, out csg_real k, out ivec2 place,"
                     " out bool inside)\n{\n    int begin = object.x;\n"
                     "    inside = false;\n%s",
                     parameters.num_handed, code.data ? code.data : "");
        csg_text_add(vertex,
                     "flat out vec4 csg_handed[CSG_NUM_HANDED];\n\n"
                     "void csg_hand_over(int begin, int end)\n{\n%s}\n",
                     handing.data ? handing.data : "");
    }
    vertex->failed |= !leaves || handing.failed || code.failed;
    fragment->failed |= vertex->failed;
    free(handing.data);
    free(code.data);
    free(leaves);
}
