// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/body_factors.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <queue>
#include <utility>

namespace raygauge {
namespace {

using Block = BodyFactors::Block;

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

// Gauss and Jordan's method, by the largest pivot of each column.
void invert(Block& A) {
  std::array<Eigen::Index, 6> row{};
  for (Eigen::Index k = 0; k < 6; ++k) {
    A.col(k).tail(6 - k).cwiseAbs().maxCoeff(&row[static_cast<std::size_t>(k)]);
    row[static_cast<std::size_t>(k)] += k;
    A.row(k).swap(A.row(row[static_cast<std::size_t>(k)]));
    const double inverse = 1 / A(k, k);
    Eigen::Matrix<double, 6, 1> column = A.col(k);
    column[k] = 0;
    for (Eigen::Index j = 0; j < 6; ++j) {
      const double share = (j == k ? 1.0 : A(k, j)) * inverse;
      if (j == k) A.col(j).setZero();
      A.col(j) -= share * column;
      A(k, j) = share;
    }
  }
  for (Eigen::Index k = 6; k-- > 0;) A.col(k).swap(A.col(row[static_cast<std::size_t>(k)]));
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
  for (Block& block : blocks_) block.setZero();
  for (const Pivot& pivot : pivots_) blocks_[pivot.first].diagonal().setOnes();
}

std::size_t BodyFactors::place_of_pivots(int row, int column) const {
  const Pivot& pivot = pivots_[index(std::min(row, column))];
  if (row == column) return pivot.first;
  const auto found = std::lower_bound(pivot.later.begin(), pivot.later.end(), std::max(row, column));
  const auto k = static_cast<std::size_t>(found - pivot.later.begin());
  return row > column ? pivot.below(k) : pivot.right(k);
}

std::size_t BodyFactors::place_of(int i, int j) const {
  return place_of_pivots(pivot_of_[index(i)], pivot_of_[index(j)]);
}

void BodyFactors::factorize() {
  auto changed = changed_.begin();
  for (const Pivot& pivot : pivots_) {
    Block& inverse = blocks_[pivot.first];
    invert(inverse);
    for (std::size_t i = 0; i < pivot.later.size(); ++i) {
      Block& below = blocks_[pivot.below(i)];
      below = Block(below.lazyProduct(inverse));
      for (std::size_t j = 0; j < pivot.later.size(); ++j)
        blocks_[*changed++].noalias() -= below.lazyProduct(blocks_[pivot.right(j)]);
    }
  }
}

void BodyFactors::solve(Columns& x) const {
  for (const Pivot& pivot : pivots_) {
    for (std::size_t i = 0; i < pivot.later.size(); ++i)
      x.col(pivots_[index(pivot.later[i])].body).noalias() -= blocks_[pivot.below(i)] * x.col(pivot.body);
  }
  for (std::size_t k = pivots_.size(); k-- > 0;) {
    const Pivot& pivot = pivots_[k];
    Eigen::Matrix<double, 6, 1> own = x.col(pivot.body);
    for (std::size_t i = 0; i < pivot.later.size(); ++i)
      own.noalias() -= blocks_[pivot.right(i)] * x.col(pivots_[index(pivot.later[i])].body);
    x.col(pivot.body).noalias() = blocks_[pivot.first] * own;
  }
}

}  // namespace raygauge
