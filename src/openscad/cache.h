/* SPDX-License-Identifier: MIT */
#ifndef CSG_OPENSCAD_CACHE_H
#define CSG_OPENSCAD_CACHE_H

/*
 * What openscad made of subtrees, kept on disk by content. An entry is a file named by a hash of
 * its key; it holds the whole key, so that a hash that two keys share is a miss and no mistake.
 * Nothing here is an error for the user: a cache that cannot be read is empty, one that cannot be
 * written is not written.
 */

#include "common/array.h"
#include "common/file.h"

struct csg_cache {
    char *folder;   /* absolute, without a / at its end; NULL: there is no cache */
    uint64_t limit; /* bytes */
};

/* folder, limit: as in struct csgcast_scene_params. */
void csg_cache_init(struct csg_cache *cache, const char *folder, uint64_t limit);
void csg_cache_finish(struct csg_cache *cache);

/* The value of the key; the caller frees value->data. false: there is none. A hit becomes the entry
 * used last. */
bool csg_cache_get(const struct csg_cache *cache, const struct csg_bytes *key,
                   struct csg_bytes *value);

/* Stores the value, then removes the entries not used for the longest time until all fit. */
void csg_cache_put(const struct csg_cache *cache, const struct csg_bytes *key,
                   const struct csg_bytes *value);

#endif
