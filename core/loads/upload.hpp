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

/// For reading only.
template <class T, class B>
Buffer<T> upload(B& backend, const std::vector<T>& host) {
  return host.empty() ? reserve<T>(backend, 0) : upload_constant(backend, host.data(), host.size());
}

template <class T, class B>
Buffer<T> zeros(B& backend, std::size_t count) {
  const std::vector<T> host(count);
  auto buffer = reserve<T>(backend, count);
  if (count > 0) backend.copy_in(host.data(), buffer.get(), count);
  return buffer;
}

template <class R>
Vec4<R> narrow(const Vec3<double>& a) {
  return {R(a.x), R(a.y), R(a.z), R(0)};
}

}  // namespace glisson::detail
