/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_PREFETCH_H
#define CSG_COMMON_PREFETCH_H

/* Starts to fetch what will be read soon. */
#if defined(__GNUC__)
#define csg_prefetch(address) __builtin_prefetch(address)
#else
#define csg_prefetch(address) ((void)(address))
#endif

#endif
