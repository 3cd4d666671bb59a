// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/scene_answers.h"

#include <gtest/gtest.h>

#include "scene/page/scene_page.h"

namespace raygauge::test_scene_answers {
namespace {

using scene_page::events_of;
using scene_page::verdict_of;

SceneRecord record(std::int32_t query, SceneEffects kind, SceneStatus status) {
  SceneRecord record;
  record.query = query;
  record.body_a = 0;
  record.body_b = 1;
  record.kind = kind;
  record.status = status;
  return record;
}

SceneRecord clearance(double lower, double upper, double time, std::int32_t b = 1) {
  SceneRecord row = record(0, SceneEffects::clearance, SceneStatus::separated);
  row.body_b = b;
  row.lower = lower;
  row.upper = upper;
  row.time = time;
  return row;
}

SceneRecord impact(double lower, double upper) {
  SceneRecord row = record(1, SceneEffects::time_of_impact, SceneStatus::contact);
  row.time_lower = lower;
  row.time = row.time_upper = upper;
  return row;
}

SceneRecord instant(std::int64_t number, double time, double distance) {
  SceneRecord row =
      record(2, SceneEffects::none, distance > 0 ? SceneStatus::separated : SceneStatus::intersecting);
  row.instant = number;
  row.time = time;
  row.distance = row.lower = row.upper = distance;
  return row;
}

SceneFile file_with(const std::vector<SceneRecord>& records) {
  SceneFile file;
  file.name = "scene";
  file.drawing = R"({"dimension": 3, "times": [0], "bodies": []})";
  file.bodies = {{"bunny", 1}, {"hand", 1}, {"</script>", 1}};
  file.queries = {{"path", "clearance", "euclidean", 0, 0, 1e-6, 0},
                  {"touch", "time_of_impact", "euclidean", 0, 0, 1e-6, 0},
                  {"gap", "distance", "euclidean", 0, 0, 1e-6, 0}};
  for (const SceneRecord& each : records) file.records.push_back({0, 0, each});
  return file;
}

TEST(SceneVerdict, SaysHowNearBodiesCome) {
  const auto verdict = verdict_of(file_with({clearance(0.5, 0.5, 1), clearance(0.0469999, 0.047, 2, 2)}));
  EXPECT_EQ(verdict.state, "safe");
  EXPECT_EQ(verdict.text, "safe: never closer than 0.0469999 m to anything asked (bunny – </script>)");
}

TEST(SceneVerdict, SaysWhoMeetsWhomFirst) {
  const auto verdict = verdict_of(
      file_with({instant(0, 0, 1), instant(1, 3, 0), impact(2.8295, 2.8296), clearance(0.5, 0.5, 1, 2)}));
  EXPECT_EQ(verdict.state, "unsafe");
  EXPECT_EQ(verdict.text, "not safe: bunny meets hand at 2.8296 s");
}

TEST(SceneVerdict, ClaimsNoSafetyThatWasNotAskedOrIsNotDecided) {
  const auto instants = verdict_of(file_with({instant(0, 0, 1), instant(1, 1, 0.25)}));
  EXPECT_EQ(instants.state, "open");
  EXPECT_NE(
      instants.text.find("least distance 0.25 m at the instant 1 s; between the instants nothing was asked"),
      std::string::npos)
      << instants.text;
  EXPECT_EQ(verdict_of(file_with({clearance(0, 1e-9, 1)})).state, "open");
  SceneFile unfinished = file_with({clearance(0.5, 0.5, 1)});
  unfinished.cell_count = 2;
  EXPECT_EQ(verdict_of(unfinished).text.find("not finished (0 of 2 cells)"), 0U);
  EXPECT_EQ(verdict_of(file_with({})).state, "open");
}

SceneRecord overlap(std::int64_t number, double time, double depth) {
  SceneRecord row = instant(number, time, 0);
  row.depth = row.depth_upper = depth;
  row.depth_lower = depth * (1 - 1e-9);
  return row;
}

TEST(SceneVerdict, SaysHowDeepTheyOverlap) {
  const SceneFile file =
      file_with({instant(0, 0, 1), overlap(1, 3, 0.125), overlap(2, 4, 0.25), impact(2.8295, 2.8296)});
  EXPECT_EQ(verdict_of(file).text,
            "not safe: bunny meets hand at 2.8296 s, at least 0.249999 m deep at the instant 4 s");
  const auto events = events_of(file);
  EXPECT_EQ(events[1].text, "contact at instant 1, 3 s, at least 0.124999 m deep");
  EXPECT_EQ(events[2].kind, EventKind::near);
  EXPECT_EQ(events[2].value, -0.25);
  EXPECT_EQ(events[2].text, "overlap: at least 0.249999 m deep at the instant 4 s");
}

TEST(SceneVerdict, HasNoUnitInAnotherMetric) {
  SceneFile file = file_with({clearance(0.5, 0.5, 1)});
  file.queries[0].metric = "p_norm_ball";
  EXPECT_EQ(verdict_of(file).text, "safe: never closer than 0.5 to anything asked (bunny – hand)");
}

TEST(SceneEvents, StandInTheOrderOfDanger) {
  const auto events =
      events_of(file_with({clearance(0.5, 0.5, 1), clearance(0.25, 0.25, 2, 2), instant(0, 0, 1),
                           instant(1, 3, 0), instant(2, 4, 1), impact(2, 2.5)}));
  std::vector<EventKind> kinds;
  for (const auto& event : events) kinds.push_back(event.kind);
  EXPECT_EQ(kinds, (std::vector<EventKind>{EventKind::contact, EventKind::contact, EventKind::near,
                                           EventKind::near, EventKind::near, EventKind::release}));
  EXPECT_EQ(events[0].time, 2.5);
  EXPECT_EQ(events[1].time, 3);
  EXPECT_EQ(events[2].value, 0) << "the distance at the contact";
  EXPECT_EQ(events[3].value, 0.25);
}

TEST(SceneEvents, AreAllOfThem) {
  std::vector<SceneRecord> many;
  for (int i = 0; i < 500; ++i) many.push_back(clearance(1 + i, 1 + i, 1));
  EXPECT_EQ(events_of(file_with(many)).size(), 500U);
}

TEST(ScenePage, LetsNoNameBecomeMarkup) {
  const std::string page = scene_page::make_page(file_with({clearance(0.5, 0.5, 1, 2)}));
  EXPECT_EQ(page.find("– </script>"), std::string::npos);
}

}  // namespace
}  // namespace raygauge::test_scene_answers
