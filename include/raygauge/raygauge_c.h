/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT

   The library raygauge_c: raygauge for C (C99), and for every language that can call C. C++ has
   raygauge/raygauge.h.

   Errors. Functions that can fail return an rg_error, RG_OK (0) or what was wrong; rg_last_message() says it
   in one line. Outputs are then unchanged, except for arrays of a batch. What a solve finds out is no error:
   it is the status in its answer. No C++ exception leaves a function.

   Handles. rg_set, rg_pose, rg_warm, rg_solver, rg_batch, rg_robot and rg_checker are made by a function that
   writes the handle to its last argument, and given back by the function of their name that ends in _free,
   which takes a null pointer too. What is made of others keeps what it needs of them: their handles may be
   freed before it.

   Threads. A set never changes: any number of threads may use one at once. A pose may be shared as long as
   nobody assigns to it, a robot as long as nobody adds to it. A solver, a batch, a checker and a warm start
   are for one thread at a time. Messages are kept for each thread.

   Numbers. Lists of vectors are stored one vector after the other, n doubles each. Matrices are stored by
   columns, as in Octave, Julia and LAPACK. Everything is copied from the caller's arrays; none needs to
   outlive its call. */
#ifndef RAYGAUGE_RAYGAUGE_C_H
#define RAYGAUGE_RAYGAUGE_C_H

#include <stddef.h> /* NOLINT(modernize-deprecated-headers) */
#include <stdint.h> /* NOLINT(modernize-deprecated-headers) */

#if defined(__GNUC__)
#define RG_API __attribute__((visibility("default")))
#else
#define RG_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN: C has its own names, and no `using` */

/* What a call returns. Numbers stay as they are from version to version; new ones are added at the end. */
typedef int32_t rg_error;
enum {
  RG_OK = 0,
  RG_INVALID_PARAMETER = 1,  /* a null pointer, or a value outside its range */
  RG_DIMENSION_MISMATCH = 2, /* two objects that must live in the same R^n do not */
  RG_NON_FINITE = 3,         /* a NaN or an infinity where a finite number is needed */
  RG_EMPTY_SET = 4,          /* a set without a single point */
  RG_UNKNOWN_NAME = 5,       /* an unknown name */
  RG_OUT_OF_MEMORY = 6,
  RG_CALLBACK_FAILED = 7, /* the caller's support mapping returned something other than 0 */
  RG_INTERNAL = 8         /* a defect of the library: please report it */
};

/* How a solve ended. In every case lower <= the value sought <= upper. */
enum {
  RG_OPTIMAL = 0,         /* upper - lower <= tolerance * upper */
  RG_CONTAINS_ORIGIN = 1, /* proven: the distance is 0; of two objects: they have a common point */
  RG_UNREACHABLE = 2,     /* proven: no multiple of Q meets A, the distance is +infinity */
  RG_PRECISION_LIMIT = 3, /* the bounds hold but could not be brought within the tolerance */
  RG_ITERATION_LIMIT = 4, /* stopped by rg_solver_set_max_iterations */
  RG_TIME_LIMIT = 5       /* stopped by rg_solver_set_time_limit or rg_solver_set_stop */
};

/* Whether two objects are apart, or have a common point. */
enum { RG_SEPARATED = 0, RG_INTERSECTING = 1, RG_UNDECIDED = 2 };

/* Whether a point lies in a set. */
enum { RG_INSIDE = 0, RG_OUTSIDE = 1, RG_MEMBERSHIP_UNDECIDED = 2 };

/* What to compute besides a distance; what is not asked for costs nothing. Flags, to be joined by |. */
enum {
  RG_WITNESS = 1,        /* rg_distance: the contact point */
  RG_CLOSEST_POINTS = 2, /* rg_object_distance and rg_signed_distance: RG_POINT_1 and RG_POINT_2 */
  RG_GRADIENT = 4        /* the same: RG_GRADIENT_1 and RG_GRADIENT_2 */
};

