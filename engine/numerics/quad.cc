// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/numerics/quad.h"

#ifdef __SIZEOF_FLOAT128__
// GCC's quadruple precision library; its header <quadmath.h> is out of other compilers' reach.
extern "C" {
raygauge::Quad sqrtq(raygauge::Quad) noexcept;
raygauge::Quad powq(raygauge::Quad, raygauge::Quad) noexcept;
}
#endif

namespace raygauge::elementary {

#ifdef __SIZEOF_FLOAT128__
Quad sqrt(Quad x) noexcept { return sqrtq(x); }
Quad pow(Quad x, Quad y) noexcept { return powq(x, y); }
#else
Quad sqrt(Quad x) noexcept { return std::sqrt(x); }
Quad pow(Quad x, Quad y) noexcept { return std::pow(x, y); }
#endif

}  // namespace raygauge::elementary
