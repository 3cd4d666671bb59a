// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/libsvm_method.h"

#include <svm.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "engine/numerics/floating_point.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

constexpr const char* kName = "libsvm_smo";
constexpr double kHardMargin = 1e100;  // C: no multiplier comes near it
constexpr double kCacheMegabytes = 400;

struct FreeModel {
  void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
};
using Model = std::unique_ptr<svm_model, FreeModel>;

void print_nothing(const char* /*text*/) {}

/// The points of both sides as LIBSVM takes them, those of A2 first, labelled 1, then those of A1, labelled
/// -1.
class LabelledPoints {
 public:
  LabelledPoints(const Eigen::MatrixXd& A2, const Eigen::MatrixXd& A1) {
    const Eigen::Index n = A2.rows();
    nodes_.reserve(static_cast<std::size_t>((A2.cols() + A1.cols()) * (n + 1)));
    add(A2, 1);
    add(A1, -1);
    for (std::size_t i = 0; i < labels_.size(); ++i)
      rows_.push_back(nodes_.data() + i * static_cast<std::size_t>(n + 1));
  }

  svm_problem problem() { return {static_cast<int>(labels_.size()), labels_.data(), rows_.data()}; }

 private:
  void add(const Eigen::MatrixXd& points, double label) {
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      for (Eigen::Index k = 0; k < points.rows(); ++k)
        nodes_.push_back({static_cast<int>(k) + 1, points(k, i)});
      nodes_.push_back({-1, 0});
      labels_.push_back(label);
    }
  }

  std::vector<svm_node> nodes_;
  std::vector<double> labels_;
  std::vector<svm_node*> rows_;
};

class LibsvmMethod final : public SolveMethod {
 public:
  explicit LibsvmMethod(const Parameters& parameters)
      : eps_(real_parameter(parameters, "eps")), shrinking_(boolean_parameter(parameters, "shrinking")) {
    svm_set_print_string_function(&print_nothing);
  }

  void load(const Instance& instance) override {
    const auto* metric = dynamic_cast<const Ball*>(instance.Q.get());
    if (metric == nullptr || !metric->center().isZero(0) || !(metric->radius() > 0)) {
      throw InvalidParameterError(std::string("method '") + kName + "' takes a ball about the origin as Q");
    }
    radius_ = metric->radius();
    const auto* difference = dynamic_cast<const MinkowskiDifference*>(instance.A.get());
    const PointSet* A2 = as_point_set(difference == nullptr ? *instance.A : *difference->A2());
    const PointSet* A1 = difference == nullptr ? nullptr : as_point_set(*difference->A1());
    if (A2 == nullptr || (difference != nullptr && A1 == nullptr)) {
      throw InvalidParameterError(std::string("method '") + kName +
                                  "' takes a point set, or the difference of two, as A");
    }
    A2_ = A2->points();
    A1_ = A1 == nullptr ? Eigen::MatrixXd::Zero(A2_.rows(), 1) : A1->points();
    model_.reset();
    points_ = std::make_unique<LabelledPoints>(A2_, A1_);
  }

  void solve(const SolveRequest& request) override {
    if (points_ == nullptr) throw Error(std::string("method '") + kName + "': solve before load");
    svm_parameter parameter{};
    parameter.svm_type = C_SVC;
    parameter.kernel_type = LINEAR;
    parameter.C = kHardMargin;
    parameter.eps = eps_ > 0 ? eps_ : request.tolerance;
    parameter.cache_size = kCacheMegabytes;
    parameter.shrinking = shrinking_ ? 1 : 0;
    const svm_problem problem = points_->problem();
    model_.reset(svm_train(&problem, &parameter));
  }

  DistanceResult result() override {
    if (model_ == nullptr) throw Error(std::string("method '") + kName + "': result before solve");
    DistanceResult result;
    const Nearest nearest = nearest_points();
    if (!(nearest.sum > 0)) return result;
    result.status = DistanceStatus::optimal;
    result.distance = nearest.difference.norm() / radius_;  // 2/|w| at the optimum
    const double count = static_cast<double>(A2_.rows() + model_->l + 8);
    result.upper = (nearest.difference.norm() + count * 2 * kUnitRoundoff * nearest.size) / radius_;
    result.lower = certified_lower(nearest.difference);
    return result;
  }

 private:
  struct Nearest {
    Vector difference;  // w, scaled so that it is one of points of the hulls
    double sum = 0;     // of the multipliers of A2
    double size = 0;    // Σ weight |p|₁: the scale of rounding errors
  };

  // The combinations of support vectors, their weights made to add up to one.
  Nearest nearest_points() const {
    Vector sums[2] = {Vector::Zero(A2_.rows()), Vector::Zero(A2_.rows())};
    double weights[2] = {0, 0}, sizes[2] = {0, 0};
    for (int i = 0; i < model_->l; ++i) {
      const double weight = std::fabs(model_->sv_coef[0][i]);
      const Eigen::Index index = model_->sv_indices[i] - 1;
      const int side = index < A2_.cols() ? 0 : 1;
      const Vector point = side == 0 ? A2_.col(index) : A1_.col(index - A2_.cols());
      sums[side] += weight * point;
      weights[side] += weight;
      sizes[side] += weight * point.lpNorm<1>();
    }
    if (!(weights[0] > 0 && weights[1] > 0)) return {};
    return {sums[0] / weights[0] - sums[1] / weights[1], weights[0],
            sizes[0] / weights[0] + sizes[1] / weights[1]};
  }

  // Weak duality (10) at u = -w: -h_A(u)/(r |u|), rounding errors included.
  double certified_lower(const Vector& w) const {
    const auto n = static_cast<double>(w.size());
    const double h = (A1_.transpose() * w).maxCoeff() - (A2_.transpose() * w).minCoeff();
    const double size =
        w.cwiseAbs().dot(A2_.cwiseAbs().rowwise().maxCoeff() + A1_.cwiseAbs().rowwise().maxCoeff());
    const double error = (n + 8) * 2 * kUnitRoundoff;
    return std::max(0.0, -(h + error * size) / (radius_ * w.norm()) * (1 - error));
  }

  double eps_;
  bool shrinking_;
  double radius_ = 1;
  Eigen::MatrixXd A2_, A1_;
  std::unique_ptr<LabelledPoints> points_;
  Model model_;  // refers to points_
};

}  // namespace

void register_libsvm_methods(MethodRegistry& registry) {
  registry.add(
      {kName,
       "the Euclidean distance of two point sets by LIBSVM " + libsvm_library_version() +
           ": a support vector machine with hard margin",
       {{"eps", 0.0, 0.0, 1.0, "LIBSVM's tolerance of the optimality conditions; 0: that of the solve", {}},
        {"shrinking", false, {}, {}, "LIBSVM's shrinking heuristic", {}}},
       [](const Parameters& parameters) -> std::unique_ptr<SolveMethod> {
         return std::make_unique<LibsvmMethod>(parameters);
       },
       false,  // Q is a ball
       Role::baseline});
}

std::string libsvm_library_version() {
  return std::to_string(LIBSVM_VERSION / 100) + "." + std::to_string(LIBSVM_VERSION % 100);
}

}  // namespace raygauge
