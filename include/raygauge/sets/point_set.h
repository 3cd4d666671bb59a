// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// A point of a PointSet, by its index, and its weight in a convex combination.
struct PointWeight {
  std::ptrdiff_t index = 0;
  double weight = 0;
};

class ClusterTree;
struct IsotropicMap;

/// conv{p_1, …, p_N}, the convex hull of N points of R^n (a V-polytope).
///
///     h(u) = max_i u·p_i,      s(u) = p_{i*}, i* the smallest maximising index.
///
/// Any N >= 1 and any rank are valid: one point, a segment, N < n+1, duplicated and interior points.
///
/// Storage: the points are stored in blocks of kLanes = 8; within a block coordinate k of the 8 points is
/// contiguous,
///
///     data()[(block * n + k) * 8 + lane]   is coordinate k of point 8 * block + lane,
///
/// so that a support query is one sequential stream of whole 64-byte cache lines for any n, at any vector
/// width. The last block is filled up with copies of the last point, which changes no maximum.
class PointSet final : public ConvexSet, private SmoothSupport {
 public:
  static constexpr int kLanes = 8;

  /// `points` is n × N, one point a column. Throws EmptySetError, InvalidParameterError (n < 1) or
  /// NonFiniteError (the message names the point and the coordinate, both counted from 0).
  explicit PointSet(const Eigen::Ref<const Eigen::MatrixXd>& points);
  ~PointSet() override;

  /// The same points with a tree of clusters, in the order of the tree; a support query then reads few of
  /// them. Where a tree does not pay (few points, many dimensions), the points as they are.
  static std::unique_ptr<const PointSet> clustered(const Eigen::Ref<const Eigen::MatrixXd>& points);

  /// nullptr, except in a set made by clustered().
  const ClusterTree* tree() const noexcept { return tree_.get(); }

  /// N, the number of points.
  std::ptrdiff_t size() const noexcept { return size_; }

  /// Point i, 0 <= i < size(). Throws InvalidParameterError outside that range.
  Vector point(std::ptrdiff_t i) const;

  /// All points, n × N, one a column.
  DenseMatrix points() const;

  /// Number of 8-point blocks, ceil(N / 8), and the blocked coordinates (64-byte aligned).
  std::ptrdiff_t block_count() const noexcept { return block_count_; }
  const double* data() const noexcept { return data_.get(); }

  /// The points rounded to single precision in blocks of kSingleLanes = 16, otherwise as data(); only for
  /// sets of up to single_numbers(n) coordinates, nullptr for larger ones. They serve to choose points, never
  /// to prove anything.
  static constexpr int kSingleLanes = 16;
  static constexpr std::ptrdiff_t single_numbers(int n) noexcept { return n <= 10 ? 65536 : 16384; }
  const float* single_data() const noexcept { return single_data_.get(); }
  std::ptrdiff_t single_block_count() const noexcept { return (size_ + kSingleLanes - 1) / kSingleLanes; }

  /// max_i |coordinate k of p_i|, dimension() doubles: the scale of rounding errors in u·p_i.
  const double* coordinate_magnitude() const noexcept { return magnitude_.data(); }

  /// Smallest |coordinate k of p_i| that is not zero, dimension() doubles; +infinity where all are zero.
  const double* smallest_magnitude() const noexcept { return smallest_magnitude_.data(); }

  /// N^(-1/(n-1)): the distance between neighbours, to a factor, if the N points were spread evenly on the
  /// unit sphere. It says how far the normal of a facet may turn from that of the smooth body which the
  /// points sample.
  double spacing() const noexcept { return spacing_; }

  /// The isotropic map of the points; nullptr where they need none.
  const IsotropicMap* isotropic() const noexcept { return isotropic_.get(); }

  /// Copies point i to `out` (dimension() doubles); unchecked.
  void copy_point(std::ptrdiff_t i, double* out) const noexcept {
    const double* block = data_.get() + (i / kLanes) * dimension() * kLanes + i % kLanes;
    for (int k = 0; k < dimension(); ++k) out[k] = block[static_cast<std::ptrdiff_t>(k) * kLanes];
  }

 private:
  struct AlignedDelete {
    void operator()(void* p) const noexcept;
  };

  void round_to_single();

  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  SupportStructure do_structure() const noexcept override;
  const SmoothSupport* do_smooth() const noexcept override { return size_ == 1 ? this : nullptr; }
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;

  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;

  std::ptrdiff_t size_;
  std::ptrdiff_t block_count_;
  std::unique_ptr<double[], AlignedDelete> data_;
  std::unique_ptr<float[], AlignedDelete> single_data_;
  Vector magnitude_;
  Vector smallest_magnitude_;
  Vector center_;
  double spacing_;
  std::unique_ptr<const IsotropicMap> isotropic_;
  std::unique_ptr<const ClusterTree> tree_;
};

/// S as the point set that it is, or nullptr.
const PointSet* as_point_set(const ConvexSet& S) noexcept;

}  // namespace raygauge
