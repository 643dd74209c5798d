/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include "messages.h"

#include <stdlib.h>

bool csg_picture_has_aov(const struct csgcast_write_params *write)
{
    return write->write_z || write->write_normal || write->write_id;
}

bool csg_picture_is_possible(const struct csg_cli_options *options)
{
    if (!csg_picture_has_aov(&options->write) || options->antialias <= 1)
        return true;
    csg_cli_error("--antialias is for colours: the mean of several rays' Z, N or id is that of no "
                  "surface; write them to a file of their own, without it");
    return false;
}

/* wanted: false leaves the channel NULL, which is no failure. */
static bool allocate_channel(float **channel, bool wanted, size_t num)
{
    *channel = wanted ? calloc(num, sizeof **channel) : NULL;
    return *channel || !wanted;
}

bool csg_picture_allocate(struct csgcast_image *image, const struct csgcast_view *view,
                          const struct csgcast_write_params *write, bool bytes)
{
    const size_t num = (size_t)view->width * (size_t)view->height;
    *image = (struct csgcast_image){.rgba8 = bytes ? calloc(num, 4) : NULL};
    if ((image->rgba8 || !bytes) && allocate_channel(&image->rgba, !bytes, 4 * num) &&
        allocate_channel(&image->z, write->write_z, num) &&
        allocate_channel(&image->normal, write->write_normal, 3 * num) &&
        allocate_channel(&image->id, write->write_id, num))
        return true;
    csg_cli_error("out of memory for an image of %d x %d pixels", view->width, view->height);
    csg_picture_free(image);
    return false;
}

void csg_picture_free(struct csgcast_image *image)
{
    free(image->rgba);
    free(image->rgba8);
    free(image->z);
    free(image->normal);
    free(image->id);
    *image = (struct csgcast_image){0};
}
