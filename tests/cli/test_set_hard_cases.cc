// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// `raygauge distance`, as a user runs it, on the set files of tests/cli/sets: the smooth families that break
// the usual tools. A = c - rK and Q = K for a body K, so that d = gauge_K(c) - r, but for the tangent disc.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/cli/program_fixture.h"

namespace raygauge::testing::test_set_hard_cases {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct SetPair {
  const char* A;
  const char* Q;
  double distance;  ///< or the double nearest to it, if `is_rounded`
  bool is_rounded = false;
};

void PrintTo(const SetPair& pair, std::ostream* stream) { *stream << pair.A; }

std::string name_of(const ::testing::TestParamInfo<SetPair>& info) { return info.param.A; }

class SmoothRow : public ProgramTest, public ::testing::WithParamInterface<SetPair> {
 protected:
  ProgramResult run(const std::string& method, const std::string& tolerance) const {
    const auto file = [](const char* name) { return std::string(RAYGAUGE_TEST_SETS "/") + name + ".toml"; };
    return run_raygauge({"distance", file(GetParam().A), file(GetParam().Q), "--method", method,
                         "--tolerance", tolerance, "--json"});
  }
};

double number(const Json& value) { return value == "inf" ? kInfinity : value.get<double>(); }

/// Bounds around the truth, within the tolerance, and the status that goes with them.
void expect_certified(const ProgramResult& outcome, const SetPair& pair, double tolerance) {
  const Json json = Json::parse(outcome.out);
  const double lower = number(json["lower"]), upper = number(json["upper"]);
  EXPECT_LE(lower, pair.is_rounded ? std::nextafter(pair.distance, kInfinity) : pair.distance);
  EXPECT_GE(upper, pair.is_rounded ? std::nextafter(pair.distance, 0) : pair.distance);
  if (pair.distance == kInfinity) {
    EXPECT_EQ(json["status"], "unreachable");
  } else {
    EXPECT_EQ(json["status"], "optimal");
    EXPECT_LE(upper - lower, tolerance * upper);
  }
}

TEST_P(SmoothRow, IsCertifiedToTwelveDigitsByEveryMethod) {
  for (const char* method : {"column_generation", "zheng_yamane", "newton"}) {
    for (const char* tolerance : {"1e-6", "1e-12"}) {
      const ProgramResult outcome = run(method, tolerance);
      SCOPED_TRACE(std::string(method) + ", " + tolerance + ": " + outcome.out + outcome.err);
      ASSERT_EQ(outcome.status, 0);
      expect_certified(outcome, GetParam(), std::stod(tolerance));
    }
  }
}

// Row 21: (1 + ε²)/2ε for ε = 2^-10, 2^-27, 0.
constexpr const char* kDisc = "disc_that_touches_the_origin";
INSTANTIATE_TEST_SUITE_P(TangentDisc, SmoothRow,
                         ::testing::Values(SetPair{"point_above_the_tangent", kDisc, 0x1p9 + 0x1p-11},
                                           SetPair{"point_close_above_the_tangent", kDisc, 0x1p26, true},
                                           SetPair{"point_on_the_tangent", kDisc, kInfinity}),
                         name_of);

// Row 26: ‖(3, 4, 5)‖_p - 1; p near 1 is 1 + 2^-20, of p = 1e6 only 1e-96000 is missing.
INSTANTIATE_TEST_SUITE_P(PNormBall, SmoothRow,
                         ::testing::Values(SetPair{"p_norm_ball_1_beside", "p_norm_ball_1", 11},
                                           SetPair{"p_norm_ball_near_1_beside", "p_norm_ball_near_1",
                                                   10.99998766836479704, true},
                                           SetPair{"p_norm_ball_3_beside", "p_norm_ball_3", 5},
                                           SetPair{"p_norm_ball_1e6_beside", "p_norm_ball_1e6", 4, true},
                                           SetPair{"p_norm_ball_inf_beside", "p_norm_ball_inf", 4}),
                         name_of);

// Row 27: |L⁻¹c| - 1 with L⁻¹c = (3, 4).
INSTANTIATE_TEST_SUITE_P(FlatEllipsoid, SmoothRow,
                         ::testing::Values(SetPair{"ellipsoid_1e4_beside", "ellipsoid_1e4", 4},
                                           SetPair{"ellipsoid_1e8_beside", "ellipsoid_1e8", 4, false}),
                         name_of);

// Row 28: max(z/z_t, -z/z_b, (ρ + kz)/R) - 1 at (3, 4, 2) and on the axis at (0, 0, 5).
INSTANTIATE_TEST_SUITE_P(TruncatedCone, SmoothRow,
                         ::testing::Values(SetPair{"truncated_cone_beside", "truncated_cone", 3},
                                           SetPair{"truncated_cone_above", "truncated_cone", 4},
                                           SetPair{"cone_beside", "cone", 6},
                                           SetPair{"cone_above", "cone", 4},
                                           SetPair{"cone_as_cylinder_beside", "cone_as_cylinder", 4},
                                           SetPair{"cylinder_beside", "cylinder", 4},
                                           SetPair{"inverted_cone_beside", "inverted_cone", 5.0 / 3, true},
                                           SetPair{"inverted_cone_above", "inverted_cone", 4}),
                         name_of);

// Row 29: c is three times a point of the surface.
INSTANTIATE_TEST_SUITE_P(Capsule, SmoothRow,
                         ::testing::Values(SetPair{"round_capsule_beside_its_side", "round_capsule", 2},
                                           SetPair{"round_capsule_beside_its_seam", "round_capsule", 2},
                                           SetPair{"round_capsule_beside_its_cap", "round_capsule", 2},
                                           SetPair{"round_capsule_beside_its_tip", "round_capsule", 2},
                                           SetPair{"thin_capsule_beside_its_side", "thin_capsule", 2},
                                           SetPair{"thin_capsule_beside_its_cap", "thin_capsule", 2},
                                           SetPair{"thin_capsule_beside_its_tip", "thin_capsule", 2}),
                         name_of);

// Row 30.
INSTANTIATE_TEST_SUITE_P(NearAxis, SmoothRow,
                         ::testing::Values(SetPair{"unit_capsule_near_its_axis", "unit_capsule", 2, true},
                                           SetPair{"cylinder_near_its_axis", "cylinder", 2},
                                           SetPair{"cone_near_its_axis", "cone", 3 + 0x1p-25}),
                         name_of);

}  // namespace
}  // namespace raygauge::testing::test_set_hard_cases
