// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/body_factors.h"

#include <algorithm>
#include <set>

namespace raygauge {
namespace {

std::size_t index(int number) { return static_cast<std::size_t>(number); }

std::vector<std::set<int>> neighbours_of(const FrictionIsland& island) {
  std::vector<std::set<int>> all(index(island.bodies));
  for (const IslandContact& contact : island.contacts) {
    if (contact.a < 0 || contact.b < 0 || contact.a == contact.b) continue;
    all[index(contact.a)].insert(contact.b);
    all[index(contact.b)].insert(contact.a);
  }
  return all;
}

// Without a body; those that were joined by it are joined.
void eliminate(int body, std::vector<std::set<int>>& neighbours) {
  const std::set<int>& around = neighbours[index(body)];
  for (const int i : around) {
    neighbours[index(i)].insert(around.begin(), around.end());
    neighbours[index(i)].erase(i);
    neighbours[index(i)].erase(body);
  }
}

}  // namespace

BodyFactors::BodyFactors(const FrictionIsland& island) : pivot_of_(index(island.bodies), -1) {
  std::vector<std::set<int>> neighbours = neighbours_of(island);
  const auto degree = [&](int body) { return neighbours[index(body)].size(); };
  for (int k = 0; k < island.bodies; ++k) {
    int next = -1;
    for (int body = 0; body < island.bodies; ++body) {
      if (pivot_of_[index(body)] < 0 && (next < 0 || degree(body) < degree(next))) next = body;
    }
    pivot_of_[index(next)] = k;
    eliminate(next, neighbours);
    pivots_.emplace_back().body = next;
  }
  for (Pivot& pivot : pivots_) {
    for (const int body : neighbours[index(pivot.body)]) pivot.later.push_back(pivot_of_[index(body)]);
    std::sort(pivot.later.begin(), pivot.later.end());
    pivot.below.resize(pivot.later.size());
    pivot.right.resize(pivot.later.size());
  }
}

void BodyFactors::set_identity() {
  for (Pivot& pivot : pivots_) {
    pivot.diagonal.setIdentity();
    for (std::size_t k = 0; k < pivot.later.size(); ++k) {
      pivot.below[k].setZero();
      pivot.right[k].setZero();
    }
  }
}

BodyFactors::Block& BodyFactors::at(int row, int column) {
  Pivot& pivot = pivots_[index(std::min(row, column))];
  if (row == column) return pivot.diagonal;
  const auto place = std::lower_bound(pivot.later.begin(), pivot.later.end(), std::max(row, column));
  return (row > column ? pivot.below : pivot.right)[static_cast<std::size_t>(place - pivot.later.begin())];
}

void BodyFactors::add(int i, int j, const Block& block) {
  at(pivot_of_[index(i)], pivot_of_[index(j)]) += block;
}

void BodyFactors::factorize() {
  for (Pivot& pivot : pivots_) {
    pivot.factors.compute(pivot.diagonal);
    for (Block& block : pivot.right) {
      for (int column = 0; column < 6; ++column) pivot.divide(block.col(column));
    }
    for (std::size_t i = 0; i < pivot.later.size(); ++i) {
      for (std::size_t j = 0; j < pivot.later.size(); ++j)
        at(pivot.later[i], pivot.later[j]).noalias() -= pivot.below[i] * pivot.right[j];
    }
  }
}

void BodyFactors::solve(Columns& x) const {
  for (const Pivot& pivot : pivots_) {
    pivot.divide(x.col(pivot.body));
    for (std::size_t i = 0; i < pivot.later.size(); ++i)
      x.col(pivots_[index(pivot.later[i])].body).noalias() -= pivot.below[i] * x.col(pivot.body);
  }
  for (std::size_t k = pivots_.size(); k-- > 0;) {
    const Pivot& pivot = pivots_[k];
    for (std::size_t i = 0; i < pivot.later.size(); ++i)
      x.col(pivot.body).noalias() -= pivot.right[i] * x.col(pivots_[index(pivot.later[i])].body);
  }
}

}  // namespace raygauge
