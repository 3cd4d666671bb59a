// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/registry.h"

#ifdef RAYGAUGE_HAS_BULLET
#include "baselines/bullet_method.h"
#endif
#ifdef RAYGAUGE_HAS_LIBCCD
#include "baselines/libccd_method.h"
#endif
#ifdef RAYGAUGE_HAS_ODE
#include "baselines/ode_method.h"
#endif
#ifdef RAYGAUGE_HAS_MUJOCO
#include "baselines/mujoco_method.h"
#endif
#ifdef RAYGAUGE_HAS_CGAL
#include "baselines/cgal_method.h"
#endif
#ifdef RAYGAUGE_HAS_GLPK
#include "baselines/glpk_simplex.h"
#endif
#ifdef RAYGAUGE_HAS_CLP
#include "baselines/clp_simplex.h"
#endif
#ifdef RAYGAUGE_HAS_EXACT
#include "baselines/exact_method.h"
#endif
#ifdef RAYGAUGE_HAS_NLOPT
#include "baselines/nlopt_method.h"
#endif
#ifdef RAYGAUGE_HAS_LIBSVM
#include "baselines/libsvm_method.h"
#endif
#ifdef RAYGAUGE_HAS_FCL
#include "baselines/fcl_bodies.h"
#include "baselines/fcl_method.h"
#endif

namespace raygauge {

void register_baselines([[maybe_unused]] MethodRegistry& registry) {
#ifdef RAYGAUGE_HAS_GLPK
  register_glpk_methods(registry);
#endif
#ifdef RAYGAUGE_HAS_CLP
  register_clp_methods(registry);
#endif
#ifdef RAYGAUGE_HAS_EXACT
  register_exact_method(registry);
#endif
#ifdef RAYGAUGE_HAS_NLOPT
  register_nlopt_method(registry);
#endif
#ifdef RAYGAUGE_HAS_LIBSVM
  register_libsvm_methods(registry);
#endif
#ifdef RAYGAUGE_HAS_FCL
  register_fcl_methods(registry);
#endif
#ifdef RAYGAUGE_HAS_BULLET
  register_bullet_method(registry);
#endif
#ifdef RAYGAUGE_HAS_LIBCCD
  register_libccd_methods(registry);
#endif
#ifdef RAYGAUGE_HAS_CGAL
  register_cgal_method(registry);
#endif
#ifdef RAYGAUGE_HAS_MUJOCO
  register_mujoco_method(registry);
#endif
#ifdef RAYGAUGE_HAS_ODE
  register_ode_method(registry);
#endif
}

std::vector<std::pair<std::string, std::string>> solver_versions() {
  std::vector<std::pair<std::string, std::string>> versions;
#ifdef RAYGAUGE_HAS_GLPK
  versions.emplace_back("GLPK", glpk_version());
#endif
#ifdef RAYGAUGE_HAS_CLP
  versions.emplace_back("Clp", clp_version());
#endif
#ifdef RAYGAUGE_HAS_EXACT
  versions.emplace_back("GMP", gmp_library_version());
#endif
#ifdef RAYGAUGE_HAS_NLOPT
  versions.emplace_back("NLopt", nlopt_library_version());
#endif
#ifdef RAYGAUGE_HAS_LIBSVM
  versions.emplace_back("LIBSVM", libsvm_library_version());
#endif
#ifdef RAYGAUGE_HAS_FCL
  versions.emplace_back("FCL", fcl_library_version());
#endif
#ifdef RAYGAUGE_HAS_BULLET
  versions.emplace_back("Bullet", bullet_library_version());
#endif
#ifdef RAYGAUGE_HAS_CGAL
  versions.emplace_back("CGAL", cgal_library_version());
#endif
#ifdef RAYGAUGE_HAS_MUJOCO
  versions.emplace_back("MuJoCo", mujoco_library_version());
#endif
  return versions;
}

}  // namespace raygauge
