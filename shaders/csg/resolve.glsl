/* SPDX-License-Identifier: MIT */
/* The first change of the solid along the ray, by interval jumping. */

/* Where the solid, seen from outside, begins; seen from inside, ends. False: nowhere in view. Out
 * of turns, the answer means nothing. CSG_REAR: where it ends for the first time, seen from
 * outside. */
bool csg_resolve(ivec3 object, vec2 d, out csg_real k, out ivec2 place, out bool inside)
{
    int begin = object.x, end = object.y;
    k = csg_screen_depth.z;
    inside = false;
    for (;;) {
        if (!csg_may_look(object.z))
            return true;
        csg_real next = csg_program_next(begin, end, d, k, inside);
        if (!(next > k)) {
#ifdef CSG_REAR
            if (inside)
                break;
            if (!(k > csg_screen_depth.z))
                return false;
#else
            if (inside || k > csg_screen_depth.z)
                break;
#endif
            inside = true; /* already at the start: where does it end? */
            continue;
        }
        k = next;
        if (k >= csg_screen_key.z)
            return false;
    }
    place = csg_program_change(begin, end, d, k, inside);
    return true;
}
