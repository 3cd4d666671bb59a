// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/kernels/basis_view.h"
#include "raygauge/numerics/instruction_set.h"

namespace raygauge {

/// How a walk over facets ended.
enum class WalkEnd : std::uint8_t {
  arrived,   ///< x >= 0, but for rounding
  no_facet,  ///< none of the points bounds the step, or rounding is in the way
  too_long,  ///< after pivot_limit basis changes
};

/// Facets that are known, for walks to begin at.
struct FacetList {
  const float* normals = nullptr;     ///< y, in blocks of 16, lanes beyond the last one 0
  const float* inverses = nullptr;    ///< n + 1 columns of 16 each: B⁻¹ and y
  const std::int32_t* ids = nullptr;  ///< n places each
  int count = 0;
};

/// Points over which the simplex walks from facet to facet; see Kernels::walk_facets. All vectors in R^n,
/// n <= 16, are of 16 numbers, padded with zeros.
struct FacetWalkPoints {
  int n = 0;
  const double* points = nullptr;       ///< of length 1 at most, one after the other
  const std::int32_t* order = nullptr;  ///< place i holds point order[i]
  const float* blocks = nullptr;        ///< all places, in an even number of blocks of 16, the rest 0
  /// The same times 2^14 and rounded, as far as find_beyond reads: of each two coordinates 16 pairs, each in
  /// the two halves of a number.
  const std::int32_t* rounded = nullptr;
  FacetList known;             ///< at least one
  int listed = 0;              ///< blocks, an even number, of which points are chosen: ...
  float share_of_highest = 0;  ///< ... those with b·p above so much of the highest of the first blocks
  int room = 0;                ///< columns that are chosen at most, but for 31
  int pivot_limit = 0;         ///< of a walk
};

constexpr int kWalksTogether = 8;  ///< at most
constexpr int kMostFound = 512;

/// A walk to the facet that the ray along b leaves the hull through.
struct FacetWalk {
  const double* wanted = nullptr;  ///< b
  float* target = nullptr;         ///< the same in single precision

  float* R = nullptr;               ///< n columns of B⁻¹
  float* y = nullptr;               ///< out: Σ_i R_ik
  std::int32_t* id = nullptr;       ///< out: the places of the basic columns
  WalkEnd end = WalkEnd::too_long;  ///< out
  int chosen = 0;                   ///< out: columns
  int pivots = 0;                   ///< out

  double* share = nullptr;  ///< out, where it arrived: x = R b refined, what is below zero cut off,
  double* rest = nullptr;   ///< b - B x as computed,
  double* dual = nullptr;   ///< and y refined

  std::int32_t* rounded = nullptr;  ///< of find_beyond: 8 pairs, y times a number, rounded,
  std::int32_t threshold = 0;       ///< and a number of the same scale
  std::int32_t* found = nullptr;    ///< out: the places with products above it, kMostFound at most
  int found_count = 0;              ///< out: more than kMostFound where there are more

