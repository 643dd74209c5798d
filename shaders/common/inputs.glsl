/* SPDX-License-Identifier: MIT */
/*
 * For each set of flat inputs llvmpipe compiles code for the set-up of triangles anew, 4 to 10 ms
 * that no cache keeps. Programs that all scenes share (CSG_SHARED) and whose vertex stage reads
 * nothing of an object therefore have the same inputs. Each input costs about a millisecond where
 * the vertex stage is compiled, so those that read an object's texels have what they need.
 */
#ifndef CSG_HAS_LIGHT
flat in vec4 csg_lit;
#endif

/* Never true, but depends on each number: the driver leaves out what is not looked at. */
bool csg_is_no_number(vec4 object)
{
    return any(isnan(object + csg_screen_depth + csg_screen_key + csg_lit +
                     vec4(csg_screen_place, 0.0)));
}
