// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/scene/motion.h"
#include "scene/input/robot_file.h"
#include "tests/results/complaint.h"
#include "tests/results/support.h"

namespace raygauge::cli::testing_robots {

/// Reads robots from texts.
class RobotReading : public ::testing::Test {
 protected:
  explicit RobotReading(std::string name) : name_(std::move(name)) {}

  void write(const std::string& file, const std::string& text) const {
    testing::write_bytes(folder_.file(file), text);
  }

  Robot read(const std::string& text, const RobotMeshes& meshes = {}) const {
    write(name_, text);
    return read_robot(folder_.file(name_), meshes);
  }

  /// What a text is refused with, without the folder.
  std::string complaint(const std::string& text) const {
    return testing::complaint_of(folder_, [&] { read(text); });
  }

  void expect_refusals(const std::vector<std::pair<std::string, std::string>>& refusals) const {
    for (const auto& [text, wanted] : refusals) {
      const std::string message = complaint(text);
      EXPECT_EQ(message.substr(0, wanted.size()), wanted) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }

  testing::TemporaryFolder folder_;
  std::string name_;
};

inline std::vector<std::string> names_of(const Robot& robot) {
  std::vector<std::string> names;
  for (const RobotLink& link : robot.links) names.push_back(link.name);
  return names;
}

/// The link's place for values of the joints.
inline Placement place_of(const Robot& robot, const std::string& link, const Eigen::VectorXd& values = {}) {
  const std::vector<std::string> names = names_of(robot);
  const auto number = std::find(names.begin(), names.end(), link) - names.begin();
  auto still = std::make_shared<JointTrajectory>();
  still->times = {0, 1};
  still->values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size())).replicate(1, 2);
  if (values.size() > 0) still->values = values.replicate(1, 2);
  const auto tree = std::make_shared<const KinematicTree>(robot.tree);
  return LinkMotion(tree, still, Placement::identity(3), static_cast<int>(number)).at(0);
}

inline void expect_near(const Placement& place, const Eigen::Vector3d& x, const Eigen::Vector3d& image) {
  const Eigen::Vector3d found = place.R * x + place.t;
  EXPECT_LT((found - image).norm(), 1e-14) << found.transpose() << ", not " << image.transpose();
}

/// How far the shape of a link reaches along a direction, in the link's frame.
inline double reach(const Robot& robot, const std::string& link, const Eigen::Vector3d& u,
                    std::size_t shape = 0) {
  for (const RobotLink& each : robot.links) {
    if (each.name == link) return each.shapes.at(shape)->support_function(u);
  }
  ADD_FAILURE() << "no link " << link;
  return 0;
}

}  // namespace raygauge::cli::testing_robots
