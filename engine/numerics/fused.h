// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>  // defines __GLIBC__ where it is

/// Before the definition of a function, most of all one that multiplies in double-double arithmetic: it is
/// compiled twice, with everything that it calls in this file, and the loader takes the version for machines
/// with fused multiply-adds where there are such. The other one calls std::fma, a function, for each product
/// of two doubles. No sum is contracted: both give the same bits.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__FMA__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RAYGAUGE_FUSED [[gnu::target_clones("fma", "default"), gnu::flatten]]
#else
#define RAYGAUGE_FUSED
#endif

/// Before the definition of a function with loops over lanes: it is compiled once more for wider vectors. No
/// sum is contracted. Its source needs -fno-math-errno and -fno-trapping-math. Also before one that has more
/// numbers at hand than there are registers: those machines have twice as many, and move less.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__AVX2__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RAYGAUGE_VECTORS [[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]]
#else
#define RAYGAUGE_VECTORS
#endif
