// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The linear program of Example 2 by QSopt_ex in rational arithmetic, for the method `command`
// (docs/baselines.md). It is a program because QSopt_ex keeps its precision in global variables: one solve a
// process.
#include <gmp.h>

extern "C" {
#include <qsopt_ex/QSopt_ex.h>
}

#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace {

/// Rationals as QSopt_ex takes them: an array with its size before its first element.
class Rationals {
 public:
  explicit Rationals(int count) : count_(static_cast<std::size_t>(count)), memory_(1 + count_ * kWords) {
    memory_[0] = count_;
    for (std::size_t i = 0; i < count_; ++i) mpq_init(data()[i]);
  }
  ~Rationals() {
    for (std::size_t i = 0; i < count_; ++i) mpq_clear(data()[i]);
  }
  Rationals(const Rationals&) = delete;
  Rationals& operator=(const Rationals&) = delete;

  mpq_t* data() { return reinterpret_cast<mpq_t*>(memory_.data() + 1); }
  mpq_t& operator[](int i) { return data()[i]; }

 private:
  static constexpr std::size_t kWords = sizeof(__mpq_struct) / sizeof(std::size_t);
  std::size_t count_;
  std::vector<std::size_t> memory_;
};

struct FreeProblem {
  void operator()(std::remove_pointer_t<mpq_QSprob>* problem) const { mpq_QSfree_prob(problem); }
};
using Problem = std::unique_ptr<std::remove_pointer_t<mpq_QSprob>, FreeProblem>;

struct Sizes {
  int A, Q, n;
};

/// minimize Σβ_j subject to Σα_i a_i - Σβ_j q_j = 0, Σα_i = 1, α, β >= 0: the columns in their order.
Problem read_problem(const Sizes& sizes) {
  Problem problem(mpq_QScreate_prob("raygauge", QS_MIN));
  const int rows = sizes.n + 1;
  Rationals constants(4);  // 0, 1, infinity, and a value
  mpq_set_si(constants[1], 1, 1);
  mpq_set(constants[2], mpq_ILL_MAXDOUBLE);
  for (int row = 0; row < rows; ++row)
    mpq_QSnew_row(problem.get(), constants[row == sizes.n ? 1 : 0], 'E', nullptr);
  std::vector<int> index(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) index[static_cast<std::size_t>(row)] = row;
  Rationals column(rows);
  for (int j = 0; j < sizes.A + sizes.Q; ++j) {
    const bool of_A = j < sizes.A;
    for (int k = 0; k < sizes.n; ++k) {
      double value = 0;
      std::cin >> value;
      mpq_set_d(column[k], of_A ? value : -value);
    }
    mpq_set_si(column[sizes.n], of_A ? 1 : 0, 1);
    mpq_QSadd_col(problem.get(), rows, index.data(), column.data(), constants[of_A ? 0 : 1], constants[0],
                  constants[2], nullptr);
  }
  return problem;
}

/// `DISTANCE u … a I … q J …`, or a word for what ended the solve.
void print_solution(const Sizes& sizes, Rationals& x, Rationals& y) {
  Rationals sum(1);
  for (int j = sizes.A; j < sizes.A + sizes.Q; ++j) mpq_add(sum[0], sum[0], x[j]);
  std::cout << mpq_get_d(sum[0]) << " u";
  for (int k = 0; k < sizes.n; ++k) std::cout << ' ' << mpq_get_d(y[k]);
  for (const auto& [name, begin, end] :
       {std::tuple{" a", 0, sizes.A}, std::tuple{" q", sizes.A, sizes.A + sizes.Q}}) {
    bool any = false;
    for (int j = begin; j < end; ++j) {
      if (mpq_sgn(x[j]) == 0) continue;
      std::cout << (any ? "" : name) << ' ' << j - begin;
      any = true;
    }
  }
}

void solve(mpq_QSprob problem, const Sizes& sizes, double limit) {
  if (std::isfinite(limit)) {
    Rationals seconds(1);
    mpq_set_d(seconds[0], limit);
    mpq_QSset_param_EGlpNum(problem, QS_PARAM_SIMPLEX_MAX_TIME, seconds[0]);
  }
  Rationals x(sizes.A + sizes.Q + sizes.n + 1),
      y(sizes.n + 1);  // x has a place for the slack of each row, too
  int status = 0;
  if (QSexact_solver(problem, x.data(), y.data(), nullptr, DUAL_SIMPLEX, &status) != 0) status = QS_LP_NUMERR;
  switch (status) {
    case QS_LP_OPTIMAL:
      print_solution(sizes, x, y);
      break;
    case QS_LP_INFEASIBLE:
      std::cout << "inf";
      break;
    case QS_LP_TIME_LIMIT:
      std::cout << "time_limit inf";
      break;
    default:
      std::cout << "precision_limit inf";
  }
  std::cout << std::endl;
}

}  // namespace

int main() {
  QSexactStart();
  QSexact_set_precision(128);
  std::cout.precision(std::numeric_limits<double>::max_digits10);
  Sizes sizes{};
  Problem problem;
  for (std::string word; std::cin >> word;) {
    if (word == "points") {
      std::cin >> sizes.A >> sizes.Q >> sizes.n;
      problem = read_problem(sizes);
      std::cout << "ready" << std::endl;
    } else {
      std::string tolerance, limit;  // inf is a word
      std::cin >> tolerance >> limit;
      solve(problem.get(), sizes, std::stod(limit));
    }
  }
  problem.reset();
  QSexactClear();
}
