// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bindings/c/border.h"

#include <array>
#include <cstdio>
#include <new>
#include <string>

#include "raygauge/exceptions.h"
#include "raygauge/methods/result.h"

namespace raygauge::c {
namespace {

// Plain memory: it takes no construction in a new thread, and writing to it cannot fail.
thread_local std::array<char, 1024> message{};

rg_error failed(rg_error error, const char* text) noexcept {
  std::snprintf(message.data(), message.size(), "%s", text);
  return error;
}

}  // namespace

rg_error caught() noexcept {
  try {
    throw;
  } catch (const DimensionMismatchError& error) {
    return failed(RG_DIMENSION_MISMATCH, error.what());
  } catch (const NonFiniteError& error) {
    return failed(RG_NON_FINITE, error.what());
  } catch (const EmptySetError& error) {
    return failed(RG_EMPTY_SET, error.what());
  } catch (const UnknownNameError& error) {
    return failed(RG_UNKNOWN_NAME, error.what());
  } catch (const Error& error) {
    return failed(RG_INVALID_PARAMETER, error.what());
  } catch (const CallbackFailed& error) {
    return failed(RG_CALLBACK_FAILED, error.what());
  } catch (const std::bad_alloc&) {
    return failed(RG_OUT_OF_MEMORY, "out of memory");
  } catch (const std::length_error&) {  // of a vector longer than the address space
    return failed(RG_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return failed(RG_INTERNAL, error.what());
  } catch (...) {
    return failed(RG_INTERNAL, "an exception of an unknown type");
  }
}

void refuse_null(const char* name) { throw InvalidParameterError(std::string(name) + " is a null pointer"); }

void refuse_range(const char* name, std::int64_t value, std::int64_t least, std::int64_t most) {
  throw InvalidParameterError(std::string(name) + " must lie in [" + std::to_string(least) + ", " +
                              std::to_string(most) + "], got " + std::to_string(value));
}

}  // namespace raygauge::c

const char* rg_version(void) { return RAYGAUGE_VERSION; }

const char* rg_last_message(void) { return raygauge::c::message.data(); }

const char* rg_error_name(rg_error error) {
  constexpr std::array kNames{
      "RG_OK",           "RG_INVALID_PARAMETER", "RG_DIMENSION_MISMATCH", "RG_NON_FINITE", "RG_EMPTY_SET",
      "RG_UNKNOWN_NAME", "RG_OUT_OF_MEMORY",     "RG_CALLBACK_FAILED",    "RG_INTERNAL"};
  static_assert(kNames.size() == RG_INTERNAL + 1);
  return error < 0 || error > RG_INTERNAL ? "unknown" : kNames[static_cast<std::size_t>(error)];
}

const char* rg_status_name(int32_t status) {
  static_assert(RG_OPTIMAL == static_cast<int>(raygauge::DistanceStatus::optimal) &&
                RG_CONTAINS_ORIGIN == static_cast<int>(raygauge::DistanceStatus::contains_origin) &&
                RG_UNREACHABLE == static_cast<int>(raygauge::DistanceStatus::unreachable) &&
                RG_PRECISION_LIMIT == static_cast<int>(raygauge::DistanceStatus::precision_limit) &&
                RG_ITERATION_LIMIT == static_cast<int>(raygauge::DistanceStatus::iteration_limit) &&
                RG_TIME_LIMIT == static_cast<int>(raygauge::DistanceStatus::time_limit));
  if (status < RG_OPTIMAL || status > RG_TIME_LIMIT) return "unknown";
  return to_string(static_cast<raygauge::DistanceStatus>(status)).data();  // literals, which end with a zero
}
