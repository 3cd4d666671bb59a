// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "raygauge/sweep/registry.h"

namespace raygauge {

/// How timed solves share the machine.
enum class TimingMode : std::uint8_t {
  serial,    ///< timed solves run alone
  parallel,  ///< cells fill the cores; a calibration cell measures the slowdown
};

/// A component and the parameters it is run with.
struct ComponentSpec {
  std::string name;       ///< registered name
  std::string label;      ///< name in results; defaults to `name`
  Parameters parameters;  ///< as given; defaults are completed by the registry
};

/// A generator, which may have axes of its own: families exist in some dimensions only.
struct GeneratorSpec : ComponentSpec {
  std::vector<int> n = {};  ///< empty: Experiment::n
  std::vector<int> N = {};  ///< empty: Experiment::N
};

/// How the axes n, N and tolerance are combined.
enum class GridMode : std::uint8_t {
  cartesian,  ///< every n with every N with every tolerance
  paired,     ///< n[i] with N[i], the lists being of one length; still times every tolerance
};

/// A sweep as its author wrote it. The in-class defaults are the only ones.
struct Experiment {
  std::string name = "experiment";
  std::string description;
  std::uint64_t seed = 1;
  int repetitions = 20;  ///< instances a cell; the most, with stop_when_within > 0
  int min_repetitions =
      10;          ///< the fewest, with stop_when_within > 0; at least 6, which a 95 % interval needs
  int warmup = 1;  ///< untimed solves of each method before a cell's first timed one
  double min_seconds = 2e-5;  ///< a timed sample lasts at least this long (several solves if need be)

  /// A cell ends once the 95 % order-statistic interval of each method's median time is no wider than this
  /// fraction of the median (see medians_known()); 0: always after `repetitions`.
  double stop_when_within = 0;

  GridMode grid = GridMode::cartesian;
  std::vector<int> n = {3};
  std::vector<int> N = {200};
  std::vector<double> tolerance = {1e-6};
  std::vector<GeneratorSpec> generators;  ///< one entry for each combination of generator parameters
  std::vector<ComponentSpec> methods;

  TimingMode timing = TimingMode::parallel;
  int threads = 0;  ///< 0: one for each core
  bool pin_threads = true;
  double time_limit = 60;  ///< seconds for one solve; passed to the method, stored as a status
  bool shuffle = true;     ///< seeded order of cells; results do not depend on it

  std::string text;  ///< the TOML source after --set, kept for provenance

  /// Whether threads of the sweep are held on cores: pin_threads, unless a method's solves take several
  /// threads.
  bool pins() const;
};

/// One cell of the grid: a generator, n, N and a tolerance. All methods and repetitions run inside it.
struct Cell {
  std::uint64_t index = 0;    ///< position in the unshuffled grid; identifies the cell on --resume
  std::size_t generator = 0;  ///< index into Experiment::generators
  int n = 0;
  int N = 0;
  double tolerance = 0;
};

/// Throws InvalidParameterError for a value outside its documented range, an experiment without generators or
/// methods, or two methods of one label. Names are checked by the registries, not here.
void validate(const Experiment& experiment);

/// The grid in its natural order: generator slowest, then n, N, tolerance. Throws InvalidParameterError for
/// an experiment without cells or with more than a million, a cell that appears twice, or paired lists of
/// different lengths.
std::vector<Cell> grid_of(const Experiment& experiment);

/// The label of a component in results: `label`, or else `name`.
const std::string& label_of(const ComponentSpec& component);

}  // namespace raygauge
