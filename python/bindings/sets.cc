// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/meshes.h"
#include "python/bindings/set_docs.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/grasp_wrenches.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

/// A class of sets, which Python holds by the same pointer as the engine does.
template <class Set>
py::class_<Set, ConvexSet, std::shared_ptr<Set>> set_class(py::module_& module, const char* name,
                                                           const char* doc) {
  return {module, name, doc};
}

/// Pickling and copying: the set is made again of what `arguments` says, the arguments of its class.
template <class Set, class Arguments>
void made_of(py::class_<Set, ConvexSet, std::shared_ptr<Set>>& type, Arguments arguments) {
  type.def("__reduce__", [arguments](const py::object& self) {
    return py::make_tuple(py::type::of(self), py::tuple(arguments(self.cast<const Set&>())));
  });
}

py::object object_of(const SetPointer& set) { return py::cast(std::const_pointer_cast<ConvexSet>(set)); }

py::array_t<double> matrix_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  py::array_t<double> array({matrix.rows(), matrix.cols()});
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) *array.mutable_data(i, k) = matrix(i, k);
  }
  return array;
}

/// One number for all n coordinates, or an array of n.
Vector numbers_of(py::handle object, Eigen::Index n, const char* name) {
  if (PyFloat_Check(object.ptr()) || PyLong_Check(object.ptr())) {
    return Vector::Constant(n, object.cast<double>());
  }
  return as_vector(object, name);
}

/// s(u) as a Python callable gives it; any thread may ask.
struct PythonMapping {
  std::shared_ptr<py::object> function;
  int n;

  PythonMapping(py::object callable, int dimension)
      : function(new py::object(std::move(callable)),
                 [](py::object* held) {
                   const py::gil_scoped_acquire acquire;
                   delete held;
                 }),
        n(dimension) {}

  void operator()(const double* u, double* point) const {
    const py::gil_scoped_acquire acquire;
    const py::object answer = (*function)(py::array_t<double>(n, u));
    const Vector support = as_vector(answer, "what the mapping returned");
    if (support.size() != n) {
      throw DimensionMismatchError("what the mapping returned: " + std::to_string(n) +
                                   " coordinates are needed, got " + std::to_string(support.size()));
    }
    Eigen::Map<Eigen::VectorXd>(point, n) = support;
  }
};

std::shared_ptr<SupportMappingSet> support_mapping(const ArrayLike& center, const py::object& mapping) {
  if (PyCallable_Check(mapping.ptr()) == 0) {
    throw InvalidParameterError("mapping: a callable u -> s(u) is needed, got " + described(mapping));
  }
  const Vector c = as_vector(center, "center");
  return std::make_shared<SupportMappingSet>(c, PythonMapping(mapping, static_cast<int>(c.size())));
}

py::array_t<double> points_of(const PointSet& set) {
  py::array_t<double> rows({set.size(), static_cast<std::ptrdiff_t>(set.dimension())});
  for (std::ptrdiff_t i = 0; i < set.size(); ++i) set.copy_point(i, rows.mutable_data(i, 0));
  return rows;
}

void bind_interface(py::module_& module) {
  py::class_<ConvexSet, std::shared_ptr<ConvexSet>>(module, "ConvexSet", kConvexSetDoc)
      .def_property_readonly("dimension", &ConvexSet::dimension, "n, the dimension of the space.")
      .def(
          "support_function",
          [](const ConvexSet& set, const ArrayLike& u) { return set.support_function(as_vector(u, "u")); },
          "u"_a, "h(u) = max u·x over the set, for a direction u, shape (n,), of any length.")
      .def(
          "support_mapping",
          [](const ConvexSet& set, const ArrayLike& u) {
            return readonly_array(set.support_mapping(as_vector(u, "u")));
          },
          "u"_a, "A point of the set that is farthest along u, shape (n,).")
      .def_property_readonly(
          "center", [](const ConvexSet& set) { return readonly_array(set.center()); },
          "A point deep inside the set, shape (n,).")
      .def("__repr__", [](py::handle self) {
        return "<raygauge." + self.attr("__class__").attr("__name__").cast<std::string>() +
               ", n = " + std::to_string(self.cast<const ConvexSet&>().dimension()) + ">";
      });
}

