/* SPDX-License-Identifier: MIT */

/* Chains: programs for what tiles mostly are, a few solids that must all be true, or not. */

#include "shader/source.h"

const struct csg_chain csg_chains[CSG_NUM_CHAINS] = {
    {.slots = 2, .handed = 2, .planes = 2, .colors = true},
    {.slots = 5, .handed = 5, .planes = 2, .colors = true},
    {.slots = CSG_CHAIN_FACETED_LITERALS,
     .handed = CSG_CHAIN_FACETED_LITERALS,
     .planes = CSG_CHAIN_FACETED_PLANES,
     .colors = true},
    {2, 2, 1, .quadrics = true, .flat = true, .colors = true, .normals = true},
    {2, 2, 2, .quadrics = true, .colors = true, .normals = true},
    {3, 3, 1, .quadrics = true, .flat = true, .colors = true, .normals = true},
    {3, 3, 2, .quadrics = true, .colors = true},
    {4, 4, 2, .quadrics = true, .flat = true, .colors = true},
    {5, 5, 1, .quadrics = true, .flat = true, .colors = true},
    {5, 4, 2, .quadrics = true},
    {5, 5, 2, .colors = true, .clauses = true},
    {3, 3, 2, .quadrics = true, .colors = true, .clauses = true},
    {5, 4, 2, .quadrics = true, .clauses = true},
    {CSG_CLAUSE_LITERALS, 4, 2, .quadrics = true, .clauses = true},
};

/* A slot's numbers, the letter of a variable and what is taken of that: its planes e and x, its
 * head h, its quadric q r s, of which the code q.w is part of h.x, and for colours its colour t and
 * the terms u v w of its quadric's normal. */
static const char numbers[][7] = {
    "e[0].x", "e[0].y", "e[0].z", "e[1].x", "e[1].y", "e[1].z", "e[2].x", "e[2].y", "e[2].z",
    "e[3].x", "e[3].y", "e[3].z", "x[0].x", "x[0].y", "x[0].z", "x[1].x", "x[1].y", "x[1].z",
    "x[2].x", "x[2].y", "x[2].z", "x[3].x", "x[3].y", "x[3].z", "h.x",    "h.y",    "h.z",
    "q.x",    "q.y",    "q.z",    "r.x",    "r.y",    "r.z",    "r.w",    "s.x",    "s.y",
    "s.z",    "s.w",    "t.x",    "t.y",    "t.z",    "u.x",    "u.y",    "u.z",    "v.x",
    "v.y",    "v.z",    "w.x",    "w.y",    "w.z"};
#define NUM_NAMES (sizeof numbers / sizeof *numbers)

static bool has_quadric(const struct csg_chain *chain, int slot)
{
    return chain->quadrics && (slot > 0 || !chain->flat);
}

static bool is_handed(const struct csg_chain *chain, int slot, const char *number)
{
    switch (*number) {
    case 'e':
    case 'x':
        return number[2] - '0' < chain->planes;
    case 'q':
    case 'r':
    case 's':
        return has_quadric(chain, slot);
    case 't':
        return chain->colors;
    case 'u':
    case 'v':
    case 'w':
        return chain->normals && has_quadric(chain, slot);
    default:
        return true;
    }
}

/* The numbers that are handed over of a slot. */
struct slot {
    const char *numbers[NUM_NAMES];
    size_t size;
};

static struct slot find_slot(const struct csg_chain *chain, int i)
{
    struct slot slot = {.size = 0};
    for (size_t j = 0; j < NUM_NAMES; j++)
        if (is_handed(chain, i, numbers[j]))
            slot.numbers[slot.size++] = numbers[j];
    return slot;
}

size_t csg_chain_handed(const struct csg_chain *chain)
{
    size_t num = 0;
    for (int i = 0; i < chain->handed; i++)
        num += find_slot(chain, i).size;
    return (num + 3) / 4;
}

struct csg_chain csg_chain_of(int i, bool direct)
{
    struct csg_chain chain = csg_chains[i];
    chain.colors &= direct;
    chain.normals &= direct;
    return chain;
}

size_t csg_chain_size(int i, bool direct)
{
    const struct csg_chain chain = csg_chain_of(i, direct);
    const bool rest = chain.slots > chain.handed; /* where the others begin */
    return csg_chain_handed(&chain) + rest;
}

bool csg_chain_fits(int i, const struct csg_chain_need *needed)
{
    const struct csg_chain *chain = &csg_chains[i];
    return needed->slots <= chain->slots && needed->planes <= chain->planes &&
           needed->quadrics <= chain->quadrics && needed->clauses == chain->clauses &&
           (needed->flat || !chain->flat);
}

bool csg_chain_is_general(int i)
{
    return csg_chains[i].planes >= CSG_CHAIN_PLANES && !csg_chains[i].flat;
}

