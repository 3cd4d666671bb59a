// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/motion_file.h"

#include <algorithm>
#include <utility>

#include "cli/input/number_table.h"
#include "cli/input/pose_table.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr const char* kTime = "time";

void require_heading(const NumberTable& table, int n) {
  if (!table.names.empty()) return;
  throw InvalidParameterError(table.path + ": no line names the columns; the first one must be " +
                              (n == 2 ? "time,x,y,angle"
                                      : "time,x,y,z,qw,qx,qy,qz or time,x,y,z,qx,qy,qz,qw, as the numbers "
                                        "are ordered: w is first in some "
                                        "files and last in others"));
}

/// What the engine complains of gets the name of the file.
template <class Call>
auto of_file(const std::string& path, const Call& call) {
  try {
    return call();
  } catch (const Error& error) {
    throw InvalidParameterError(path + ": " + error.what());
  }
}

}  // namespace

MotionPointer read_pose_file(const std::string& path, int n) {
  if (n != 2 && n != 3)
    throw InvalidParameterError(path + ": a file of poses needs a scene of 2 or 3 dimensions");
  const NumberTable table = read_number_table(path, kTime);
  require_heading(table, n);
  std::vector<std::string> wanted = {kTime, "x", "y", "angle"};
  if (n == 3) wanted = {kTime, "x", "y", "z", "qw", "qx", "qy", "qz"};
  for (const std::string& name : table.names) {
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end())
      throw UnknownNameError("column", name, wanted, table.heading);
  }
  std::vector<Eigen::Index> columns;
  for (const std::string& name : wanted) columns.push_back(table.column(name));
  require_rising(table, kTime);
  std::vector<double> times;
  std::vector<Placement> frames;
  for (Eigen::Index i = 0; i < table.rows.rows(); ++i) {
    const auto entry = [&](std::size_t k) { return table.rows(i, columns[k]); };
    times.push_back(entry(0));
    Placement frame = Placement::identity(n);
    for (int k = 0; k < n; ++k) frame.t[k] = entry(static_cast<std::size_t>(k) + 1);
    if (n == 2) frame.R = plane_rotation(entry(3));
    if (n == 3) frame.R = from_quaternion({entry(4), entry(5), entry(6), entry(7)}, table.place(i));
    frames.push_back(std::move(frame));
  }
  return of_file(path, [&] { return std::make_shared<const KeyframeMotion>(times, frames); });
}

std::shared_ptr<const JointTrajectory> read_joint_file(
    const std::string& path, const std::vector<std::string>& joints,
    const std::map<std::string, std::string>& without_value) {
  const NumberTable table = read_number_table(path, kTime);
  if (table.names.empty())
    throw InvalidParameterError(path +
                                ": no line names the columns; the first one must name time and the joints");
  for (const std::string& name : table.names) {
    if (name == kTime || std::find(joints.begin(), joints.end(), name) != joints.end()) continue;
    if (const auto found = without_value.find(name); found != without_value.end())
      throw InvalidParameterError(table.heading + ": joint '" + name + "' " + found->second +
                                  " and takes no values; leave its column out");
    throw UnknownNameError("joint", name, joints, table.heading);
  }
  require_rising(table, kTime);
  auto trajectory = std::make_shared<JointTrajectory>();
  const Eigen::Index time = table.column(kTime);
  for (Eigen::Index i = 0; i < table.rows.rows(); ++i) trajectory->times.push_back(table.rows(i, time));
  trajectory->values.resize(static_cast<Eigen::Index>(joints.size()), table.rows.rows());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    trajectory->values.row(static_cast<Eigen::Index>(j)) =
        table.rows.col(table.column(joints[j])).transpose();
  }
  return trajectory;
}

}  // namespace raygauge::cli