void bind_points(py::module_& module) {
  auto type = set_class<PointSet>(module, "PointSet", kPointSetDoc);
  type.def(py::init([](const SetLike& points) {
             if (py::isinstance<PointSet>(points)) return points.cast<std::shared_ptr<PointSet>>();
             if (py::isinstance<ConvexSet>(points)) {
               throw InvalidParameterError("points: an array of shape (N, n) is needed, got " +
                                           described(points));
             }
             return std::dynamic_pointer_cast<PointSet>(
                 std::const_pointer_cast<ConvexSet>(as_set(points, "points")));
           }),
           "points"_a)
      .def_property_readonly("points", points_of, "The points, a new array of shape (N, n).")
      .def("__len__", &PointSet::size);
  made_of(type, [](const PointSet& set) { return py::make_tuple(points_of(set)); });
}

void bind_prepared(py::module_& module) {
  auto prepared = set_class<PreparedSet>(module, "PreparedSet", kPreparedSetDoc);
  prepared
      .def(py::init([](const SetLike& points) {
             const SetPointer set = as_set(points, "points");
             const PointSet* const given = as_point_set(*set);
             if (given == nullptr) {
               throw InvalidParameterError("points: an array of shape (N, n) or a PointSet is needed, got " +
                                           described(points));
             }
             return std::make_shared<PreparedSet>(*given);
           }),
           "points"_a)
      .def_static("has_hulls", &PreparedSet::has_hulls, "Whether this build prepares hulls (Qhull).")
      .def_property_readonly("vertex_count", &PreparedSet::vertex_count,
                             "Vertices of the hull; 0 where Qhull did not find it.")
      .def_property_readonly("memory", &PreparedSet::memory, "Bytes that the set holds.")
      .def_property_readonly(
          "points", [](const PreparedSet& set) { return points_of(set.points()); },
          "The points that are left, a new array of shape (N, n); indices in results count these.")
      .def("__len__", [](const PreparedSet& set) { return set.points().size(); });
  made_of(prepared, [](const PreparedSet& set) { return py::make_tuple(points_of(set.points())); });
}

void bind_round_sets(py::module_& module) {
  auto ball = set_class<Ball>(module, "Ball", kBallDoc);
  ball.def(py::init([](const ArrayLike& center, double radius) {
             return std::make_shared<Ball>(as_vector(center, "center"), radius);
           }),
           "center"_a, "radius"_a = 1.0)
      .def_property_readonly("radius", &Ball::radius);
  made_of(ball, [](const Ball& set) { return py::make_tuple(readonly_array(set.center()), set.radius()); });
  auto ellipsoid = set_class<Ellipsoid>(module, "Ellipsoid", kEllipsoidDoc);
  ellipsoid.def(py::init([](const ArrayLike& center, const ArrayLike& factor) {
                  return std::make_shared<Ellipsoid>(as_vector(center, "center"),
                                                     as_matrix(factor, "factor"));
                }),
                "center"_a, "factor"_a);
  made_of(ellipsoid, [](const Ellipsoid& set) {
    return py::make_tuple(readonly_array(set.center()), matrix_of(set.factor()));
  });
  auto norm_ball = set_class<PNormBall>(module, "PNormBall", kPNormBallDoc);
  norm_ball
      .def(py::init([](const ArrayLike& center, const ArrayLike& semi_axes, double p) {
             const Vector c = as_vector(center, "center");
             return std::make_shared<PNormBall>(c, numbers_of(semi_axes, c.size(), "semi_axes"), p);
           }),
           "center"_a, "semi_axes"_a = 1.0, "p"_a = 2.0)
      .def_property_readonly("p", &PNormBall::p);
  made_of(norm_ball, [](const PNormBall& set) {
    return py::make_tuple(readonly_array(set.center()), readonly_array(set.semi_axes()), set.p());
  });
}