/* Variables of a slot. */
static void add_slot(struct csg_text *text, const struct csg_chain *chain, int i)
{
    csg_text_add(text,
                 "    vec4 e%d[CSG_SLOT_PLANES], x%d[CSG_SLOT_PLANES];\n"
                 "    vec3 h%d;\n",
                 i, i, i);
    if (has_quadric(chain, i))
        csg_text_add(text, "    vec4 q%d, r%d, s%d;\n", i, i, i);
    if (chain->colors)
        csg_text_add(text, "    vec3 t%d;\n", i);
    if (chain->normals)
        csg_text_add(text, "    vec3 u%d, v%d, w%d;\n", i, i, i);
}

/* ... read from where p is. */
static void add_reading(struct csg_text *text, const struct csg_chain *chain, int i)
{
    add_slot(text, chain, i);
    csg_text_add(text, "    bool b%d;\n", i);
    csg_text_add(text, "    csg_read_slot(p, object.xy, h%d, e%d, x%d, b%d);\n", i, i, i, i);
    if (has_quadric(chain, i))
        csg_text_add(text, "    csg_read_slot_quadric(p, b%d, h%d, q%d, r%d, s%d);\n", i, i, i, i,
                     i);
    if (chain->colors)
        csg_text_add(text, "    t%d = csg_slot_color(h%d);\n", i, i);
    if (chain->normals)
        csg_text_add(text, "    csg_read_slot_normal(h%d, u%d, v%d, w%d);\n", i, i, i, i);
}

/* Number j of all that are handed over: a variable's component. */
static void add_number(struct csg_text *text, const struct csg_chain *chain, size_t j)
{
    for (int i = 0; i < chain->handed; i++) {
        const struct slot slot = find_slot(chain, i);
        if (j < slot.size) {
            csg_text_add(text, "%c%d%s", slot.numbers[j][0], i, slot.numbers[j] + 1);
            return;
        }
        j -= slot.size;
    }
    csg_text_add(text, "0.0");
}

