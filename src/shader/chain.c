/* SPDX-License-Identifier: MIT */

/* Chains: programs for what tiles mostly are, a few solids that must all be true, or not. */

#include "shader/source.h"

#include <math.h>

const struct csg_chain csg_chains[CSG_NUM_CHAINS] = {
    {.slots = 2, .handed = 2, .quadrics = false}, {.slots = 5, .handed = 5, .quadrics = false},
    {.slots = 2, .handed = 2, .quadrics = true},  {.slots = 3, .handed = 3, .quadrics = true},
    {.slots = 5, .handed = 4, .quadrics = true},
};

/* Planes of either sense that a slot holds, and numbers of normals that shaders/csg/normals.glsl
 * has bits for. */
#define MAX_PLANES 2
#define MAX_NUMBER 63

#define NOT_IN_CHAINS                                                                              \
    (CSG_RECORD_POP | CSG_RECORD_PUSH | CSG_RECORD_GAP | CSG_RECORD_BOUND | CSG_RECORD_SURFACE)

/* A slot's numbers, variable and component: its planes e f x y, its head h, its quadric q r s. The
 * code of the quadric, q.w, is part of h.x. */
static const char numbers[][3] = {"ex", "ey", "ez", "fx", "fy", "fz", "xx", "xy", "xz",
                                  "yx", "yy", "yz", "hx", "hy", "hz", "qx", "qy", "qz",
                                  "rx", "ry", "rz", "rw", "sx", "sy", "sz", "sw"};
#define NUM_OF_PLANES 15
#define NUM_OF_QUADRICS 26

static int slot_size(const struct csg_chain *chain)
{
    return chain->quadrics ? NUM_OF_QUADRICS : NUM_OF_PLANES;
}

size_t csg_chain_handed(const struct csg_chain *chain)
{
    return (size_t)(slot_size(chain) * chain->handed + 3) / 4;
}

size_t csg_chain_size(const struct csg_chain *chain)
{
    const bool rest = chain->slots > chain->handed; /* where the others begin */
    return csg_chain_handed(chain) + rest;
}

/* csg_choose's order: solids before complements, then the order of the file. */
static int64_t rank_of(const float *texels, const float *head)
{
    const float leaf = texels[4 * (4 * (size_t)head[3] + CSG_ATTRIBUTE_LEAF)];
    return (int64_t)leaf + ((int)head[2] & CSG_RECORD_NEGATED ? (int64_t)1 << 32 : 0);
}

/* Whether the record is one that a chain can have behind another one of that rank. */
static bool is_link(const float *texels, const float *head, int64_t rank)
{
    const int entries = (int)head[0], exits = (int)head[1], flags = (int)head[2];
    if (flags & NOT_IN_CHAINS || !(flags & (CSG_RECORD_START | CSG_RECORD_AND)) ||
        entries > MAX_PLANES || exits > MAX_PLANES || rank_of(texels, head) < rank)
        return false;
    for (int i = 0; i < entries + exits; i++)
        if (fabsf(head[4 * (1 + i) + 3]) > MAX_NUMBER + 1)
            return false;
    return true;
}

int csg_chain_find(const float *texels, size_t begin, size_t end)
{
    int slots = 0;
    bool quadrics = false;
    int64_t rank = 0;
    for (const float *head = texels + 4 * begin; head < texels + 4 * end; slots++) {
        const int flags = (int)head[2];
        if (!is_link(texels, head, rank) || (slots == 0 && flags & CSG_RECORD_NEGATED))
            return -1;
        rank = rank_of(texels, head);
        quadrics |= flags & CSG_RECORD_QUADRIC;
        head += 4 * (1 + (int)head[0] + (int)head[1] +
                     (flags & CSG_RECORD_QUADRIC ? CSG_QUADRIC_TEXELS : 0));
    }
    for (int i = 0; i < CSG_NUM_CHAINS; i++)
        if (slots <= csg_chains[i].slots && quadrics == csg_chains[i].quadrics)
            return i;
    return -1;
}

/* Variables of a slot. */
static void add_slot(struct csg_text *text, const struct csg_chain *chain, int i)
{
    csg_text_add(text, "    vec4 e%d, f%d, x%d, y%d;\n    vec3 h%d;\n", i, i, i, i, i);
    if (chain->quadrics)
        csg_text_add(text, "    vec4 q%d, r%d, s%d;\n", i, i, i);
}

/* ... read from where p is. */
static void add_reading(struct csg_text *text, const struct csg_chain *chain, int i)
{
    add_slot(text, chain, i);
    csg_text_add(text,
                 "    bool b%d;\n    csg_read_slot(p, object.xy, h%d, e%d, f%d, x%d, y%d, b%d);\n",
                 i, i, i, i, i, i, i);
    if (chain->quadrics)
        csg_text_add(text, "    csg_read_slot_quadric(p, b%d, h%d, q%d, r%d, s%d);\n", i, i, i, i,
                     i);
}

