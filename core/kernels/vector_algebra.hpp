// Small loop bodies over node arrays for the step estimate and dynamic relaxation. Sums go to one double per
// chunk of nodes and are added on the host in order: the same bits on every backend and for any number of
// threads.
#pragma once

#include <glisson/core/chunk_sums.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson {

constexpr int node_chunk = 256;
constexpr int node_chunks(int node_count) { return chunks_of(node_count, node_chunk); }

/// out = u + s x
template <class R>
struct Displaced {
  const Vec4<R>*u, *x;
  R s;
  Vec4<R>* out;
  GLISSON_HD void operator()(int n) const {
    out[n] = {u[n].x + s * x[n].x, u[n].y + s * x[n].y, u[n].z + s * x[n].z, u[n].w};
  }
};

/// y = s (f - g) / m: M^-1 K x from two force evaluations.
template <class R>
struct ScaledForceDifference {
  const Vec4<R>*f, *g, *v;  ///< v.w: 1/mass
  R s;
  Vec4<R>* y;
  GLISSON_HD void operator()(int n) const {
    const R w = s * v[n].w;
    y[n] = {w * (f[n].x - g[n].x), w * (f[n].y - g[n].y), w * (f[n].z - g[n].z), R(0)};
  }
};

template <class R>
struct Scale {
  Vec4<R>* x;
  R s;
  GLISSON_HD void operator()(int n) const { x[n] = {s * x[n].x, s * x[n].y, s * x[n].z, x[n].w}; }
};

template <class R>
struct Copy {
  const Vec4<R>* from;
  Vec4<R>* to;
  GLISSON_HD void operator()(int n) const { to[n] = from[n]; }
};

/// sums[c] = sum over the chunk of m a.b (mass-weighted) or a.b, free nodes only.
template <class R>
struct DotChunk {
  static constexpr int chunk = node_chunk, cost = 2 * node_chunk;
  using Sum = double;
  const Vec4<R>*a, *b, *v;
  bool mass_weighted;
  int node_count;
  double* sums;  ///< [node_chunks(node_count)]
  GLISSON_HD int entry_count() const { return node_count; }
  GLISSON_HD void add(int n, Sum& sum) const {
    if (!(v[n].w > R(0))) return;
    const double d =
        double(a[n].x) * double(b[n].x) + double(a[n].y) * double(b[n].y) + double(a[n].z) * double(b[n].z);
    sum += mass_weighted ? d / double(v[n].w) : d;
  }
  GLISSON_HD static void join(Sum& to, const Sum& from) { to += from; }
  GLISSON_HD void leave(int c, const Sum& sum) const { sums[c] = sum; }
  GLISSON_HD void operator()(int c) const { run_chunk(*this, c); }
};

/// maxima[c] = largest |a_i|^2 in the chunk.
template <class R>
struct LargestChunk {
  static constexpr int chunk = node_chunk, cost = node_chunk;
  using Sum = double;
  const Vec4<R>* a;
  int node_count;
  double* maxima;  ///< [node_chunks(node_count)]
  GLISSON_HD int entry_count() const { return node_count; }
  GLISSON_HD void add(int n, Sum& largest) const {
    join(largest,
         double(a[n].x) * double(a[n].x) + double(a[n].y) * double(a[n].y) + double(a[n].z) * double(a[n].z));
  }
  GLISSON_HD static void join(Sum& largest, const Sum& d) {
    largest = d > largest || d != d ? d : largest;  // a NaN stays
  }
  GLISSON_HD void leave(int c, const Sum& largest) const { maxima[c] = largest; }
  GLISSON_HD void operator()(int c) const { run_chunk(*this, c); }
};

}  // namespace glisson