/* Vectors that the last solve of a solver may have: see rg_solver_vector. */
enum {
  RG_NORMAL = 0, /* of the plane that proves a lower bound or separation; where objects meet, the way out */
  RG_CONTACT_POINT = 1, /* a point of A that lies in the scaled Q; with RG_WITNESS */
  RG_POINT_1 = 2, /* in the first object: the closest point; of objects that meet, the point in contact ... */
  RG_POINT_2 = 3, /* ... and in the second; with RG_CLOSEST_POINTS */
  RG_GRADIENT_1 = 4, /* of the distance or signed distance, when the first object is translated ... */
  RG_GRADIENT_2 = 5  /* ... and when the second is; with RG_GRADIENT */
};

/* What a joint lets its link do. */
enum { RG_FIXED = 0, RG_REVOLUTE = 1, RG_PRISMATIC = 2 };

/* What is proven of a motion of a robot. */
enum {
  RG_EDGE_FREE = 0,     /* no distance is ever `margin` or less */
  RG_EDGE_CONTACT = 1,  /* at `time` a distance is at most margin + contact */
  RG_EDGE_UNDECIDED = 2 /* neither */
};

typedef struct rg_set rg_set;   /* a nonempty compact convex set of R^n */
typedef struct rg_pose rg_pose; /* a rigid motion x -> R x + t of R^n */
typedef struct rg_warm rg_warm; /* what earlier solves of some pairs have found: a hint, never an answer */
typedef struct rg_solver rg_solver; /* options and workspace of single queries */
typedef struct rg_batch rg_batch;   /* options and workspaces of many queries at once, on threads */
typedef struct rg_robot rg_robot; /* links, joints and bodies of a robot in R^3, and what stands around it */
typedef struct rg_checker rg_checker; /* proves motions of a robot free, or finds a contact */

/* Two sets, each in its pose; a null pose is the identity. */
typedef struct rg_pair {
  const rg_set* first;
  const rg_pose* pose_first;
  const rg_set* second;
  const rg_pose* pose_second;
} rg_pair;

/* A number with its certified bounds. */
typedef struct rg_answer {
  double distance;
  double lower;
  double upper;
  int32_t status; /* RG_OPTIMAL, ... */
  int32_t meet; /* of rg_object_distance and rg_signed_distance: 1 proven to have a common point, 0 proven to
                   be apart, -1 not decided. Of other queries -1 */
} rg_answer;

/* Arrays of the caller that a batch fills; entry i is for pair i. A null pointer asks for nothing. Arrays of
   vectors hold n doubles a pair, NaN where there is no such vector. */
typedef struct rg_batch_answers {
  double* distance;
  double* lower;
  double* upper;
  uint8_t* status;          /* RG_OPTIMAL, ... */
  double* normal;           /* n doubles a pair */
  double* closest_points_1; /* n doubles a pair; rg_batch_object_distances only */
  double* closest_points_2;
} rg_batch_answers;

/* A link of a robot and the joint that it hangs on: its frame is that of the parent, moved by `origin`, then
   turned about, or shifted along, `axis` by scale * (joint value) + offset. */
typedef struct rg_link {
  int32_t parent; /* a link that was added before; -1: the base */
  int32_t kind;   /* RG_FIXED, ... */
  int32_t joint;  /* whose value it is, from 0; of a fixed link nothing is read from here on but origin */
  const rg_pose* origin; /* null: the identity */
  double axis[3];        /* of length 1 to 1e-12 */
  double scale;          /* 1, or of a joint that mimics another; not 0 */
  double offset;
} rg_link;

/* Options of a checker. */
typedef struct rg_checker_options {
  double margin;     /* free motions keep more than this distance; 0 or more */
  double contact;    /* a distance of at most margin + contact is a contact; 0 stands for 1e-6 */
  int64_t max_looks; /* pairs solved for one edge until it is undecided; 0 stands for 20000 */
  int32_t witness;   /* not 0: of a contact also points and depth */
} rg_checker_options;

/* The verdict of a checker. Bodies have the numbers that rg_robot_add_body and rg_robot_add_obstacle gave
   them, parts their places in the list; -1: none. NaN where there is no such number. */
typedef struct rg_verdict {
  int32_t outcome; /* RG_EDGE_FREE, ... */
  int32_t body_1, body_2, part_1, part_2;
  double time; /* of the contact, not always the first one: 1.5 is halfway from configuration 1 to 2 */
  double lower, upper;           /* of a contact: certified bounds on the distance of these parts */
  double depth;                  /* with witness: by how much they overlap; 0: they do not */
  double point_1[3], point_2[3]; /* with witness: the closest points, or those to be pushed apart */
} rg_verdict;

