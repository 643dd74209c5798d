/* SPDX-License-Identifier: MIT */
/*
 * From cell to cell along the ray (src/cells/cells.h), by splits. s is the depth from that of the
 * box's center. Where a cell's tree is false up to the key at which the ray leaves it, the next
 * cell's goes on there: trees hold somewhat beyond their cells, so where exactly the ray changes
 * from one to the other does not matter.
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

/* Where the ray is in the tree: a node, and the depth at which it leaves the node's part. */
struct csg_walk {
    int node;
    float exit;
};

/*
 * The last splits on the way down that the ray has not left yet, and behind them the root: where
 * there were more, the way is found from there (Horn et al. 2007, "Interactive k-D tree GPU
 * raytracing"). llvmpipe reads and writes an array pixel by pixel; these stay in registers.
 */
struct csg_trail {
    ivec4 nodes;
    vec4 exits;
};

void csg_trail_push(csg_walk at, inout csg_trail trail)
{
    trail.nodes = ivec4(at.node, trail.nodes.xyz);
    trail.exits = vec4(at.exit, trail.exits.xyz);
}

csg_walk csg_trail_pop(csg_walk root, inout csg_trail trail)
{
    csg_walk at = csg_walk(trail.nodes.x, trail.exits.x);
    trail.nodes = ivec4(trail.nodes.yzw, root.node);
    trail.exits = vec4(trail.exits.yzw, root.exit);
    return at;
}

bool csg_resolve(ivec3 object, vec2 d, out float k, out ivec2 place, out bool inside)
{
    vec3 org = csg_handed[0].xyz + (d.x * csg_handed[1].xyz + d.y * csg_handed[2].xyz);
    vec3 dir = csg_handed[3].xyz + (d.x * csg_handed[4].xyz + d.y * csg_handed[5].xyz);
    vec3 inverse = csg_walk_inverse(dir);
    vec3 a = (-csg_handed[6].xyz - org) * inverse, b = (csg_handed[6].xyz - org) * inverse;
    vec3 near = min(a, b), far = max(a, b);
    float s = max(max(near.x, near.y), near.z);
    csg_walk root = csg_walk(int(csg_handed[3].w), min(min(far.x, far.y), far.z)), at = root;
    csg_trail trail = csg_trail(ivec4(root.node), vec4(root.exit));
    bool found = false;
    inside = false;
    k = csg_walk_key(s);
    while (s < root.exit && !found && csg_walk_turns < CSG_MAX_WALK_TURNS) {
        csg_walk_turns += 3; /* and the ends of the loops within */
        /* To the next cell in which something is. */
        vec4 texel;
        bool searches = true;
        while (searches) {
            texel = csg_cell_texel(at.node);
            int code = int(texel.w), axis = code & 3;
            csg_walk_turns++;
            if (axis == 3) {
                searches = texel.x == texel.y && at.exit < root.exit;
                if (texel.x == texel.y) {
                    s = at.exit;
                    at = csg_trail_pop(root, trail);
                }
            } else {
                float o = axis == 0 ? org.x : axis == 1 ? org.y : org.z;
                float i = axis == 0 ? inverse.x : axis == 1 ? inverse.y : inverse.z;
                vec3 places = (texel.xyz - o) * i;
                bvec3 ahead = greaterThan(places, vec3(s));
                int num = int(ahead.x) + int(ahead.y) + int(ahead.z);
                vec3 ends = mix(vec3(CSG_KEY_MAX), places, ahead);
                float leaves = min(ends.x, min(ends.y, min(ends.z, CSG_KEY_MAX)));
                if (leaves < at.exit) {
                    csg_trail_push(at, trail);
                    at.exit = leaves;
                }
                at.node = root.node + code - axis + (i > 0.0 ? 3 - num : num);
            }
        }
        if (s < root.exit) {
            float last = csg_walk_key(at.exit);
            k = max(k, csg_walk_key(s));
            found = csg_cell_search(root.node + int(texel.x), root.node + int(texel.y), object.y, d,
                                    last, k, place);
            s = at.exit;
            at = csg_trail_pop(root, trail);
        }
    }
    if (!found && csg_walk_turns >= CSG_MAX_WALK_TURNS) {
        csg_give_up();
        return true;
    }
    place = csg_cell_face(place, object.y, d);
    return found && k < csg_screen_key.z;
}
