// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/registry.h"
#include "generators/component.h"

#include "generators/hard/axial.h"
#include "generators/hard/boxes.h"
#include "generators/hard/origin.h"
#include "generators/hard/planted.h"
#include "generators/hard/rounded.h"
#include "generators/hard/smooth.h"
#include "generators/hard/thin.h"
#include "generators/hard/ties.h"

namespace raygauge {

void register_hard_generators(GeneratorRegistry& registry) {
  registry.add(with_known_distance(hard_box_generator()));
  registry.add(with_known_distance(hard_capsule_generator()));
  registry.add(with_known_distance(hard_contact_generator()));
  registry.add(with_known_distance(hard_cross_polytope_generator()));
  registry.add(with_known_distance(hard_duplicates_generator()));
  registry.add(with_known_distance(hard_ellipsoid_generator()));
  registry.add(with_known_distance(hard_far_generator()));
  registry.add(with_known_distance(hard_flat_generator()));
  registry.add(with_known_distance(hard_lattice_generator()));
  registry.add(hard_low_rank_generator());
  registry.add(hard_minkowski_difference_generator());
  registry.add(hard_moment_curve_generator());
  registry.add(with_known_distance(hard_near_axis_generator()));
  registry.add(with_known_distance(hard_near_face_generator()));
  registry.add(hard_needle_generator());
  registry.add(with_known_distance(hard_origin_in_object_generator()));
  registry.add(with_known_distance(hard_origin_near_facet_generator()));
  registry.add(with_known_distance(hard_origin_on_boundary_generator()));
  registry.add(with_known_distance(hard_origin_outside_generator()));
  registry.add(with_known_distance(hard_p_norm_ball_generator()));
  registry.add(with_known_distance(hard_planted_origin_generator()));
  registry.add(with_known_distance(hard_planted_ties_generator()));
  registry.add(with_known_distance(hard_planted_unimodular_generator()));
  registry.add(with_known_distance(hard_planted_unreachable_generator()));
  registry.add(with_known_distance(hard_point_generator()));
  registry.add(hard_polygons_generator());
  registry.add(with_known_distance(hard_scaled_generator()));
  registry.add(with_known_distance(hard_scaled_object_generator()));
  registry.add(with_known_distance(hard_scaled_simplex_generator()));
  registry.add(with_known_distance(hard_tangent_disc_generator()));
  registry.add(with_known_distance(hard_truncated_cone_generator()));
  registry.add(with_known_distance(hard_vertex_generator()));
}

}  // namespace raygauge
