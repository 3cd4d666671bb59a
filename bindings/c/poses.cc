// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "bindings/c/handles.h"
#include "raygauge/exceptions.h"

namespace {

using namespace raygauge;     // NOLINT(google-build-using-namespace)
using namespace raygauge::c;  // NOLINT(google-build-using-namespace)

/// Gives the pose other numbers by `assign`, which may throw and then leaves it as it was.
template <class Assign>
void replace(rg_pose& pose, const Assign& assign) {
  try {
    assign(pose.next);
  } catch (...) {
    pose.next = Pose(pose.pose.dimension());
    throw;
  }
  std::swap(pose.pose, pose.next);
}

}  // namespace

rg_error rg_pose_create(int32_t n, const double* R, const double* t, rg_pose** pose) {
  return guarded([&] {
    rg_pose*& out = needed(pose, "pose");
    const int size = static_cast<int>(in_range("n", n, 1, std::numeric_limits<int32_t>::max()));
    auto made = std::make_unique<rg_pose>(rg_pose{Pose(size), Pose(size)});
    if (R != nullptr || t != nullptr) {
      const std::vector<double> zero(t == nullptr ? static_cast<std::size_t>(size) : 0);
      const DenseMatrix identity = R == nullptr ? made->pose.rotation() : DenseMatrix();
      made->pose.assign(R == nullptr ? identity.data() : R, t == nullptr ? zero.data() : t);
    }
    out = made.release();
  });
}

rg_error rg_pose_assign(rg_pose* pose, const double* R, const double* t) {
  return guarded([&] {
    needed(R, "R"), needed(t, "t");
    replace(needed(pose, "pose"), [&](Pose& next) { next.assign(R, t); });
  });
}

rg_error rg_pose_assign_quaternion(rg_pose* pose, const double* wxyz, const double* t) {
  return guarded([&] {
    needed(wxyz, "wxyz"), needed(t, "t");
    if (const int n = needed(pose, "pose").pose.dimension(); n != 3) {
      throw DimensionMismatchError("pose: a quaternion turns R^3, the pose is of R^" + std::to_string(n));
    }
    replace(*pose, [&](Pose& next) {
      next = Pose(Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]), Eigen::Vector3d(t));
    });
  });
}

void rg_pose_free(rg_pose* pose) { delete pose; }

rg_error rg_warm_create(int64_t count, rg_warm** warm) {
  return guarded([&] {
    rg_warm*& out = needed(warm, "warm");
    const auto size =
        static_cast<std::size_t>(in_range("count", count, 1, std::numeric_limits<int32_t>::max()));
    out = new rg_warm{std::vector<WarmStart>(size)};
  });
}

rg_error rg_warm_clear(rg_warm* warm) {
  return guarded([&] {
    for (WarmStart& start : needed(warm, "warm").starts) start.clear();
  });
}

void rg_warm_free(rg_warm* warm) { delete warm; }
