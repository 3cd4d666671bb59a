// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/mujoco_method.h"

#include <mujoco/mujoco.h>

#include <array>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <sstream>
#include <string>
#include <utility>

#include "baselines/pair_method.h"
#include "baselines/rigid_body.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using Kind = RigidBody::Kind;

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// A text of numbers from which MuJoCo reads the same numbers.
std::ostringstream exact_text() {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  return text;
}

/// The attributes of a geometry; of a hull the mesh is `mesh_name`.
std::string geometry_of(const RigidBody& body, const std::string& mesh_name) {
  std::ostringstream text = exact_text();
  switch (body.kind) {
    case Kind::ball:
      text << R"(type="sphere" size=")" << body.radius;
      break;
    case Kind::capsule:
      text << R"(type="capsule" size=")" << body.radius << ' ' << 0.5 * body.height;
      break;
    case Kind::cylinder:
      text << R"(type="cylinder" size=")" << body.radius << ' ' << 0.5 * body.height;
      break;
    case Kind::box:
    case Kind::ellipsoid:
      text << "type=\"" << (body.kind == Kind::box ? "box" : "ellipsoid") << "\" size=\"" << body.half.x()
           << ' ' << body.half.y() << ' ' << body.half.z();
      break;
    default:
      text << R"(type="mesh" mesh=")" << mesh_name;
  }
  text << '"';
  return text.str();
}

std::string mesh_of(const RigidBody& body, const std::string& name) {
  if (body.kind != Kind::hull) return "";
  std::ostringstream text = exact_text();
  text << "<mesh name=\"" << name << "\" vertex=\"";
  for (const Eigen::Vector3d& p : body.vertices) text << p.x() << ' ' << p.y() << ' ' << p.z() << ' ';
  text << "\"/>";
  return text.str();
}

/// A body that floats: MuJoCo looks at no pair of fixed ones.
std::string body_of(const RigidBody& body, const std::string& mesh_name) {
  std::ostringstream text = exact_text();
  const Eigen::Vector3d t = body.frame.translation();
  const Eigen::Quaterniond q(body.frame.linear());
  text << "<body pos=\"" << t.x() << ' ' << t.y() << ' ' << t.z() << "\" quat=\"" << q.w() << ' ' << q.x()
       << ' ' << q.y() << ' ' << q.z()
       << R"("><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/><geom )"
       << geometry_of(body, mesh_name) << "/></body>";
  return text.str();
}

/// Reading is one at a time: MuJoCo says nothing of threads there.
std::unique_ptr<mjModel, DeleteModel> read(const std::string& xml) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const char* name = "pair.xml";
  if (mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(xml.size())) != 0)
    throw Error("MuJoCo: no room for a model");
  std::memcpy(files->filedata[0], xml.data(), xml.size());
  std::array<char, 500> error{};
  std::unique_ptr<mjModel, DeleteModel> model(
      mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size())));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw Error(std::string("MuJoCo: ") + error.data());
  return model;
}

class MujocoPair final : public BodyPair {
 public:
  MujocoPair(const RigidBody& first, const RigidBody& second, double own_tolerance, int iterations)
      : model_(read("<mujoco><asset>" + mesh_of(first, "m1") + mesh_of(second, "m2") + "</asset><worldbody>" +
                    body_of(first, "m1") + body_of(second, "m2") + "</worldbody></mujoco>")),
        data_(mj_makeData(model_.get())),
        own_tolerance_(own_tolerance) {
    model_->opt.mpr_iterations = iterations;
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
  }

  PairAnswer answer(Quantity quantity, double tolerance) override {
    model_->opt.mpr_tolerance = own_tolerance_ > 0 ? own_tolerance_ : tolerance;
    mj_collision(model_.get(), data_.get());
    const int found = data_->ncon;
    if (quantity == Quantity::separated) return {found > 0 ? 0.0 : 1.0};
    PairAnswer answer{0.0};
    for (int i = 0; i < found; ++i) {
      const mjContact& contact = data_->contact[i];
      if (!(-contact.dist > answer.value)) continue;
      const double sign = contact.geom1 == 0 ? 1 : -1;
      answer = {-contact.dist, sign * Eigen::Vector3d(contact.frame[0], contact.frame[1], contact.frame[2])};
    }
    return answer;
  }

 private:
  std::unique_ptr<mjModel, DeleteModel> model_;
  std::unique_ptr<mjData, DeleteData> data_;
  double own_tolerance_;
};

}  // namespace

void register_mujoco_method(MethodRegistry& registry) {
  PairLibrary library;
  library.name = "mujoco";
  library.description =
      std::string("whether two bodies of R^3 are separated, and their depth, by mj_collision() of MuJoCo ") +
      mj_versionString();
  library.parameters = {
      {"mpr_tolerance", 0.0, 0.0, 1.0, "MuJoCo's (its own is 1e-6), absolute; 0: that of the solve", {}},
      {"mpr_iterations", std::int64_t{500}, 1.0, 1e6, "MuJoCo's (its own is 50)", {}}};
  library.takes = "balls, capsules, boxes, ellipsoids, cylinders and hulls that are not flat, of R^3";
  library.quantities = {Quantity::depth, Quantity::separated};
  library.make = [](const ConvexSet& one, const ConvexSet& two,
                    const Parameters& parameters) -> std::unique_ptr<BodyPair> {
    const auto first = RigidBody::of(one), second = RigidBody::of(two);
    if (!first || !second || first->kind == Kind::cone || second->kind == Kind::cone) return nullptr;
    return std::make_unique<MujocoPair>(*first, *second, real_parameter(parameters, "mpr_tolerance"),
                                        static_cast<int>(integer_parameter(parameters, "mpr_iterations")));
  };
  registry.add(pair_component(std::move(library)));
}

std::string mujoco_library_version() { return mj_versionString(); }

}  // namespace raygauge
