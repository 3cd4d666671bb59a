// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

class BoundedInverse;

/// {M x + t : x in S}, what AffineImage, sets in poses and placed bodies have in common; it refers to S, M
/// and t, which its subclass keeps.
///
///     h(u) = h_S(Mᵀu) + u·t,      s(u) = M s_S(Mᵀu) + t,      centre M c_S + t.
///
/// What S offers beyond its support function is kept: pieces and flat faces always, its gauge where t = 0. A
/// proof that it touches the origin, and symmetry about the axes, are kept where M only exchanges, reverses
/// and scales the axes.
class LinearImage : public ConvexSet,
                    private SmoothSupport,
                    private FlatFaces,
                    private GaugeFormula,
                    private CoordinateSymmetry {
 protected:
  /// M, n × n by columns, with what is known of its inverse.
  struct Map {
    const double* M = nullptr;
    const double* t = nullptr;
    const BoundedInverse* inverse = nullptr;  ///< nullptr for a rotation: its inverse is Mᵀ, up to the defect
    double defect = 0;            ///< of a rotation: at least ‖MᵀM - 1‖ in the spectral norm
    bool exchanges_axes = false;  ///< each row and each column of M has one entry that is not 0
    bool reverses_axes = false;   ///< the same, and these entries are 1 or -1
  };

  explicit LinearImage(int dimension) : ConvexSet(dimension) {}

  /// What this is the image of. All must outlive their use.
  void look_at(const ConvexSet& S, const Map& map) noexcept {
    S_ = &S;
    map_ = map;
  }

  /// M and t, with `exchanges_axes` and `reverses_axes` from the entries of M.
  static Map make_map(const double* M, const double* t, int n) noexcept;

  const ConvexSet& operand() const noexcept { return *S_; }

 private:
  double do_support(const double* u, double* point) const final;
  void do_center(double* point) const final;
  void do_magnitude(double* magnitude) const final;
  double do_inner_radius(const double* c) const final;
  SupportStructure do_structure() const noexcept final { return S_->structure(); }
  const SmoothSupport* do_smooth() const noexcept final;
  const FlatFaces* do_flat_faces() const noexcept final;
  const GaugeFormula* do_gauge_formula() const noexcept final;
  const CoordinateSymmetry* do_symmetry() const noexcept final;

  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const final;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const final;
  bool do_facet_normal(const double* u, const double* v, double* normal) const final;
  void do_facet_point(const double* normal, const double* target, double* point) const final;
  bool do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const final;
  void do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const final;
  double do_gauge(const double* x, double* normal) const final;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const final;
  bool do_touches_origin(double* u) const final;
  bool do_is_unconditional(double* extent) const final;

  template <class Real>
  void map_linearly(const Real* x, int stride, Real* image) const noexcept;
  template <class Real>
  void map_back(const Real* u, Real* inner) const noexcept;
  template <class Real>
  void divide(const Real* image, Real* x) const noexcept;
  template <class Real>
  void find_preimage(const Real* image, Real* x) const noexcept;
  template <class Real>
  void map_normal(const Real* inner, Real* normal) const noexcept;
  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;
  template <class Real>
  bool find_facet_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void find_facet_point(const Real* normal, const Real* target, Real* point) const;
  void map(const double* x, double* image) const noexcept;
  bool is_translated() const noexcept;
  bool has_inverse() const noexcept;
  double least_stretch() const noexcept;
  double preimage_error(const double* image, const double* x) const;

  const ConvexSet* S_ = nullptr;
  Map map_;
};

/// {M x + t : x in S}, the image of S under an invertible affine map of R^n. See LinearImage for what it
/// keeps of S.
///
///     h(u) = h_S(Mᵀu) + u·t,      s(u) = M s_S(Mᵀu) + t,      centre M c_S + t.
class AffineImage final : public LinearImage {
 public:
  /// M is n × n. Throws InvalidParameterError (null pointer, or M singular: after its rows and columns are
  /// scaled, a pivot of its LU factors is below n ε of the largest), DimensionMismatchError or
  /// NonFiniteError.
  AffineImage(std::shared_ptr<const ConvexSet> S, const Eigen::Ref<const Eigen::MatrixXd>& M,
              const ConstVectorRef& t);

  /// The same for a rigid motion: the rotation is that of nearest_rotation(), which may throw.
  static std::shared_ptr<const AffineImage> rigid(std::shared_ptr<const ConvexSet> S,
                                                  const Eigen::Ref<const Eigen::MatrixXd>& R,
                                                  const ConstVectorRef& t);

  const std::shared_ptr<const ConvexSet>& S() const noexcept { return S_; }
  const DenseMatrix& M() const noexcept { return M_; }
  const Vector& t() const noexcept { return t_; }

 private:
  std::shared_ptr<const ConvexSet> S_;
  DenseMatrix M_;
  Vector t_;
  std::shared_ptr<const BoundedInverse> inverse_;  // of M
};

}  // namespace raygauge
