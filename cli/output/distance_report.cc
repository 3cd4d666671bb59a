// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/distance_report.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "engine/methods/counters.h"
#include "engine/numerics/number_text.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

Json json_array(const Vector& vector) { return std::vector<double>(vector.begin(), vector.end()); }

Json json_points(const ReportedSet& set) { return set.n_points == 0 ? Json() : Json(set.n_points); }

Json json_counters(const DistanceCounters& counters) {
  Json object = Json::object();
  for (const CounterInfo& counter : kCounters) object[counter.name] = counters.*counter.member;
  return object;
}

std::vector<std::string> violated_preconditions(const DistanceReport& report) {
  if (report.precondition.answer != OriginInInterior::Answer::violated) return {};
  return {"origin_in_interior_of_Q"};
}

// Of other sets than point sets there is no check that could take long.
bool was_not_checked(const DistanceReport& report) {
  return report.precondition.answer == OriginInInterior::Answer::unknown && report.Q.n_points > 0;
}

std::vector<std::string> unchecked_preconditions(const DistanceReport& report) {
  if (!was_not_checked(report)) return {};
  return {"origin_in_interior_of_Q"};
}

Json json_weights(const std::vector<PointWeight>& weights) {
  Json array = Json::array();
  for (const PointWeight& point : weights)
    array.push_back({{"point", point.index}, {"weight", point.weight}});
  return array;
}

std::string vector_text(const Vector& vector) {
  std::string text;
  for (const double value : vector) text += fmt::format("{}{:.10g}", text.empty() ? "" : " ", value);
  return text;
}

std::string bounds_text(const DistanceReport& report) {
  const DistanceResult& r = report.result;
  if (std::isnan(r.lower) || std::isnan(r.upper)) {
    return fmt::format("[{:.17g}, {:.17g}] (nan: the method left nothing that proves this bound)", r.lower,
                       r.upper);
  }
  if (!std::isfinite(r.upper) || r.upper == 0) return fmt::format("[{:.17g}, {:.17g}]", r.lower, r.upper);
  const double gap = r.upper - r.lower;
  return fmt::format("[{:.17g}, {:.17g}], gap {} ({} of the distance; tolerance {})", r.lower, r.upper,
                     rounded_text(gap, 2), rounded_text(gap / r.upper, 2), rounded_text(report.tolerance, 6));
}

std::string line(const char* label, const std::string& text) {
  return fmt::format("{:<10} {}\n", label, text);
}

std::string normal_line(const DistanceResult& r) {
  if (r.normal.size() == 0 || r.normal.isZero(0)) return "";
  return line(r.status == DistanceStatus::unreachable ? "direction" : "normal", vector_text(r.normal));
}

// The combination of A's points, counted from 0, that is the origin.
std::string weights_line(const DistanceResult& r) {
  std::string text;
  for (const PointWeight& point : r.origin_weights) {
    text += fmt::format("{}{:.10g} a_{}", text.empty() ? "0 = " : " + ", point.weight, point.index);
  }
  return text.empty() ? "" : line("weights", text);
}

std::string precondition_line(const DistanceReport& report) {
  if (report.precondition.answer == OriginInInterior::Answer::unknown && std::isinf(report.result.upper)) {
    return line("unproven",
                "the origin was not found to be in the interior of Q, which a gauge needs: without that "
                "there may be no upper bound");
  }
  if (was_not_checked(report)) {
    return line(
        "unchecked",
        "not checked: whether the origin is in the interior of Q, which a gauge needs; that would have "
        "taken longer than the solve");
  }
  // Of an unreachable A the status says it already.
  if (report.precondition.answer != OriginInInterior::Answer::violated ||
      report.result.status == DistanceStatus::unreachable) {
    return "";
  }
  return line("violated",
              "the origin is not in the interior of Q, which a gauge needs: u·q >= 0 for every point q of "
              "Q with u = " +
                  vector_text(report.precondition.direction) +
                  "; other sets A may have an infinite distance");
}

std::string contact_line(const DistanceReport& report) {
  if (!report.witness) return "";
  const Vector& point = report.result.contact_point;
  return line("contact", point.size() == 0 ? "there is no contact point" : vector_text(point));
}