void bind_bodies_of_revolution(py::module_& module) {
  auto capsule = set_class<Capsule>(module, "Capsule", kCapsuleDoc);
  capsule
      .def(py::init([](const ArrayLike& p, const ArrayLike& q, double radius) {
             return std::make_shared<Capsule>(as_vector(p, "p"), as_vector(q, "q"), radius);
           }),
           "p"_a, "q"_a, "radius"_a)
      .def_property_readonly("radius", &Capsule::radius);
  made_of(capsule, [](const Capsule& set) {
    return py::make_tuple(readonly_array(set.p()), readonly_array(set.q()), set.radius());
  });
  auto cylinder = set_class<Cylinder>(module, "Cylinder", kCylinderDoc);
  cylinder
      .def(py::init([](const ArrayLike& p, const ArrayLike& q, double radius) {
             return std::make_shared<Cylinder>(as_vector(p, "p"), as_vector(q, "q"), radius);
           }),
           "p"_a, "q"_a, "radius"_a)
      .def_property_readonly("radius", &Cylinder::radius);
  made_of(cylinder, [](const Cylinder& set) {
    return py::make_tuple(readonly_array(set.p()), readonly_array(set.q()), set.radius());
  });
  auto cone = set_class<TruncatedCone>(module, "TruncatedCone", kTruncatedConeDoc);
  cone.def(py::init([](const ArrayLike& base, double base_radius, const ArrayLike& top, double top_radius) {
             return std::make_shared<TruncatedCone>(as_vector(base, "base"), base_radius,
                                                    as_vector(top, "top"), top_radius);
           }),
           "base"_a, "base_radius"_a, "top"_a, "top_radius"_a = 0.0);
  made_of(cone, [](const TruncatedCone& set) {
    return py::make_tuple(readonly_array(set.base()), set.base_radius(), readonly_array(set.top()),
                          set.top_radius());
  });
}

void bind_polytopes(py::module_& module) {
  auto boxes = set_class<Box>(module, "Box", kBoxDoc);
  boxes
      .def(py::init([](const ArrayLike& lower, const ArrayLike& upper) {
             return std::make_shared<Box>(as_vector(lower, "lower"), as_vector(upper, "upper"));
           }),
           "lower"_a, "upper"_a)
      .def_property_readonly("lower", [](const Box& box) { return readonly_array(box.lower()); })
      .def_property_readonly("upper", [](const Box& box) { return readonly_array(box.upper()); });
  made_of(boxes, [](const Box& set) {
    return py::make_tuple(readonly_array(set.lower()), readonly_array(set.upper()));
  });
  auto simplex = set_class<Simplex>(module, "Simplex", kSimplexDoc);
  simplex.def(py::init([](const ArrayLike& corner, const ArrayLike& legs) {
                const Vector o = as_vector(corner, "corner");
                return std::make_shared<Simplex>(o, numbers_of(legs, o.size(), "legs"));
              }),
              "corner"_a, "legs"_a = 1.0);
  made_of(simplex, [](const Simplex& set) {
    return py::make_tuple(readonly_array(set.corner()), readonly_array(set.legs()));
  });
  auto polytope = set_class<HPolytope>(module, "HPolytope", kHPolytopeDoc);
  polytope.def(py::init([](const ArrayLike& G, const ArrayLike& g) {
                 return std::make_shared<HPolytope>(as_matrix(G, "G"), as_vector(g, "g"));
               }),
               "G"_a, "g"_a);
  made_of(polytope,
          [](const HPolytope& set) { return py::make_tuple(matrix_of(set.G()), readonly_array(set.g())); });
  auto zonotope = set_class<Zonotope>(module, "Zonotope", kZonotopeDoc);
  zonotope.def(py::init([](const ArrayLike& center, const ArrayLike& generators) {
                 const Eigen::MatrixXd rows = as_matrix(generators, "generators");
                 return std::make_shared<Zonotope>(as_vector(center, "center"), rows.transpose());
               }),
               "center"_a, "generators"_a);
  made_of(zonotope, [](const Zonotope& set) {
    return py::make_tuple(readonly_array(set.center()), matrix_of(set.generators().transpose()));
  });
}

