/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_WIDE_H
#define CSG_COMMON_WIDE_H

/*
 * Loops of fixed form without branches, for the compiler to make vectors of. WIDE functions are
 * compiled for twice as wide ones, too, where the processor has them; the choice is made when the
 * library is loaded, which the sanitizers do not bear. Static: gcc exports clones of what is not.
 * What they call is PART. Files with them have options of their own in cmake/library.cmake.
 */
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) &&   \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WIDE static __attribute__((target_clones("avx2", "default")))
#define PART static inline __attribute__((always_inline))
#else
#define WIDE static
#define PART static
#endif

#endif