/* ---- The library ---- */

/* "0.2.0": major, minor and patch. */
RG_API const char* rg_version(void);

/* One line about the last call of this thread that failed, or "". It is valid until the next call fails. */
RG_API const char* rg_last_message(void);

/* "RG_NON_FINITE" and the like; "optimal" and the like. "unknown" for any other number. */
RG_API const char* rg_error_name(rg_error error);
RG_API const char* rg_status_name(int32_t status);

/* ---- Sets ---- */

/* conv{p_1, ..., p_count}: points[n * i + k] is coordinate k of point i. */
RG_API rg_error rg_set_points(int32_t n, int64_t count, const double* points, rg_set** set);

/* The same set, prepared for many queries: it takes longer to make, and answers sooner. */
RG_API rg_error rg_set_prepared_points(int32_t n, int64_t count, const double* points, rg_set** set);

/* {x : |x - center| <= radius}, radius >= 0. */
RG_API rg_error rg_set_ball(int32_t n, const double* center, double radius, rg_set** set);

/* {x : lower <= x <= upper}, coordinate by coordinate. */
RG_API rg_error rg_set_box(int32_t n, const double* lower, const double* upper, rg_set** set);

/* {center + L z : |z| <= 1}: the factor L is n x m, by columns, semi-axes where these are orthogonal. */
RG_API rg_error rg_set_ellipsoid(int32_t n, const double* center, int32_t m, const double* factor,
                                 rg_set** set);

/* {center + diag(w) z : |z|_p <= 1}, semi-axes w >= 0, 1 <= p <= infinity. */
RG_API rg_error rg_set_p_norm_ball(int32_t n, const double* center, const double* semi_axes, double p,
                                   rg_set** set);

/* {x : the distance of x to the segment from p to q is <= radius}. */
RG_API rg_error rg_set_capsule(int32_t n, const double* p, const double* q, double radius, rg_set** set);

/* The cylinder around the segment from p to q, p != q. */
RG_API rg_error rg_set_cylinder(int32_t n, const double* p, const double* q, double radius, rg_set** set);

/* The truncated cone between two discs across the axis from base to top; top_radius = 0 is a cone. */
RG_API rg_error rg_set_cone(int32_t n, const double* base, double base_radius, const double* top,
                            double top_radius, rg_set** set);

/* conv{corner, corner + legs_k e_k}. */
RG_API rg_error rg_set_simplex(int32_t n, const double* corner, const double* legs, rg_set** set);

/* {center + sum of t_i g_i : |t_i| <= 1}, the generators g_i one after the other. */
RG_API rg_error rg_set_zonotope(int32_t n, const double* center, int32_t count, const double* generators,
                                rg_set** set);

/* {x : G_i.x <= g_i for i = 1, ..., count}, bounded, with interior; the normals G_i one after the other. */
RG_API rg_error rg_set_h_polytope(int32_t n, int64_t count, const double* normals, const double* offsets,
                                  rg_set** set);

/* The wrenches (f, p x f) in R^6 of one contact with friction at point, its normal force at most 1. The
   normal points into the object held. facets = 0: the exact cone; else a polygon of so many sides inside its
   disc. */
RG_API rg_error rg_set_contact_wrenches(const double* point, const double* normal, double friction,
                                        int32_t facets, rg_set** set);

/* Writes to point, n doubles, a point of the set that is farthest along u, n doubles, and returns 0; any
   other number ends the query with RG_CALLBACK_FAILED. The same u must give the same point. Threads may call
   it at once, if they use the set at once; u = 0 is allowed. It must return: longjmp and exceptions are not
   allowed. */
typedef int32_t (*rg_support_mapping)(void* data, int32_t n, const double* u, double* point);

/* The set of the caller's own support mapping. center is a point of it, inside if it has an interior. data is
   handed to the mapping, and must live as long as this set and the sets made of it. */
RG_API rg_error rg_set_support_mapping(int32_t n, const double* center, rg_support_mapping mapping,
                                       void* data, rg_set** set);

/* {M x + t : x in S}, M n x n by columns, invertible. */
RG_API rg_error rg_set_affine_image(const rg_set* S, const double* M, const double* t, rg_set** set);