/* Number j of all that are handed over: a variable's component. */
static void add_number(struct csg_text *text, const struct csg_chain *chain, int j)
{
    const int slot = j / slot_size(chain);
    const char *name = numbers[j % slot_size(chain)];
    if (slot < chain->handed)
        csg_text_add(text, "%c%d.%c", name[0], slot, name[1]);
    else
        csg_text_add(text, "0.0");
}

static void add_vertex(struct csg_text *text, const struct csg_chain *chain)
{
    const int num = (int)csg_chain_handed(chain);
    csg_text_add(text,
                 "#define CSG_NUM_HANDED %d\nflat out vec4 csg_handed[CSG_NUM_HANDED];\n"
                 "#define CSG_HAS_REST\nflat out int csg_rest;\n\n"
                 "void csg_hand_over(int begin, int end)\n{\n"
                 /* No vertex is below 0. The driver need not know that the first solid's place in
                  * the chain is 0: it would leave it out, and shared programs are to be alike. */
                 "    int p = begin + min(gl_VertexID, 0);\n"
                 "    ivec2 object = ivec2(begin, end);\n",
                 num);
    for (int i = 0; i < chain->handed; i++)
        add_reading(text, chain, i);
    for (int i = 0; i < num; i++) {
        csg_text_add(text, "    csg_handed[%d] = vec4(", i);
        for (int j = 0; j < 4; j++) {
            csg_text_add(text, j ? ", " : "");
            add_number(text, chain, 4 * i + j);
        }
        csg_text_add(text, ");\n");
    }
    csg_text_add(text, "    csg_rest = p;\n}\n");
}

/* What the vertex stage has handed over, and what it has not. */
static void add_slots(struct csg_text *text, const struct csg_chain *chain)
{
    for (int i = 0; i < chain->handed; i++) {
        add_slot(text, chain, i);
        for (int j = 0; j < slot_size(chain); j++) {
            const int at = slot_size(chain) * i + j;
            csg_text_add(text, "    ");
            add_number(text, chain, at);
            csg_text_add(text, " = csg_handed[%d].%c;\n", at / 4, "xyzw"[at % 4]);
        }
        if (chain->quadrics)
            csg_text_add(text, "    q%d.w = h%d.x;\n", i, i);
    }
    if (chain->slots > chain->handed)
        csg_text_add(text, "    int p = csg_rest;\n");
    for (int i = chain->handed; i < chain->slots; i++)
        add_reading(text, chain, i);
}

/* The first slot is a solid's. */
static void add_spans(struct csg_text *text, const struct csg_chain *chain)
{
    for (int i = 0; i < chain->slots; i++) {
        csg_text_add(text, "    csg_span l%d = csg_chain_planes(e%d, f%d, x%d, y%d, d);\n", i, i, i,
                     i, i);
        if (chain->quadrics)
            csg_text_add(text, "    csg_clip_quadric(csg_quadric(q%d, r%d, s%d, d), 4, l%d);\n", i,
                         i, i, i);
        if (i == 0)
            csg_text_add(text, "    const bool c0 = false;\n    vec2 whole = l0.key;\n");
        else
            csg_text_add(text,
                         "    bool c%d = h%d.x >= float(CSG_CHAIN_NEGATED);\n"
                         "    vec2 o%d = csg_chain_hole(c%d, l%d, whole);\n",
                         i, i, i, i, i);
    }
}

static void add_search(struct csg_text *text, const struct csg_chain *chain)
{
    static const size_t slots[] = {1, 2, 3, 4};
    csg_text_add_passing(text, "o%zu", slots, (size_t)chain->slots - 1);
}

static void add_fragment(struct csg_text *text, const struct csg_chain *chain)
{
    csg_text_add(text,
                 "#define CSG_KNOWS_NORMALS\n"
                 "#define CSG_NUM_HANDED %zu\nflat in vec4 csg_handed[CSG_NUM_HANDED];\n"
                 "#define CSG_HAS_REST\nflat in int csg_rest;\n\n"
                 "bool csg_resolve(ivec3 object, vec2 d, out float k, out ivec2 place,"
                 " out bool inside)\n{\n    inside = false;\n    place = ivec2(0);\n",
                 csg_chain_handed(chain));
    add_slots(text, chain);
    add_spans(text, chain);
    add_search(text, chain);
    for (int i = chain->slots; i-- > 0;)
        csg_text_add(text, "    place = csg_chain_place(c%d, h%d, l%d, k, place);\n", i, i, i);
    csg_text_add(text, "    return true;\n}\n");
}

void csg_source_chain(struct csg_text *vertex, struct csg_text *fragment,
                      const struct csg_chain *chain)
{
    add_vertex(vertex, chain);
    add_fragment(fragment, chain);
}
