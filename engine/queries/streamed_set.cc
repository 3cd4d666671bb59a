// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/streamed_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr std::ptrdiff_t kFirstPoints = 512;  // and for each dimension
constexpr std::ptrdiff_t kFirstPerDimension = 16;
constexpr std::size_t kKept = 16;  // points of a part

template <class Real>
double product(const double* u, const Real* p, int n) {
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += u[k] * static_cast<double>(p[k]);
  return sum;
}

// Throws for the first coordinate that is not finite.
template <class Real>
void require_finite(const Real* points, const StreamedPoints& part, int n) {
  std::ptrdiff_t at = 0;
  while (at < part.count * n && std::isfinite(points[at])) ++at;
  if (at == part.count * n) return;
  throw NonFiniteError(std::string(std::isnan(points[at]) ? "NaN" : "infinity") + " at row " +
                       std::to_string(part.first + at / n) + ", column " + std::to_string(at % n));
}

}  // namespace

StreamedSet::StreamedSet(std::unique_ptr<PointStream> stream)
    : stream_(std::move(stream)), n_(stream_->dimension()), magnitude_(static_cast<std::size_t>(n_), 0.0) {
  stream_->pass([this](const StreamedPoints& part) {
    const std::ptrdiff_t wanted = std::min(part.count, kFirstPoints + kFirstPerDimension * n_);
    for (std::ptrdiff_t i = 0; i < wanted; ++i) {
      const std::ptrdiff_t number = i * part.count / wanted;
      if (part.doubles != nullptr) {
        keep(part.doubles + number * n_, number);
      } else {
        keep(part.floats + number * n_, number);
      }
    }
    return false;
  });
}

template <class Real>
void StreamedSet::keep(const Real* point, std::ptrdiff_t number) {
  if (!known_.insert(number).second) return;
  numbers_.push_back(number);
  for (int k = 0; k < n_; ++k) points_.push_back(static_cast<double>(point[k]));
}

std::shared_ptr<const PointSet> StreamedSet::working_set() {
  const auto count = std::ssize(points_) / n_;
  return std::make_shared<const PointSet>(Eigen::Map<const Eigen::MatrixXd>(points_.data(), n_, count));
}

double StreamedSet::rounding(const double* u) const {
  double sum = 0;
  for (int k = 0; k < n_; ++k) sum += std::fabs(u[k]) * magnitude_[static_cast<std::size_t>(k)];
  return ConvexSet::rounding_error(n_) * sum + std::numeric_limits<double>::min();
}

template <class Real>
void StreamedSet::measure(const Real* points, const StreamedPoints& part) {
  double* magnitude = magnitude_.data();
  const Real* p = points;
  for (std::ptrdiff_t i = 0; i < part.count; ++i, p += n_) {
    for (int k = 0; k < n_; ++k) magnitude[k] = std::max(magnitude[k], std::fabs(static_cast<double>(p[k])));
  }
  measured_ = part.first + part.count;
}

// A coordinate that is no number makes `poison` one that is none, whatever u.
template <class Real>
double StreamedSet::look_at(const Real* points, const StreamedPoints& part, const double* u,
                            double threshold) {
  if (part.first >= measured_) measure(points, part);
  candidates_.clear();
  const auto is_better = [](const Candidate& a, const Candidate& b) { return a.value > b.value; };
  double best = -std::numeric_limits<double>::infinity();
  double poison = 0;
  const Real* p = points;
  for (std::ptrdiff_t i = 0; i < part.count; ++i, p += n_) {
    const double value = product(u, p, n_);
    poison += 0 * value;
    best = std::max(best, value);
    if (!(value > threshold)) continue;
    candidates_.push_back({value, i});
    std::push_heap(candidates_.begin(), candidates_.end(), is_better);
    if (candidates_.size() <= kKept) continue;
    std::pop_heap(candidates_.begin(), candidates_.end(), is_better);
    candidates_.pop_back();
    threshold = candidates_.front().value;
  }
  if (!(poison == 0)) {
    require_finite(points, part, n_);
    return std::numeric_limits<double>::infinity();  // products overflow
  }
  for (const Candidate& candidate : candidates_) keep(points + candidate.at * n_, part.first + candidate.at);
  return best;
}

double StreamedSet::look(const StreamedPoints& part, const double* u, double level, double reach) {
  if (part.doubles != nullptr) return look_at(part.doubles, part, u, level - reach);
  return look_at(part.floats, part, u, level - reach);
}

}  // namespace raygauge
