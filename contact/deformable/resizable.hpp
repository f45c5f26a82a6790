// A buffer of a backend for lists whose length changes between searches.
#pragma once

#include <vector>

#include <glisson/core/loads/upload.hpp>

namespace glisson::contact {

/// Grows by half more than is needed, so that after a few searches nothing is allocated.
template <Backend B, class T>
class Resizable {
 public:
  explicit Resizable(B& backend) : backend_(&backend), data_(detail::reserve<T>(backend, 1)), capacity_(1) {}

  /// Room for `count` values; what was there is lost.
  void resize(std::size_t count) {
    if (count <= capacity_) return;
    capacity_ = count + count / 2;
    data_ = detail::reserve<T>(*backend_, capacity_);
  }
  void put(const std::vector<T>& host) {
    resize(host.size());
    if (!host.empty()) backend_->copy_in(host.data(), data_.get(), host.size());
  }
  T* get() const { return data_.get(); }

 private:
  B* backend_;
  Buffer<T> data_;
  std::size_t capacity_;
};

}  // namespace glisson::contact
