// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/lp/basis.h"
#include "engine/methods/column_generation/support_oracle.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// Ray shooting, equations (11)–(16): with S = A - a_c - ηQ it finds the farthest point z = -a_c/σ of S on
/// the ray along -a_c, as the linear program
///
///     σ = min Σc_l   subject to   Σ c_l s_l = -a_c,   c >= 0,      s_l = s_A(u_l) - a_c - η s_Q(-u_l),
///
/// whose n duals are the normal u (scaled to u·s_l = 1 on the basis, so that σ = -u·a_c). Each iteration is
/// one support query of S: (13). σ is the growth distance of Ong & Gilbert: by how much A about a_c and ηQ
/// about the origin must both grow to touch.
class RayShooter {
 public:
  enum class End : std::uint8_t {
    hit,
    overtaken,  ///< the normal proves a much larger η, or that no η reaches A
    missed,
    failed,
    iteration_limit,
    time_limit
  };

  /// The oracles are the caller's. `a_c`: n doubles, copied.
  void begin(SupportOracle& A, SupportOracle& Q, int n, const double* a_c, const Kernels& kernels);

  /// Large point sets are first shot at with their working sets; a hit is one over the whole sets.
  ///
  /// Shoots at A - a_c - ηQ until h_S(u) <= 1 + tolerance. After a first call the vertices of the previous
  /// one are the start (Fig. 3c): moved to the new η if the ray still passes through their hull, as they are
  /// otherwise (they remain points of S as long as η grows).
  ///
  /// Ends early once -h_A(u) / h_Q(-u) >= `overtaking`, a bound as (10), or h_Q(-u) <= 0 while h_A(u) < 0.
  End shoot(double eta, double tolerance, double overtaking, std::int64_t max_iterations,
            const Stopwatch& stopwatch);

  double sigma() const noexcept { return sigma_; }
  const double* normal() const noexcept { return basis_->view().y; }
  const SupportValue& h_A() const noexcept { return h_A_; }  ///< h_A(normal)
  const SupportValue& h_Q() const noexcept { return h_Q_; }  ///< h_Q(-normal)

  std::int64_t iterations() const noexcept { return iterations_; }  ///< N_rs, all calls together
  std::int64_t passes() const noexcept { return passes_; }          ///< of those the ones over sets
  std::int64_t pivots() const noexcept { return pivots_ + basis_->view().pivots; }
  std::int64_t refactorisations() const noexcept { return refactorisations_; }

  /// The vertices s_l of the last hit as pairs (s_A(u_l), s_Q(-u_l)); nullptr where position l < n holds
  /// none.
  const double* vertex_A(int l) const noexcept;
  const double* vertex_Q(int l) const noexcept;

 private:
  void start_cold(double eta);
  bool move_vertices(double eta);
  double best_column(const double* u, double eta, double enough);
  double query_shortlists(const double* u, double eta);
  double query(const double* u, double eta);
  double verify(const double* u, double eta);
  double support_of_column(const double* u, double eta);
  double* slot_A(std::int64_t slot) const noexcept;
  double* slot_Q(std::int64_t slot) const noexcept;
  void form_column(std::int64_t slot, double eta, double* column) const;
  double artificial_weight() const;
  int between_looks() const;
  bool overtakes(double overtaking) const noexcept;
  bool is_overtaken(double eta, double overtaking);
  bool enter_candidate(double h_S);
  bool raise_artificial_costs();

  SupportOracle* A_ = nullptr;
  SupportOracle* Q_ = nullptr;
  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  bool warm_ = false;
  double eta_shot_ = 0;
  double sigma_ = 0;
  int raises_ = 0;
  double best_A_ = 0;  // of the last query
  double best_Q_ = 0;
  SupportValue h_A_;  // of the last verification
  SupportValue h_Q_;
  std::int64_t iterations_ = 0;
  std::int64_t passes_ = 0;
  bool keeps_shortlists_ = false;
  double shortlist_excess_ = 0;  // of the best column after the last pass
  int shortlisted_ = 0;          // queries of the shortlists before the next pass
  std::int64_t pivots_ = 0;
  std::int64_t refactorisations_ = 0;
  std::int64_t free_slot_ = 0;

  Basis bases_[2];
  Basis* basis_ = &bases_[0];
  Basis* spare_ = &bases_[1];
  AlignedBuffer<double> center_;
  AlignedBuffer<double> slots_;  // n + 1 slots of two points: those of the basis, and one to enter
  AlignedBuffer<double> column_;
};

}  // namespace raygauge
