// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "raygauge/sets/pose.h"
#include "raygauge/sweep/instance.h"

namespace raygauge {

/// What a sweep has to know of a set before it is read again: its size, and a digest of its points or of its
/// description.
struct SetFacts {
  int n = 0;
  int N = 1;  ///< points; 1 for a set that is none of points
  std::uint64_t digest = 0;
  bool streamed = false;  ///< not in memory: see StreamedHull
};

/// How a file of points is read.
struct FileFormat {
  bool skip_header = false;  ///< the first line of a text is a heading
  bool stream = false;       ///< datasets by passes over them, where that can be done

  bool operator<(const FileFormat& other) const {
    return std::pair(skip_header, stream) < std::pair(other.skip_header, other.stream);
  }
};

/// How files are reached: this room reads none. Implementations are shared between threads.
class FileAccess {
 public:
  virtual ~FileAccess() = default;

  /// These throw Error, with the name of the file, for one that cannot be read or has changed since its facts
  /// were first asked for.
  virtual SetFacts facts(const std::string& source, FileFormat format) = 0;
  virtual std::shared_ptr<const ConvexSet> read(const std::string& source, FileFormat format) = 0;

  /// The pose of R^n that a text describes.
  virtual Pose pose(const std::string& text, int n) = 0;
};

/// Parameters of `files` that not every pair has.
inline constexpr const char* kExactDistance = "exact_distance";
inline constexpr const char* kExactDistanceRounding = "exact_distance_rounding";

/// `files`: two sets of the user's as the one instance of every repetition. Each is moved to
///
///     { R s (x - c) + t : x in S },      s the scale, (R, t) the pose, c the centre of S or 0.
///
/// Point sets stay point sets. An instance has the n of its sets and as N the larger number of points. Of the
/// parameters that are not declared, exact_distance (a number) is the distance that the user knows, and
/// exact_distance_rounding its relative error; the others are carried along.
class FilePair final : public Generator {
 public:
  FilePair(std::shared_ptr<FileAccess> files, Parameters parameters);

  /// Throws InvalidParameterError also for a key of another n or N than the sets have.
  Instance generate(const InstanceKey& key) const override;

  /// What there is of A and of Q. These throw what FileAccess throws.
  SetFacts facts_of_A() const { return facts("A"); }
  SetFacts facts_of_Q() const { return facts("Q"); }

  /// Throws what generate() would throw for the parameters of either set.
  void check() const;

 private:
  FileFormat format() const;
  SetFacts facts(const std::string& role) const;
  bool is_moved(const std::string& role) const;
  std::shared_ptr<const ConvexSet> placed(const std::string& role) const;
  std::shared_ptr<const ConvexSet> kept(const std::string& role,
                                        std::weak_ptr<const ConvexSet>& earlier) const;

  struct Kept;
  std::shared_ptr<FileAccess> files_;
  Parameters parameters_;
  std::shared_ptr<Kept> kept_;  ///< so that repetitions share what is in memory
};

Component<Generator> files_generator(std::shared_ptr<FileAccess> files);

}  // namespace raygauge
