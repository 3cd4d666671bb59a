// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/simulation.h"

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <NumericsVerbose.h>
#include <SolverOptions.h>

#include <cstdlib>

namespace raygauge {

namespace {

constexpr double kEnough = 1e-10;
constexpr int kMostIterations = 4'000;

struct FreeMatrix {
  void operator()(NumericsMatrix* matrix) const {
    matrix->matrix0 = nullptr;  // the numbers are the problem's
    NM_clear(matrix);
    std::free(matrix);
  }
};

struct FreeOptions {
  void operator()(SolverOptions* options) const { solver_options_delete(options); }
};

class SiconosFriction final : public FrictionSolver {
 public:
  SiconosFriction() : options_(solver_options_create(SICONOS_FRICTION_3D_NSGS)) {
    numerics_set_verbose(0);
    options_->dparam[SICONOS_DPARAM_TOL] = kEnough;
    options_->iparam[SICONOS_IPARAM_MAX_ITER] = kMostIterations;
  }

  // Divided by the largest numbers of W and q: Siconos has absolute limits.
  void solve(const FrictionProblem& given, Eigen::VectorXd& r) override {
    const double size_W = given.W.diagonal().maxCoeff(), size_q = given.q.lpNorm<Eigen::Infinity>();
    if (!(size_W > 0) || !(size_q > 0)) {
      r.setZero(given.q.size());
      return;
    }
    FrictionProblem scaled{given.W / size_W, given.q / size_q, given.mu};
    const double unit = size_q / size_W;
    r /= unit;
    drive(scaled, r);
    r *= unit;
  }

 private:
  void drive(FrictionProblem& scaled, Eigen::VectorXd& r) {
    const int size = static_cast<int>(scaled.q.size());
    const std::unique_ptr<NumericsMatrix, FreeMatrix> W(
        NM_create_from_data(NM_DENSE, size, size, scaled.W.data()));
    Eigen::VectorXd velocity = Eigen::VectorXd::Zero(size);
    FrictionContactProblem problem{};
    problem.dimension = 3;
    problem.numberOfContacts = size / 3;
    problem.M = W.get();
    problem.q = scaled.q.data();
    problem.mu = scaled.mu.data();
    fc3d_driver(&problem, r.data(), velocity.data(), options_.get());
  }

  std::unique_ptr<SolverOptions, FreeOptions> options_;
};

}  // namespace

std::unique_ptr<FrictionSolver> siconos_friction() { return std::make_unique<SiconosFriction>(); }

}  // namespace raygauge
