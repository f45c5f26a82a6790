// Axis-aligned boxes.
#pragma once

#include <limits>

#include <glisson/core/tensor/tensor.hpp>

namespace glisson::contact {

/// Starts empty: it overlaps nothing and is neutral in a union.
struct Box {
  Vec3<double> low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity()};
  Vec3<double> high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
};

GLISSON_HD inline double smaller(double a, double b) { return b < a ? b : a; }
GLISSON_HD inline double larger(double a, double b) { return b > a ? b : a; }

GLISSON_HD inline Box united(const Box& a, const Box& b) {
  return {{smaller(a.low.x, b.low.x), smaller(a.low.y, b.low.y), smaller(a.low.z, b.low.z)},
          {larger(a.high.x, b.high.x), larger(a.high.y, b.high.y), larger(a.high.z, b.high.z)}};
}
GLISSON_HD inline Box united(const Box& a, const Vec3<double>& p) { return united(a, Box{p, p}); }

GLISSON_HD inline Box inflated(const Box& a, double margin) {
  const Vec3<double> m{margin, margin, margin};
  return {a.low - m, a.high + m};
}
/// Boxes that touch overlap.
GLISSON_HD inline bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}
GLISSON_HD inline bool contains(const Box& a, const Vec3<double>& p) {
  return a.low.x <= p.x && p.x <= a.high.x && a.low.y <= p.y && p.y <= a.high.y && a.low.z <= p.z &&
         p.z <= a.high.z;
}
GLISSON_HD inline double volume(const Box& a) {
  const Vec3<double> d = a.high - a.low;
  return d.x * d.y * d.z;
}

}  // namespace glisson::contact
