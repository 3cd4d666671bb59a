// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

/// The robot that scenes and SRDF files among the seeds are about: links u, v and w, of which j turns v.
inline constexpr const char* kCrew =
    R"(<robot name="r"><link name="u"><collision><geometry><sphere radius="1"/></geometry></collision></link>
<link name="v"><collision><origin xyz="3 0 0"/><geometry><sphere radius="1"/></geometry></collision></link>
<link name="w"><collision><geometry><sphere radius="0.5"/></geometry></collision></link>
<joint name="j" type="revolute"><origin xyz="0 0 9"/><parent link="u"/><child link="v"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="1"/></joint>
<joint name="f" type="fixed"><origin xyz="0 0 3"/><parent link="v"/><child link="w"/></joint></robot>)";

/// It, as a file of this process.
class CrewFile {
 public:
  CrewFile() : file_(".crew.urdf") { file_.write(kCrew); }

  std::string path() const { return file_.path(); }

  /// A text that names crew.urdf, with this file in its place.
  std::string named_in(std::string_view text) const {
    constexpr std::string_view kName = "crew.urdf";
    std::string named(text);
    for (std::size_t at = 0; (at = named.find(kName, at)) != std::string::npos; at += path().size())
      named.replace(at, kName.size(), path());
    return named;
  }

 private:
  ScratchFile file_;
};

}  // namespace raygauge::fuzz
