// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/registry.h"

#include "generators/bodies.h"
#include "generators/clustered.h"
#include "generators/example1.h"
#include "generators/example2.h"
#include "generators/hard/registry.h"
#include "generators/needle.h"
#include "generators/random_segments.h"
#include "generators/tangent_facets.h"

namespace raygauge {

void register_generators(GeneratorRegistry& registry) {
  registry.add(bodies_generator());
  registry.add(clustered_generator());
  registry.add(example1_generator());
  registry.add(example2_generator());
  registry.add(needle_generator());
  registry.add(random_segments_generator());
  registry.add(tangent_facets_generator());
  register_hard_generators(registry);
}

}  // namespace raygauge
