/* SPDX-License-Identifier: MIT */

/* Chains: programs for what tiles mostly are, a few solids under one operation after the other. */

#include "shader/source.h"

const struct csg_chain csg_chains[CSG_NUM_CHAINS] = {
    {.slots = 2, .quadrics = false},
    {.slots = 5, .quadrics = false},
    {.slots = 2, .quadrics = true},
    {.slots = 3, .quadrics = true},
};

/* Planes of either sense that a slot holds. */
#define MAX_PLANES 2

#define NOT_IN_CHAINS                                                                              \
    (CSG_RECORD_POP | CSG_RECORD_PUSH | CSG_RECORD_GAP | CSG_RECORD_BOUND | CSG_RECORD_SURFACE)

static int slot_size(const struct csg_chain *chain)
{
    return chain->quadrics ? 8 : 5;
}

size_t csg_chain_size(const struct csg_chain *chain)
{
    return (size_t)(slot_size(chain) * chain->slots);
}

int csg_chain_find(const float *records, const float *end)
{
    int slots = 0;
    bool quadrics = false;
    for (const float *head = records; head < end; slots++) {
        const int entries = (int)head[0], exits = (int)head[1], flags = (int)head[2];
        if (flags & NOT_IN_CHAINS || entries > MAX_PLANES || exits > MAX_PLANES)
            return -1;
        quadrics |= flags & CSG_RECORD_QUADRIC;
        head += 4 * (1 + entries + exits + (flags & CSG_RECORD_QUADRIC ? CSG_QUADRIC_TEXELS : 0));
    }
    for (int i = 0; i < CSG_NUM_CHAINS; i++)
        if (slots <= csg_chains[i].slots && quadrics == csg_chains[i].quadrics)
            return i;
    return -1;
}

static void add_vertex(struct csg_text *text, const struct csg_chain *chain)
{
    const int size = slot_size(chain);
    csg_text_add(text,
                 "#define CSG_NUM_HANDED %d\nflat out vec4 csg_handed[CSG_NUM_HANDED];\n\n"
                 "void csg_hand_over(int begin, int end)\n{\n    int p = begin;\n",
                 size * chain->slots);
    for (int i = 0; i < chain->slots; i++) {
        const int at = size * i;
        csg_text_add(text,
                     "    csg_hand_slot(p, ivec2(begin, end), csg_handed[%d], csg_handed[%d], "
                     "csg_handed[%d], csg_handed[%d], csg_handed[%d]);\n",
                     at, at + 1, at + 2, at + 3, at + 4);
        if (chain->quadrics)
            csg_text_add(text,
                         "    csg_hand_quadric(p, csg_handed[%d], csg_handed[%d], "
                         "csg_handed[%d], csg_handed[%d]);\n",
                         at, at + 5, at + 6, at + 7);
    }
    csg_text_add(text, "}\n");
}

static void add_spans(struct csg_text *text, const struct csg_chain *chain)
{
    const int size = slot_size(chain);
    for (int i = 0; i < chain->slots; i++) {
        const int at = size * i;
        csg_text_add(text,
                     "    vec4 h%d = csg_handed[%d];\n"
                     "    csg_span s%d = csg_chain_planes(h%d, csg_handed[%d], csg_handed[%d], "
                     "csg_handed[%d], csg_handed[%d], d);\n",
                     i, at, i, i, at + 1, at + 2, at + 3, at + 4);
        if (chain->quadrics)
            csg_text_add(text,
                         "    csg_clip_quadric(csg_quadric(csg_handed[%d], csg_handed[%d], "
                         "csg_handed[%d], d), int(h%d.w), s%d);\n",
                         at + 5, at + 6, at + 7, i, i);
    }
}

static void add_fragment(struct csg_text *text, const struct csg_chain *chain)
{
    const int size = slot_size(chain);
    csg_text_add(text,
                 "flat in vec4 csg_handed[%d];\n\n"
                 "bool csg_resolve(ivec2 object, vec2 d, out float k, out ivec2 place,"
                 " out bool inside)\n{\n    int begin = object.x;\n    inside = false;\n",
                 size * chain->slots);
    add_spans(text, chain);
    csg_text_add(text, "    k = -CSG_KEY_MAX;\n    for (;;) {\n"
                       "        float r = csg_chain_value(h0, s0, k);\n");
    for (int i = 1; i < chain->slots; i++)
        csg_text_add(text, "        r = csg_chain_next(h%d, s%d, k, r);\n", i, i);
    csg_text_add(text,
                 "        if (!(r > k))\n            break;\n        k = r;\n"
                 "        if (k >= csg_screen_key.z)\n            return false;\n    }\n"
                 "    csg_change c = csg_chain_literal(h0, csg_handed[1].w, s0, begin, k);\n");
    for (int i = 1; i < chain->slots; i++)
        csg_text_add(text,
                     "    c = csg_chain_change(h%d, c, csg_chain_literal(h%d, "
                     "csg_handed[%d].w, s%d, begin, k));\n",
                     i, i, size * i + 1, i);
    csg_text_add(text, "    place = c.place;\n    return true;\n}\n");
}

void csg_source_chain(struct csg_text *vertex, struct csg_text *fragment,
                      const struct csg_chain *chain)
{
    add_vertex(vertex, chain);
    add_fragment(fragment, chain);
}
