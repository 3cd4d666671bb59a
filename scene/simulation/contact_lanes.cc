// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/contact_lanes.h"

#include <Eigen/LU>
#include <cmath>

#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

using Side = ContactLanes::Side;

Side side_of(int body, int bodies, const ContactSlope& A) {
  Side side;
  side.body = static_cast<std::size_t>(body < 0 ? bodies : body);
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < 3; ++k) side.row[j][k] = side.column[k][j] = A(j, k);
  }
  return side;
}

ContactLanes lanes_of(const IslandContact& contact, int bodies) {
  ContactLanes lanes;
  lanes.a = side_of(contact.a, bodies, contact.A_a);
  lanes.b = side_of(contact.b, bodies, contact.A_b);
  Eigen::Matrix3d W = contact.A_a.transpose() * contact.A_a + contact.A_b.transpose() * contact.A_b;
  if (!(W(2, 2) > 0)) W(2, 2) = W(0, 0);  // in the plane
  const Eigen::Matrix3d inverse = W.inverse();
  for (int i = 0; i < 3; ++i) {
    lanes.q[i] = contact.q[i];
    for (int k = 0; k < 3; ++k) {
      lanes.W[k][i] = W(i, k);
      lanes.inverse[k][i] = inverse(i, k);
    }
  }
  lanes.mu = contact.mu;
  lanes.rate = 2 / (W(1, 1) + W(2, 2));
  return lanes;
}

[[gnu::always_inline]] inline Four product(const Four* columns, Four x) {
  return columns[0] * x[0] + columns[1] * x[1] + columns[2] * x[2];
}

[[gnu::always_inline]] inline void push(const Side& side, Four r, Eight& y) {
  y += side.column[0] * r[0] + side.column[1] * r[1] + side.column[2] * r[2];
}

[[gnu::always_inline]] inline Four velocity(const ContactLanes& contact, const Eight& of_a,
                                            const Eight& of_b) {
  Four a = contact.q, b = {};
  for (int j = 0; j < 6; ++j) {
    a += contact.a.row[j] * of_a[j];
    b += contact.b.row[j] * of_b[j];
  }
  return a + b;
}

// Steps of projection to the cone, which come nearer always.
[[gnu::noinline]] Eigen::Vector3d nearer(const ContactLanes& contact, const Eigen::Vector3d& b,
                                         Eigen::Vector3d r) {
  constexpr int kSteps = 8;
  Eigen::Matrix3d W;
  for (int k = 0; k < 3; ++k) W.col(k) << contact.W[k][0], contact.W[k][1], contact.W[k][2];
  const double rate = 1 / W.norm();
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Vector3d changed = W * r + b;
    changed[0] += contact.mu * changed.tail<2>().norm();
    r = nearest_in_cone(r - rate * changed, contact.mu);
  }
  return r;
}

// Towards 0 <= r_n ⊥ u_n >= 0 and Coulomb's law with u = W r + b. What slips turns once into the direction
// that r so far asks for. `last`: it is near that.
[[gnu::always_inline]] inline Four solved(const ContactLanes& contact, const Four& b, const Four& last) {
  const double mu = contact.mu;
  if (b[0] >= 0) return Four{};
  if (!(mu > 0)) return Four{-b[0] / contact.W[0][0], 0, 0, 0};
  const Four sticks = -product(contact.inverse, b);
  const double most = mu * sticks[0];
  if (most >= 0 && sticks[1] * sticks[1] + sticks[2] * sticks[2] <= most * most) return sticks;
  const Four start = last[0] > 0 ? last : sticks;
  const Four u = b + product(contact.W, start);
  const double x = start[1] - contact.rate * u[1], y = start[2] - contact.rate * u[2];
  const double length = std::sqrt(x * x + y * y), share = mu / length;
  const double slope = contact.W[0][0] + share * (contact.W[1][0] * x + contact.W[2][0] * y);
  if (!(length > 0 && slope > 0) || u[1] * x + u[2] * y > 0) {
    const Eigen::Vector3d r = nearer(contact, {b[0], b[1], b[2]}, {last[0], last[1], last[2]});
    return Four{r[0], r[1], r[2], 0};
  }
  const double normal = -b[0] / slope;
  return Four{normal, share * normal * x, share * normal * y, 0};
}

}  // namespace

// In turn one of the first half and one of the other: contacts of one body, which wait for each other, stand
// side by side.
IslandLanes::IslandLanes(const FrictionIsland& island)
    : bodies_(static_cast<std::size_t>(island.bodies) + 1) {
  const std::size_t count = island.contacts.size(), half = (count + 1) / 2;
  contacts_.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t c = k % 2 == 0 ? k / 2 : half + k / 2;
    contacts_.push_back(lanes_of(island.contacts[c], island.bodies));
    contacts_.back().at = 3 * c;
  }
}

RAYGAUGE_VECTORS void IslandLanes::reset(const Eigen::VectorXd& impulses) {
  for (BodyLanes& body : bodies_) body.y = Eight{};
  for (const ContactLanes& contact : contacts_) {
    const double* const r = impulses.data() + contact.at;
    const Four here{r[0], r[1], r[2], 0};
    push(contact.a, here, bodies_[contact.a.body].y);
    push(contact.b, here, bodies_[contact.b.body].y);
  }
}

RAYGAUGE_VECTORS void IslandLanes::pass(Eigen::VectorXd& impulses) {
  reset(impulses);
  for (const ContactLanes& contact : contacts_) {
    Eight &of_a = bodies_[contact.a.body].y, &of_b = bodies_[contact.b.body].y;
    double* const r = impulses.data() + contact.at;
    const Four before{r[0], r[1], r[2], 0};
    const Four b = velocity(contact, of_a, of_b) - product(contact.W, before);
    const Four after = solved(contact, b, before), change = after - before;
    push(contact.a, change, of_a);
    push(contact.b, change, of_b);
    for (int k = 0; k < 3; ++k) r[k] = after[k];
  }
}

RAYGAUGE_VECTORS double IslandLanes::error(double s, const Eigen::VectorXd& impulses) const {
  double sum = 0;
  for (const ContactLanes& contact : contacts_) {
    const double* const r = impulses.data() + contact.at;
    const Four u = velocity(contact, bodies_[contact.a.body].y, bodies_[contact.b.body].y);
    sum += law_error(contact.mu, {u[0], u[1], u[2]}, s, {r[0], r[1], r[2]});
  }
  return sum;
}

}  // namespace raygauge
