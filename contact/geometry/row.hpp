// The four numbers of a node, which a core multiplies and adds as one. Device code does so one by one.
#pragma once

#include <cstring>

#include <glisson/contact/geometry/lanes.hpp>
#include <glisson/core/tensor/tensor.hpp>

namespace glisson::contact {

#ifdef __CUDACC__

template <class R>
struct Row {
  Vec4<R> v;

  GLISSON_HD static Row of(const Vec4<R>& from) { return {from}; }
  GLISSON_HD Vec4<R> value() const { return v; }
  friend GLISSON_HD Row operator+(Row a, Row b) {
    return {{a.v.x + b.v.x, a.v.y + b.v.y, a.v.z + b.v.z, a.v.w + b.v.w}};
  }
  friend GLISSON_HD Row operator-(Row a, Row b) {
    return {{a.v.x - b.v.x, a.v.y - b.v.y, a.v.z - b.v.z, a.v.w - b.v.w}};
  }
  friend GLISSON_HD Row operator*(Row a, Row b) {
    return {{a.v.x * b.v.x, a.v.y * b.v.y, a.v.z * b.v.z, a.v.w * b.v.w}};
  }
  friend GLISSON_HD Row operator*(R s, Row a) { return {{s * a.v.x, s * a.v.y, s * a.v.z, s * a.v.w}}; }
};

#else

template <class R>
struct Row {
  static constexpr int parts = 4 / Lanes<R>::width;
  Lanes<R> v[parts];

  static Row of(const Vec4<R>& from) {
    Row row;
    std::memcpy(static_cast<void*>(row.v), &from, sizeof from);
    return row;
  }
  Vec4<R> value() const {
    Vec4<R> to;
    std::memcpy(static_cast<void*>(&to), v, sizeof to);
    return to;
  }
  friend Row operator+(Row a, const Row& b) {
    for (int p = 0; p < parts; ++p) a.v[p] = a.v[p] + b.v[p];
    return a;
  }
  friend Row operator-(Row a, const Row& b) {
    for (int p = 0; p < parts; ++p) a.v[p] = a.v[p] - b.v[p];
    return a;
  }
  friend Row operator*(Row a, const Row& b) {
    for (int p = 0; p < parts; ++p) a.v[p] = a.v[p] * b.v[p];
    return a;
  }
  friend Row operator*(R s, Row a) {
    for (int p = 0; p < parts; ++p) a.v[p] = Lanes<R>(s) * a.v[p];
    return a;
  }
};

/// x, y and z of as many rows.
template <class L, class R>
requires(lane_count<L> > 1) Vec3<L> turned(const Row<R> (&row)[lane_count<L>]) {
  return turned_parts<L>([&](int l, int p) { return row[l].v[p].v; });
}

#endif

template <class L, class R>
requires(lane_count<L> == 1) GLISSON_HD Vec3<L> turned(const Row<R> (&row)[1]) {
  const Vec4<R> its = row[0].value();
  return {its.x, its.y, its.z};
}

}  // namespace glisson::contact
