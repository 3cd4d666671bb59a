// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"
#include "scene/engines/physics_engine.h"

namespace raygauge {
namespace {

using Kind = RigidBody::Kind;

struct Text {
  std::ostringstream out;
  Text() { out.precision(17); }

  void numbers(const char* key, std::initializer_list<double> values) {
    out << ' ' << key << "=\"";
    for (const double value : values) out << ' ' << value;
    out << '"';
  }
  void place(const Eigen::Vector3d& at, const Eigen::Matrix3d& R) {
    const Eigen::Quaterniond q(R);
    numbers("pos", {at.x(), at.y(), at.z()});
    numbers("quat", {q.w(), q.x(), q.y(), q.z()});
  }
};

double sliding(const std::optional<ContactLaw>& law) { return law ? law->friction.value_or(0) : 0; }

void refuse_restitution(const std::optional<ContactLaw>& law) {
  if (law && law->restitution.value_or(0) > 0)
    throw InvalidParameterError("engine: mujoco has no restitution");
}

/// The model as MuJoCo's own XML.
class ModelText {
 public:
  explicit ModelText(const EngineWorld& world) : world_(world) {
    refuse_restitution(world.usual);
    for (std::size_t b = 0; b < world.bodies.size(); ++b) add(b, world.bodies[b]);
    for (int a = 0; a < static_cast<int>(world.bodies.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(world.bodies.size()); ++b) add_exception(a, b);
    }
  }

  std::string text() const {
    const std::size_t bodies = world_.bodies.size(), contacts = 12 * bodies + 100, rows = 4 * contacts,
                      speeds = 6 * bodies;
    Text all;
    all.out << R"(<mujoco><compiler balanceinertia="false" boundmass="0"/><size nconmax=")" << contacts
            << "\" njmax=\"" << rows << "\" nstack=\"" << 2'000'000 + 40 * speeds * speeds + 400 * rows
            << "\"/><option";
    all.numbers("gravity", {world_.gravity.x(), world_.gravity.y(), world_.gravity.z()});
    all.numbers("timestep", {world_.step});
    all.out << "/><asset>" << assets_.out.str() << "</asset><worldbody>" << bodies_.out.str()
            << "</worldbody><contact>" << exceptions_.out.str() << "</contact></mujoco>";
    return all.out.str();
  }

 private:
  void add(std::size_t number, const EngineBody& body) {
    bodies_.out << "<body name=\"b" << number << '"';
    bodies_.place(body.start.x, body.start.R);
    if (body.moves && body.mass == 0) bodies_.out << " mocap=\"true\"";
    bodies_.out << '>';
    if (body.mass > 0) {
      bodies_.out << "<freejoint/><inertial pos=\"0 0 0\"";
      bodies_.numbers("mass", {body.mass});
      bodies_.numbers("diaginertia", {body.moments[0], body.moments[1], body.moments[2]});
      bodies_.out << "/>";
    }
    if (body.plane) add_plane(number, *body.plane);
    for (std::size_t k = 0; k < body.parts.size(); ++k)
      add_part("b" + std::to_string(number) + "p" + std::to_string(k), body.parts[k]);
    bodies_.out << "</body>";
  }

  void begin_geom(const std::string& name) {
    const double mu = sliding(world_.usual);
    bodies_.out << "<geom name=\"" << name << "\" condim=\"" << (mu > 0 ? 3 : 1) << '"';
    if (mu > 0) bodies_.numbers("friction", {mu});
  }

  void add_plane(std::size_t number, const Eigen::Vector4d& plane) {
    const Eigen::Vector3d n = plane.head<3>();
    begin_geom("b" + std::to_string(number) + "p0");
    bodies_.place(plane[3] * n,
                  Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), n).toRotationMatrix());
    bodies_.out << R"( type="plane" size="0 0 1"/>)";
  }

  void add_part(const std::string& name, const RigidBody& part) {
    begin_geom(name);
    bodies_.place(part.frame.translation(), part.frame.linear());
    switch (part.kind) {
      case Kind::ball:
        return end_geom("sphere", {part.radius});
      case Kind::capsule:
        return end_geom("capsule", {part.radius, part.height / 2});
      case Kind::cylinder:
        return end_geom("cylinder", {part.radius, part.height / 2});
      case Kind::box:
        return end_geom("box", {part.half.x(), part.half.y(), part.half.z()});
      case Kind::ellipsoid:
        return end_geom("ellipsoid", {part.half.x(), part.half.y(), part.half.z()});
      case Kind::hull:
        break;
      case Kind::cone:
      case Kind::frustum:
        throw InvalidParameterError("engine: mujoco has no cones");
    }
    assets_.out << "<mesh name=\"" << name << "\" vertex=\"";
    for (const Eigen::Vector3d& v : part.vertices)
      assets_.out << v.x() << ' ' << v.y() << ' ' << v.z() << ' ';
    assets_.out << "\"/>";
    bodies_.out << R"( type="mesh" mesh=")" << name << "\"/>";
  }

  void end_geom(const char* type, std::initializer_list<double> sizes) {
    bodies_.out << " type=\"" << type << '"';
    bodies_.numbers("size", sizes);
    bodies_.out << "/>";
  }

  // Pairs of which at least one reacts and whose law is not that of all.
  void add_exception(int a, int b) {
    const EngineBody &one = world_.bodies[static_cast<std::size_t>(a)],
                     &two = world_.bodies[static_cast<std::size_t>(b)];
    if (!(one.mass > 0 || two.mass > 0)) return;
    const std::optional<ContactLaw> law = world_.law(a, b);
    refuse_restitution(law);
    if (!law) exceptions_.out << "<exclude body1=\"b" << a << "\" body2=\"b" << b << "\"/>";
    if (!law || sliding(law) == sliding(world_.usual)) return;
    const double mu = sliding(law);
    for (std::size_t i = 0; i < std::max<std::size_t>(one.parts.size(), 1); ++i) {
      for (std::size_t j = 0; j < std::max<std::size_t>(two.parts.size(), 1); ++j) {
        exceptions_.out << "<pair geom1=\"b" << a << 'p' << i << "\" geom2=\"b" << b << 'p' << j
                        << "\" condim=\"" << (mu > 0 ? 3 : 1) << '"';
        if (mu > 0) exceptions_.numbers("friction", {mu, mu});
        exceptions_.out << "/>";
      }
    }
  }

  const EngineWorld& world_;
  Text assets_, bodies_, exceptions_;
};

struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

std::unique_ptr<mjModel, Free> model_of(const std::string& text) {
  constexpr const char* kName = "scene.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(text.size()));
  std::copy(text.begin(), text.end(),
            static_cast<char*>(files->filedata[mj_findFileVFS(files.get(), kName)]));
  std::array<char, 500> error{};
  mjModel* model = mj_loadXML(kName, files.get(), error.data(), error.size());
  mj_deleteVFS(files.get());
  if (model == nullptr) throw InvalidParameterError(std::string("engine: mujoco: ") + error.data());
  return std::unique_ptr<mjModel, Free>(model);
}

void be_silent(const char* /*message*/) {}

[[noreturn]] void give_up(const char* message) { throw Error(std::string("engine: mujoco: ") + message); }

/// Soft contacts, solved by Newton's method; bodies that follow a motion push by where they are.
class MujocoEngine final : public PhysicsEngine {
 public:
  explicit MujocoEngine(const EngineWorld& world) {
    mju_user_warning = be_silent;  // in place of a log file
    mju_user_error = give_up;
    model_ = model_of(ModelText(world).text());
    data_.reset(mj_makeData(model_.get()));
    for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b)
      start(b, world.bodies[static_cast<std::size_t>(b)], world.damping);
  }

  void drive(int body, const BodyState& state) override {
    const std::ptrdiff_t number = model_->body_mocapid[body + 1];
    const Eigen::Quaterniond q(state.R);
    const double values[] = {q.w(), q.x(), q.y(), q.z()};
    std::copy_n(state.x.data(), 3, data_->mocap_pos + 3 * number);
    std::copy_n(values, 4, data_->mocap_quat + 4 * number);
  }

  void step(double dt) override {
    model_->opt.timestep = dt;
    mj_step(model_.get(), data_.get());
    for (const int bad : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
      if (data_->warning[bad].number > 0) throw Error("engine: mujoco has become unstable, and began anew");
    }
    for (const int full : {mjWARN_CONTACTFULL, mjWARN_CNSTRFULL}) {
      if (data_->warning[full].number > 0) throw Error("engine: mujoco has no room for all contacts");
    }
  }

  BodyState state(int body) const override {
    const mjtNum* place = data_->qpos + model_->jnt_qposadr[joint_of(body)];
    const mjtNum* speed = data_->qvel + model_->jnt_dofadr[joint_of(body)];
    BodyState state;
    state.x = {place[0], place[1], place[2]};
    state.R = Eigen::Quaterniond(place[3], place[4], place[5], place[6]).normalized().toRotationMatrix();
    state.v = {speed[0], speed[1], speed[2]};
    state.spin = state.R * Eigen::Vector3d(speed[3], speed[4], speed[5]);
    return state;
  }

 private:
  int joint_of(int body) const { return model_->body_jntadr[body + 1]; }  // the world is body 0

  void start(int number, const EngineBody& body, const std::optional<Damping>& damping) {
    if (!(body.mass > 0)) return;
    const int at = model_->jnt_dofadr[joint_of(number)];
    const Eigen::Vector3d spin = body.start.R.transpose() * body.start.spin;
    std::copy_n(body.start.v.data(), 3, data_->qvel + at);
    std::copy_n(spin.data(), 3, data_->qvel + at + 3);
    for (int k = 0; damping && k < 3; ++k) {
      model_->dof_damping[at + k] = damping->linear * body.mass;
      model_->dof_damping[at + 3 + k] = damping->angular * body.moments[k];
    }
  }

  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
};

}  // namespace
}  // namespace raygauge

extern "C" raygauge::PhysicsEngine* raygauge_create_engine(const raygauge::EngineWorld& world) {
  return new raygauge::MujocoEngine(world);
}
