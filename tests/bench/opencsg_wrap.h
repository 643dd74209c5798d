/* SPDX-License-Identifier: MIT */
#ifndef BENCH_OPENCSG_WRAP_H
#define BENCH_OPENCSG_WRAP_H

/* The little of OpenCSG's C++ interface that opencsg_peer.c needs. */

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct opencsg_product;

struct opencsg_product *opencsg_product_create(void);
void opencsg_product_destroy(struct opencsg_product *product);

/* A display list with one convex solid. */
bool opencsg_product_add(struct opencsg_product *product, unsigned list, bool subtracted);

/* Fills the depth buffer with the product's visible surface. */
void opencsg_product_render(const struct opencsg_product *product);

#ifdef __cplusplus
}
#endif

#endif
