// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "results/disk/atomic_file.h"
#include "results/exceptions.h"

namespace raygauge {

/// An output that would destroy what is there, or cannot go there. The message is one line: which path, why.
/// Nothing was touched.
class OutputRefusedError : public ResultsError {
 public:
  using ResultsError::ResultsError;
};

enum class OutputKind : std::uint8_t {
  text,     ///< derived, for people and other programs: a page, a table, CSV
  image,    ///< derived: a picture
  results,  ///< measurements
};

/// What a command wants to write, and where.
struct OutputRequest {
  std::string path;  ///< as the user gave it
  OutputKind kind = OutputKind::text;
  std::vector<std::string>
      extensions;                   ///< of files of this kind, in lower case, the usual one first: ".html"
  std::vector<std::string> inputs;  ///< the files that the command reads
  bool force = false;
};

enum class OutputWay : std::uint8_t {
  standard_output,
  stream,  ///< a device, a FIFO or an open file: written to, never replaced
  file,    ///< replaced as a whole or not at all
};

struct OutputPlace {
  OutputWay way = OutputWay::file;
  std::filesystem::path path;  ///< behind links; its folder may be missing
};

/// The one place that decides what may be written where.
///
///   - No input is written to, whatever it is called here, nor the parts of an unfinished run.
///   - HDF5 files are replaced by results alone, and names that end in .h5 or .hdf5 are theirs.
///   - What is derived replaces a file of its own kind (one with an extension of `extensions`) or an empty
///     one; another file, or one that is write-protected, only under `force`.
///   - Whether results may replace results is for RunWriter to say; they go to a regular file alone.
///   - A link is followed, even a dangling one; devices and FIFOs are written to; "-" is standard output for
///     text. A folder is never a place.
///
/// Changes nothing. Throws OutputRefusedError.
OutputPlace output_place(const OutputRequest& request);

/// Writes the bytes of `source` to a place that is not standard output, making the folders above it. A file
/// appears whole, with the permissions of the one it replaces, or stays as it was. Throws ResultsError with
/// the system's reason, and what `source` throws.
void write_output(const OutputPlace& place, const ByteSource& source);
void write_output(const OutputPlace& place, std::string_view bytes);

/// The file that `path` leads to over symbolic links, whether it is there or not. Throws OutputRefusedError
/// for links that lead in a circle.
std::filesystem::path behind_links(const std::filesystem::path& path);

}  // namespace raygauge
