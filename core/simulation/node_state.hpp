// The state of all nodes in a backend's memory, in internal order, and sums over it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <glisson/core/backend.hpp>
#include <glisson/core/kernels/advance_nodes.hpp>
#include <glisson/core/kernels/vector_algebra.hpp>
#include <glisson/core/numbering.hpp>

namespace glisson {

/// NaN if any is.
inline double largest_of(std::span<const double> parts) {
  double largest = 0;
  for (const double part : parts) largest = part > largest || part != part ? part : largest;
  return largest;
}

/// The largest length in a node array, on which a device can work while other things are done.
template <class B, class R>
class LargestLength {
 public:
  LargestLength(B& backend, int node_count)
      : backend_(backend),
        count_(node_count),
        chunks_(backend.template allocate<double>(static_cast<std::size_t>(node_chunks(node_count)))) {}

  void find(const Vec4<R>* a) {
    backend_.for_each(node_chunks(count_), LargestChunk<R>{a, count_, chunks_.get()});
  }
  /// What was found last; NaN if any is. Waits for a device.
  double read() const {
    std::vector<double> host(static_cast<std::size_t>(node_chunks(count_)));
    backend_.copy_out(chunks_.get(), host.data(), host.size());
    return std::sqrt(largest_of(host));
  }

 private:
  B& backend_;
  int count_;
  Buffer<double> chunks_;
};

template <class B, class R>
class NodeState {
 public:
  NodeState(B& backend, std::span<const double> mass)
      : backend_(backend), count_(static_cast<int>(mass.size())), u_(zeros()), v_(zeros()), f_(zeros()) {
    partial_ = backend_.template allocate<double>(3 * static_cast<std::size_t>(node_chunks(count_)));
    std::vector<Vec4<R>> v(mass.size());
    for (std::size_t n = 0; n < mass.size(); ++n) v[n].w = mass[n] > 0 ? R(1 / mass[n]) : R(0);
    put(v, v_.get());
  }

  int count() const { return count_; }
  std::size_t size() const { return static_cast<std::size_t>(count_); }
  Vec4<R>* u() const { return u_.get(); }
  Vec4<R>* v() const { return v_.get(); }
  Vec4<R>* f() const { return f_.get(); }

  /// A further node array, zeroed.
  Buffer<Vec4<R>> zeros() {
    auto buffer = backend_.template allocate<Vec4<R>>(size());
    backend_.for_each(count_, ZeroForces<R>{buffer.get()});
    return buffer;
  }
  void put(const std::vector<Vec4<R>>& from, Vec4<R>* to) { backend_.copy_in(from.data(), to, from.size()); }
  std::vector<Vec4<R>> get(const Vec4<R>* from) const {
    std::vector<Vec4<R>> host(size());
    backend_.copy_out(from, host.data(), host.size());
    return host;
  }
  /// In the user's node order, in double.
  std::vector<Vec3<double>> for_user(const Vec4<R>* from, const Numbering& numbering) const {
    const auto host = get(from);
    std::vector<Vec3<double>> result(size());
    for (std::size_t n = 0; n < size(); ++n) {
      const auto& a = host[n];
      result[static_cast<std::size_t>(numbering.user_of_internal[n])] = {double(a.x), double(a.y),
                                                                         double(a.z)};
    }
    return result;
  }

  /// Sum over nodes with mass of a.b, or of m a.b.
  double dot(const Vec4<R>* a, const Vec4<R>* b, bool mass_weighted) {
    backend_.for_each(node_chunks(count_), DotChunk<R>{a, b, v(), mass_weighted, count_, partial_.get()});
    return sum_of(partials(1));
  }
  /// Largest squared length; NaN if any is.
  double largest(const Vec4<R>* a) const {
    backend_.for_each(node_chunks(count_), LargestChunk<R>{a, count_, partial_.get()});
    return largest_of(partials(1));
  }
  /// Sums of m x.x and m y.y and the largest squared length of y at once: a device waits once.
  std::array<double, 3> norms(const Vec4<R>* x, const Vec4<R>* y) const {
    const int chunks = node_chunks(count_);
    backend_.for_each(chunks, DotChunk<R>{x, x, v(), true, count_, partial_.get()});
    backend_.for_each(chunks, DotChunk<R>{y, y, v(), true, count_, partial_.get() + chunks});
    backend_.for_each(chunks, LargestChunk<R>{y, count_, partial_.get() + 2 * chunks});
    const std::vector<double> all = partials(3);
    const std::span<const double> part(all);
    const auto count = static_cast<std::size_t>(chunks);
    return {sum_of(part.subspan(0, count)), sum_of(part.subspan(count, count)),
            largest_of(part.subspan(2 * count))};
  }
  std::size_t memory_bytes() const { return 3 * size() * sizeof(Vec4<R>); }

 private:
  static double sum_of(std::span<const double> parts) {
    double sum = 0;
    for (const double part : parts) sum += part;
    return sum;
  }
  /// Of the first `sums` bodies.
  std::vector<double> partials(int sums) const {
    std::vector<double> host(static_cast<std::size_t>(sums * node_chunks(count_)));
    backend_.copy_out(partial_.get(), host.data(), host.size());
    return host;
  }

  B& backend_;
  int count_;
  Buffer<Vec4<R>> u_, v_, f_;
  Buffer<double> partial_;  ///< of up to three bodies at once
};

}  // namespace glisson
