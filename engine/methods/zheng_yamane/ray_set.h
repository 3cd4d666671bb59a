// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/methods/column_generation/support_oracle.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// The set S = A - a_c - ηQ of RayShooter, known through its support points s_A - a_c - η s_Q, equation
/// (13b). Those in use are kept in n + 1 slots as pairs (s_A, s_Q), one of which takes the next candidate.
class RaySet {
 public:
  /// The oracles are the caller's. `a_c`: n doubles, copied.
  void begin(SupportOracle& A, SupportOracle& Q, int n, const double* a_c, const Kernels& kernels);

  /// From now on S is that of η.
  void move_to(double eta) noexcept {
    eta_ = eta;
    shortlisted_ = 0;
  }

  /// A candidate with u·s > enough, of the shortlists if they have one; otherwise the best of the points at
  /// hand. Returns its u·s.
  double best_candidate(const double* u, double enough);

  /// h_S(u) over the points at hand, and over the whole sets; the maximiser becomes the candidate.
  double query(const double* u);
  double verify(const double* u);

  std::int64_t candidate() const noexcept { return candidate_; }             ///< its slot
  void next_candidate_at(std::int64_t slot) noexcept { candidate_ = slot; }  ///< the one before stays
  const double* column() const noexcept { return column_.data(); }           ///< s of the candidate
  const double* form_column(std::int64_t slot);                     ///< s of another pair, in its place
  const double* center() const noexcept { return center_.data(); }  ///< a_c
  const double* slot_A(std::int64_t slot) const noexcept { return slots_.data() + 2 * slot * n_; }
  const double* slot_Q(std::int64_t slot) const noexcept { return slot_A(slot) + n_; }

  /// Whether the last query, if it was one of all points at hand, promises a bound (10) of `overtaking`,
  /// which the whole sets then prove.
  bool is_overtaken(const double* u, double overtaking);

  /// Iterations between two looks at the clock.
  int between_looks() const;

  const SupportValue& h_A() const noexcept { return h_A_; }  ///< of the last verification
  const SupportValue& h_Q() const noexcept { return h_Q_; }
  std::int64_t iterations() const noexcept { return iterations_; }  ///< N_rs
  std::int64_t passes() const noexcept { return passes_; }          ///< of those the ones over sets

 private:
  double* room_A() noexcept { return slots_.data() + 2 * candidate_ * n_; }
  double* room_Q() noexcept { return room_A() + n_; }
  double query_shortlists(const double* u);
  double support_of_candidate(const double* u);

  SupportOracle* A_ = nullptr;
  SupportOracle* Q_ = nullptr;
  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  double eta_ = 0;
  double best_A_ = 0;  // of the last query
  double best_Q_ = 0;
  SupportValue h_A_, h_Q_;
  std::int64_t iterations_ = 0;
  std::int64_t passes_ = 0;
  bool keeps_shortlists_ = false;
  double shortlist_excess_ = 0;  // of the best column after the last pass
  int shortlisted_ = 0;          // queries of the shortlists before the next pass
  std::int64_t candidate_ = 0;
  AlignedBuffer<double> center_;
  AlignedBuffer<double> slots_;
  AlignedBuffer<double> column_;
};

}  // namespace raygauge
