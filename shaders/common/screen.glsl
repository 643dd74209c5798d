/* SPDX-License-Identifier: MIT */
/* Pixels and depth keys k, as src/pack/screen.h defines them; from common/screen.vert.glsl. */

/* Scale, offset, key where rays start, 0: affine, 1: of 1/t, 2: of all t. */
flat in vec4 csg_screen_depth;
flat in vec4 csg_screen_key;   /* a, b, key at infinity, 1: orthographic */
flat in vec3 csg_screen_place; /* the strip's first pixel from the reference one, bias of depths */

/* The pixel, from the reference pixel: whole numbers and a half, so exact. */
vec2 csg_pixel()
{
    return gl_FragCoord.xy + csg_screen_place.xy;
}

/* Depth buffer value of a key: 0 near, 1 far. */
float csg_depth(csg_real k)
{
    if (csg_screen_depth.w == 0.0) {
        csg_exact csg_real depth = csg_screen_depth.x * k + csg_screen_depth.y;
        return clamp(float(depth), 0.0, 1.0);
    }
    if (csg_screen_depth.w == 1.0) {
        csg_exact csg_real over = 1.0 + (csg_screen_key.x - k) * csg_screen_depth.x;
        return float(1.0 / over);
    }
    csg_real s = k * csg_screen_depth.x;
    return float(0.5 + 0.5 * s / (1.0 + abs(s)));
}

/* Distance along the view axis. */
float csg_distance(float k)
{
    return csg_screen_key.w != 0.0 ? k + csg_screen_key.x
                                   : csg_screen_key.y / (csg_screen_key.x - k);
}
