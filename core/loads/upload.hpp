// Host arrays into a backend's memory at set-up.
#pragma once

#include <vector>

#include <glisson/core/backend.hpp>

namespace glisson::detail {

/// A backend buffer of `count` values; never a null pointer, so that empty lists need no special case.
template <class T, class B>
Buffer<T> reserve(B& backend, std::size_t count) {
  return backend.template allocate<T>(count > 0 ? count : 1);
}

template <class T, class B>
Buffer<T> upload(B& backend, const std::vector<T>& host) {
  auto buffer = reserve<T>(backend, host.size());
  if (!host.empty()) backend.copy_in(host.data(), buffer.get(), host.size());
  return buffer;
}

template <class T, class B>
Buffer<T> zeros(B& backend, std::size_t count) {
  return upload(backend, std::vector<T>(count));
}

template <class R>
Vec4<R> narrow(const Vec3<double>& a) {
  return {R(a.x), R(a.y), R(a.z), R(0)};
}

}  // namespace glisson::detail
