/* Copyright (c) 2026 The raygauge authors
 * SPDX-License-Identifier: MIT
 *
 * What a collision library must offer to be timed by `raygauge_pairs --library ./adapter.so`, in C.
 * An adapter is one file, built outside this tree against that library; fcl_library.cc is an example:
 *
 *     c++ -O3 -shared -fPIC -I RAYGAUGE_TREE adapter.cc -lLIBRARY -o adapter.so
 *
 * No function may throw. Lengths have the bodies' unit.
 */
#ifndef RAYGAUGE_BENCH_PAIR_LIBRARY_H
#define RAYGAUGE_BENCH_PAIR_LIBRARY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Raised when this file changes. */
enum { RAYGAUGE_PAIR_LIBRARY_VERSION = 1 };

enum raygauge_body_kind {
  RAYGAUGE_BALL,      /* radius */
  RAYGAUGE_CAPSULE,   /* radius; ends of the segment at z = +-height/2 */
  RAYGAUGE_BOX,       /* half: half edges */
  RAYGAUGE_ELLIPSOID, /* half: semi-axes along x, y, z */
  RAYGAUGE_CYLINDER,  /* radius; discs at z = +-height/2 */
  RAYGAUGE_CONE,      /* radius of the disc at z = -height/2, tip at z = height/2 */
  RAYGAUGE_FRUSTUM,   /* radius of the disc at z = -height/2, top_radius of the one at z = height/2 */
  RAYGAUGE_HULL       /* vertices and faces; 0 is the mean of the points that it is the hull of */
};

/* A convex body of R^3 about the origin of its own frame. Arrays live until make() returns. */
struct raygauge_body {
  enum raygauge_body_kind kind;
  double radius, top_radius, height;
  double half[3];
  const double* vertices; /* x, y, z of each */
  size_t vertex_count;
  const int* triangles; /* three vertices each, anticlockwise seen from outside */
  size_t triangle_count;
};

/* x -> rotation x + translation, from the body's own frame; the rotation row by row. */
struct raygauge_placement {
  double rotation[9], translation[3];
};

enum raygauge_pair_query {
  RAYGAUGE_DISTANCE, /* Euclidean, with closest points; 0 or less: the bodies meet */
  RAYGAUGE_DEPTH,    /* of bodies that overlap, with the points in contact; 0: they don't */
  RAYGAUGE_GROWTH,   /* the factor by which both grow about their own origins until they touch */
  RAYGAUGE_QUERIES
};

struct raygauge_pair_answer {
  double value;
  double point_1[3], point_2[3]; /* on the first and on the second body */
};

struct raygauge_pair_library {
  int version; /* RAYGAUGE_PAIR_LIBRARY_VERSION */
  const char* name;
  size_t memory_size; /* bytes of a warm start, copied by memcpy; 0: the library has none */

  /* A pair for one query, or NULL where the library has no such body or query. */
  void* (*make)(const struct raygauge_body* first, const struct raygauge_body* second,
                enum raygauge_pair_query query, double tolerance);
  void (*place)(void* pair, const struct raygauge_placement* first, const struct raygauge_placement* second);

  /* The one call that is timed. start: what an earlier solve left in `memory`, NULL for a cold start;
   * memory: where to leave it, or NULL. Returns 1, or 0 where the library fails. */
  int (*solve)(void* pair, const void* start, void* memory, struct raygauge_pair_answer* answer);
  void (*destroy)(void* pair);
};

/* The one function that an adapter exports. */
const struct raygauge_pair_library* raygauge_pair_library_entry(void);

#ifdef __cplusplus
}
#endif
#endif
