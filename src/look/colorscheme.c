/* SPDX-License-Identifier: MIT */
#include "look/colorscheme.h"

#include <stddef.h>
#include <string.h>
#include <strings.h>

#define RGB(hex)                                                                                   \
    {                                                                                              \
        (float)((hex) >> 16 & 255) / 255, (float)((hex) >> 8 & 255) / 255,                         \
            (float)((hex)&255) / 255                                                               \
    }

static const struct csg_colorscheme schemes[] = {
    {"Cornfield", RGB(0xffffe5), RGB(0xf9d72c), RGB(0x9dcb51)},
    {"Metallic", RGB(0xaaaaff), RGB(0xddddff), RGB(0xdd22dd)},
    {"Sunset", RGB(0xaa4444), RGB(0xffaaaa), RGB(0x882233)},
    {"Starnight", RGB(0x000000), RGB(0xffffe0), RGB(0x00ffff)},
    {"BeforeDawn", RGB(0x333333), RGB(0xcccccc), RGB(0x5563dd)},
    {"Nature", RGB(0xfafafa), RGB(0x16a085), RGB(0xdbf4da)},
    {"DeepOcean", RGB(0x333333), RGB(0xeeeeee), RGB(0x0babc8)},
    {"Solarized", RGB(0xfdf6e3), RGB(0xb58800), RGB(0x882233)},
    {"Tomorrow", RGB(0xf8f8f8), RGB(0x4271ae), RGB(0xf5871f)},
    {"Tomorrow Night", RGB(0x1d1f21), RGB(0x81a2be), RGB(0xde935f)},
    {"Monotone", RGB(0xffffe5), RGB(0xf9d72c), RGB(0xf9d72c)},
};

#define NUM_SCHEMES (sizeof schemes / sizeof *schemes)

/* Colours of the % and # overlays of solids without color() (OpenSCAD's renderer.cc). */
static const float background_color[4] = {180 / 255.f, 180 / 255.f, 180 / 255.f, 128 / 255.f};
static const float highlight_color[4] = {255 / 255.f, 81 / 255.f, 81 / 255.f, 128 / 255.f};

const char *csgcast_colorscheme_name(size_t index)
{
    return index < NUM_SCHEMES ? schemes[index].name : NULL;
}

const struct csg_colorscheme *csg_colorscheme_find(const char *name)
{
    if (!name)
        return &schemes[0];
    for (size_t i = 0; i < NUM_SCHEMES; i++)
        if (strcasecmp(schemes[i].name, name) == 0)
            return &schemes[i];
    return NULL;
}

void csg_face_color(const struct csg_colorscheme *scheme, const struct csg_leaf *leaf,
                    const struct csg_leaf *minuend, enum csg_layer layer, bool subtracted,
                    float rgba[4])
{
    bool cut = subtracted != leaf->is_hole;
    if (cut && minuend) {
        leaf = minuend;
        cut = false;
    }
    const float *base = cut ? scheme->cut : scheme->face;
    const float opaque[4] = {base[0], base[1], base[2], 1};
    const float *fallback = layer == CSG_LAYER_HIGHLIGHT    ? highlight_color
                            : layer == CSG_LAYER_BACKGROUND ? background_color
                                                            : opaque;
    const bool own = layer != CSG_LAYER_HIGHLIGHT;
    for (int i = 0; i < 4; i++)
        rgba[i] = own && leaf->color[i] >= 0 ? leaf->color[i] : fallback[i];
    const bool has_alpha = leaf->color[0] >= 0 || leaf->color[3] < 1;
    if (layer == CSG_LAYER_BACKGROUND && !has_alpha)
        rgba[3] = background_color[3];
}

double csg_light_factor(const struct csgcast_frustum *frustum, struct csg_vec3 normal)
{
    const double *r = frustum->right, *u = frustum->up, *f = frustum->forward;
    const double x = normal.x * r[0] + normal.y * r[1] + normal.z * r[2];
    const double y = normal.x * u[0] + normal.y * u[1] + normal.z * u[2];
    const double z = -(normal.x * f[0] + normal.y * f[1] + normal.z * f[2]);
    return CSG_LIGHT_AMBIENT + fabs(x * CSG_LIGHT_X + y * CSG_LIGHT_Y + z * CSG_LIGHT_Z);
}

void csg_color_bytes(uint8_t *bytes, const float *components, size_t num)
{
    for (size_t i = 0; i < num; i++) {
        const float value = components[i];
        bytes[i] = (uint8_t)(value > 0 ? (value < 1 ? value * 255 + 0.5f : 255) : 0);
    }
}
