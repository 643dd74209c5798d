/* SPDX-License-Identifier: MIT */
/* A surface of triangles alone, seen from outside: begins where its turns first differ from zero.
 */

bool csg_resolve(ivec3 object, vec2 d, out csg_real k, out ivec2 place, out bool inside)
{
    csg_surface_first first = csg_surface_first(-CSG_KEY_MAX, 0, ivec2(0));
    inside = false;
    do {
        if (!csg_may_look(object.z))
            return true;
        first = csg_surface_behind(object.x, d, first.key);
        k = first.key;
    } while (first.turns == 0 && k < csg_screen_key.z);
    place = ivec2(object.x, first.turns > 0 ? first.face.x : first.face.y);
    return k < csg_screen_key.z;
}
