// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/contact_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "raygauge/numerics/vector3.h"
#include "scene/simulation/friction_jam.h"
#include "scene/simulation/friction_ladder.h"
#include "scene/simulation/friction_passes.h"
#include "scene/simulation/islands.h"
#include "scene/simulation/tuning.h"

namespace raygauge {
namespace {

// Rows: normal and two tangents.
Eigen::Matrix3d frame_of(const Eigen::Vector3d& n, int dimension) {
  Eigen::Vector3d tangent(-n[1], n[0], 0);
  if (dimension == 3) {
    const Vector3 some = any_orthogonal(Vector3{n[0], n[1], n[2]});
    tangent = {some.x, some.y, some.z};
  }
  Eigen::Matrix3d frame;
  frame << n.transpose(), tangent.transpose(), n.cross(tangent).transpose();
  return frame;
}

Eigen::Matrix3d hat(const Eigen::Vector3d& a) {
  Eigen::Matrix3d A;
  A << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return A;
}

// The bodies that react, numbered.
std::map<int, int> numbers_of(const std::vector<ContactUnknown*>& contacts,
                              const std::vector<SimulatedBody>& bodies) {
  std::map<int, int> numbers;
  for (const ContactUnknown* contact : contacts) {
    for (const int body : {contact->a, contact->b}) {
      if (bodies[static_cast<std::size_t>(body)].reacts()) numbers.emplace(body, 0);
    }
  }
  int next = 0;
  for (auto& [body, number] : numbers) number = next++;
  return numbers;
}

// Whether friction is, for one of them.
bool is_named(const std::vector<ContactUnknown*>& contacts) {
  return std::any_of(contacts.begin(), contacts.end(), [](const ContactUnknown* c) { return c->mu; });
}

// False: no offset was below 0.
bool leave_at_rest(const std::vector<ContactUnknown*>& contacts) {
  bool any = false;
  for (ContactUnknown* const contact : contacts) {
    any = any || contact->offset < 0;
    contact->offset = std::max(contact->offset, 0.0);
  }
  return any;
}

std::vector<int> pressed_by(const Eigen::VectorXd& r, const std::vector<ContactUnknown*>& contacts) {
  constexpr double kSlight = 1e-6;
  std::set<int> bodies;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (!(r[3 * static_cast<Eigen::Index>(c)] > kSlight * r.lpNorm<Eigen::Infinity>())) continue;
    bodies.insert({contacts[c]->a, contacts[c]->b});
  }
  return {bodies.begin(), bodies.end()};
}

}  // namespace

void push_apart(const ContactUnknown& contact, std::vector<SimulatedBody>& bodies) {
  SimulatedBody &a = bodies[static_cast<std::size_t>(contact.a)],
                &b = bodies[static_cast<std::size_t>(contact.b)];
  if (a.reacts()) a.push(contact.impulse, contact.at);
  if (b.reacts()) b.push(-contact.impulse, contact.at);
}

std::vector<std::vector<std::size_t>> islands_of(const std::vector<ContactUnknown>& contacts,
                                                 const std::vector<SimulatedBody>& bodies) {
  Islands islands(bodies.size());
  for (const ContactUnknown& contact : contacts) {
    const auto a = static_cast<std::size_t>(contact.a), b = static_cast<std::size_t>(contact.b);
    if (bodies[a].reacts() && bodies[b].reacts()) islands.join(a, b);
  }
  std::map<std::size_t, std::vector<std::size_t>> of_root;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto a = static_cast<std::size_t>(contacts[c].a), b = static_cast<std::size_t>(contacts[c].b);
    of_root[islands.root(bodies[a].reacts() ? a : b)].push_back(c);
  }
  std::vector<std::vector<std::size_t>> all;
  for (auto& [root, island] : of_root) all.push_back(std::move(island));
  return all;
}

// The largest islands first: they take longest.
double ContactProblem::solve(std::vector<ContactUnknown>& contacts, std::vector<SimulatedBody>& bodies,
                             bool roughly) {
  jammed_.clear();
  is_rough_ = false;
  if (contacts.empty()) return 0;
  std::vector<std::vector<ContactUnknown*>> islands;
  for (const std::vector<std::size_t>& numbers : islands_of(contacts, bodies)) {
    std::vector<ContactUnknown*>& island = islands.emplace_back();
    for (const std::size_t c : numbers) island.push_back(&contacts[c]);
    count(island);
  }
  std::stable_sort(islands.begin(), islands.end(),
                   [](const auto& one, const auto& other) { return one.size() > other.size(); });
  // Small islands alone are solved to the end as soon.
  roughly = roughly && islands.front().size() > tuned::kManyContacts;
  std::vector<Solved> solved(islands.size());
  share_work(contacts.size() < tuned::kContactsOfThreads ? nullptr : team_, islands.size(), 1, false,
             [&](std::size_t first, std::size_t last) {
               for (std::size_t k = first; k < last; ++k)
                 solved[k] = solve_island(islands[k], bodies, roughly);
             });
  for (const ContactUnknown& contact : contacts) push_apart(contact, bodies);
  double residual = 0;
  for (Solved& one : solved) {
    is_rough_ = is_rough_ || one.is_rough;
    if (jammed_.empty()) jammed_ = one.jammed;
    residual = std::max(residual, one.residual);
    if (!one.was_known) known_.push_back(std::move(one));
  }
  return residual;
}

void ContactProblem::count(const std::vector<ContactUnknown*>& contacts) {
  if (is_named(contacts))
    ++counters_.friction_problems;
  else
    ++counters_.frictionless_problems;
}

