// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/body_factors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <queue>
#include <utility>

#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

std::size_t index(int number) { return static_cast<std::size_t>(number); }

// In rising order.
std::vector<std::vector<int>> neighbours_of(const FrictionIsland& island) {
  std::vector<std::vector<int>> all(index(island.bodies));
  for (const IslandContact& contact : island.contacts) {
    if (contact.a < 0 || contact.b < 0 || contact.a == contact.b) continue;
    all[index(contact.a)].push_back(contact.b);
    all[index(contact.b)].push_back(contact.a);
  }
  for (std::vector<int>& some : all) {
    std::sort(some.begin(), some.end());
    some.erase(std::unique(some.begin(), some.end()), some.end());
  }
  return all;
}

// Without a body; those that were joined by it are joined.
void eliminate(int body, std::vector<std::vector<int>>& neighbours) {
  const std::vector<int>& around = neighbours[index(body)];
  std::vector<int> joined;
  for (const int i : around) {
    std::vector<int>& own = neighbours[index(i)];
    joined.clear();
    std::set_union(own.begin(), own.end(), around.begin(), around.end(), std::back_inserter(joined));
    own.clear();
    std::copy_if(joined.begin(), joined.end(), std::back_inserter(own),
                 [i, body](int j) { return j != i && j != body; });
  }
}

// The bodies in turn, each as one of those with fewest neighbours then; what is left of `neighbours` are
// those that come later.
std::vector<int> elimination(std::vector<std::vector<int>>& neighbours) {
  using Choice = std::pair<std::size_t, int>;
  std::priority_queue<Choice, std::vector<Choice>, std::greater<>> open;
  const auto offer = [&](int body) { open.emplace(neighbours[index(body)].size(), body); };
  for (int body = 0; body < static_cast<int>(neighbours.size()); ++body) offer(body);
  std::vector<int> order;
  std::vector<bool> gone(neighbours.size(), false);
  while (!open.empty()) {
    const auto [degree, body] = open.top();
    open.pop();
    if (gone[index(body)] || degree != neighbours[index(body)].size()) continue;
    gone[index(body)] = true;
    order.push_back(body);
    eliminate(body, neighbours);
    for (const int other : neighbours[index(body)]) offer(other);
  }
  return order;
}

}  // namespace

BodyFactors::BodyFactors(const FrictionIsland& island) : pivot_of_(index(island.bodies), -1) {
  std::vector<std::vector<int>> neighbours = neighbours_of(island);
  for (const int body : elimination(neighbours)) {
    pivot_of_[index(body)] = static_cast<int>(pivots_.size());
    pivots_.push_back({body, {}, 0});
  }
  std::size_t blocks = 0;
  for (Pivot& pivot : pivots_) {
    for (const int body : neighbours[index(pivot.body)]) pivot.later.push_back(pivot_of_[index(body)]);
    std::sort(pivot.later.begin(), pivot.later.end());
    pivot.first = blocks;
    blocks += 1 + 2 * pivot.later.size();
  }
  blocks_.resize(blocks);
  for (const Pivot& pivot : pivots_) {
    for (const int row : pivot.later) {
      for (const int column : pivot.later) changed_.push_back(place_of_pivots(row, column));
    }
  }
}

void BodyFactors::set_identity() {
  std::fill(blocks_.begin(), blocks_.end(), Block());
  for (const Pivot& pivot : pivots_) {
    for (int k = 0; k < 6; ++k) blocks_[pivot.first].column[k][k] = 1;
  }
}

std::size_t BodyFactors::place_of_pivots(int row, int column) const {
  const Pivot& pivot = pivots_[index(std::min(row, column))];
  if (row == column) return pivot.first;
  const auto found = std::lower_bound(pivot.later.begin(), pivot.later.end(), std::max(row, column));
  const auto k = static_cast<std::size_t>(found - pivot.later.begin());
  return row > column ? pivot.below(k) : pivot.right(k);
}

BodyFactors::Places BodyFactors::places_of(const IslandContact& contact) const {
  Places places{};
  std::size_t* place = places.data();
  for (const int i : {contact.a, contact.b}) {
    for (const int j : {contact.a, contact.b})
      *place++ = i < 0 || j < 0 ? 0 : place_of_pivots(pivot_of_[index(i)], pivot_of_[index(j)]);
  }
  return places;
}