static void add_vertex(struct csg_text *text, const struct csg_chain *chain)
{
    const size_t num = csg_chain_handed(chain);
    csg_text_add(text,
                 "#define CSG_NUM_HANDED %zu\nflat out vec4 csg_handed[CSG_NUM_HANDED];\n"
                 "flat out int csg_rest;\n\n"
                 "void csg_hand_over(int begin, int end)\n{\n"
                 /* No vertex is below 0. The driver need not know that the first solid's place in
                  * the chain is 0: it would leave it out, and shared programs are to be alike. */
                 "    int p = begin + min(gl_VertexID, 0);\n"
                 "    ivec2 object = ivec2(begin, end);\n",
                 num);
    for (int i = 0; i < chain->handed; i++)
        add_reading(text, chain, i);
    for (size_t i = 0; i < num; i++) {
        csg_text_add(text, "    csg_handed[%zu] = vec4(", i);
        for (size_t j = 0; j < 4; j++) {
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
    size_t at = 0;
    for (int i = 0; i < chain->handed; i++) {
        add_slot(text, chain, i);
        for (const size_t end = at + find_slot(chain, i).size; at < end; at++) {
            csg_text_add(text, "    ");
            add_number(text, chain, at);
            csg_text_add(text, " = csg_handed[%zu].%c;\n", at / 4, "xyzw"[at % 4]);
        }
        if (has_quadric(chain, i))
            csg_text_add(text, "    q%d.w = h%d.x;\n", i, i);
        else if (chain->normals)
            csg_text_add(text, "    u%d = v%d = w%d = vec3(0.0);\n", i, i, i);
    }
    if (chain->slots > chain->handed)
        csg_text_add(text, "    int p = csg_rest;\n");
    for (int i = chain->handed; i < chain->slots; i++)
        add_reading(text, chain, i);
}

/* Where the ray is inside of the slot's solid. */
static void add_span(struct csg_text *text, const struct csg_chain *chain, int i)
{
    csg_text_add(text, "    csg_span l%d = csg_chain_planes(e%d, x%d, d);\n", i, i, i);
    if (has_quadric(chain, i))
        csg_text_add(text, "    csg_clip_quadric(csg_quadric(q%d, r%d, s%d, d), 4, l%d);\n", i, i,
                     i, i);
}

/* The first slot is a solid's. */
static void add_spans(struct csg_text *text, const struct csg_chain *chain)
{
    for (int i = 0; i < chain->slots; i++) {
        add_span(text, chain, i);
        if (i == 0)
            csg_text_add(text, "    const bool c0 = false;\n    vec2 whole = l0.key;\n");
        else
            csg_text_add(text,
                         "    bool c%d = h%d.x >= float(CSG_CHAIN_NEGATED);\n"
                         "    vec2 o%d = csg_chain_hole(c%d, l%d, whole);\n",
                         i, i, i, i, i);
    }
}

/* ---- clauses: see shaders/csg/clauses.glsl -------------------------------------------------- */

static void add_literals(struct csg_text *text, const struct csg_chain *chain)
{
    for (int i = 0; i < chain->slots; i++) {
        add_span(text, chain, i);
        csg_text_add(text,
                     "    bool c%d = csg_clause_negated(h%d);\n"
                     "    int g%d = csg_clause_of(h%d);\n",
                     i, i, i, i);
    }
}

/* Those that hold just after k, or just before, as the bits of a variable. */
static void add_holding(struct csg_text *text, const struct csg_chain *chain, const char *name,
                        const char *when, const char *k)
{
    csg_text_add(text, "%s = ", name);
    for (int i = 0; i < chain->slots; i++)
        csg_text_add(text, "%scsg_clause_%s(c%d, l%d, %s, %d)", i ? " | " : "", when, i, i, k,
                     1 << i);
    csg_text_add(text, ";\n");
}

/* The first key at which all clauses hold, of those at which a literal begins to. */
static void add_first(struct csg_text *text, const struct csg_chain *chain)
{
    csg_text_add(text, "    int flip = csg_clause_flip(h0), holding;\n    float at;\n"
                       "    k = CSG_NEVER;\n");
    for (int i = 0; i < chain->slots; i++) {
        csg_text_add(text, "    at = csg_clause_begin(c%d, l%d);\n    ", i, i);
        add_holding(text, chain, "holding", "after", "at");
        csg_text_add(text, "    holding ^= flip;\n    k = (");
        for (int j = 0; j < chain->slots; j++)
            csg_text_add(text, "%s(holding & g%d) != 0", j ? " && " : "", j);
        csg_text_add(text, ") != (flip != 0) ? min(k, at) : k;\n");
    }
    csg_text_add(text, "    if (!(k < csg_screen_key.z))\n        return false;\n");
}

/* Literals that have begun to hold, and whose clauses then have: of a union none held before, of an
 * intersection all do behind. */
static void add_changes(struct csg_text *text, const struct csg_chain *chain)
{
    csg_text_add(text, "    int ");
    add_holding(text, chain, "before", "before", "k");
    csg_text_add(text, "    int ");
    add_holding(text, chain, "after", "after", "k");
    csg_text_add(text, "    int begun = after & ~before, other = flip != 0 ? ~after : before;\n"
                       "    int least = 8;\n");
    for (int i = 0; i < chain->slots; i++)
        csg_text_add(text,
                     "    int o%d = (begun & %d) != 0 && (other & g%d) == 0 ? "
                     "csg_clause_order(h%d) : 8;\n    least = min(least, o%d);\n",
                     i, 1 << i, i, i, i);
}

static void add_search(struct csg_text *text, const struct csg_chain *chain)
{
    static const size_t slots[] = {1, 2, 3, 4, 5, 6};
    csg_text_add_passing(text, "o%zu", slots, (size_t)chain->slots - 1);
}

/* Whether it is the literal's face that shows: it has begun to hold. */
static void add_change(struct csg_text *text, const struct csg_chain *chain, int i)
{
    if (chain->clauses)
        csg_text_add(text, "    bool m%d = o%d == least;\n", i, i);
    else
        csg_text_add(text, "    bool m%d = csg_chain_changes(c%d, l%d, k);\n", i, i, i);
}

/* The face; of several, of the first. */
static void add_face(struct csg_text *text, const struct csg_chain *chain)
{
    for (int i = chain->slots; i-- > 0;) {
        add_change(text, chain, i);
        csg_text_add(text, "    place = m%d ? csg_chain_place(c%d, h%d, l%d) : place;\n", i, i, i,
                     i);
        if (chain->colors)
            csg_text_add(text, "    csg_tint = m%d ? t%d : csg_tint;\n", i, i);
        for (int j = 0; j < 3 && chain->normals; j++)
            csg_text_add(text, "    csg_bend_%c = m%d ? %c%d : csg_bend_%c;\n", "uvw"[j], i,
                         "uvw"[j], i, "uvw"[j]);
    }
    csg_text_add(text, "    return true;\n}\n");
}

static void add_fragment(struct csg_text *text, const struct csg_chain *chain)
{
    if (chain->colors)
        csg_text_add(text, "#define CSG_KNOWS_COLORS\nvec3 csg_tint = vec3(0.0);\n");
    if (chain->normals)
        csg_text_add(text, "#define CSG_KNOWS_BENDS\nvec3 csg_bend_u = vec3(0.0), "
                           "csg_bend_v = vec3(0.0), csg_bend_w = vec3(0.0);\n");
    csg_text_add(text,
                 "#define CSG_KNOWS_NORMALS\n"
                 "#define CSG_NUM_HANDED %zu\nflat in vec4 csg_handed[CSG_NUM_HANDED];\n"
                 "flat in int csg_rest;\n\n"
                 "bool csg_resolve(ivec3 object, vec2 d, out float k, out ivec2 place,"
                 " out bool inside)\n{\n    inside = false;\n    place = ivec2(0);\n",
                 csg_chain_handed(chain));
    add_slots(text, chain);
    if (chain->clauses) {
        add_literals(text, chain);
        add_first(text, chain);
        add_changes(text, chain);
    } else {
        add_spans(text, chain);
        add_search(text, chain);
    }
    add_face(text, chain);
}

void csg_source_chain(struct csg_text *vertex, struct csg_text *fragment,
                      const struct csg_chain *chain)
{
    add_vertex(vertex, chain);
    add_fragment(fragment, chain);
}