// By velocities that are scaled by the root of the mass matrix: of the body's six numbers.
FrictionIsland ContactProblem::island_of(const std::vector<ContactUnknown*>& contacts,
                                         const std::vector<SimulatedBody>& bodies) const {
  const std::map<int, int> numbers = numbers_of(contacts, bodies);
  FrictionIsland island;
  island.bodies = static_cast<int>(numbers.size());
  const auto slope = [&](int body, const Eigen::Matrix3d& frame, const Eigen::Vector3d& at, double sign) {
    const SimulatedBody& one = bodies[static_cast<std::size_t>(body)];
    ContactSlope A;
    A.topRows<3>() = sign * std::sqrt(one.inverse_mass) * frame.transpose();
    A.bottomRows<3>() = sign * one.inverse_inertia_root().transpose() * hat(at - one.x) * frame.transpose();
    if (n_ == 2) A.col(2).setZero();  // the third direction is not of the plane
    return A;
  };
  for (const ContactUnknown* contact : contacts) {
    const SimulatedBody &a = bodies[static_cast<std::size_t>(contact->a)],
                        &b = bodies[static_cast<std::size_t>(contact->b)];
    const Eigen::Matrix3d frame = frame_of(contact->normal, n_);
    IslandContact& one = island.contacts.emplace_back();
    one.mu = contact->mu.value_or(0);
    one.q = frame * (a.velocity_at(contact->at) - b.velocity_at(contact->at));
    one.q[0] += contact->offset;
    if (n_ == 2) one.q[2] = 0;
    if (a.reacts()) {
      one.a = numbers.at(contact->a);
      one.A_a = slope(contact->a, frame, contact->at, 1);
    }
    if (b.reacts()) {
      one.b = numbers.at(contact->b);
      one.A_b = slope(contact->b, frame, contact->at, -1);
    }
  }
  return island;
}

const ContactProblem::Solved* ContactProblem::known(const Solved& asked) const {
  const auto found = std::find_if(known_.rbegin(), known_.rend(), [&asked](const Solved& one) {
    return one.first == asked.first && (!one.is_rough || asked.is_rough) && one.island == asked.island;
  });
  return found == known_.rend() ? nullptr : &*found;
}

ContactProblem::Solved ContactProblem::solve_island(const std::vector<ContactUnknown*>& contacts,
                                                    const std::vector<SimulatedBody>& bodies,
                                                    bool roughly) const {
  Solved one;
  one.is_rough = roughly;
  one.first = {contacts.front()->a, contacts.front()->b};
  one.island = island_of(contacts, bodies);
  if (const Solved* const before = known(one)) {
    one.r = before->r;
    one.residual = before->residual;
    one.rests = before->rests;
    one.jammed = before->jammed;
    one.is_rough = before->is_rough;
    one.was_known = true;
    if (one.rests) leave_at_rest(contacts);
  } else {
    solve_anew(contacts, bodies, roughly, one);
  }
  for (std::size_t c = 0; c < contacts.size(); ++c)
    contacts[c]->impulse =
        frame_of(contacts[c]->normal, n_).transpose() * one.r.segment<3>(3 * static_cast<Eigen::Index>(c));
  return one;
}

// Overlaps that nothing can push apart are left: bodies that stand jam nobody then.
void ContactProblem::solve_anew(const std::vector<ContactUnknown*>& contacts,
                                const std::vector<SimulatedBody>& bodies, bool roughly, Solved& one) const {
  Eigen::VectorXd guess(3 * static_cast<Eigen::Index>(contacts.size()));
  for (std::size_t c = 0; c < contacts.size(); ++c)
    guess.segment<3>(3 * static_cast<Eigen::Index>(c)) =
        frame_of(contacts[c]->normal, n_) * contacts[c]->impulse;
  one.r = guess;
  one.residual = impulses(contacts, one.island, roughly, one.r);
  one.is_rough = roughly && contacts.size() > kFewContacts && one.residual <= kMostRough &&
                 one.residual > enough_friction(contacts.size(), false);
  std::optional<Eigen::VectorXd> jam;
  if (one.residual > kUnsolvable && !one.is_rough) jam = jam_of(one.island);
  if (!jam) return;
  FrictionIsland island = one.island;
  if (leave_at_rest(contacts)) {
    one.rests = true;
    island = island_of(contacts, bodies);
    one.r = guess;
    one.residual = impulses(contacts, island, false, one.r);
    jam = one.residual > kUnsolvable ? jam_of(island) : std::nullopt;
  }
  if (jam) one.jammed = pressed_by(*jam, contacts);
}

double ContactProblem::impulses(const std::vector<ContactUnknown*>& contacts, const FrictionIsland& island,
                                bool roughly, Eigen::VectorXd& r) const {
  if (is_named(contacts)) {
    const double residual = solve_friction(island, friction_, r, roughly);
    if (std::isfinite(residual) && r.allFinite())
      return std::max(residual, island.rounding_of_residual(island.bound_of_W(), r));
    r.setZero();
    return std::numeric_limits<double>::infinity();
  }
  const FrictionProblem problem = island.dense();
  const auto count = static_cast<Eigen::Index>(contacts.size());
  const Eigen::MatrixXd normals = problem.W(Eigen::seqN(0, count, 3), Eigen::seqN(0, count, 3));
  const Eigen::VectorXd along = problem.q(Eigen::seqN(0, count, 3));
  const Eigen::VectorXd found = nonnegative_solution(normals, along);
  r.setZero();  // guesses lean where normals have turned
  r(Eigen::seqN(0, count, 3)) = found;
  return nonnegative_residual(normals, along, found);
}

}  // namespace raygauge
