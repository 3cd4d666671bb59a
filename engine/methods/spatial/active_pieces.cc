// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/active_pieces.h"

#include <algorithm>

namespace raygauge {

template <class Pair>
void ActivePieces<Pair>::begin(const SpatialCombination& combination) {
  count = 0;
  for (int i = 0; i < combination.count; ++i) {
    Point piece;
    if constexpr (kIsDouble<Real>) piece = combination.point[i];  // vertices have their places
    piece.index_1 = combination.point[i].index_1;
    piece.index_2 = combination.point[i].index_2;
    const int known = find(piece);
    if (known == kMostToBegin) continue;
    point[known] = piece;
    weight[known] = combination.weight[i] + (known < count ? weight[known] : 0.0);
    count = std::max(count, known + 1);
  }
}

template <class Pair>
int ActivePieces<Pair>::find(const Point& piece) const {
  const Point* found =
      std::find_if(point, point + count, [&](const Point& known) { return known.has_same_pieces(piece); });
  return static_cast<int>(found - point);
}

template <class Pair>
void ActivePieces<Pair>::add(const Point& piece) {
  if (count == kMost) return;
  weight[count] = count == 0 ? 1 : 0;
  point[count++] = piece;
}

template <class Pair>
void ActivePieces<Pair>::follow(const Pair& pair, const Vector& u, const Point* highest) {
  int left = 0;
  const Point* followed = nullptr;
  for (int i = 0; i < count; ++i) {
    Point& moved = point[left];
    if (i != left) moved = point[i];
    if (highest != nullptr && moved.has_same_pieces(*highest)) {
      moved = *highest;
    } else if (!pair.follow(u, moved, followed)) {
      continue;
    }
    weight[left++] = weight[i];
    followed = &moved;
  }
  count = left;
  if (highest != nullptr && find(*highest) == count) add(*highest);
}

// Whether pieces k and i differ in vertices alone: they have the same Hessian.
template <class Pair>
bool ActivePieces<Pair>::share(const Pair& pair, int k, int i) const {
  for (int body = 0; body < 2; ++body) {
    if (is_curved(pair.shape(body)) && point[k].index(body) != point[i].index(body)) return false;
  }
  return true;
}

template <class Pair>
Matrix3 ActivePieces<Pair>::hessian(const Pair& pair, const Vector3& u) const {
  Matrix3 H;
  double total[kMost];
  std::copy_n(weight, count, total);
  for (int i = 0; i < count; ++i) {
    int k = 0;
    while (k < i && !share(pair, k, i)) ++k;
    if (k == i) continue;
    total[k] += total[i];
    total[i] = 0;
  }
  for (int i = 0; i < count; ++i) {
    if (total[i] > 0) pair.in_doubles().add_hessian(u, point[i].index_1, point[i].index_2, total[i], H);
  }
  return H;
}

template <class Pair>
TangentMetric ActivePieces<Pair>::metric(const Pair& pair, const Vector& u, double lambda,
                                         double damping) const {
  Vector3 normal = pair.to_first(u);
  if constexpr (!kIsDouble<Real>) normal = normal * (1 / length(normal));
  const Matrix3 H = hessian(pair, normal);
  const double size = H.column[0].x + H.column[1].y + H.column[2].z;
  TangentMetric metric(normal, H, lambda + damping * size + pair.error());
  if constexpr (!kIsDouble<Real>) {
    for (Vector3& tangent : metric.tangent) tangent = pair.to_world(tangent);
  }
  return metric;
}

template <class Pair>
void ActivePieces<Pair>::keep(const ContactStep<Real>& found) {
  if (found.count > 1 || found.piece[0] != 0) {
    Point kept[3];
    for (int i = 0; i < found.count; ++i) kept[i] = point[found.piece[i]];
    std::copy_n(kept, found.count, point);
  }
  count = found.count;
  for (int i = 0; i < count; ++i) {
    weight[i] = std::clamp(rounded(found.weight[i]), 0.0, 1.0);
  }
}

template <class Pair>
auto ActivePieces<Pair>::combine(const ContactStep<Real>& found) const -> Point {
  Point sum = point[0];
  if (found.count == 1) return sum;
  sum.s = sum.a1 = sum.a2 = {};
  Real all{};
  for (int i = 0; i < found.count; ++i) {
    if (!(found.weight[i] > Real{})) continue;
    sum.s = sum.s + point[i].s * found.weight[i];
    sum.a1 = sum.a1 + point[i].a1 * found.weight[i];
    sum.a2 = sum.a2 + point[i].a2 * found.weight[i];
    all = all + found.weight[i];
  }
  const Real share = Real{1} / all;
  sum.s = sum.s * share;
  sum.a1 = sum.a1 * share;
  sum.a2 = sum.a2 * share;
  return sum;
}

template struct ActivePieces<SpatialPair>;
template struct ActivePieces<PrecisePair>;

}  // namespace raygauge
