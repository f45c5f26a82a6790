// Work on the host in parts that threads may share.
#pragma once

#include <functional>

namespace glisson::contact {

/// run(count, part) calls part(i, worker) once for each i from 0 to count - 1 and returns when all are done;
/// worker < workers, and no two calls at a time have the same one. Parts write disjoint places and must not
/// throw.
struct HostParts {
  int workers = 1;
  std::function<void(int count, const std::function<void(int, int)>& part)> run =
      [](int count, const std::function<void(int, int)>& part) {
        for (int i = 0; i < count; ++i) part(i, 0);
      };
};

/// body(first, last, worker) over pieces of 0 ... n - 1 of `length`.
template <class Body>
void in_pieces(const HostParts& parts, int n, int length, Body body) {
  parts.run((n + length - 1) / length, [&](int i, int worker) {
    const int first = i * length;
    body(first, n - first < length ? n : first + length, worker);
  });
}

}  // namespace glisson::contact
