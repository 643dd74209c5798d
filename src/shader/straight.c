/* SPDX-License-Identifier: MIT */

/*
 * Straight-line GLSL for one small tree: the steps of the machine in shaders/csg/program.glsl with
 * the loop, the stack and the headers compiled away. Parameters stay in the data texture.
 */

#include "shader/source.h"

#include <stdlib.h>

struct leaf_code {
    size_t record;  /* offset of the record from the object's first */
    unsigned rank;  /* among the object's leaves, in file order */
    bool gap;
};

static bool is_pop(const struct csg_structure *structure, size_t step)
{
    return structure->steps[step].flags & CSG_RECORD_POP;
}

/* Number of the object's leaves that come earlier in the file. */
static unsigned rank_of(const struct csg_structure *structure, size_t step)
{
    unsigned rank = 0;
    for (size_t i = 0; i < structure->num; i++)
        rank += !is_pop(structure, i) &&
                structure->steps[i].leaf < structure->steps[step].leaf;
    return rank;
}

static void add_spans(struct csg_text *text, const struct csg_structure *structure,
                      struct leaf_code *leaves)
{
    size_t record = 0;
    for (size_t i = 0; i < structure->num; i++) {
        const uint32_t flags = structure->steps[i].flags;
        leaves[i] = (struct leaf_code){record, rank_of(structure, i), flags & CSG_RECORD_GAP};
        record++;
        if (is_pop(structure, i))
            continue;
        const size_t planes =
            structure->scene->leaves[structure->steps[i].leaf].shape.num_planes;
        csg_text_add(text, "    vec2 s%zu = vec2(-CSG_KEY_MAX, CSG_KEY_MAX);\n", i);
        for (size_t plane = 0; plane < planes; plane++)
            csg_text_add(text, "    csg_clip_plane(csg_texel(begin + %zu), d, s%zu);\n", record++,
                         i);
        if (flags & CSG_RECORD_GAP)
            csg_text_add(text, "    vec2 g%zu;\n    csg_gap_quadric(begin + %zu, d, s%zu, g%zu);\n",
                         i, record, i, i);
        else if (flags & CSG_RECORD_QUADRIC)
            csg_text_add(text, "    csg_clip_quadric(begin + %zu, d, s%zu);\n", record, i);
        record += flags & CSG_RECORD_QUADRIC ? CSG_QUADRIC_TEXELS : 0;
    }
}

/* Runs the steps once more over registers r0, r1, ...; value writes a leaf's value. */
static void add_steps(struct csg_text *text, const struct csg_structure *structure,
                      const char *indent, const char *all, const char *any,
                      void (*value)(struct csg_text *, const struct csg_structure *, size_t,
                                    const struct leaf_code *),
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
        if (flags & CSG_RECORD_START)
            csg_text_add(text, "%sr%d = ", indent, top);
        else
            csg_text_add(text, "%sr%d = %s(r%d, ", indent, top, op, top);
        value(text, structure, i, leaves);
        csg_text_add(text, flags & CSG_RECORD_START ? ";\n" : ");\n");
    }
}

static void add_next_value(struct csg_text *text, const struct csg_structure *structure, size_t i,
                           const struct leaf_code *leaves)
{
    const char *side = structure->steps[i].flags & CSG_RECORD_NEGATED ? "outside" : "inside";
    if (leaves[i].gap)
        csg_text_add(text, "csg_%s_gap(k, s%zu, g%zu)", side, i, i);
    else
        csg_text_add(text, "csg_%s(k, s%zu)", side, i);
}

static void add_change_value(struct csg_text *text, const struct csg_structure *structure, size_t i,
                             const struct leaf_code *leaves)
{
    const bool negated = structure->steps[i].flags & CSG_RECORD_NEGATED;
    csg_text_add(text, "csg_literal(%s", negated ? "not(" : "");
    if (leaves[i].gap)
        csg_text_add(text, "csg_around_gap(k, s%zu, g%zu)", i, i);
    else
        csg_text_add(text, "csg_around(k, s%zu)", i);
    csg_text_add(text, "%s, %u + %s, %zu)", negated ? ")" : "", leaves[i].rank,
                 negated ? "CSG_RANK_NEGATED" : "0", leaves[i].record);
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

void csg_source_straight(struct csg_text *text, const struct csg_structure *structure)
{
    struct leaf_code *leaves = calloc(structure->num, sizeof *leaves);
    if (!leaves) {
        text->failed = true;
        return;
    }
    csg_text_add(text, "bool csg_resolve(int begin, int end, vec2 d, out float k, out int record,"
                       " out bool inside)\n{\n    inside = false;\n");
    add_spans(text, structure, leaves);
    csg_text_add(text, "    k = -CSG_KEY_MAX;\n    for (;;) {\n");
    declare_registers(text, structure, "        ", "float");
    add_steps(text, structure, "        ", "max", "min", add_next_value, leaves);
    csg_text_add(text, "        if (!(r0 > k))\n            break;\n"
                       "        k = r0;\n"
                       "        if (k >= csg_screen_key.z)\n            return false;\n    }\n");
    size_t num_leaves = 0;
    for (size_t i = 0; i < structure->num; i++)
        num_leaves += !is_pop(structure, i);
    if (num_leaves == 1) {
        csg_text_add(text, "    record = begin;\n    return true;\n}\n");
    } else {
        declare_registers(text, structure, "    ", "csg_change");
        add_steps(text, structure, "    ", "csg_all", "csg_any", add_change_value, leaves);
        csg_text_add(text, "    record = begin + r0.record;\n    return true;\n}\n");
    }
    free(leaves);
}
