// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/hull_depth.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/methods/bodies/inner_hull.h"
#include "engine/numerics/floating_point.h"
#include "engine/proof/bounds.h"

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;
constexpr int kMostIterations = 1 << 15;
constexpr std::int32_t kMostFacets = 1 << 20;  // of about 150 bytes each
constexpr int kMostSetbacks = 32;              // of the least facet, which never sinks but for rounding
constexpr double kLost = 16;                   // errors of a support point
constexpr int kIterationsBetweenLooks = 8;     // at the watch

template <std::size_t N>
std::array<double, N> negated(std::array<double, N> u) {
  for (double& x : u) x = -x;
  return u;
}

template <std::size_t N>
bool make_unit(std::array<double, N>& u) {
  double squares = 0;
  for (const double x : u) squares += x * x;
  if (!(squares > 0)) return false;
  const double scale = 1 / std::sqrt(squares);
  for (double& x : u) x *= scale;
  return true;
}

/// Takes from v what it has along the first `count` axes, which are orthonormal.
template <int N>
void orthogonalise(const std::array<std::array<double, N>, N>& axis, std::size_t count,
                   std::array<double, N>& v) {
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t j = 0; j < count; ++j) {
      const double along = InnerHull<N>::product(v, axis[j]);
      for (std::size_t k = 0; k < N; ++k) v[k] -= along * axis[j][k];
    }
  }
}

/// A unit vector orthogonal to the first `count` axes, near the axis of coordinates that is farthest from
/// them.
template <int N>
std::array<double, N> off_axes(const std::array<std::array<double, N>, N>& axis, std::size_t count) {
  std::array<double, N> best{};
  double most = -1;
  for (std::size_t c = 0; c < N; ++c) {
    std::array<double, N> v{};
    v[c] = 1;
    orthogonalise<N>(axis, count, v);
    const double rest = InnerHull<N>::product(v, v);
    if (!(rest > most)) continue;
    most = rest;
    best = v;
  }
  make_unit(best);
  return best;
}

}  // namespace

class HullDepth::Search {
 public:
  virtual ~Search() = default;
  virtual DepthEnd run(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q, double tolerance,
                       const double* start, const Stopwatch& watch) = 0;
  virtual void put_normal(Vector& u) const = 0;
  virtual void put_points(Vector& a1, Vector& a2) const = 0;

  double lower() const noexcept { return lower_; }
  double upper() const noexcept { return upper_; }
  int iterations() const noexcept { return iterations_; }
  std::int64_t queries() const noexcept { return queries_; }

 protected:
  double lower_ = 0, upper_ = kInfinity;
  int iterations_ = 0;
  std::int64_t queries_ = 0;
};

template <int N>
class HullDepth::SearchIn final : public Search {
 public:
  using Hull = InnerHull<N>;
  using Array = typename Hull::Array;
  using Point = HullPoint<N>;

  DepthEnd run(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q, double tolerance,
               const double* start, const Stopwatch& watch) override;
  void put_normal(Vector& u) const override;
  void put_points(Vector& a1, Vector& a2) const override;

 private:
  struct Entry {
    double value;
    std::int32_t facet;
    std::int64_t stamp;
    bool operator<(const Entry& other) const noexcept { return value > other.value; }
  };

  void bind(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q);
  double metric(const Array& u, double side) const;
  void probe(const Array& u, Point& point);
  void probe_from_outside();
  bool farther(const Array& u, const Array& from, Point& point);
  bool begin(const double* start);
  void queue_new_facets();
  const Entry& least();
  bool is_done() const { return Bounds(lower_, upper_).close(tolerance_ * kDown); }
  // A gap that closes is less than what the bounds of one facet lose, and so is the one that is left.
  bool is_lost() const { return std::max(tolerance_ * upper_, upper_ - lower_) * height_ < kLost * error_; }
  DepthEnd expand(const Stopwatch& watch);
  bool weights(const HullFacet<N>& facet, const Array& u, double outside, Array& weight) const;

  const ConvexSet *A1_ = nullptr, *A2_ = nullptr, *Q_ = nullptr;
  Array of_metric_{}, normal_{};
  double error_ = 0, size_ = 0, tolerance_ = 0, height_ = 0;  // height_: h_Q(normal_), from below
  bool solid_ = false;
  Hull hull_;
  std::vector<Entry> heap_;
};

// A rounding more than the support mappings have, for the difference.
template <int N>
void HullDepth::SearchIn<N>::bind(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q) {
  A1_ = &A1;
  A2_ = &A2;
  Q_ = &Q;
  Array of_1, of_2;
  A1.magnitude_unchecked(of_1.data());
  A2.magnitude_unchecked(of_2.data());
  Q.magnitude_unchecked(of_metric_.data());
  double squares = 0;
  for (std::size_t k = 0; k < N; ++k) squares += (of_1[k] + of_2[k]) * (of_1[k] + of_2[k]);
  const double reach = std::sqrt(squares) * (1 + 0x1p-40);
  error_ = ConvexSet::rounding_error(N + 1) * reach;
  size_ = 2 * reach;
}

