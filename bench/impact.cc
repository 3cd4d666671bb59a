// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// When do two bodies that fly straight and spin first touch? Proven times of impact beside FCL's conservative
// advancement: how often FCL's answer is right, and the times of both where it is.
#include <fcl/fcl.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "bench/fcl_geometry.h"
#include "bench/program.h"
#include "bench/timed_medians.h"
#include "raygauge/scene/continuous.h"

namespace raygauge::bench {
namespace {

constexpr std::array kNames = {"box", "capsule", "cylinder", "ball"};  // of which FCL supports every pair
constexpr std::array kKinds = {GeometryKind::box, GeometryKind::capsule, GeometryKind::cylinder,
                               GeometryKind::ball};
constexpr double kTimeTolerance =
    1e-3;  // FCL's time of contact is right where it is this near to the proven one
constexpr int kRepetitions = 5;

struct Settings {
  std::string one, other;  // kinds; empty: all
  int pairs = 2000;
  double spin = 3;
  double contact =
      1e-5;  // FCL ends where a step takes less than 1e-5 of the time: some 5e-5 of distance here
};

/// A body that flies from one placement to another in the time [0, 1] and turns the shorter way.
struct Flight {
  Body body;
  std::shared_ptr<fcl::CollisionGeometryd> fcl;
  Placement first, last;