  float* x = nullptr;        ///< scratch: R b
  float* columns = nullptr;  ///< scratch for the chosen points: n rows of `stride`, a multiple of 16
  std::ptrdiff_t stride = 0;
  std::int32_t* place = nullptr;  ///< scratch, a number a column: its place,
  float* cost = nullptr;          ///< 1 - y·p,
  float* along = nullptr;         ///< and α
};

/// Points with u·p > threshold, found while taking the maximum; see Kernels::collect.
struct Collection {
  std::int64_t* index = nullptr;  ///< capacity entries
  double* value = nullptr;        ///< capacity entries
  std::ptrdiff_t capacity = 0;
  std::ptrdiff_t count = 0;
  double threshold = 0;  ///< raised when the buffer runs full, so that the best are kept
};

/// See Kernels::best_vertex.
struct BestVertex {
  const double* center = nullptr;  ///< c
  double eta = 0;
  double* point_A = nullptr;  ///< out: a, with max u·a
  double* point_Q = nullptr;  ///< out: q, with max -u·q
  double* column = nullptr;   ///< out: s = a - c - ηq
  double value_A = 0;         ///< out: u·a
  double value_Q = 0;         ///< out: -u·q
};

struct MatrixNorms {
  double residual = 0;  ///< at least ‖I - R B‖∞: every rounding error is in it
  double R = 0;         ///< ‖R‖∞
};

/// Layout of the matrix of SharedGram in R^n: column-major, gram_rows(n) rows and gram_columns(n) columns, of
/// which the lower triangle of the first n is written, by stripes of kGramStripe rows. Panels hold
/// gram_rows(n) numbers for each of kGramPoints points.
constexpr int kGramStripe = 32;
constexpr int kGramColumnPadding = 8;
constexpr int kGramPoints = 128;
constexpr int kCholeskyColumns = 48;  ///< that are factored one by one before the rest is brought up to date
constexpr int gram_stripes(int n) { return (n + kGramStripe - 1) / kGramStripe; }
constexpr int gram_rows(int n) { return gram_stripes(n) * kGramStripe; }
constexpr int gram_columns(int n) {
  return (n + kGramColumnPadding - 1) / kGramColumnPadding * kGramColumnPadding;
}

/// A point of a blocked set, and by what it is multiplied.
struct GramPoint {
  std::ptrdiff_t index = 0;
  double factor = 0;
};

/// Rows first … last - 1, whole stripes, of a matrix with n rows and leading dimension ld, and how many slots
/// of the panels are filled.
struct GramPart {
  int depth = 0;
  int n = 0;
  int first = 0;
  int last = 0;
  std::ptrdiff_t ld = 0;
};

constexpr int kPivotsAtOnce = 8;  ///< of an inverse

struct SeparationLanes;
struct HullLanes;
struct BoxLanes;
struct PlacedBox;
struct TriangleBlock;
struct TriangleLanes;

/// The vector kernels of one instruction set.
struct Kernels {
  int width;  ///< doubles in a vector

  /// max_i u·p_i over `block_count` blocks in R^n and its smallest index.
  double (*price)(const double* blocks, std::ptrdiff_t block_count, int n, const double* u,
                  std::ptrdiff_t* index);

  /// The vertex s of A - c - ηQ that is best along u, and u·s.
  double (*best_vertex)(const PricedPoints* A, const PricedPoints* Q, int n, const double* u,
                        BestVertex* best);

  /// max_i u·p_i and the best point of every lane. In single precision where the points have a copy in it (n
  /// numbers of scratch); u·p only chooses then.
  double (*price_lanes)(const PricedPoints* points, int n, const double* u, float* single, LaneList* lanes);

  /// Copies the best point of every lane to `block`, which is a block of points then: a shortlist of a pass,
  /// for directions near u. In single precision where the points have a copy in it (n numbers of scratch).
  void (*best_of_lanes)(const PricedPoints* points, int n, const double* u, float* single, double* block);

  /// As price, and collects the points above a threshold in the same pass.
  double (*collect)(const double* blocks, std::ptrdiff_t first_block, std::ptrdiff_t last_block, int n,
                    const double* u, Collection* collection);

  /// The same of points and u in single precision, in blocks of 16.
  double (*collect_single)(const float* blocks, std::ptrdiff_t first_block, std::ptrdiff_t last_block, int n,
                           const float* u, Collection* collection);

  /// Brings `column` (m entries, padded with zeros) with reduced cost cost - y·column into the basis; the
  /// identity of the column that leaves is written to `left`.
  PivotResult (*pivot)(BasisView* basis, const double* column, double cost, double reduced_cost,
                       std::int64_t id, bool bland, std::int64_t* left);

  /// Dual simplex on min Σβ, Σ β_j p_j = b, β >= 0 over some of the points, in single precision; from the
  /// known facet whose plane b is farthest beyond, the row that leaves by the steepest edge. Up to
  /// kWalksTogether walks at once, so that each goes on while the others wait for their sums; what one finds
  /// does not depend on the others.
  void (*walk_facets)(const FacetWalkPoints* points, FacetWalk* const* walks, int count);

  /// Of up to kWalksTogether walks the points of the first blocks (an even number) whose product with y, both
  /// rounded to integers, is above a threshold; in one pass. No sum may exceed 32 bits.
  void (*find_beyond)(const FacetWalkPoints* points, std::ptrdiff_t block_count, FacetWalk* const* walks,
                      int count);

