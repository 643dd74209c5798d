/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_HEAP_H
#define CSG_COMMON_HEAP_H

/*
 * For processes that end soon: a heap that begins large, in huge pages, and is not given back. It
 * takes up to a fifth more memory. Where libc or the kernel knows no such thing nothing happens.
 */

void csg_heap_begin(void);

#endif
