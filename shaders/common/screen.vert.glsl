/* SPDX-License-Identifier: MIT */
/*
 * Hands over to the fragments what common/screen.glsl and common/light.glsl declare. llvmpipe
 * fetches a uniform for each lane of a fragment program, in some thirty instructions a number; a
 * flat input is simply there.
 */

uniform vec4 csg_view_depth;
uniform vec4 csg_view_key;
uniform vec2 csg_window;      /* of the strip that is drawn, in the whole picture */
uniform vec2 csg_at;          /* the reference pixel */
uniform float csg_depth_bias; /* overlays win over what they repeat */
uniform vec4 csg_light;

flat out vec4 csg_screen_depth;
flat out vec4 csg_screen_key;
flat out vec3 csg_screen_place;
flat out vec4 csg_lit;

void csg_hand_screen()
{
    csg_screen_depth = csg_view_depth;
    csg_screen_key = csg_view_key;
    csg_screen_place = vec3(csg_window - csg_at, csg_depth_bias);
    csg_lit = csg_light;
}