// h_Q(u): a number that is not below it, or one that is not above it.
template <int N>
double HullDepth::SearchIn<N>::metric(const Array& u, double side) const {
  Array q;
  const double height = Q_->support_unchecked(u.data(), q.data());
  double error = 0;
  for (std::size_t k = 0; k < N; ++k) error += std::fabs(u[k]) * of_metric_[k];
  return height + side * (ConvexSet::rounding_error(N) * error + 0x1p-50 * std::fabs(height));
}

// The support point for a u of length 1, whose height may be a better upper bound.
template <int N>
void HullDepth::SearchIn<N>::probe(const Array& u, Point& point) {
  const Array back = negated(u);
  const double height = A2_->support_unchecked(u.data(), point.a2.data()) +
                        A1_->support_unchecked(back.data(), point.a1.data());
  queries_ += 2;
  for (std::size_t k = 0; k < N; ++k) point.s[k] = point.a2[k] - point.a1[k];
  const double of_metric = metric(u, -1);
  if (!(of_metric > 0)) return;
  const double upper = std::max((height + error_ * kUp) / of_metric * kUp, 0.0);
  if (!(upper < upper_)) return;
  upper_ = upper;
  normal_ = u;
  height_ = of_metric;
}

// Of the support points for u and -u the one that is farther from the plane through `from`. False if both are
// in that plane: D is flat.
template <int N>
bool HullDepth::SearchIn<N>::farther(const Array& u, const Array& from, Point& point) {
  Point below;
  probe(u, point);
  probe(negated(u), below);
  const double base = Hull::product(u, from), up = Hull::product(u, point.s) - base,
               down = base - Hull::product(u, below.s);
  if (down > up) point = below;
  return std::max(up, down) > 4 * (Hull::noise_of(size_) + error_);
}

// A simplex of support points, each as far as possible from the plane of those before it. False if D is flat.
template <int N>
bool HullDepth::SearchIn<N>::begin(const double* start) {
  std::array<Point, N + 1> corner{};
  std::array<Array, N> axis{};  // orthonormal: of the edges so far
  Array u{};
  for (std::size_t k = 0; start != nullptr && k < N; ++k) u[k] = start[k];
  if (!make_unit(u)) u[0] = 1;
  probe(u, corner[0]);
  u = negated(u);
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0) u = off_axes<N>(axis, i);
    if (!farther(u, corner[0].s, corner[i + 1])) return false;
    for (std::size_t k = 0; k < N; ++k) axis[i][k] = corner[i + 1].s[k] - corner[0].s[k];
    orthogonalise<N>(axis, i, axis[i]);
    make_unit(axis[i]);
  }
  return hull_.begin(corner.data(), size_, error_);
}

template <int N>
void HullDepth::SearchIn<N>::queue_new_facets() {
  for (const std::int32_t i : hull_.made()) {
    const HullFacet<N>& facet = hull_.facet(i);
    const double certain = facet.offset - error_ * kUp;
    double value = certain;
    if (certain > 0) {
      // A direction in which Q does not reach is no obstacle to it.
      const double of_metric = metric(facet.n, 1);
      value = of_metric > 0 ? certain / of_metric * kDown : kInfinity;
    }
    heap_.push_back({value, i, facet.stamp});
    std::push_heap(heap_.begin(), heap_.end());
  }
}

template <int N>
auto HullDepth::SearchIn<N>::least() -> const Entry& {
  while (hull_.facet(heap_.front().facet).stamp != heap_.front().stamp) {
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
  }
  return heap_.front();
}

// The mean of the normals of the facets that the origin is not proven to be below: if it is outside of D, or
// on a curved corner of it, this may show it where no facet's normal does.
template <int N>
void HullDepth::SearchIn<N>::probe_from_outside() {
  Array u{};
  for (const Entry& entry : heap_) {
    const HullFacet<N>& facet = hull_.facet(entry.facet);
    if (entry.value > 0 || facet.stamp != entry.stamp) continue;
    for (std::size_t k = 0; k < N; ++k) u[k] += facet.n[k];
  }
  Point point;
  if (make_unit(u)) probe(u, point);
}

template <int N>
DepthEnd HullDepth::SearchIn<N>::expand(const Stopwatch& watch) {
  Point point;
  int setbacks = 0;
  for (; iterations_ < kMostIterations && hull_.facet_count() < kMostFacets; ++iterations_) {
    const Entry entry = least();
    if (entry.value < lower_) ++setbacks;
    lower_ = std::max(lower_, entry.value);
    if (is_done()) return DepthEnd::closed;
    // Where the origin may be on the boundary, or just outside, another direction may prove it.
    if (is_lost() && (lower_ > 0 || ++setbacks > kMostSetbacks)) return DepthEnd::rounding;
    if (setbacks > kMostSetbacks) return DepthEnd::rounding;
    if (iterations_ % kIterationsBetweenLooks == kIterationsBetweenLooks - 1 && watch.expired())
      return DepthEnd::time;
    const bool power_of_two = (iterations_ & (iterations_ - 1)) == 0;
    if (!(entry.value > 0) && power_of_two) probe_from_outside();
    const HullFacet<N>& facet = hull_.facet(entry.facet);
    probe(facet.n, point);
    if (is_done()) return DepthEnd::closed;
    const double above = hull_.above(facet, point.s);
    if (!(above > hull_.noise()) || !hull_.add(entry.facet, point)) return DepthEnd::rounding;
    queue_new_facets();
  }
  return DepthEnd::limit;
}

