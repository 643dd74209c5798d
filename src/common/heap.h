/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_HEAP_H
#define CSG_COMMON_HEAP_H

/* Where libc or the kernel knows no such things nothing happens. */

/* For processes that end soon: a heap that begins large, in huge pages, and is not given back. It
 * takes up to a fifth more memory. */

void csg_heap_begin(void);

/* For processes that draw frames: memory that one frame frees, some MB, stays for the next. */
void csg_heap_keep(void);

#endif