  /// Then `count` more points, by their places, some of them with y·p > 1: the primal simplex goes on.
  void (*add_to_walk)(const FacetWalkPoints* points, FacetWalk* walk, const std::int32_t* places, int count);

  /// Primal simplex on the LP of Example 2 over the priced points, entering the best point of A and the best
  /// of Q after each pricing. Basis rows: n coordinates, then convexity; m = n + 1.
  LoopEnd (*simplex_loop)(BasisView* basis, SimplexLoop* loop);

  /// A bound on ‖I - R B‖∞, and ‖R‖∞ as computed.
  MatrixNorms (*norms)(BasisView* basis);

  /// The same in parts: the collected changes first; then rows begin … end - 1, multiples of kRowPadding, in
  /// any order, by any thread; at last the largest of all rows.
  void (*subtract_collected)(BasisView* basis);
  void (*sum_rows)(BasisView* basis, int begin, int end);
  MatrixNorms (*largest_sums)(BasisView* basis);

  /// One step of iterative refinement of x = R b by r = b - B x. With `correct`, x += R r. Without it,
  /// returns max_i (|R r|_i + (|R| (γ (|b| + |B||x|) + γ |r|))_i): a bound on what is left of R (b - B x),
  /// rounding included.
  double (*refine)(BasisView* basis, const double* b, bool correct);

  /// The same in twice the precision, for x + x_low (padded): residuals b - B (x + x_low) as if in 106 bits.
  double (*refine_twofold)(BasisView* basis, const double* b, double* x_low, bool correct);

  /// |b - B (x + x_low)|∞, rounded up; NaN or infinite after an overflow.
  double (*residual_twofold)(const BasisView* basis, const double* b, const double* x_low);

  /// One step of iterative refinement of the duals y + y_low (padded), by c_B - Bᵀ (y + y_low) in 106 bits.
  void (*duals_twofold)(BasisView* basis, double* y_low);

  /// yᵀ = c_Bᵀ R, corrected once by the residual c_B - Bᵀ y.
  void (*duals)(BasisView* basis);

  /// factor_s p_s of the points s = first … last - 1 into the slots of the panels; with `single` in single
  /// precision.
  void (*pack_points)(const double* blocks, int n, const GramPoint* points, int first, int last, bool single,
                      double* panels);

  /// M += sign Σ_s v_s v_sᵀ over what the panels hold, in the lower triangle of some rows. Layout: gram_rows.
  /// The same numbers however the rows are divided.
  void (*add_panels)(const double* panels, const GramPart& part, bool single, double sign, double* M);

  /// `count` columns of n rows, aligned, into the slots of the panels.
  void (*pack_columns)(const double* columns, std::ptrdiff_t ld, int count, int n, double* panels);

  /// Columns first … last - 1 of M, of which the earlier ones are subtracted, become those of its Cholesky
  /// factor, down to row n. False at a pivot that is not positive.
  bool (*factor_columns)(double* M, std::ptrdiff_t ld, int n, int first, int last);

  /// sum += Σ weight_i p_i over the points of `block_count` blocks in R^n, as many weights as lanes. 8 n
  /// numbers of scratch.
  void (*add_weighted)(const double* blocks, std::ptrdiff_t block_count, int n, const double* weight,
                       double* scratch, double* sum);

  /// The same of points in single precision, in blocks of 16; sums in double precision.
  void (*add_weighted_single)(const float* blocks, std::ptrdiff_t block_count, int n, const double* weight,
                              double* scratch, double* sum);

  /// values_i = u·p_i over `block_count` blocks in R^n, as many values as lanes.
  void (*products)(const double* blocks, std::ptrdiff_t block_count, int n, const double* u, double* values);

  /// The same of points in single precision, in blocks of 16; sums in double precision.
  void (*products_single)(const float* blocks, std::ptrdiff_t block_count, int n, const double* u,
                          double* values);

  /// p -= Q Qᵀp for `count` orthonormal columns Q, by modified Gram-Schmidt; Qᵀp is added to `coefficients`.
  /// Columns and p have ld = padded_rows(·) entries, padding zero, here, in rotate and in add_multiple.
  void (*project_out)(const double* Q, std::ptrdiff_t ld, int count, double* p, double* coefficients);

