// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "bindings/c/handles.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"

namespace {

using namespace raygauge;     // NOLINT(google-build-using-namespace)
using namespace raygauge::c;  // NOLINT(google-build-using-namespace)

/// The caller's arrays for `count` pairs of R^n. Statuses go through a buffer of the batch.
class Arrays {
 public:
  Arrays(rg_batch& batch, const rg_batch_answers& out, std::size_t count, int n)
      : batch_(batch), status_(out.status) {
    const std::size_t numbers = count * static_cast<std::size_t>(n);
    batch.statuses.resize(out.status == nullptr ? 0 : count);
    answers_.status = batch.statuses;
    answers_.distance = span(out.distance, count);
    answers_.lower = span(out.lower, count);
    answers_.upper = span(out.upper, count);
    answers_.normal = span(out.normal, numbers);
    answers_.closest_points_1 = span(out.closest_points_1, numbers);
    answers_.closest_points_2 = span(out.closest_points_2, numbers);
  }

  const BatchAnswers& answers() const noexcept { return answers_; }

  void write_statuses() const {
    std::transform(batch_.statuses.begin(), batch_.statuses.end(), status_,
                   [](DistanceStatus status) { return static_cast<std::uint8_t>(status); });
  }

 private:
  static std::span<double> span(double* values, std::size_t size) {
    return values == nullptr ? std::span<double>() : std::span<double>(values, size);
  }

  rg_batch& batch_;
  std::uint8_t* status_;
  BatchAnswers answers_;
};

/// Reads the pairs into the batch's own; returns the dimension of the first.
int read_pairs(rg_batch& batch, std::int64_t count, const rg_pair* pairs) {
  batch.pairs.clear();
  batch.pairs.reserve(static_cast<std::size_t>(count));
  const rg_pair* pair = &needed(pairs, "pairs");
  for (const rg_pair* const end = pair + count; pair != end; ++pair) {
    batch.pairs.push_back({posed(pair->first, pair->pose_first, "a pair's first"),
                           posed(pair->second, pair->pose_second, "a pair's second")});
  }
  return batch.pairs.front().first.dimension();
}

std::span<WarmStart> starts_of(rg_warm* warm) {
  return warm == nullptr ? std::span<WarmStart>() : std::span<WarmStart>(warm->starts);
}

PairBatch& ready(std::optional<PairBatch>& place, const DistanceOptions& options) {
  if (!place) place.emplace(options);
  return *place;
}

std::int64_t count_of(std::int64_t count) {
  return in_range("count", count, 0, std::numeric_limits<std::int32_t>::max());
}

}  // namespace

rg_error rg_batch_create(int32_t threads, double tolerance, rg_batch** batch) {
  return guarded([&] {
    rg_batch*& out = needed(batch, "batch");
    DistanceOptions options;
    options.threads = threads;
    options.tolerance = tolerance;
    if (const std::string problem = validate(options); !problem.empty()) throw InvalidParameterError(problem);
    auto made = std::make_unique<rg_batch>();
    made->options = options;
    out = made.release();
  });
}

void rg_batch_free(rg_batch* batch) { delete batch; }

rg_error rg_batch_object_distances(rg_batch* batch, int64_t count, const rg_pair* pairs, const rg_set* Q,
                                   rg_warm* warm, const rg_batch_answers* answers) {
  return guarded([&] {
    rg_batch& used = needed(batch, "batch");
    const rg_batch_answers& out = needed(answers, "answers");
    if (count_of(count) == 0) return;
    const int n = read_pairs(used, count, pairs);
    const ConvexSet& metric = Q == nullptr ? used.euclidean.of(n) : *Q->set;
    const Arrays arrays(used, out, used.pairs.size(), metric.dimension());
    ready(used.objects, used.options).distances(used.pairs, metric, arrays.answers(), starts_of(warm));
    arrays.write_statuses();
  });
}

rg_error rg_batch_growth_distances(rg_batch* batch, int64_t count, const rg_pair* pairs, rg_warm* warm,
                                   const rg_batch_answers* answers) {
  return guarded([&] {
    rg_batch& used = needed(batch, "batch");
    const rg_batch_answers& out = needed(answers, "answers");
    if (out.closest_points_1 != nullptr || out.closest_points_2 != nullptr) {
      throw InvalidParameterError("answers: growth distances have no closest points");
    }
    if (count_of(count) == 0) return;
    const int n = read_pairs(used, count, pairs);
    const Arrays arrays(used, out, used.pairs.size(), n);
    ready(used.growth, growth_options(used.options))
        .growth_distances(used.pairs, arrays.answers(), starts_of(warm));
    arrays.write_statuses();
  });
}
