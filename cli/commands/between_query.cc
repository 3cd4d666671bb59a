// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/between_query.h"

#include <fmt/format.h>

#include <chrono>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/point_set.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

DistanceMethod engine_method(const std::string& name, const MethodRegistry& methods) {
  if (name == to_string(DistanceMethod::automatic)) return DistanceMethod::automatic;
  const std::string known = methods.find(name).name;
  for (const DistanceMethod method :
       {DistanceMethod::column_generation, DistanceMethod::zheng_yamane, DistanceMethod::newton}) {
    if (to_string(method) == known) return method;
  }
  throw InvalidParameterError("method '" + known +
                              "' takes a set and a gauge: --between needs automatic, column_generation, "
                              "zheng_yamane or newton");
}

void check_one_space(const char* name, const ConvexSet& set, int n) {
  if (set.dimension() == n) return;
  throw DimensionMismatchError(
      "A1, A2 and the metric must have the same dimension: A1 has n = " + std::to_string(n) + ", " + name +
      " has n = " + std::to_string(set.dimension()));
}

ReportedSet reported(const ConvexSet& set) {
  const PointSet* points = as_point_set(set);
  return {set.structure(), points == nullptr ? 0 : points->size()};
}

// What is proven of the interiors; null where it is open.
Json meeting(const BetweenReport& report) {
  if (report.answer.distance.lower > 0) return false;
  const bool common = report.answer.distance.status == DistanceStatus::contains_origin ||
                      (report.is_depth() && report.answer.depth.lower > 0);
  return common ? Json(true) : Json();
}

const Vector& normal_of(const BetweenReport& report) {
  return report.is_depth() ? report.answer.depth.normal : report.answer.distance.normal;
}

const Vector& point_of(const BetweenReport& report, int i) {
  const ObjectDistance& r = report.answer;
  if (report.is_depth()) return i == 1 ? r.depth.point_1 : r.depth.point_2;
  return i == 1 ? r.closest_point_1 : r.closest_point_2;
}

Json json_array(const Vector& vector) { return std::vector<double>(vector.begin(), vector.end()); }
Json json_points(const ReportedSet& set) { return set.n_points == 0 ? Json() : Json(set.n_points); }

std::string vector_text(const Vector& vector) {
  std::string text;
  for (const double value : vector) text += fmt::format("{}{:.10g}", text.empty() ? "" : " ", value);
  return text.empty() ? "there is none" : text;
}

std::string line(const char* label, const std::string& text) {
  return fmt::format("{:<10} {}\n", label, text);
}

std::string verdict_between(const BetweenReport& report) {
  const Json meet = meeting(report);
  if (meet.is_null()) {
    return report.is_depth() && report.answer.depth.upper == 0
               ? "the interiors are disjoint; the bounds do not tell contact from separation"
               : "the bounds do not tell contact from separation";
  }
  if (!meet.get<bool>()) return "the objects are apart";
  if (!report.is_depth()) return "the objects meet (--signed: how deep)";
  return "the objects overlap: A1 gets out along the normal, by the least way";
}

}  // namespace

BetweenReport answer_between(const DistanceQuery& query, bool is_signed,
                             const std::shared_ptr<const ConvexSet>& A1,
                             const std::shared_ptr<const ConvexSet>& A2,
                             const std::shared_ptr<const ConvexSet>& metric, const MethodRegistry& methods) {
  BetweenReport report;
  DistanceOptions options = query.options;
  options.method = engine_method(query.method, methods);
  report.n = A1->dimension();
  check_one_space("A2", *A2, report.n);
  const auto Q = metric != nullptr ? metric : std::make_shared<Ball>(Vector::Zero(report.n), 1.0);
  check_one_space("the metric", *Q, report.n);
  report.is_signed = is_signed;
  report.witness = query.witness;
  report.method = to_string(options.method);
  report.tolerance = options.tolerance;
  report.A1 = reported(*A1);
  report.A2 = reported(*A2);
  ObjectEffects effects = query.witness ? ObjectEffects::closest_points : ObjectEffects::none;
  if (is_signed) effects = effects | ObjectEffects::depth;
  ObjectDistanceSolver solver(options);
  const auto start = std::chrono::steady_clock::now();
  report.answer = solver.solve(*A1, *A2, *Q, effects);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

Json between_json(const BetweenReport& report) {
  Json json = {{"distance", report.is_depth() ? -report.answer.depth.depth : report.answer.distance.distance},
               {"lower", report.lower()},
               {"upper", report.upper()},
               {"status", std::string(to_string(report.status()))},
               {"meet", meeting(report)},
               {"signed", report.is_signed},
               {"method", report.method},
               {"tolerance", report.tolerance},
               {"seconds", report.seconds},
               {"n", report.n},
               {"n_points_A1", json_points(report.A1)},
               {"n_points_A2", json_points(report.A2)},
               {"normal", json_array(normal_of(report))}};
  if (!report.witness) return json;
  json["point_1"] = json_array(point_of(report, 1));
  json["point_2"] = json_array(point_of(report, 2));
  return json;
}

std::string between_text(const BetweenReport& report) {
  const double value = report.is_depth() ? -report.answer.depth.depth : report.answer.distance.distance;
  std::string text =
      line("distance", fmt::format("{:.17g}", value)) +
      line("bounds", fmt::format("[{:.17g}, {:.17g}]", report.lower(), report.upper())) +
      line("status", fmt::format("{}: {}", to_string(report.status()), verdict_between(report)));
  if (normal_of(report).size() > 0) text += line("normal", vector_text(normal_of(report)));
  if (report.witness) {
    text +=
        line("point_1", vector_text(point_of(report, 1))) + line("point_2", vector_text(point_of(report, 2)));
  }
  return text +
         line("method", fmt::format("{}, n = {}, {:.3g} ms", report.method, report.n, report.seconds * 1e3));
}

}  // namespace raygauge::cli
