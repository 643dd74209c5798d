/* SPDX-License-Identifier: MIT */
/*
 * Any bytes make a scene or messages: no crash, no leak, no hang. The first byte chooses the
 * parameters, the rest is the text.
 */
#include <stdint.h>

#include "csgcast/csgcast.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void ignore_message(void *user, enum csgcast_log_level level, enum csgcast_message id,
                           const char *text)
{
    (void)user;
    (void)level;
    (void)id;
    (void)text;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct csgcast_scene_params params = {.log = ignore_message, .no_handoff = true};
    if (size == 0)
        return 0;
    params.facets = (enum csgcast_facets)(data[0] % 3);
    params.skip_unsupported = (data[0] & 4) != 0;
    csgcast_scene_destroy(csgcast_scene_parse((const char *)data + 1, size - 1, &params));
    return 0;
}