RAYGAUGE_VECTORS void BodyFactors::add(const IslandContact& contact, const Places& places,
                                       const Eigen::Matrix3d& M) {
  const int bodies[2] = {contact.a, contact.b};
  const ContactSlope* const slopes[2] = {&contact.A_a, &contact.A_b};
  for (int side = 0; side < 2; ++side) {
    if (bodies[side] < 0) continue;
    const ContactSlope& A = *slopes[side];
    Eight G[3], moved[3];
    for (int k = 0; k < 3; ++k) G[k] = Eight{A(0, k), A(1, k), A(2, k), A(3, k), A(4, k), A(5, k), 0, 0};
    for (int k = 0; k < 3; ++k) moved[k] = G[0] * M(0, k) + G[1] * M(1, k) + G[2] * M(2, k);
    for (int other = 0; other < 2; ++other) {
      if (bodies[other] < 0) continue;
      const ContactSlope& H = *slopes[other];
      Block& sum = blocks_[places[index(2 * side + other)]];
      for (int j = 0; j < 6; ++j)
        sum.column[j] += moved[0] * H(j, 0) + moved[1] * H(j, 1) + moved[2] * H(j, 2);
    }
  }
}

// Gauss and Jordan's method, by the largest pivot of each column.
[[gnu::always_inline]] inline void BodyFactors::invert(Block& A) {
  std::array<int, 6> row{};
  for (int k = 0; k < 6; ++k) {
    int best = k;
    for (int i = k + 1; i < 6; ++i)
      best = std::fabs(A.column[k][i]) > std::fabs(A.column[k][best]) ? i : best;
    row[index(k)] = best;
    for (Eight& column : A.column) {
      const double above = column[k];
      column[k] = column[best];
      column[best] = above;
    }
    const double inverse = 1 / A.column[k][k];
    Eight others = A.column[k];
    others[k] = 0;
    for (int j = 0; j < 6; ++j) {
      Eight& column = A.column[j];
      const double share = (j == k ? 1.0 : column[k]) * inverse;
      column = (j == k ? Eight{} : column) - share * others;
      column[k] = share;
    }
  }
  for (int k = 6; k-- > 0;) std::swap(A.column[k], A.column[row[index(k)]]);
}

[[gnu::always_inline]] inline Eight BodyFactors::product(const Block& A, const Eight& x) {
  return ((A.column[0] * x[0] + A.column[1] * x[1]) + (A.column[2] * x[2] + A.column[3] * x[3])) +
         (A.column[4] * x[4] + A.column[5] * x[5]);
}

RAYGAUGE_VECTORS void BodyFactors::factorize() {
  const std::size_t* changed = changed_.data();
  for (const Pivot& pivot : pivots_) {
    Block& inverse = blocks_[pivot.first];
    invert(inverse);
    for (std::size_t i = 0; i < pivot.later.size(); ++i) {
      Block& below = blocks_[pivot.below(i)];
      const Block before = below;
      for (int k = 0; k < 6; ++k) below.column[k] = product(before, inverse.column[k]);
      for (std::size_t j = 0; j < pivot.later.size(); ++j) {
        const Block& right = blocks_[pivot.right(j)];
        Block& changes = blocks_[*changed++];
        for (int k = 0; k < 6; ++k) changes.column[k] -= product(below, right.column[k]);
      }
    }
  }
}

void BodyFactors::solve(BodyColumns& x) {
  x_.resize(pivots_.size());
  for (std::size_t k = 0; k < pivots_.size(); ++k) {
    for (int i = 0; i < 6; ++i) x_[k].y[i] = x(i, pivots_[k].body);
  }
  solve_lanes();
  for (std::size_t k = 0; k < pivots_.size(); ++k) {
    for (int i = 0; i < 6; ++i) x(i, pivots_[k].body) = x_[k].y[i];
  }
}

RAYGAUGE_VECTORS void BodyFactors::solve_lanes() {
  for (std::size_t k = 0; k < pivots_.size(); ++k) {
    const Pivot& pivot = pivots_[k];
    const Eight own = x_[k].y;
    for (std::size_t i = 0; i < pivot.later.size(); ++i)
      x_[index(pivot.later[i])].y -= product(blocks_[pivot.below(i)], own);
  }
  for (std::size_t k = pivots_.size(); k-- > 0;) {
    const Pivot& pivot = pivots_[k];
    Eight own = x_[k].y;
    for (std::size_t i = 0; i < pivot.later.size(); ++i)
      own -= product(blocks_[pivot.right(i)], x_[index(pivot.later[i])].y);
    x_[k].y = product(blocks_[pivot.first], own);
  }
}

}  // namespace raygauge
