/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_ARRAY_H
#define CSG_COMMON_ARRAY_H

#include <stdbool.h>
#include <stddef.h>

/*
 * Growable arrays: a pointer, a count and a capacity side by side, declared by CSG_ARRAY.
 *
 *     CSG_ARRAY(struct csg_plane) planes = {0};
 *     if (!csg_array_push(&planes, plane)) ... out of memory
 *     free(planes.data);
 */
#define CSG_ARRAY(type)                                                                            \
    struct {                                                                                       \
        type *data;                                                                                \
        size_t num, capacity;                                                                      \
    }

/* Makes room for extra more elements of the given size; false when memory is out. */
bool csg_array_grow(void **data, size_t *capacity, size_t num, size_t extra, size_t element_size);

#define csg_array_reserve(array, extra)                                                            \
    ((array)->num + (extra) <= (array)->capacity ||                                                \
     csg_array_grow((void **)&(array)->data, &(array)->capacity, (array)->num, (extra),            \
                    sizeof *(array)->data))

/* Gives back what is reserved beyond the elements. */
void csg_array_shrink(void **data, size_t *capacity, size_t num, size_t element_size);

#define csg_array_trim(array)                                                                      \
    csg_array_shrink((void **)&(array)->data, &(array)->capacity, (array)->num,                    \
                     sizeof *(array)->data)

#define csg_array_push(array, value)                                                               \
    (csg_array_reserve(array, 1) ? ((array)->data[(array)->num++] = (value), true) : false)

#endif
