// Node lists of a model in the engine's own order: sorted by internal node, each node once.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include <glisson/core/base/error.hpp>
#include <glisson/core/numbering.hpp>

namespace glisson::detail {

inline int internal_node(const Numbering& numbering, int user_node) {
  if (user_node < 0 || std::size_t(user_node) >= numbering.internal_of_user.size())
    throw Error(ErrorKind::input,
                "Node " + std::to_string(user_node) + " does not exist: the mesh has nodes 0 to " +
                    std::to_string(int(numbering.internal_of_user.size()) - 1) + ". Correct the list.");
  return numbering.internal_of_user[std::size_t(user_node)];
}

/// Value k of a list that holds one value for all or one each.
template <class T>
const T& value_of(const std::vector<T>& values, std::size_t k, std::size_t count, const char* what) {
  if (values.size() != 1 && values.size() != count)
    throw Error(ErrorKind::input, std::to_string(values.size()) + " " + what + " for " +
                                      std::to_string(count) + " entries: give one for all or one each.");
  return values[values.size() == 1 ? 0 : k];
}

/// Merges entries of the same node with `merge(T& sum, const T& more)`; ordered by internal node.
template <class T, class Make, class Merge>
std::map<int, T> by_node(const Numbering& numbering, const std::vector<int>& nodes, Make make, Merge merge) {
  std::map<int, T> entries;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const T value = make(k);
    const auto [place, is_new] = entries.try_emplace(internal_node(numbering, nodes[k]), value);
    if (!is_new) merge(place->second, value);
  }
  return entries;
}

template <class T>
std::vector<int> keys(const std::map<int, T>& entries) {
  std::vector<int> result;
  result.reserve(entries.size());
  for (const auto& [node, value] : entries) result.push_back(node);
  return result;
}

inline Vec3<double> on_axes(unsigned axes, double value) {
  return {axes & 1u ? value : 0, axes & 2u ? value : 0, axes & 4u ? value : 0};
}

}  // namespace glisson::detail
