// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// `clustered`: as `example2`, with the points of either sphere in clusters. Point i belongs to cluster
/// i mod `clusters` and is
///
///     (m + spread · g / √n) / |m + spread · g / √n|,      g standard normal, m the cluster's direction;
///
/// clusters come in antipodal pairs ±m with m uniform on the sphere, so that Q surrounds the origin however
/// few they are. Fewer than 2n clusters make Q almost flat: d grows like 1 / spread.
Component<Generator> clustered_generator();

}  // namespace raygauge
