// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/files.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "raygauge/exceptions.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

constexpr const char* kName = "files";
constexpr double kSmallestScale = 1e-100;
constexpr double kLargestScale = 1e100;

/// { M x + t : x in S }.
std::shared_ptr<const ConvexSet> image(const std::shared_ptr<const ConvexSet>& S, const Eigen::MatrixXd& M,
                                       const Vector& t) {
  if (const PointSet* points = as_point_set(*S))
    return std::make_shared<PointSet>((M * points->points()).colwise() + t);
  return std::make_shared<AffineImage>(S, M, t);
}

std::vector<ParameterInfo> parameters_of(const std::string& role) {
  return {{role, std::string(), {}, {}, "the set " + role + ": points, a mesh, a dataset or a set file", {}},
          {"scale_" + role, 1.0, kSmallestScale, kLargestScale, "factor on " + role, {}},
          {"center_" + role, false, {}, {}, "first move the centre of " + role + " to the origin", {}},
          {"pose_" + role, std::string(), {}, {}, "rigid motion of " + role + ", the last step", {}},
          {"content_" + role, std::string(), {}, {}, "digest of what was read as " + role, {}}};
}

}  // namespace

struct FilePair::Kept {
  std::mutex mutex;
  std::weak_ptr<const ConvexSet> A;
  std::weak_ptr<const ConvexSet> Q;
};

FilePair::FilePair(std::shared_ptr<FileAccess> files, Parameters parameters)
    : files_(std::move(files)), parameters_(std::move(parameters)), kept_(std::make_shared<Kept>()) {}

FileFormat FilePair::format() const {
  return {boolean_parameter(parameters_, "skip_header"), boolean_parameter(parameters_, "stream")};
}

SetFacts FilePair::facts(const std::string& role) const {
  return files_->facts(string_parameter(parameters_, role), format());
}

bool FilePair::is_moved(const std::string& role) const {
  return real_parameter(parameters_, "scale_" + role) != 1 ||
         boolean_parameter(parameters_, "center_" + role) ||
         !string_parameter(parameters_, "pose_" + role).empty();
}

void FilePair::check() const {
  for (const std::string role : {"A", "Q"}) {
    const std::string pose = string_parameter(parameters_, "pose_" + role);
    const SetFacts known = facts(role);
    if (!pose.empty()) files_->pose(pose, known.n);
    if (known.streamed && is_moved(role))
      throw InvalidParameterError("'" + string_parameter(parameters_, role) +
                                  "' is streamed and stays where it is: no scale, centre or pose");
  }
  const int n_A = facts_of_A().n;
  const int n_Q = facts_of_Q().n;
  if (n_A == n_Q) return;
  throw DimensionMismatchError("A, '" + string_parameter(parameters_, "A") + "', is in " +
                               std::to_string(n_A) + " dimensions, Q, '" +
                               string_parameter(parameters_, "Q") + "', in " + std::to_string(n_Q));
}

std::shared_ptr<const ConvexSet> FilePair::placed(const std::string& role) const {
  std::shared_ptr<const ConvexSet> S = files_->read(string_parameter(parameters_, role), format());
  const int n = S->dimension();
  if (!is_moved(role)) return S;
  const double scale = real_parameter(parameters_, "scale_" + role);
  const bool centred = boolean_parameter(parameters_, "center_" + role);
  const std::string pose_text = string_parameter(parameters_, "pose_" + role);
  const Pose pose = pose_text.empty() ? Pose(n) : files_->pose(pose_text, n);
  const Eigen::MatrixXd M = scale * pose.rotation();
  const Vector centre = centred ? S->center() : Vector::Zero(n);
  return image(S, M, pose.translation() - M * centre);
}

std::shared_ptr<const ConvexSet> FilePair::kept(const std::string& role,
                                                std::weak_ptr<const ConvexSet>& earlier) const {
  auto set = earlier.lock();
  if (set == nullptr) earlier = set = placed(role);
  return set;
}

Instance FilePair::generate(const InstanceKey& key) const {
  const SetFacts A = facts_of_A();
  const SetFacts Q = facts_of_Q();
  const int N = std::max(A.N, Q.N);
  if (key.n != A.n || key.N != N) {
    throw InvalidParameterError("generator 'files': '" + string_parameter(parameters_, "pair") +
                                "' has n = " + std::to_string(A.n) + " and N = " + std::to_string(N));
  }
  const std::lock_guard lock(kept_->mutex);
  Instance instance{kept("A", kept_->A), kept("Q", kept_->Q), std::nullopt};
  if (parameters_.count(kExactDistance) != 0)
    instance.exact_distance = real_parameter(parameters_, kExactDistance);
  if (parameters_.count(kExactDistanceRounding) != 0)
    instance.exact_distance_rounding = real_parameter(parameters_, kExactDistanceRounding);
  return instance;
}

Component<Generator> files_generator(std::shared_ptr<FileAccess> files) {
  std::vector<ParameterInfo> parameters = {
      {"pair", std::string(), {}, {}, "name of the pair", {}},
      {"skip_header", false, {}, {}, "the first line of a text file is a heading", {}},
      {"stream", false, {}, {}, "datasets are read by passes over them", {}}};
  for (const char* role : {"A", "Q"}) {
    for (ParameterInfo& info : parameters_of(role)) parameters.push_back(std::move(info));
  }
  parameters.push_back(
      {kAnyParameter, std::string(), {}, {}, "columns of the pairs' file, carried along", {}});
  return {kName, "pairs of the user's point sets, meshes and set files", std::move(parameters),
          [files = std::move(files)](const Parameters& given) {
            return std::make_unique<FilePair>(files, given);
          }};
}

}  // namespace raygauge