/* {a + b : a in A, b in B}. */
RG_API rg_error rg_set_sum(const rg_set* A, const rg_set* B, rg_set** set);

/* {a2 - a1 : a2 in A2, a1 in A1}. */
RG_API rg_error rg_set_difference(const rg_set* A2, const rg_set* A1, rg_set** set);

/* The hull of the union of count sets. */
RG_API rg_error rg_set_union_hull(int64_t count, const rg_set* const* sets, rg_set** set);

RG_API void rg_set_free(rg_set* set);

/* n; 0 for a null pointer. */
RG_API int32_t rg_set_dimension(const rg_set* set);

/* A point deep inside, n doubles. */
RG_API rg_error rg_set_center(const rg_set* set, double* center);

/* h(u) = max{u.x : x in set} and a point that attains it, n doubles; either output may be null. */
RG_API rg_error rg_set_support(const rg_set* set, const double* u, double* value, double* point);

/* ---- Poses ---- */

/* x -> R x + t: R is n x n by columns, t has n doubles. A null R or t is the identity or zero. R must be a
   rotation: it is used as it is if R'R = 1 to 1e-12, and replaced by the nearest rotation if no entry is
   farther than 1e-6. */
RG_API rg_error rg_pose_create(int32_t n, const double* R, const double* t, rg_pose** pose);

/* Other numbers for the same pose, both needed. After an error the pose is what it was. */
RG_API rg_error rg_pose_assign(rg_pose* pose, const double* R, const double* t);

/* The same for a pose of R^3, from the quaternion (w, x, y, z), which is normalised. */
RG_API rg_error rg_pose_assign_quaternion(rg_pose* pose, const double* wxyz, const double* t);

RG_API void rg_pose_free(rg_pose* pose);

/* ---- Warm starts ---- */

/* Room for what is known of count pairs. Single queries use the first, a batch one a pair. */
RG_API rg_error rg_warm_create(int64_t count, rg_warm** warm);
RG_API rg_error rg_warm_clear(rg_warm* warm);
RG_API void rg_warm_free(rg_warm* warm);

/* ---- Single queries ---- */

/* A solver with the default options. It keeps its workspace: a query of the same size allocates nothing. */
RG_API rg_error rg_solver_create(rg_solver** solver);
RG_API void rg_solver_free(rg_solver* solver);

/* The relative gap at which a solve stops, in (0, 1); 1e-6 if it is not set. */
RG_API rg_error rg_solver_set_tolerance(rg_solver* solver, double tolerance);

/* Seconds after which a solve ends with the bounds that it has; +infinity is no limit. */
RG_API rg_error rg_solver_set_time_limit(rg_solver* solver, double seconds);

/* The largest number of basis changes; 0 lets the solver choose. */
RG_API rg_error rg_solver_set_max_iterations(rg_solver* solver, int64_t iterations);

/* "automatic", "column_generation", "newton" or "zheng_yamane". For growth distances automatic means newton.
 */
RG_API rg_error rg_solver_set_method(rg_solver* solver, const char* method);

/* A function that long solves call every few milliseconds; if it returns something other than 0 the solve
   ends as by a time limit. A null pointer removes it. */
typedef int32_t (*rg_stop)(void* data);
RG_API rg_error rg_solver_set_stop(rg_solver* solver, rg_stop stop, void* data);

/* The queries below read the pair, and update warm if it is not null. effects: RG_WITNESS and the like, or 0.
 */

/* d_Q(A) = min{t >= 0 : A and tQ have a common point}, A the first and Q the second of the pair. */
RG_API rg_error rg_distance(rg_solver* solver, const rg_pair* pair, uint32_t effects, rg_warm* warm,
                            rg_answer* answer);

/* The distance of two objects in the metric with unit ball Q; a null Q: the Euclidean one. 0 if they meet. */
RG_API rg_error rg_object_distance(rg_solver* solver, const rg_pair* pair, const rg_set* Q, uint32_t effects,
                                   rg_warm* warm, rg_answer* answer);

/* The same; of objects that meet, minus the depth: the length of the shortest translation after which their
   interiors are disjoint. In R^1, R^2 and R^3; elsewhere the depth of objects that meet has wide bounds. */
