// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The vector kernels, written once and compiled once per instruction set: each including file defines
// RAYGAUGE_ISA (a namespace) and RAYGAUGE_WIDTH (doubles in a register). Nothing of the standard library is
// called from here, so that no inline function compiled for a newer machine can leak into the portable part
// of the program.
#pragma once

#include "engine/kernels/box_separation_kernels.h"
#include "engine/kernels/certificate_kernels.h"
#include "engine/kernels/facet_walk_kernels.h"
#include "engine/kernels/gram_kernels.h"
#include "engine/kernels/hull_separation_kernels.h"
#include "engine/kernels/inverse_kernels.h"
#include "engine/kernels/mesh_kernels.h"
#include "engine/kernels/orthogonal_kernels.h"
#include "engine/kernels/plane_pass_kernels.h"
#include "engine/kernels/simplex_kernels.h"
#include "engine/kernels/twofold_basis_kernels.h"
#include "engine/kernels/twofold_kernels.h"

namespace raygauge::RAYGAUGE_ISA {

extern const Kernels kKernels;
const Kernels kKernels = {kWidth,
                          price,
                          best_vertex,
                          price_lanes,
                          best_of_lanes,
                          collect<double>,
                          collect<float>,
                          pivot,
                          walk_facets,
                          find_beyond,
                          add_to_walk,
                          simplex_loop,
                          norms,
                          subtract_collected,
                          sum_rows,
                          largest_sums,
                          refine,
                          refine_twofold,
                          residual_twofold,
                          duals_twofold,
                          duals,
                          pack_points,
                          add_panels,
                          pack_columns,
                          factor_columns,
                          add_weighted<double>,
                          add_weighted<float>,
                          products<double>,
                          products<float>,
                          project_out,
                          rotate,
                          add_multiple,
                          back_substitute,
                          invert,
                          eliminate_panel,
                          apply_panel,
                          undo_exchanges,
                          products_twofold,
                          multiply_twofold,
                          subtract_product_twofold,
                          separate_boxes,
                          separate_box_from_capsule,
                          separate_capsules,
                          separate_hulls,
                          bound_boxes,
                          bound_block,
                          bound_triangles};

}  // namespace raygauge::RAYGAUGE_ISA
