// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stdexcept>

#include "raygauge/raygauge_c.h"

namespace raygauge::c {

/// The caller's own function did not do its work.
class CallbackFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Inside a handler: the number of the exception being handled; its text becomes this thread's message.
rg_error caught() noexcept;

/// Runs the work of one function of the C interface. What it throws ends here.
template <class Work>
rg_error guarded(const Work& work) noexcept {
  try {
    work();
    return RG_OK;
  } catch (...) {
    return caught();
  }
}

[[noreturn]] void refuse_null(const char* name);
[[noreturn]] void refuse_range(const char* name, std::int64_t value, std::int64_t least, std::int64_t most);

/// What the caller's pointer points to. Throws InvalidParameterError for a null pointer.
template <class Type>
Type& needed(Type* pointer, const char* name) {
  if (pointer == nullptr) refuse_null(name);
  return *pointer;
}

/// Returns the value. Throws InvalidParameterError outside [least, most].
inline std::int64_t in_range(const char* name, std::int64_t value, std::int64_t least, std::int64_t most) {
  if (value < least || value > most) refuse_range(name, value, least, most);
  return value;
}

}  // namespace raygauge::c