template <int N>
DepthEnd HullDepth::SearchIn<N>::run(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q,
                                     double tolerance, const double* start, const Stopwatch& watch) {
  bind(A1, A2, Q);
  tolerance_ = tolerance;
  lower_ = 0;
  upper_ = kInfinity;
  iterations_ = 0;
  queries_ = 0;
  heap_.clear();
  solid_ = begin(start);
  if (!solid_) return is_done() ? DepthEnd::closed : DepthEnd::flat;
  queue_new_facets();
  return expand(watch);
}

template <int N>
void HullDepth::SearchIn<N>::put_normal(Vector& u) const {
  u.resize(upper_ < kInfinity ? N : 0);
  for (Eigen::Index k = 0; k < u.size(); ++k) u[k] = normal_[static_cast<std::size_t>(k)] / height_;
}

// Of t u = Σ w_i s_i over the corners, Σ w_i = 1. False unless the least weight is above `outside`.
template <int N>
bool HullDepth::SearchIn<N>::weights(const HullFacet<N>& facet, const Array& u, double outside,
                                     Array& weight) const {
  Eigen::Matrix<double, N, N> corners;
  for (int i = 0; i < N; ++i)
    corners.col(i) = Eigen::Map<const Eigen::Matrix<double, N, 1>>(
        hull_.point(facet.corner[static_cast<std::size_t>(i)]).s.data());
  const Eigen::Matrix<double, N, 1> w =
      corners.partialPivLu().solve(Eigen::Map<const Eigen::Matrix<double, N, 1>>(u.data()));
  const double sum = w.sum();
  if (!(sum > 0) || !(w.minCoeff() > outside * sum)) return false;
  const double kept = w.cwiseMax(0.0).sum();
  for (int i = 0; i < N; ++i) weight[static_cast<std::size_t>(i)] = std::max(w[i], 0.0) / kept;
  return true;
}

template <int N>
void HullDepth::SearchIn<N>::put_points(Vector& a1, Vector& a2) const {
  constexpr double kOutside = -1e-9, kSamePlane = 1 + 1e-9;
  a1.resize(0);
  a2.resize(0);
  if (!solid_ || !(lower_ > 0)) return;
  Array way;
  Q_->support_unchecked(normal_.data(), way.data());
  const auto meets = [&](const Entry& entry) {
    const HullFacet<N>& facet = hull_.facet(entry.facet);
    const double along = facet.stamp == entry.stamp ? Hull::product(facet.n, way) : 0.0;
    return along > 0 ? facet.reach / along : kInfinity;
  };
  double first = kInfinity;
  for (const Entry& entry : heap_) first = std::min(first, meets(entry));
  for (const Entry& entry : heap_) {
    Array weight;
    if (!(meets(entry) <= first * kSamePlane)) continue;
    const HullFacet<N>& facet = hull_.facet(entry.facet);
    if (!weights(facet, way, kOutside, weight)) continue;
    a1.setZero(N);
    a2.setZero(N);
    for (std::size_t i = 0; i < N; ++i) {
      const Point& p = hull_.point(facet.corner[i]);
      a1 += weight[i] * Eigen::Map<const Eigen::Matrix<double, N, 1>>(p.a1.data());
      a2 += weight[i] * Eigen::Map<const Eigen::Matrix<double, N, 1>>(p.a2.data());
    }
    return;
  }
}

HullDepth::HullDepth() = default;
HullDepth::~HullDepth() = default;
HullDepth::HullDepth(HullDepth&&) noexcept = default;
HullDepth& HullDepth::operator=(HullDepth&&) noexcept = default;

DepthEnd HullDepth::run(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q, double tolerance,
                        const double* start, const Stopwatch& watch) {
  const int n = Q.dimension();
  std::unique_ptr<Search>& search = search_[static_cast<std::size_t>(n - kLeast)];
  if (search == nullptr) {
    if (n == 4) search = std::make_unique<SearchIn<4>>();
    if (n == 5) search = std::make_unique<SearchIn<5>>();
    if (n == 6) search = std::make_unique<SearchIn<6>>();
  }
  used_ = search.get();
  return used_->run(A1, A2, Q, tolerance, start, watch);
}

double HullDepth::lower() const noexcept { return used_->lower(); }
double HullDepth::upper() const noexcept { return used_->upper(); }
int HullDepth::iterations() const noexcept { return used_->iterations(); }
std::int64_t HullDepth::queries() const noexcept { return used_->queries(); }
void HullDepth::put_normal(Vector& u) const { used_->put_normal(u); }
void HullDepth::put_points(Vector& a1, Vector& a2) const { used_->put_points(a1, a2); }

}  // namespace raygauge
