/* SPDX-License-Identifier: MIT */
/*
 * For each set of flat inputs llvmpipe compiles code for the set-up of triangles anew, 4 to 10 ms
 * that no cache keeps. Programs that all scenes share (CSG_SHARED) therefore have the same inputs
 * there, or the same larger ones where the vertex stage reads an object's texels: csg_spare has
 * what an object does not need. The fewer there are, the sooner is the vertex stage compiled.
 */
#ifndef CSG_HAS_LIGHT
flat in vec4 csg_lit;
#endif
#ifndef CSG_HAS_REST
flat in int csg_rest;
#endif

/* Never true, but depends on each number: the driver leaves out what is not looked at. */
bool csg_is_no_number(vec4 object)
{
    vec4 sum = object + csg_screen_depth + csg_screen_key + csg_lit +
               vec4(csg_screen_place, float(csg_rest));
#ifdef CSG_NUM_HANDED
    for (int i = 0; i < CSG_NUM_HANDED; i++)
        sum += csg_handed[i];
#endif
#if CSG_NUM_SPARE > 0
    for (int i = 0; i < CSG_NUM_SPARE; i++)
        sum += csg_spare[i];
#endif
    return any(isnan(sum));
}
