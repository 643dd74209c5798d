/* SPDX-License-Identifier: MIT */
/*
 * Algorithm 4 of "GPU Objects" (Ranta et al. 2006), generalised to any tree: collect the crossings
 * of all solids, sort them by insertion, walk them and evaluate the tree where its literals change.
 * The baseline that benchmarks compare with; csg/resolve.glsl is what it grew into.
 */

#define CSG_MAX_WORDS (CSG_MAX_CROSSINGS / 64 + 1)

/* Crossings in order: key and leaf. Global, since arrays are copied into functions. */
float csg_keys[CSG_MAX_CROSSINGS];
int csg_leaves[CSG_MAX_CROSSINGS];
int csg_num_crossings;

void csg_insert(float key, int leaf)
{
    int i = csg_num_crossings++;
    for (; i > 0; i--) {
        float before = csg_keys[i - 1];
        if (before <= key)
            break;
        csg_keys[i] = before;
        csg_leaves[i] = csg_leaves[i - 1];
    }
    csg_keys[i] = key;
    csg_leaves[i] = leaf;
}

void csg_insert_span(vec2 span, int leaf)
{
    if (!(span.x < span.y))
        return;
    csg_insert(span.x, leaf);
    csg_insert(span.y, leaf);
}

void csg_collect(int begin, int end, vec2 d)
{
    csg_num_crossings = 0;
    int leaf = 0;
    for (int p = begin; p < end;) {
        vec4 head = csg_texel(p);
        if ((int(head.z) & CSG_RECORD_POP) != 0) {
            p++;
            continue;
        }
        csg_span span = csg_whole_ray();
        csg_real2 gap;
        csg_read_leaf(p, head, d, span, gap);
        if (gap.x < gap.y) {
            csg_insert_span(vec2(span.key.x, min(span.key.y, gap.x)), leaf);
            csg_insert_span(vec2(max(span.key.x, gap.y), span.key.y), leaf);
        } else {
            csg_insert_span(span.key, leaf);
        }
        leaf++;
    }
}

/* The plus and minus counters, for a tree: its value where the bits say which leaves hold. */
uint csg_holds[CSG_MAX_WORDS]; /* a bit for each leaf that the ray is inside of */

bool csg_program_holds(int begin, int end)
{
    bool stack[CSG_STACK_SIZE];
    int top = 0, leaf = 0;
    bool result = false;
    for (int p = begin; p < end;) {
        vec4 head = csg_texel(p);
        int flags = int(head.z);
        bool value;
        p += 1 + int(head.x) + int(head.y);
        if ((flags & CSG_RECORD_POP) != 0) {
            value = result;
            result = stack[--top];
        } else {
            bool holds = (csg_holds[leaf >> 5] >> uint(leaf & 31) & 1u) != 0u;
            value = holds != ((flags & CSG_RECORD_NEGATED) != 0);
            p += (flags & CSG_RECORD_QUADRIC) != 0 ? CSG_QUADRIC_TEXELS : 0;
            leaf++;
        }
        if ((flags & CSG_RECORD_PUSH) != 0)
            stack[top++] = result;
        if ((flags & CSG_RECORD_START) != 0)
            result = value;
        else
            result = (flags & CSG_RECORD_AND) != 0 ? result && value : result || value;
    }
    return result;
}

bool csg_resolve(ivec3 object, vec2 d, out csg_real k, out ivec2 place, out bool from_inside)
{
    int begin = object.x, end = object.y;
    csg_collect(begin, end, d);
    for (int i = 0; i < CSG_MAX_WORDS; i++)
        csg_holds[i] = 0u;
    int i = 0;
    /* Those behind the ray's start: it may be inside there. */
    for (; i < csg_num_crossings && csg_keys[i] <= csg_screen_depth.z; i++)
        csg_holds[csg_leaves[i] >> 5] ^= 1u << uint(csg_leaves[i] & 31);
    from_inside = csg_program_holds(begin, end);
    while (i < csg_num_crossings && csg_keys[i] < csg_screen_key.z) {
        k = csg_keys[i];
        for (; i < csg_num_crossings && csg_keys[i] == k; i++) /* equal crossings are one event */
            csg_holds[csg_leaves[i] >> 5] ^= 1u << uint(csg_leaves[i] & 31);
        if (csg_program_holds(begin, end) != from_inside) {
            place = csg_program_change(begin, end, d, k, from_inside);
            return true;
        }
    }
    return false;
}