  /// (a, b) becomes (c a + s b, c b - s a): a Givens rotation of two vectors.
  void (*rotate)(double* a, double* b, std::ptrdiff_t length, double cosine, double sine);

  /// v += s w; the largest |v_k| afterwards.
  double (*add_multiple)(double* v, const double* w, std::ptrdiff_t length, double s);

  /// Solves R x = x for an upper triangular R of `count` rows, kept by rows of ld entries, zeros left of the
  /// diagonal.
  void (*back_substitute)(const double* R, std::ptrdiff_t ld, int count, double* x);

  /// M becomes its inverse: m columns of ld = padded_rows(m) entries, padding zero. Gauss-Jordan elimination
  /// with exchanges of rows, noted in `exchanged` (m entries). False at a pivot that is not above `smallest`;
  /// M is lost then.
  bool (*invert)(double* M, std::ptrdiff_t ld, int m, double smallest, int* exchanged);

  /// The same in parts, kPivotsAtOnce columns first … last - 1 after the other: they are eliminated within
  /// themselves; then all other columns, begin … end - 1, by any thread. At last columns are exchanged back.
  bool (*eliminate_panel)(double* M, std::ptrdiff_t ld, int m, int first, int last, double smallest,
                          int* exchanged);
  void (*apply_panel)(double* M, std::ptrdiff_t ld, int first, int last, const int* exchanged, int begin,
                      int end);
  void (*undo_exchanges)(double* M, std::ptrdiff_t ld, int m, const int* exchanged);

  /// values_i = (u + u_low)·p_i over `block_count` blocks in R^n, as many values as lanes, as if in 106 bits:
  /// |error| <= 2⁻⁵³ |value| + 4 (n + 4)² 2⁻¹⁰⁶ Σ|u_k p_k|, barring underflow.
  void (*products_twofold)(const double* blocks, std::ptrdiff_t block_count, int n, const double* u,
                           const double* u_low, double* values);

  /// out + out_low = (M + M_low) v, with the errors of products_twofold; `columns` columns of ld entries.
  void (*multiply_twofold)(const double* M, const double* M_low, std::ptrdiff_t ld, int columns,
                           const double* v, double* out, double* out_low);

  /// M_k -= s_k v for every column k, all of them unevaluated sums of two doubles.
  void (*subtract_product_twofold)(double* M, double* M_low, std::ptrdiff_t ld, int columns, const double* v,
                                   const double* v_low, const double* s, const double* s_low);

  /// Which pairs of bodies are apart and which meet, proven: of two boxes, of a box and a capsule or a ball,
  /// of two capsules or balls, of hulls. See PairLanes.
  void (*separate_boxes)(SeparationLanes* lanes);
  void (*separate_box_from_capsule)(SeparationLanes* lanes);
  void (*separate_capsules)(SeparationLanes* lanes);
  void (*separate_hulls)(HullLanes* lanes);

  /// lower_l is at most the distance of `box` and box l, but for what rounding adds: less than 2⁻¹⁶ of the
  /// sum of what coordinates, halves and distances reach; where they overlap it is negative, by how
  /// much. Bit l of the answer: lower_l < beyond. Squares of lengths must be in the range of single
  /// precision.
  unsigned (*bound_boxes)(const BoxLanes* boxes, const PlacedBox* box, float beyond, float* lower);

  /// The same of `box` and the triangles of a block.
  unsigned (*bound_block)(const TriangleBlock* block, const PlacedBox* box, float beyond, float* lower);

  /// See TriangleLanes; the first `count` lanes at least.
  void (*bound_triangles)(TriangleLanes* lanes, int count);
};

/// The kernels for `isa`; `automatic` is the best that this machine runs. Throws InvalidParameterError if the
/// machine lacks the instructions.
const Kernels& kernels_for(InstructionSet isa);

/// kernels_for(InstructionSet::automatic), looked up once.
const Kernels& best_kernels() noexcept;

/// The instruction set that `automatic` stands for here.
InstructionSet best_instruction_set() noexcept;

namespace baseline {
extern const Kernels kKernels;
}
#if defined(__x86_64__)
namespace avx2 {
extern const Kernels kKernels;
}
namespace avx512 {
extern const Kernels kKernels;
}
#endif

}  // namespace raygauge
