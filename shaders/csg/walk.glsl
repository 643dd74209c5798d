/* SPDX-License-Identifier: MIT */
/*
 * From cell to cell along the ray (src/cells/cells.h), by splits, with a stack of those that the
 * ray has not left yet. s is the depth from that of the box's center. Where a cell's tree is false
 * up to the key at which the ray leaves it, the next cell's goes on there: trees hold somewhat
 * beyond their cells, so where exactly the ray changes from one to the other does not matter.
 */

#define CSG_NUM_HANDED CSG_WALK_HEADER
flat in vec4 csg_handed[CSG_NUM_HANDED];

float csg_walk_key(float s)
{
    return (csg_handed[0].w + csg_handed[1].w * s) / (1.0 + csg_handed[2].w * s);
}

/* Distances along the ray of places across one axis; a ray that runs along them meets none. */
vec3 csg_walk_inverse(vec3 dir)
{
    vec3 size = max(abs(dir), 1e-15);
    return mix(vec3(1.0), vec3(-1.0), lessThan(dir, vec3(0.0))) / size;
}

bool csg_resolve(ivec3 object, vec2 d, out float k, out ivec2 place, out bool inside)
{
    vec3 org = csg_handed[0].xyz + (d.x * csg_handed[1].xyz + d.y * csg_handed[2].xyz);
    vec3 dir = csg_handed[3].xyz + (d.x * csg_handed[4].xyz + d.y * csg_handed[5].xyz);
    vec3 inverse = csg_walk_inverse(dir);
    vec3 a = (-csg_handed[6].xyz - org) * inverse, b = (csg_handed[6].xyz - org) * inverse;
    vec3 near = min(a, b), far = max(a, b);
    float s = max(max(near.x, near.y), near.z), exit = min(min(far.x, far.y), far.z);
    int root = int(csg_handed[3].w), node = root;
    int nodes[CSG_WALK_DEPTH];
    float exits[CSG_WALK_DEPTH];
    int top = 0, begin = 0, end = 0;
    bool found = false, walks = s < exit;
    inside = false;
    k = csg_walk_key(s);
    while (walks && !found && csg_walk_turns < CSG_MAX_WALK_TURNS) {
        csg_walk_turns += 3; /* and the ends of the loops within */
        /* To the next cell in which something is. */
        bool searches = true;
        while (searches) {
            vec4 texel = csg_cell_texel(node);
            int code = int(texel.w), axis = code & 3;
            csg_walk_turns++;
            if (axis == 3) {
                begin = root + int(texel.x);
                end = root + int(texel.y);
                searches = begin == end && top > 0;
                if (begin == end) {
                    s = exit;
                    walks = top > 0;
                    if (top > 0) {
                        top--;
                        node = nodes[top];
                        exit = exits[top];
                    }
                }
            } else {
                float o = axis == 0 ? org.x : axis == 1 ? org.y : org.z;
                float i = axis == 0 ? inverse.x : axis == 1 ? inverse.y : inverse.z;
                vec3 at = (texel.xyz - o) * i;
                bvec3 ahead = greaterThan(at, vec3(s));
                int num = int(ahead.x) + int(ahead.y) + int(ahead.z);
                vec3 ends = mix(vec3(CSG_KEY_MAX), at, ahead);
                float leaves = min(min(ends.x, ends.y), ends.z);
                if (leaves < exit) {
                    nodes[top] = node;
                    exits[top] = exit;
                    top++;
                    exit = leaves;
                }
                node = root + code - axis + (i > 0.0 ? 3 - num : num);
            }
        }
        if (walks) {
            float last = csg_walk_key(exit);
            k = max(k, csg_walk_key(s));
            found = csg_cell_search(begin, end, object.y, d, last, k, place);
            s = exit;
            if (!found) {
                walks = top > 0;
                if (top > 0) {
                    top--;
                    node = nodes[top];
                    exit = exits[top];
                }
            }
        }
    }
    if (!found && csg_walk_turns >= CSG_MAX_WALK_TURNS) {
        csg_give_up();
        return true;
    }
    place = csg_cell_face(place, object.y, d);
    return found && k < csg_screen_key.z;
}
