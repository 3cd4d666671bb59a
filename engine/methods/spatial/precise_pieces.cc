// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_pieces.h"

#include <algorithm>

namespace raygauge {

void PrecisePieces::begin(const SpatialCombination& combination) {
  count = 0;
  for (int i = 0; i < combination.count; ++i) {
    PrecisePoint piece;
    piece.index_1 = combination.point[i].index_1;
    piece.index_2 = combination.point[i].index_2;
    const int known = find(piece);
    if (known == count && count == 3) continue;
    point[known] = piece;
    weight[known] = combination.weight[i] + (known < count ? weight[known] : 0.0);
    count = std::max(count, known + 1);
  }
}

int PrecisePieces::find(const PrecisePoint& piece) const {
  const auto* found = std::find_if(point, point + count,
                                   [&](const PrecisePoint& known) { return known.has_same_pieces(piece); });
  return static_cast<int>(found - point);
}

void PrecisePieces::follow(const PrecisePair& precise, const PreciseVector3& u, const PrecisePoint* highest) {
  int left = 0;
  const PrecisePoint* followed = nullptr;
  for (int i = 0; i < count; ++i) {
    PrecisePoint moved = point[i];
    const bool same = highest != nullptr && moved.has_same_pieces(*highest);
    if (same) moved = *highest;
    if (!same && !precise.follow(u, moved, followed)) continue;
    weight[left] = weight[i];
    point[left] = moved;
    if (!same) followed = &point[left];
    ++left;
  }
  count = left;
  if (highest == nullptr || find(*highest) < count) return;
  weight[count] = count == 0 ? 1 : 0;
  point[count++] = *highest;
}

TangentMetric PrecisePieces::metric(const SpatialPair& pair, const PreciseVector3& u, double lambda,
                                    double damping) const {
  const double in_world[3] = {u.x.high, u.y.high, u.z.high};
  Vector3 normal = pair.to_body(in_world);
  normal = normal * (1 / length(normal));
  Matrix3 H;
  for (int i = 0; i < count; ++i) {
    SpatialPoint piece;
    piece.index_1 = point[i].index_1;
    piece.index_2 = point[i].index_2;
    if (weight[i] > 0) pair.add_hessian(normal, piece, weight[i], H);
  }
  const double size = H.column[0].x + H.column[1].y + H.column[2].z;
  TangentMetric metric(normal, H, lambda + damping * size);
  for (Vector3& tangent : metric.tangent) {
    double world[3] = {0, 0, 0};
    pair.to_world(tangent, world);
    tangent = {world[0], world[1], world[2]};
  }
  return metric;
}

void PrecisePieces::keep(const ContactStep<DoubleDouble>& found) {
  PrecisePoint kept[3];
  for (int i = 0; i < found.count; ++i) kept[i] = point[found.piece[i]];
  count = found.count;
  for (int i = 0; i < count; ++i) {
    point[i] = kept[i];
    weight[i] = std::max(0.0, found.weight[i].rounded());
  }
}

}  // namespace raygauge