std::string counters_line(const DistanceCounters& c) {
  return line("counters", counted(c.outer_iterations, "outer iteration") + " (K), " +
                              counted(c.ray_iterations, "ray-shooting iteration") + " (N_rs), " +
                              counted(c.pivots, "pivot") + ", " +
                              counted(c.refactorisations, "refactorisation") + ", " +
                              std::to_string(c.support_queries) + " support queries, " +
                              counted(c.points_priced, "point") + " priced");
}

std::string check_text(const DistanceReport& report) {
  if (report.check_seconds < 0.1 * report.seconds || report.check_seconds < 1e-3) return "";
  return fmt::format(", and {:.3g} ms to check Q", report.check_seconds * 1e3);
}

/// "3 points in A", "smooth A".
std::string set_text(const ReportedSet& set, const char* name) {
  if (set.n_points > 0) return counted(set.n_points, "point") + " in " + name;
  switch (set.structure) {
    case SupportStructure::smooth:
      return std::string("smooth ") + name;
    case SupportStructure::polytope:
      return std::string("polytope ") + name;
    case SupportStructure::point:
      return std::string("one point ") + name;
    default:
      return std::string("general ") + name;
  }
}

/// What is known of contact when the bounds are as they are.
std::string compared_with_contact(const DistanceResult& r) {
  if (r.lower > 1) return "separated: Q must grow to touch A";
  if (r.upper == 0) return "A contains the origin: the distance is 0, whatever Q is";
  if (r.upper < 1) return "penetrating: Q meets A already, and would have to shrink to touch it only";
  if (r.status == DistanceStatus::optimal && r.lower <= 1 && r.upper >= 1) {
    return "in contact, as far as the tolerance can tell";
  }
  return "the bounds do not tell separation from penetration";
}

std::string limit_text(DistanceStatus status) {
  switch (status) {
    case DistanceStatus::iteration_limit:
      return "stopped at the iteration limit; ";
    case DistanceStatus::time_limit:
      return "stopped at the time limit; ";
    case DistanceStatus::precision_limit:
      return "double precision could not bring the bounds within the tolerance; ";
    default:
      return "";
  }
}

}  // namespace

Json distance_json(const DistanceReport& report) {
  const DistanceResult& r = report.result;
  Json json = {{"distance", r.distance},
               {"lower", r.lower},
               {"upper", r.upper},
               {"status", std::string(to_string(r.status))},
               {"violated_preconditions", violated_preconditions(report)},
               {"unchecked_preconditions", unchecked_preconditions(report)},
               {"method", report.method},
               {"tolerance", report.tolerance},
               {"seconds", report.seconds + report.check_seconds},
               {"check_seconds", report.check_seconds},
               {"n", report.n},
               {"n_points_A", json_points(report.A)},
               {"n_points_Q", json_points(report.Q)},
               {"normal", json_array(r.normal)}};
  if (report.witness) json["contact_point"] = json_array(r.contact_point);
  if (r.status == DistanceStatus::contains_origin) json["origin_weights"] = json_weights(r.origin_weights);
  json["counters"] = json_counters(r.counters);
  return json;
}

std::string verdict(const DistanceResult& r) {
  if (r.status == DistanceStatus::contains_origin)
    return "A contains the origin: the distance is 0, whatever Q is";
  if (r.status == DistanceStatus::unreachable) {
    return "no multiple of Q meets A: along the direction u below, u·a < 0 for every point a of A and u·q >= "
           "0 for every point q of Q, or u·a <= 0 and u·q > 0 but at the origin (so the origin is not in the "
           "interior of Q, which a gauge needs)";
  }
  return limit_text(r.status) + compared_with_contact(r);
}

std::string distance_text(const DistanceReport& report) {
  const DistanceResult& r = report.result;
  return line("distance", fmt::format("{:.17g}", r.distance)) + line("bounds", bounds_text(report)) +
         line("status", fmt::format("{}: {}", to_string(r.status), verdict(r))) + precondition_line(report) +
         normal_line(r) + weights_line(r) + contact_line(report) +
         line("sets",
              fmt::format("n = {}, {}, {}", report.n, set_text(report.A, "A"), set_text(report.Q, "Q"))) +
         line("method",
              fmt::format("{}, {:.3g} ms{}", report.method, report.seconds * 1e3, check_text(report))) +
         counters_line(r.counters);
}

}  // namespace raygauge::cli