RG_API rg_error rg_signed_distance(rg_solver* solver, const rg_pair* pair, const rg_set* Q, uint32_t effects,
                                   rg_warm* warm, rg_answer* answer);

/* The factor by which both objects must be scaled, each about its centre, until they touch: above 1 if they
   are apart. */
RG_API rg_error rg_growth_distance(rg_solver* solver, const rg_pair* pair, rg_warm* warm, rg_answer* answer);

/* Whether the objects are apart: the first proof ends it. outcome: RG_SEPARATED and the like. */
RG_API rg_error rg_separation(rg_solver* solver, const rg_pair* pair, rg_warm* warm, int32_t* outcome);

/* Vector which (RG_NORMAL, ...) of the last query of this solver that did not fail: n doubles, NaN if it has
   none. n must be the dimension of its sets. */
RG_API rg_error rg_solver_vector(const rg_solver* solver, int32_t which, int32_t n, double* values);

/* Bounds on the gauge of S at x, min{t >= 0 : x in tS}, with the relative gap asked for. */
RG_API rg_error rg_gauge(const rg_set* S, const double* x, double tolerance, double* lower, double* upper);

/* Whether x lies in S: RG_INSIDE and the like, undecided within about tolerance of the boundary. */
RG_API rg_error rg_contains(const rg_set* S, const double* x, double tolerance, int32_t* membership);

/* ---- Many queries ---- */

/* Pairs are shared by so many threads, 1 to 64; each answer is that of a single query, bit for bit. */
RG_API rg_error rg_batch_create(int32_t threads, double tolerance, rg_batch** batch);
RG_API void rg_batch_free(rg_batch* batch);

/* rg_object_distance of count pairs; warm is null or has room for count pairs. All bodies live in one space.
 */
RG_API rg_error rg_batch_object_distances(rg_batch* batch, int64_t count, const rg_pair* pairs,
                                          const rg_set* Q, rg_warm* warm, const rg_batch_answers* answers);

/* rg_growth_distance of count pairs. */
RG_API rg_error rg_batch_growth_distances(rg_batch* batch, int64_t count, const rg_pair* pairs, rg_warm* warm,
                                          const rg_batch_answers* answers);

/* ---- Motions of a robot, since version 2 of the interface ---- */

/* A robot with so many joints, without links; its base is the frame of the scene. */
RG_API rg_error rg_robot_create(int32_t joints, rg_robot** robot);
RG_API void rg_robot_free(rg_robot* robot);

/* Adds a link; number, which may be null, is its number: 0, 1, 2, ... */
RG_API rg_error rg_robot_add_link(rg_robot* robot, const rg_link* link, int32_t* number);

/* Adds a rigid body, the union of count sets of R^3, to a link, by `origin` on it (null: the identity). */
RG_API rg_error rg_robot_add_body(rg_robot* robot, int32_t link, int64_t count, const rg_set* const* parts,
                                  const rg_pose* origin, int32_t* number);

/* Adds a body that stands still. The robot has got all of its bodies before. */
RG_API rg_error rg_robot_add_obstacle(rg_robot* robot, int64_t count, const rg_set* const* parts,
                                      const rg_pose* pose, int32_t* number);

/* These two bodies never count. */
RG_API rg_error rg_robot_ignore(rg_robot* robot, int32_t body_1, int32_t body_2);

/* So do bodies of one link, and of links that a joint joins, also over links without a body. To be called
   before what the robot has grasped is added to it. */
RG_API rg_error rg_robot_ignore_joined(rg_robot* robot);

/* A checker of this robot as it is now; null options are the default. */
RG_API rg_error rg_checker_create(const rg_robot* robot, const rg_checker_options* options,
                                  rg_checker** checker);
RG_API void rg_checker_free(rg_checker* checker);

/* Whether the robot moves without contact through these configurations, straight in the space of its joints
   from each to the next: count * joints doubles, one configuration after the other. It ends with the first
   edge that is not free. count = 1: one configuration. */
RG_API rg_error rg_checker_prove(rg_checker* checker, int64_t count, const double* configurations,
                                 rg_verdict* verdict);

/* Forgets what is kept from earlier edges to save time: answers are those of a new checker, bit for bit. */
RG_API rg_error rg_checker_forget(rg_checker* checker);

/* NOLINTEND */

#ifdef __cplusplus
}
#endif

#endif
