// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/input/xml_values.h"
#include "raygauge/scene/placement.h"
#include "scene/input/urdf_file.h"

namespace raygauge::cli {

/// The pose of an <origin> inside the element; none: the identity.
Placement urdf_origin(const XmlFile& file, const XmlElement& element);

/// The collision shapes of a <link>, in its frame. Meshes that are missing are added to robot.skipped if
/// `meshes` say so, those that are not convex to robot.notes.
std::vector<SetPointer> urdf_shapes(const XmlFile& file, const XmlElement& link, const std::string& path,
                                    const RobotMeshes& meshes, Robot& robot);

}  // namespace raygauge::cli
