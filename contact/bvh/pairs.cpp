#include <glisson/contact/bvh/pairs.hpp>

#include <algorithm>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

template <class Body>
void for_each_child(const Hierarchy& h, int n, Body body) {
  for (const int c : h.nodes[at(n)].child) {
    if (c < 0) return;
    body(c);
  }
}

/// Descends both trees at once from the pairs on the stack; the larger box is opened first.
void descend(const Hierarchy& a, const Hierarchy& b, Pairs& stack, Pairs& found) {
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    if (!overlap(a.box[at(i)], b.box[at(j)])) continue;
    if (a.is_leaf(i) && b.is_leaf(j))
      found.emplace_back(a.nodes[at(i)].triangle, b.nodes[at(j)].triangle);
    else if (b.is_leaf(j) || (!a.is_leaf(i) && volume(a.box[at(i)]) >= volume(b.box[at(j)])))
      for_each_child(a, i, [&, other = j](int c) { stack.emplace_back(c, other); });
    else
      for_each_child(b, j, [&, other = i](int c) { stack.emplace_back(other, c); });
  }
}

}  // namespace

Pairs overlapping_pairs(const Hierarchy& a, const Hierarchy& b) {
  Pairs found, stack;
  if (a.nodes.empty() || b.nodes.empty()) return found;
  stack.emplace_back(0, 0);
  descend(a, b, stack, found);
  std::sort(found.begin(), found.end());
  return found;
}

SelfPairs overlapping_pairs(const Hierarchy& a, double threshold) {
  SelfPairs result;
  Pairs stack;
  std::vector<int> open;
  if (!a.nodes.empty()) open.push_back(0);
  while (!open.empty()) {
    const int n = open.back();
    open.pop_back();
    if (a.is_leaf(n) || a.cone[at(n)].angle < threshold) continue;
    ++result.subtrees_tested;
    const auto& child = a.nodes[at(n)].child;
    for (std::size_t i = 0; i < child.size() && child[i] >= 0; ++i) {
      open.push_back(child[i]);
      for (std::size_t j = i + 1; j < child.size() && child[j] >= 0; ++j)
        stack.emplace_back(child[i], child[j]);
    }
    descend(a, a, stack, result.pairs);
  }
  for (auto& [i, j] : result.pairs)
    if (i > j) std::swap(i, j);
  std::sort(result.pairs.begin(), result.pairs.end());
  return result;
}

void triangles_near(const Hierarchy& a, const Box& box, std::vector<int>& found, std::vector<int>& stack) {
  found.clear();
  stack.clear();
  if (!a.nodes.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const int n = stack.back();
    stack.pop_back();
    if (!overlap(a.box[at(n)], box)) continue;
    if (a.is_leaf(n))
      found.push_back(a.nodes[at(n)].triangle);
    else
      for_each_child(a, n, [&](int c) { stack.push_back(c); });
  }
  std::sort(found.begin(), found.end());
}

}  // namespace glisson::contact
