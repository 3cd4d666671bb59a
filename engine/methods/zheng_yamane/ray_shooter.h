// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/lp/basis.h"
#include "engine/methods/zheng_yamane/ray_set.h"
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
  const RaySet& set() const noexcept { return set_; }  ///< its last verification was along the normal

  std::int64_t pivots() const noexcept { return pivots_ + basis_->view().pivots; }
  std::int64_t refactorisations() const noexcept { return refactorisations_; }

  /// The slot in set() of vertex s_l of the last hit, l < n; negative where there is none.
  std::int64_t vertex(int l) const noexcept { return basis_->view().id[l]; }

 private:
  void start_cold();
  bool move_vertices();
  double artificial_weight() const;
  bool enter_candidate(double h_S);
  bool raise_artificial_costs();

  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  bool warm_ = false;
  double eta_shot_ = 0;
  double sigma_ = 0;
  int raises_ = 0;
  std::int64_t pivots_ = 0;
  std::int64_t refactorisations_ = 0;

  Basis bases_[2];
  Basis* basis_ = &bases_[0];
  Basis* spare_ = &bases_[1];
  RaySet set_;
};

}  // namespace raygauge
