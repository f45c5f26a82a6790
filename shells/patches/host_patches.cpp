#include <glisson/shells/patches/host_patches.hpp>

#include <algorithm>
#include <numeric>

namespace glisson::shells {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// One value in place of many equal ones.
template <class T, class Equal>
void shorten(std::vector<T>& values, Equal&& equal) {
  const bool same =
      std::all_of(values.begin(), values.end(), [&](const T& v) { return equal(v, values.front()); });
  if (same && !values.empty()) values.resize(1);
}

/// Of RotationFree: [16][element_count] and [12][element_count].
template <class R>
void store_shells(const HostShells& host, const std::vector<int>& order, HostRest<R>& rest) {
  const std::size_t count = order.size();
  rest.gradients.resize(16 * count), rest.images.resize(12 * count);
  for (std::size_t e = 0; e < count; ++e) {
    const auto& c = host.shells[at(order[e])];
    std::size_t k = e;
    const auto next = [&](std::vector<R>& to, double value) { to[k] = R(value), k += count; };
    for (const auto& side : c.g)
      for (const auto& row : side)
        for (const double g : row) next(rest.gradients, g);
    for (const auto& row : c.dL)
      for (const double g : row) next(rest.gradients, g);
    k = e;
    for (const auto& [mirror, turned] : c.image)
      for (const double number : {mirror.x, mirror.y, mirror.z, turned}) next(rest.images, number);
  }
}

}  // namespace

std::vector<int> locality_order(const ShellSection& section, const Numbering& numbering) {
  std::vector<int> rank(numbering.triangle_order.size());
  for (std::size_t i = 0; i < rank.size(); ++i) rank[at(numbering.triangle_order[i])] = static_cast<int>(i);
  std::vector<int> order(section.elements.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return rank[at(section.elements[at(a)])] < rank[at(section.elements[at(b)])];
  });
  return order;
}

template <class R>
HostBlock<R> patch_block(const HostShells& host, const std::vector<int>& order, const Numbering& numbering) {
  HostBlock<R> block;
  block.element_count = static_cast<int>(order.size());
  block.nodes_per_element = host.slots();
  for (const int k : order)
    for (int a = 0; a < host.slots(); ++a)
      block.nodes.push_back(numbering.internal_of_user[at(host.nodes[at(k * host.slots() + a)])]);
  return block;
}

template <class R>
HostRest<R> make_rest(const HostShells& host, const std::vector<int>& order, const HostPatches& patches,
                      const Mesh& mesh, const Numbering& numbering) {
  HostRest<R> rest;
  rest.X = rest_positions<R>(patches, mesh, numbering);
  for (const int k : order) {
    const Vec3<double>& along = host.along[at(k)];
    rest.thickness.push_back(R(host.section->thickness_of(at(k))));
    rest.along.push_back({R(along.x), R(along.y), R(along.z)});
  }
  shorten(rest.thickness, [](R a, R b) { return a == b; });
  shorten(rest.along,
          [](const Vec3<R>& a, const Vec3<R>& b) { return a.x == b.x && a.y == b.y && a.z == b.z; });
  if (host.bends()) store_shells(host, order, rest);
  return rest;
}

template HostBlock<float> patch_block(const HostShells&, const std::vector<int>&, const Numbering&);
template HostBlock<double> patch_block(const HostShells&, const std::vector<int>&, const Numbering&);
template HostRest<float> make_rest(const HostShells&, const std::vector<int>&, const HostPatches&,
                                   const Mesh&, const Numbering&);
template HostRest<double> make_rest(const HostShells&, const std::vector<int>&, const HostPatches&,
                                    const Mesh&, const Numbering&);

}  // namespace glisson::shells
