// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/contact_problem.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "raygauge/numerics/vector3.h"
#include "scene/simulation/friction_newton.h"
#include "scene/simulation/friction_smoothing.h"

namespace raygauge {
namespace {

// Which contacts belong together: a forest over the bodies.
class Islands {
 public:
  explicit Islands(std::size_t bodies) : parent_(bodies) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    const std::size_t a = root(i), b = root(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

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

// Where the velocities of the bodies that react stand.
std::map<int, Eigen::Index> columns_of(const std::vector<ContactUnknown*>& contacts,
                                       const std::vector<SimulatedBody>& bodies) {
  std::map<int, Eigen::Index> column;  // of the bodies that react
  for (const ContactUnknown* contact : contacts) {
    for (const int body : {contact->a, contact->b}) {
      if (bodies[static_cast<std::size_t>(body)].reacts()) column.emplace(body, 0);
    }
  }
  Eigen::Index next = 0;
  for (auto& [body, at] : column) at = 6 * next++;
  return column;
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

double ContactProblem::solve(std::vector<ContactUnknown>& contacts, std::vector<SimulatedBody>& bodies) {
  double residual = 0;
  for (const std::vector<std::size_t>& numbers : islands_of(contacts, bodies)) {
    std::vector<ContactUnknown*> island;
    for (const std::size_t c : numbers) island.push_back(&contacts[c]);
    residual = std::max(residual, solve_island(island, bodies));
  }
  for (const ContactUnknown& contact : contacts) push_apart(contact, bodies);
  return residual;
}

// W = J M⁻¹ Jᵀ with J the velocities of a contact, a's less b's, along its frame, by those of the bodies.
double ContactProblem::solve_island(std::vector<ContactUnknown*>& contacts,
                                    const std::vector<SimulatedBody>& bodies) {
  const std::map<int, Eigen::Index> column = columns_of(contacts, bodies);
  const auto rows = 3 * static_cast<Eigen::Index>(contacts.size());
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows, 6 * static_cast<Eigen::Index>(column.size())), JM = J;
  Eigen::VectorXd q(rows), r(rows);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const ContactUnknown& contact = *contacts[c];
    const auto row = 3 * static_cast<Eigen::Index>(c);
    const Eigen::Matrix3d frame = frame_of(contact.normal, n_);
    const SimulatedBody &a = bodies[static_cast<std::size_t>(contact.a)],
                        &b = bodies[static_cast<std::size_t>(contact.b)];
    q.segment<3>(row) = frame * (a.velocity_at(contact.at) - b.velocity_at(contact.at));
    q[row] += contact.offset;
    r.segment<3>(row) = frame * contact.impulse;
    for (const auto& [body, sign] : {std::pair{contact.a, 1.0}, std::pair{contact.b, -1.0}}) {
      const auto found = column.find(body);
      if (found == column.end()) continue;
      const SimulatedBody& one = bodies[static_cast<std::size_t>(body)];
      const Eigen::Matrix3d turn = -frame * hat(contact.at - one.x);
      J.block<3, 3>(row, found->second) = sign * frame;
      J.block<3, 3>(row, found->second + 3) = sign * turn;
      JM.block<3, 3>(row, found->second) = sign * one.inverse_mass * frame;
      JM.block<3, 3>(row, found->second + 3) = sign * turn * one.inverse_inertia();
    }
  }
  const Eigen::MatrixXd product = JM * J.transpose();
  const Eigen::MatrixXd W = (product + product.transpose()) / 2;
  const double residual = impulses(contacts, W, q, r);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    ContactUnknown& contact = *contacts[c];
    contact.impulse =
        frame_of(contact.normal, n_).transpose() * r.segment<3>(3 * static_cast<Eigen::Index>(c));
  }
  return residual;
}

double ContactProblem::impulses(const std::vector<ContactUnknown*>& contacts, const Eigen::MatrixXd& W,
                                const Eigen::VectorXd& q, Eigen::VectorXd& r) {
  const auto count = static_cast<Eigen::Index>(contacts.size());
  const bool named =
      std::any_of(contacts.begin(), contacts.end(), [](const ContactUnknown* c) { return c->mu; });
  if (!named) {
    ++counters_.frictionless_problems;
    const Eigen::MatrixXd normals = W(Eigen::seqN(0, count, 3), Eigen::seqN(0, count, 3));
    const Eigen::VectorXd along = q(Eigen::seqN(0, count, 3));
    const Eigen::VectorXd found = nonnegative_solution(normals, along);
    r.setZero();  // guesses lean where normals have turned
    r(Eigen::seqN(0, count, 3)) = found;
    return nonnegative_residual(normals, along, found);
  }
  ++counters_.friction_problems;
  FrictionProblem problem{W, q, {}};
  for (const ContactUnknown* contact : contacts) problem.mu.push_back(contact->mu.value_or(0));
  if (n_ == 2) {  // the third direction is not of the plane
    const double size = W.diagonal().maxCoeff();
    for (Eigen::Index k = 2; k < q.size(); k += 3) {
      problem.W.row(k).setZero();
      problem.W.col(k).setZero();
      problem.W(k, k) = size;
      problem.q[k] = 0;
    }
  }
  return with_friction(problem, r);
}

// Newton's method from what is known of the step before; where that does not end, from the end of a path of
// smoothed problems; then from where the solver's passes end.
double ContactProblem::with_friction(const FrictionProblem& problem, Eigen::VectorXd& r) {
  constexpr double kEnough = 1e-11;
  constexpr std::size_t kMostContacts = 150;  // of dense factorizations before the passes
  const bool small = problem.mu.size() <= kMostContacts || friction_ == nullptr;
  const Eigen::VectorXd guess = r;
  double residual = friction_residual(problem, r);
  const auto attempt = [&](auto find) {
    if (!(residual > kEnough)) return;
    Eigen::VectorXd trial = guess;
    find(trial);
    const double found = improve_friction(problem, trial);
    if (!(found < residual)) return;
    residual = found;
    r = trial;
  };
  if (small) {
    attempt([](Eigen::VectorXd& /*guess*/) {});
    for (const double rate : {0.3, 0.7})
      attempt([&](Eigen::VectorXd& trial) { follow_smoothed_friction(problem, rate, trial); });
  }
  if (friction_ != nullptr) attempt([&](Eigen::VectorXd& trial) { friction_->solve(problem, trial); });
  return residual;
}

}  // namespace raygauge
