// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/methods/spatial/pair_frames.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// The difference of two placed cores, over the number type and the frame of reference: support points, and
/// the pieces that these are on.
template <class Frame>
class CorePair {
 public:
  using Real = typename Frame::Real;
  using Vector = BasicVector3<Real>;
  using Point = PairPoint<Real>;

  const SpatialShape& shape(int i) const noexcept { return frame_.shape(i); }
  double radius() const noexcept { return shape(0).radius + shape(1).radius; }

  /// Whether a core is curved, so that its points have to follow a normal.
  bool is_curved() const noexcept { return curved_; }

  /// What is computed here of points and heights is within this of the truth.
  double error() const noexcept { return error_; }
  std::int64_t queries() const noexcept { return queries_; }

  const Frame& frame() const noexcept { return frame_; }
  InstructionSet instruction_set() const noexcept { return isa_; }

  /// The difference of two vertices of the cores by their indices; false where there are none.
  bool core_vertex(std::int32_t index_1, std::int32_t index_2, Point& point) const {
    if (!find_vertex<0>(index_1, point) || !find_vertex<1>(index_2, point)) return false;
    point.index_1 = index_1;
    point.index_2 = index_2;
    frame_.subtract(point);
    return true;
  }

  /// Of the vertices and rims that `point`'s indices name, the latter's points those for u; of a core that
  /// has none by that index, the highest point.
  void find_named(const Vector& u, Point& point) {
    look_again(u, u, {.index_1 = point.index_1, .index_2 = point.index_2}, point);
    frame_.subtract(point);
  }

  /// Whether a point of one core is inside the other one for certain. `point` is a pair of their points, or a
  /// combination of such pairs, with the outer normal u, its indices those of any of them. The point of the
  /// other core is x_1 - R⁻¹s in the frame of the first one, x_2 + R⁻¹s in that of the second, and R⁻¹ is Rᵀ
  /// but for the defect of the pose.
  bool overlap(const Vector& u, const Point& point) const {
    const Vector3 s = rounded(point.s), normal = rounded(u);
    const double away = length(s), height = dot(normal, s) / length(normal);
    for (int i = 0; i < 2; ++i) {
      const double margin = 4 * error_ + frame_.slack(i, away);
      const bool inside = with_core(shape(i), [&](const auto& core) {
        if constexpr (requires { core.kIsCurved; })
          return core.holds(frame_.own(i, point), frame_.into(i, point.s), height, margin);
        return false;
      });
      if (inside) return true;
    }
    return false;
  }

 protected:
  /// The bodies of the frame are new.
  void begin() noexcept {
    curved_ = raygauge::is_curved(shape(0)) || raygauge::is_curved(shape(1));
    queries_ = 0;
  }

  /// The highest points of both cores, put into `point` if `kPoints`; use(i, v, height) is called for each
  /// with the normal v that body i sees, and h(v) of its core.
  template <bool kPoints, class Use>
  [[gnu::always_inline]] void look(const Vector& u, Point& point, const Use& use) {
    look_at<0, kPoints>(u, point, use);
    look_at<1, kPoints>(u, point, use);
    queries_ += 2;
  }

  /// The same along a direction for each, but that a core has the vertex or the rim that `corner` names,
  /// where there is one.
  void look_again(const Vector& u_1, const Vector& u_2, const DepthMemory::Corner& corner, Point& point) {
    look_again_at<0>(u_1, corner.index_1, point);
    look_again_at<1>(u_2, corner.index_2, point);
  }

  /// The point that the pieces of `point`'s indices have for u; a ball has its centre whatever its index.
  /// False where u is so near the axis of a rim that this says nothing, and where an index names no vertex of
  /// a core that has nothing else. `followed` is a point that has followed u before, or null: it may share a
  /// piece.
  [[gnu::always_inline]] bool find_pieces(const Vector& u, Point& point, const Point* followed) const {
    if (!find_piece<0>(u, point, followed) || !find_piece<1>(u, point, followed)) return false;
    frame_.subtract(point);
    return true;
  }

  Frame frame_;
  InstructionSet isa_ = InstructionSet::automatic;
  double error_ = 0;
  bool curved_ = false;
  std::int64_t queries_ = 0;

 private:
  template <int i, bool kPoints, class Use>
  [[gnu::always_inline]] void look_at(const Vector& u, Point& point, const Use& use) const {
    const Vector v = frame_.into(i, u);
    with_core(shape(i), [&](const auto& core) {
      const auto view = core.look(v, isa_);
      point.index(i) = view.index;
      if constexpr (kPoints) frame_.put(i, view.point(view.index), point);
      use(i, v, view.height(view.index));
    });
  }

  template <int i>
  void look_again_at(const Vector& u, std::int32_t index, Point& point) {
    const bool known = with_core(shape(i), [&](const auto& core) {
      point.index(i) = index;
      if (index >= 0 && index < core.vertex_count()) {
        frame_.put(i, core.vertex(index), point);
        return true;
      }
      if constexpr (requires { core.top_of_rim(u, index); }) {
        if (core.is_rim(index)) {
          frame_.put(i, core.top_of_rim(frame_.into(i, u), index), point);
          return true;
        }
      }
      return false;
    });
    if (known) return;
    look_at<i, true>(u, point, [](int, const Vector&, double) {});
    ++queries_;
  }

  template <int i>
  bool find_vertex(std::int32_t index, Point& point) const {
    return with_core(shape(i), [&](const auto& core) {
      if (index < 0 || index >= core.vertex_count()) return false;
      frame_.put(i, vector_of<Real>(core.vertex(index)), point);
      return true;
    });
  }

  template <int i>
  [[gnu::always_inline]] bool find_piece(const Vector& u, Point& point, const Point* followed) const {
    const std::int32_t index = point.index(i);
    return with_core(shape(i), [&](const auto& core) {
      if constexpr (requires { core.kIsCurved; }) {
        if (followed != nullptr && index == followed->index(i)) {
          point.a(i) = followed->a(i);
          return true;
        }
        const auto view = core.look(frame_.into(i, u), isa_);
        if (!kIsDouble<Real> && view.is_flat()) return false;
        frame_.put(i, view.point(index), point);
      } else if constexpr (!Frame::kKeepsVertices) {
        if (index < 0 && !is_point(core.shape)) return false;
        frame_.put(i, vector_of<Real>(core.vertex(std::max(index, 0))), point);
      }
      return true;
    });
  }
};

}  // namespace raygauge
