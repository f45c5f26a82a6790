#include <glisson/contact/bvh/pair_search.hpp>

#include <algorithm>

#include <glisson/contact/bvh/node_regions.hpp>

namespace glisson::contact {
namespace {

constexpr int part_count = 64;
/// Pairs of subtrees before they are dealt out: many for each part, because some hold most of the triangles.
constexpr std::size_t task_count = 16 * part_count;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

PairSearch::PairSearch(const Hierarchy& hierarchy, std::span<const int> region, MayTouch may_touch)
    : may_touch_(std::move(may_touch)), parts_(part_count) {
  NodeRegions regions = node_regions(hierarchy, region, may_touch_);
  region_ = std::move(regions.of_node);
  uses_cones_ = regions.uses_cones;
}

bool PairSearch::may_touch(int a, int b) const {
  const int i = region_[at(a)], j = region_[at(b)];
  return i < 0 || j < 0 || may_touch_(i, j);
}

void PairSearch::open_one(const Hierarchy& h, int n, Part& part) const {
  ++part.subtrees;
  const auto& child = h.nodes[at(n)].child;
  for (std::size_t i = 0; i < child.size() && child[i] >= 0; ++i) {
    part.open.emplace_back(child[i], child[i]);
    for (std::size_t j = i + 1; j < child.size() && child[j] >= 0; ++j)
      part.open.emplace_back(child[i], child[j]);
  }
}

/// The larger box is opened first.
void PairSearch::open_two(const Hierarchy& h, Task task, Part& part) const {
  const auto [i, j] = task;
  const bool first = h.is_leaf(j) || (!h.is_leaf(i) && volume(h.box[at(i)]) >= volume(h.box[at(j)]));
  const auto [opened, other] = first ? std::pair{i, j} : std::pair{j, i};
  for (const int c : h.nodes[at(opened)].child)
    if (c >= 0) part.open.emplace_back(c, other);
}

/// Replaces the last open task by what it consists of.
void PairSearch::step(const Hierarchy& h, double threshold, Part& part) const {
  const auto [i, j] = part.open.back();
  part.open.pop_back();
  if (!may_touch(i, j)) return;
  if (i == j) {
    if (!h.is_leaf(i) && (!uses_cones_ || h.cone[at(i)].angle >= threshold)) open_one(h, i, part);
  } else if (overlap(h.box[at(i)], h.box[at(j)])) {
    if (h.is_leaf(i) && h.is_leaf(j))
      part.found.push_back(std::minmax(h.nodes[at(i)].triangle, h.nodes[at(j)].triangle));
    else
      open_two(h, {i, j}, part);
  }
}

/// Opens tasks, the oldest first, until there are enough to deal out. What is found on the way is the first
/// part's.
void PairSearch::divide(const Hierarchy& h, double threshold) {
  for (Part& part : parts_) part.open.clear(), part.found.clear(), part.subtrees = 0;
  std::vector<Task> tasks{{0, 0}}, next;
  Part& first = parts_.front();
  while (!tasks.empty() && tasks.size() < task_count) {
    next.clear();
    for (const Task& task : tasks) {
      first.open.assign(1, task);
      step(h, threshold, first);
      next.insert(next.end(), first.open.begin(), first.open.end());
    }
    tasks.swap(next);
  }
  first.open.clear();
  for (std::size_t k = 0; k < tasks.size(); ++k) parts_[k % parts_.size()].open.push_back(tasks[k]);
}

int PairSearch::find(const Hierarchy& h, double threshold, const HostParts& parts, Pairs& found) {
  found.clear();
  if (h.nodes.empty()) return 0;
  divide(h, threshold);
  parts.run(part_count, [&](int p, int) {
    while (!parts_[at(p)].open.empty()) step(h, threshold, parts_[at(p)]);
  });
  int subtrees = 0;
  for (const Part& part : parts_) {
    found.insert(found.end(), part.found.begin(), part.found.end());
    subtrees += part.subtrees;
  }
  return subtrees;
}

}  // namespace glisson::contact
