/* SPDX-License-Identifier: MIT */
#include "libfive_wrap.h"

#include <atomic>
#include <cstring>
#include <libfive.h>
#include <libfive/render/discrete/heightmap.hpp>
#include <libfive/tree/tree.hpp>
#include <thread>

bool libfive_heightmap(const void *tree, const struct libfive_view *view, unsigned char *rgba)
{
    try {
        const Eigen::Vector3f lower(view->lower), upper(view->upper);
        // As many voxels as asked: libfive rounds their number up.
        const Eigen::Vector3f num =
            Eigen::Map<const Eigen::Vector3i>(view->num).cast<float>().array() - 0.01F;
        const libfive::Voxels box(lower, upper, num.cwiseQuotient(upper - lower));
        const std::atomic_bool abort(false);
        const auto map =
            libfive::Heightmap::render(libfive::Tree(static_cast<libfive_tree>(tree)), box, abort,
                                       std::thread::hardware_concurrency());
        for (int y = 0; y < view->num[1]; y++)
            for (int x = 0; x < view->num[0]; x++, rgba += 4) {
                std::memcpy(rgba, &map->norm(y, x), 4);
                rgba[3] = map->depth(y, x) >= view->lower[2] ? 255 : 0;
            }
        return true;
    } catch (...) {
        return false;
    }
}
