// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/meshes/mesh.h"

#include <typeinfo>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

[[noreturn]] void refuse() {
  throw InvalidParameterError(
      "a mesh is not convex: it has a Euclidean distance and a separation from another object, in scenes "
      "too, "
      "and nothing else; take the hull of its vertices or convex parts");
}

}  // namespace

double MeshObject::do_support(const double* /*u*/, double* /*point*/) const { refuse(); }
void MeshObject::do_center(double* /*point*/) const { refuse(); }
void MeshObject::do_magnitude(double* /*magnitude*/) const { refuse(); }

// A final class has no subclasses: quicker than a cast that looks for them.
const Mesh* as_mesh(const ConvexSet& S) noexcept {
  return typeid(S) == typeid(MeshObject) ? &static_cast<const MeshObject&>(S).mesh() : nullptr;
}

}  // namespace raygauge