  /// About the origin of the body, said outright: FCL's constructor without it leaves that point unset.
  fcl::InterpMotion<double> motion() const {
    return {Eigen::Matrix3d(first.R), Eigen::Vector3d(first.t), Eigen::Matrix3d(last.R),
            Eigen::Vector3d(last.t), Eigen::Vector3d(Eigen::Vector3d::Zero())};
  }
};

Flight make_flight(std::size_t kind, Random& random, double side, double spin) {
  const Geometry geometry = make_geometry(kKinds[kind], 0.2, 0.8, random);
  geometry.fcl->computeLocalAABB();  // FCL's bounds on the motion need its radius
  Placement first = Placement::identity(3), last = first;
  const Eigen::Vector3d turn = uniform_vector(random, 3);
  first.R = rotation_about(turn);
  last.R = rotation_about(uniform_vector(random, spin / 2)) * first.R;
  first.t = uniform_vector(random, 1) + Eigen::Vector3d(3 * side, 0, 0);
  last.t = uniform_vector(random, 1) - Eigen::Vector3d(side, 0, 0);
  const std::vector<double> times = {0, 1};
  auto motion = std::make_shared<KeyframeMotion>(times, std::vector<Placement>{first, last});
  return {make_body(kNames[kind], {geometry.set}, std::move(motion)), geometry.fcl, first, last};
}

struct FclAnswer {
  bool contact = false;
  double time = 0;
};

FclAnswer ask_fcl(const Flight& a, const Flight& b) {
  const fcl::InterpMotion<double> motion_a = a.motion(), motion_b = b.motion();
  fcl::ContinuousCollisionRequestd request;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  fcl::ContinuousCollisionResultd result;
  fcl::continuousCollide(a.fcl.get(), &motion_a, b.fcl.get(), &motion_b, request, result);
  return {result.is_collide, result.time_of_contact};
}

ImpactResult ask_raygauge(ContinuousSolver& solver, const Flight& a, const Flight& b, double contact) {
  ContinuousOptions over;
  over.contact = contact;
  over.to = 1;
  return solver.time_of_impact(a.body, b.body, over);
}

bool agrees(const FclAnswer& theirs, const ImpactResult& ours) {
  const bool contact = ours.outcome == ImpactResult::Outcome::contact;
  if (theirs.contact != contact) return false;
  return !contact || std::abs(theirs.time - ours.upper) <= kTimeTolerance;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// What is counted of one pair of kinds.
struct Tally {
  int pairs = 0, contacts = 0, right = 0, undecided = 0;
  std::vector<double> ours, theirs;  ///< seconds, where FCL is right
  std::vector<double> steps;         ///< of ours
};

void time_pair(ContinuousSolver& solver, const Flight& a, const Flight& b, double contact, Tally& tally) {
  std::vector<double> ours, theirs;
  for (int k = 0; k < kRepetitions; ++k) {
    ours.push_back(seconds_of([&] { ask_raygauge(solver, a, b, contact); }));
    theirs.push_back(seconds_of([&] { ask_fcl(a, b); }));
  }
  tally.ours.push_back(median(ours));
  tally.theirs.push_back(median(theirs));
}

void print(const std::string& what, const Tally& tally) {
  const double ours = median(tally.ours) * 1e6, theirs = median(tally.theirs) * 1e6;
  std::printf(
      "%-22s %6d pairs, %5d contacts, %d undecided, %g steps; FCL right %6.2f %%; there raygauge %7.1f us, "
      "FCL %7.1f "
      "us, "
      "ratio %.3f\n",
      what.c_str(), tally.pairs, tally.contacts, tally.undecided, median(tally.steps),
      100.0 * tally.right / tally.pairs, ours, theirs, ours / theirs);
}

bool is_asked_for(const Settings& settings, std::size_t one, std::size_t other) {
  const auto is = [](const std::string& name, std::size_t kind) {
    return name.empty() || name == kNames[kind];
  };
  return (is(settings.one, one) && is(settings.other, other)) ||
         (is(settings.one, other) && is(settings.other, one));
}

void run(const Settings& settings) {
  Random random(1);
  ContinuousSolver solver(3);
  Tally all;
  for (std::size_t one = 0; one < kKinds.size(); ++one) {
    for (std::size_t other = one; other < kKinds.size(); ++other) {
      if (!is_asked_for(settings, one, other)) continue;
      Tally tally;
      for (int i = 0; i < settings.pairs; ++i) {
        const Flight a = make_flight(one, random, -1, settings.spin);
        const Flight b = make_flight(other, random, 1, settings.spin);
        const ImpactResult impact = ask_raygauge(solver, a, b, settings.contact);
        ++tally.pairs;
        tally.steps.push_back(static_cast<double>(impact.steps));
        tally.contacts += impact.outcome == ImpactResult::Outcome::contact ? 1 : 0;
        tally.undecided += impact.outcome == ImpactResult::Outcome::undecided ? 1 : 0;
        if (!agrees(ask_fcl(a, b), impact)) continue;
        ++tally.right;
        time_pair(solver, a, b, settings.contact, tally);
      }
      print(std::string(kNames[one]) + " and " + kNames[other], tally);
      all.pairs += tally.pairs, all.contacts += tally.contacts, all.right += tally.right;
      all.undecided += tally.undecided;
      all.steps.insert(all.steps.end(), tally.steps.begin(), tally.steps.end());
      all.ours.insert(all.ours.end(), tally.ours.begin(), tally.ours.end());
      all.theirs.insert(all.theirs.end(), tally.theirs.begin(), tally.theirs.end());
    }
  }
  print("all", all);
}

void add_options(CLI::App& app, Settings& settings) {
  const CLI::IsMember is_kind(std::vector<std::string>(kNames.begin(), kNames.end()));
  app.add_option("--one", settings.one, "only pairs with this kind of body")->check(is_kind);
  app.add_option("--other", settings.other, "and this other one")->check(is_kind);
  app.add_option("--pairs", settings.pairs, "motions of each pair of kinds")->check(CLI::PositiveNumber);
  app.add_option("--spin", settings.spin, "greatest turn of a body, radians")->check(CLI::NonNegativeNumber);
  app.add_option("--contact", settings.contact, "distance that is a contact")->check(CLI::PositiveNumber);
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options("raygauge_impact",
                                           "Times of impact, proven, beside FCL's conservative advancement.",
                                           raygauge::bench::add_options, raygauge::bench::run, argc, argv);
}
