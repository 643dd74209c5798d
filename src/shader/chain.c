/* SPDX-License-Identifier: MIT */

/* Chains: programs for what tiles mostly are, a few solids under one operation after the other. */

#include "shader/source.h"

#include <stdio.h>

const struct csg_chain csg_chains[CSG_NUM_CHAINS] = {
    {.slots = 2, .handed = 2, .quadrics = false},
    {.slots = 5, .handed = 5, .quadrics = false},
    {.slots = 2, .handed = 2, .quadrics = true},
    {.slots = 3, .handed = 3, .quadrics = true},
    {.slots = 5, .handed = 3, .quadrics = true},
};

/* Planes of either sense that a slot holds. */
#define MAX_PLANES 2

#define NOT_IN_CHAINS                                                                              \
    (CSG_RECORD_POP | CSG_RECORD_PUSH | CSG_RECORD_GAP | CSG_RECORD_BOUND | CSG_RECORD_SURFACE)

static int slot_size(const struct csg_chain *chain)
{
    return chain->quadrics ? 8 : 5;
}

size_t csg_chain_handed(const struct csg_chain *chain)
{
    return (size_t)(slot_size(chain) * chain->handed);
}

size_t csg_chain_size(const struct csg_chain *chain)
{
    const bool rest = chain->slots > chain->handed; /* where the others begin */
    return csg_chain_handed(chain) + rest;
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

/* Texel j of slot i: an expression, in text. */
struct texel {
    char text[32];
};

static struct texel texel_of(const struct csg_chain *chain, int i, int j)
{
    const int at = slot_size(chain) * (i < chain->handed ? i : i - chain->handed) + j;
    struct texel texel;
    const char *name = i < chain->handed ? "handed" : "read";
    snprintf(texel.text, sizeof texel.text, "csg_%s[%d]", name, at);
    return texel;
}

/* Code that reads slots [begin, end) from where p is. */
static void add_reading(struct csg_text *text, const struct csg_chain *chain, int begin, int end)
{
    for (int i = begin; i < end; i++) {
        csg_text_add(text, "    csg_read_slot(p, object.xy");
        for (int j = 0; j < 5; j++)
            csg_text_add(text, ", %s", texel_of(chain, i, j).text);
        csg_text_add(text, ");\n");
        if (chain->quadrics)
            csg_text_add(text, "    csg_read_slot_quadric(p, %s, %s, %s, %s);\n",
                         texel_of(chain, i, 0).text, texel_of(chain, i, 5).text,
                         texel_of(chain, i, 6).text, texel_of(chain, i, 7).text);
    }
}

static void add_vertex(struct csg_text *text, const struct csg_chain *chain)
{
    const int num = slot_size(chain) * chain->handed;
    csg_text_add(text,
                 "#define CSG_NUM_HANDED %d\nflat out vec4 csg_handed[CSG_NUM_HANDED];\n"
                 "#define CSG_HAS_REST\nflat out int csg_rest;\n\n"
                 "void csg_hand_over(int begin, int end)\n{\n"
                 /* No vertex is below 0. The driver need not know that the first solid's place in
                  * the chain is 0: it would leave it out, and shared programs are to be alike. */
                 "    int p = begin + min(gl_VertexID, 0);\n"
                 "    ivec2 object = ivec2(begin, end);\n",
                 num);
    add_reading(text, chain, 0, chain->handed);
    csg_text_add(text, "    csg_rest = p;\n}\n");
}

static void add_spans(struct csg_text *text, const struct csg_chain *chain)
{
    for (int i = 0; i < chain->slots; i++) {
        csg_text_add(text, "    vec4 h%d = %s;\n    csg_span s%d = csg_chain_planes(h%d", i,
                     texel_of(chain, i, 0).text, i, i);
        for (int j = 1; j < 5; j++)
            csg_text_add(text, ", %s", texel_of(chain, i, j).text);
        csg_text_add(text, ", d);\n");
        if (chain->quadrics)
            csg_text_add(text,
                         "    csg_clip_quadric(csg_quadric(%s, %s, %s, d), int(h%d.w), s%d);\n",
                         texel_of(chain, i, 5).text, texel_of(chain, i, 6).text,
                         texel_of(chain, i, 7).text, i, i);
    }
}

/* The slots that no vertex stage has handed over. */
static void add_rest(struct csg_text *text, const struct csg_chain *chain)
{
    if (chain->slots == chain->handed)
        return;
    csg_text_add(text, "    vec4 csg_read[%d];\n    int p = csg_rest;\n",
                 slot_size(chain) * (chain->slots - chain->handed));
    add_reading(text, chain, chain->handed, chain->slots);
}

static void add_search(struct csg_text *text, const struct csg_chain *chain)
{
    csg_text_add(text, "    k = -CSG_KEY_MAX;\n    for (;;) {\n"
                       "        float r = csg_chain_value(h0, s0, k);\n");
    for (int i = 1; i < chain->slots; i++)
        csg_text_add(text, "        r = csg_chain_next(h%d, s%d, k, r);\n", i, i);
    csg_text_add(text, "        if (!(r > k))\n            break;\n        k = r;\n"
                       "        if (k >= csg_screen_key.z)\n            return false;\n    }\n");
}

static void add_fragment(struct csg_text *text, const struct csg_chain *chain)
{
    csg_text_add(text,
                 "#define CSG_NUM_HANDED %d\nflat in vec4 csg_handed[CSG_NUM_HANDED];\n"
                 "#define CSG_HAS_REST\nflat in int csg_rest;\n\n"
                 "bool csg_resolve(ivec3 object, vec2 d, out float k, out ivec2 place,"
                 " out bool inside)\n{\n    int begin = object.x;\n    inside = false;\n",
                 slot_size(chain) * chain->handed);
    add_rest(text, chain);
    add_spans(text, chain);
    add_search(text, chain);
    csg_text_add(text, "    csg_change c = csg_chain_literal(h0, %s.w, s0, begin, k);\n",
                 texel_of(chain, 0, 1).text);
    for (int i = 1; i < chain->slots; i++)
        csg_text_add(text,
                     "    c = csg_chain_change(h%d, c, csg_chain_literal(h%d, %s.w, s%d, begin, "
                     "k));\n",
                     i, i, texel_of(chain, i, 1).text, i);
    csg_text_add(text, "    place = c.place;\n    return true;\n}\n");
}

void csg_source_chain(struct csg_text *vertex, struct csg_text *fragment,
                      const struct csg_chain *chain)
{
    add_vertex(vertex, chain);
    add_fragment(fragment, chain);
}
