// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

namespace raygauge {

/// An array of trivially copyable T, 64-byte aligned, that only ever grows: a repeated solve of the same size
/// finds its memory in place. Contents survive growth.
template <class T>
class AlignedBuffer {
 public:
  T* data() noexcept { return data_.get(); }
  const T* data() const noexcept { return data_.get(); }
  std::size_t capacity() const noexcept { return capacity_; }
  T& operator[](std::size_t i) noexcept { return data_[i]; }
  const T& operator[](std::size_t i) const noexcept { return data_[i]; }

  /// Room for at least `count` elements; new ones are not initialised.
  void reserve(std::size_t count) {
    if (count <= capacity_) return;
    auto* grown = static_cast<T*>(::operator new[](count * sizeof(T), kAlignment));
    if (capacity_ > 0) std::memcpy(grown, data_.get(), capacity_ * sizeof(T));
    data_.reset(grown);
    capacity_ = count;
  }

 private:
  static constexpr std::align_val_t kAlignment{64};
  struct Delete {
    void operator()(T* p) const noexcept { ::operator delete[](p, kAlignment); }
  };
  std::unique_ptr<T[], Delete> data_;
  std::size_t capacity_ = 0;
};

}  // namespace raygauge
