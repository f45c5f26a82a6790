// Forward dual numbers: a value and its derivative by one parameter, carried through any law or element.
#pragma once

#include <glisson/core/numbers/functions.hpp>

namespace glisson {

/// value + derivative epsilon with epsilon^2 = 0. Comparisons look at the value. Where a function has no
/// derivative (square_root at 0), the derivative is NaN or infinite.
template <class T>
struct Dual {
  T value, derivative;
  Dual() = default;
  GLISSON_HD Dual(T v, T d = T(0)) : value(v), derivative(d) {}

  friend GLISSON_HD Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.derivative + b.derivative};
  }
  friend GLISSON_HD Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.derivative - b.derivative};
  }
  friend GLISSON_HD Dual operator-(const Dual& a) { return {-a.value, -a.derivative}; }
  friend GLISSON_HD Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.value * b.derivative + a.derivative * b.value};
  }
  friend GLISSON_HD Dual operator/(const Dual& a, const Dual& b) {
    const T q = a.value / b.value;
    return {q, (a.derivative - q * b.derivative) / b.value};
  }
  friend GLISSON_HD bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend GLISSON_HD bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend GLISSON_HD bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend GLISSON_HD bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
};

template <class T>
GLISSON_HD Dual<T> rcbrt(const Dual<T>& a) {
  const T y = rcbrt(a.value);
  return {y, -a.derivative * y / (T(3) * a.value)};
}
template <class T>
GLISSON_HD Dual<T> square_root(const Dual<T>& a) {
  const T r = square_root(a.value);
  return {r, a.derivative / (r + r)};
}
template <class T>
GLISSON_HD Dual<T> log_1p(const Dual<T>& a) {
  return {log_1p(a.value), a.derivative / (T(1) + a.value)};
}
template <class T>
GLISSON_HD Dual<T> exp_m1(const Dual<T>& a) {
  const T e = exp_m1(a.value);
  return {e, a.derivative * (T(1) + e)};
}
template <class T>
GLISSON_HD Dual<T> select(bool condition, const Dual<T>& a, const Dual<T>& b) {
  return condition ? a : b;
}

}  // namespace glisson
