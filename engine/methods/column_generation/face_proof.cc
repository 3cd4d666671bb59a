// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/face_proof.h"

#include <algorithm>

#include "engine/methods/column_generation/last_resort.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// A weight above carries, others are zero but for rounding: of most bases, and of those that a shear has left
// so ill-conditioned that weights of 1e-4 are rounding.
constexpr double kCarries[] = {1e-9, 1e-3};

}  // namespace

double FaceProof::upper(const SiftingSolve& solve) {
  int tried = 0;
  for (const double least : kCarries) {
    if (!collect_basis(solve, least, true) || face_.count() == tried) break;
    tried = face_.count();
    const double upper = face_.choose(solve.stopwatch) ? face_.upper(solve.stopwatch) : kInfinity;
    if (upper < kInfinity) return upper;
  }
  return kInfinity;
}

bool FaceProof::proves_zero(const SiftingSolve& solve) {
  int tried = 0;
  for (const double least : kCarries) {
    if (!collect_basis(solve, least, false) || face_.count() == tried) continue;
    tried = face_.count();
    if (face_.is_independent_zero(solve.stopwatch)) return true;
  }
  return false;
}

bool FaceProof::certify(const SiftingSolve& solve, double distance, std::span<const double> duals,
                        std::span<const InteriorPoint::Carrier> carriers) {
  collect(solve, carriers, distance > 0);
  if (!face_.choose(solve.stopwatch)) return false;
  const double upper = face_.upper(solve.stopwatch);
  if (!(upper < kInfinity)) return false;
  std::vector<double> y(duals.begin(), duals.end()), y_low(duals.size());
  face_.refine_duals(y.data(), y_low.data());
  std::int64_t best_A = 0;
  std::int64_t best_Q = 0;
  const double lower = solve.sets.bound_twofold(y.data(), y_low.data(), &best_A, &best_Q);
  // Weights of dependent points are not the one solution that a result is to hold.
  if (upper > 0 ? !solve.closes(lower, upper) : !face_.is_independent_zero(solve.stopwatch)) return false;
  write(solve, lower, upper);
  return true;
}

// The basic columns with a weight above `least`, into face_, those of A alone or of both sets. False where
// there is none, or an artificial one is among them.
bool FaceProof::collect_basis(const SiftingSolve& solve, double least, bool with_Q) {
  const BasisView& view = solve.program.basis().view();
  face_.begin(view.m, solve.sets.kernels());
  for (int i = 0; i < view.m; ++i) {
    const double weight = view.x()[i];
    if (!(weight > least)) continue;
    if (is_artificial(view.id[i])) return false;
    if (is_from_Q(view.id[i]) && !with_Q) continue;
    face_.add(solve.program.basis().column(i), is_from_Q(view.id[i]) ? 1.0 : 0.0, weight, view.id[i]);
  }
  return face_.count() > 0;
}

// The carriers into face_, those of A alone or of both sets.
void FaceProof::collect(const SiftingSolve& solve, std::span<const InteriorPoint::Carrier> carriers,
                        bool with_Q) {
  const int n = solve.sets.n();
  face_.begin(n + 1, solve.sets.kernels());
  std::vector<double> column(static_cast<std::size_t>(n) + 1);
  for (const auto& [id, weight] : carriers) {
    const bool from_Q = is_from_Q(id);
    if (from_Q && !with_Q) continue;
    (from_Q ? solve.sets.Q() : solve.sets.A()).pool.copy_point(id / 2, column.data());
    for (int k = 0; from_Q && k < n; ++k) column[static_cast<std::size_t>(k)] *= -1;
    column.back() = from_Q ? 0.0 : 1.0;
    face_.add(column.data(), from_Q ? 1.0 : 0.0, weight, id);
  }
}

void FaceProof::weights(const SiftingSolve& solve, std::vector<PointWeight>& weights) const {
  weights.clear();
  for (int i = 0; i < face_.count(); ++i) {
    if (is_from_Q(face_.id(i))) continue;
    weights.push_back({solve.sets.A().own_index(face_.id(i) / 2), face_.weight(i)});
  }
}

void FaceProof::write(const SiftingSolve& solve, double lower, double upper) const {
  write_answer(solve, DistanceStatus::optimal, lower, upper);
  if (upper == 0) {
    solve.result.status = DistanceStatus::contains_origin;
    weights(solve, solve.result.origin_weights);
    if (!is_rounded()) solve.last.round_weights(solve);
  }
  double distance = 0;
  for (int i = 0; i < face_.count(); ++i) distance += is_from_Q(face_.id(i)) ? face_.weight(i) : 0.0;
  write_estimate(solve, distance);
  const int n = solve.sets.n();
  double* contact = solve.result.room_for_contact(solve.effects, n);
  if (contact == nullptr) return;
  std::fill_n(contact, n, 0.0);
  for (int i = 0; i < face_.count(); ++i) {
    if (is_from_Q(face_.id(i))) continue;
    for (int k = 0; k < n; ++k) contact[k] += face_.weight(i) * face_.column(i)[k] / solve.sets.A().factor[k];
  }
}

}  // namespace raygauge
