/* SPDX-License-Identifier: MIT */
/* What needs double where the driver has none: every pixel of the rectangle is cast on the CPU. */

bool csg_resolve(ivec3 object, vec2 d, out csg_real k, out ivec2 place, out bool inside)
{
    csg_give_up();
    k = 0.0;
    place = ivec2(object.x, 0);
    inside = false;
    return true;
}
