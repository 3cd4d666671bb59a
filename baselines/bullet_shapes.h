// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <memory>
#include <optional>

#include "baselines/rigid_body.h"

namespace raygauge {

btVector3 bullet(const Eigen::Vector3d& v);
btTransform bullet(const Eigen::Isometry3d& pose);

/// The body about the origin of its own frame. `margin` is Bullet's collision margin; none: Bullet's own,
/// 0.04, or a tenth of the body's least half extent. That of balls and capsules is their radius.
std::unique_ptr<btConvexShape> bullet_shape(const RigidBody& body, std::optional<double> margin);

}  // namespace raygauge
