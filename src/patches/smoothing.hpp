// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "planescope/cloud.hpp"

namespace planescope {

/// Thins the walls of a map whose points scatter across the surface more widely than they lie apart
/// along it, as depth images do that were put together without fusion: patches fitted within such a
/// slab have any normal. Each point is projected onto the plane through its surroundings, some
/// rounds long, after the moving least-squares surfaces of Alexa et al. (IEEE VIS 2001).
///
/// The surroundings are cells of edge `cell`, 2 `cell` and 4 `cell`, spread to their neighbours
/// twice (a window of about 1.2 cells, standard deviation). A point takes the smallest window that
/// is nearly as flat (ratio of thickness to width) as the flattest one: noise looks flatter the
/// wider the window, a corner the same at every width, so corners keep the smallest and stay sharp.
/// \param cell [m] edge of the smallest cells, about the noise. \returns the cloud with its
/// positions moved, without labels; where the cloud has them, colours; non-finite points stay as
/// they are. Same bytes at any thread count.
PointCloud smooth_points(const PointCloud& cloud, double cell);

}  // namespace planescope
