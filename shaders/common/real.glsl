/* SPDX-License-Identifier: MIT */
/*
 * The numbers that keys are made of: float, or double in programs for objects that float does not
 * hold (docs/numerics.md). Their records then have two texels a term, its float and what is left.
 */

#ifdef CSG_DOUBLE
#define csg_real double
#define csg_real2 dvec2
#define csg_real3 dvec3
#define csg_real4 dvec4
#define CSG_TERM_TEXELS 2
#else
#define csg_real float
#define csg_real2 vec2
#define csg_real3 vec3
#define csg_real4 vec4
#define CSG_TERM_TEXELS 1
#endif

/* Of what faces that coincide must agree on to the last bit, in whatever programs: a compiler may
 * not join a product with a sum, or order sums anew, in one of them and not in another. */
#ifdef GL_ARB_gpu_shader5
#define csg_exact precise
#else
#define csg_exact
#endif

/* Term i of those that begin at texel p. */
csg_real4 csg_term(int p, int i)
{
#ifdef CSG_DOUBLE
    return dvec4(csg_texel(p + 2 * i)) + dvec4(csg_texel(p + 2 * i + 1));
#else
    return csg_texel(p + i);
#endif
}