void bind_half_spaces(py::module_& module) {
  auto half_space = set_class<HalfSpace>(module, "HalfSpace", kHalfSpaceDoc);
  half_space.def(py::init([](const ArrayLike& normal, double offset) {
                   return std::make_shared<HalfSpace>(as_vector(normal, "normal"), offset);
                 }),
                 "normal"_a, "offset"_a);
  made_of(half_space,
          [](const HalfSpace& set) { return py::make_tuple(readonly_array(set.normal()), set.offset()); });
}

void bind_wrenches(py::module_& module) {
  auto wrenches = set_class<ContactWrenches>(module, "ContactWrenches", kContactWrenchesDoc);
  wrenches.def(py::init([](const ArrayLike& point, const ArrayLike& normal, double friction, int facets) {
                 return std::make_shared<ContactWrenches>(as_vector(point, "point"),
                                                          as_vector(normal, "normal"), friction, facets);
               }),
               "point"_a, "normal"_a, "friction"_a, "facets"_a = 0);
  made_of(wrenches, [](const ContactWrenches& set) {
    return py::make_tuple(readonly_array(set.point()), readonly_array(set.normal()), set.friction(),
                          set.facets());
  });
}

std::shared_ptr<UnionHull> union_hull(const py::iterable& sets) {
  std::vector<SetPointer> members;
  for (const py::handle member : sets) {
    const std::string name = "sets[" + std::to_string(members.size()) + "]";
    members.push_back(as_set(member, name.c_str()));
  }
  return std::make_shared<UnionHull>(std::move(members));
}

void bind_combinators(py::module_& module) {
  auto image = set_class<AffineImage>(module, "AffineImage", kAffineImageDoc);
  image.def(py::init([](const SetLike& set, const ArrayLike& matrix, const ArrayLike& translation) {
              return std::make_shared<AffineImage>(as_set(set, "set"), as_matrix(matrix, "matrix"),
                                                   as_vector(translation, "translation"));
            }),
            "set"_a, "matrix"_a, "translation"_a);
  made_of(image, [](const AffineImage& set) {
    return py::make_tuple(object_of(set.S()), matrix_of(set.M()), readonly_array(set.t()));
  });
  auto sum = set_class<MinkowskiSum>(module, "MinkowskiSum", kMinkowskiSumDoc);
  sum.def(py::init([](const SetLike& A, const SetLike& B) {
            return std::make_shared<MinkowskiSum>(as_set(A, "A"), as_set(B, "B"));
          }),
          "A"_a, "B"_a);
  made_of(sum,
          [](const MinkowskiSum& set) { return py::make_tuple(object_of(set.A()), object_of(set.B())); });
  auto difference = set_class<MinkowskiDifference>(module, "MinkowskiDifference", kMinkowskiDifferenceDoc);
  difference.def(py::init([](const SetLike& A2, const SetLike& A1) {
                   return std::make_shared<MinkowskiDifference>(as_set(A2, "A2"), as_set(A1, "A1"));
                 }),
                 "A2"_a, "A1"_a);
  made_of(difference, [](const MinkowskiDifference& set) {
    return py::make_tuple(object_of(set.A2()), object_of(set.A1()));
  });
  auto hull = set_class<UnionHull>(module, "UnionHull", kUnionHullDoc);
  hull.def(py::init(&union_hull), "sets"_a);
  made_of(hull, [](const UnionHull& set) {
    py::list members;
    for (const SetPointer& member : set.sets()) members.append(object_of(member));
    return py::make_tuple(members);
  });
  auto mapped = set_class<SupportMappingSet>(module, "SupportMappingSet", kSupportMappingSetDoc);
  mapped.def(py::init(&support_mapping), "center"_a, "mapping"_a);
  made_of(mapped, [](const SupportMappingSet& set) {
    return py::make_tuple(readonly_array(set.center()), *set.mapping().target<PythonMapping>()->function);
  });
}

}  // namespace

void bind_sets(py::module_& module) {
  bind_interface(module);
  bind_points(module);
  bind_prepared(module);
  bind_round_sets(module);
  bind_bodies_of_revolution(module);
  bind_polytopes(module);
  bind_half_spaces(module);
  bind_meshes(module);
  bind_wrenches(module);
  bind_combinators(module);
}

}  // namespace raygauge::python
