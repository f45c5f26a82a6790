#include <glisson/contact/bvh/split.hpp>

#include <limits>

namespace glisson::contact::detail {
namespace {

constexpr int outside = -1, unassigned = 2;
std::size_t at(int i) { return static_cast<std::size_t>(i); }

int farthest_from(const PatchData& data, const std::vector<int>& patch, const Vec3<double>& p, int but) {
  int best = -1;
  double largest = -1;
  for (const int t : patch) {
    const Vec3<double> d = data.centre[at(t)] - p;
    if (t != but && dot(d, d) > largest) {
      largest = dot(d, d);
      best = t;
    }
  }
  return best;
}

class Half {
 public:
  Half(const PatchData& data, int id) : data_(data), id_(id) {}

  void take(int t, std::vector<int>& mark) {
    mark[at(t)] = id_;
    triangles.push_back(t);
    box_ = united(box_, data_.box[at(t)]);
    cone_ = merged(cone_, data_.cone[at(t)], data_.settings.cones);
    for (const int n : data_.neighbours[at(t)])
      if (n >= 0 && mark[at(n)] == unassigned) frontier_.push_back(n);
  }
  /// Takes the cheapest neighbour; false if there is none left.
  bool grow(std::vector<int>& mark) {
    std::size_t kept = 0;
    int best = -1;
    double lowest = std::numeric_limits<double>::infinity();
    for (const int t : frontier_) {
      if (mark[at(t)] != unassigned) continue;
      frontier_[kept++] = t;
      const double cost = cost_with(t);
      if (best < 0 || cost < lowest || (cost == lowest && t < best)) {
        lowest = cost;
        best = t;
      }
    }
    frontier_.resize(kept);
    if (best >= 0) take(best, mark);
    return best >= 0;
  }

  std::vector<int> triangles;

 private:
  double cost_with(int t) const {
    const double angle = merged(cone_, data_.cone[at(t)], data_.settings.cones).angle;
    return volume(united(box_, data_.box[at(t)])) * (1 + data_.settings.angle_weight * angle);
  }

  const PatchData& data_;
  int id_;
  Box box_;
  NormalCone cone_;
  std::vector<int> frontier_;
};

}  // namespace

std::pair<std::vector<int>, std::vector<int>> split_patch(const PatchData& data,
                                                          const std::vector<int>& patch,
                                                          std::vector<int>& mark) {
  for (const int t : patch) mark[at(t)] = unassigned;
  const int first = farthest_from(data, patch, data.centre[at(patch[0])], -1);
  const int second = farthest_from(data, patch, data.centre[at(first)], first);
  Half a(data, 0), b(data, 1);
  a.take(first, mark);
  b.take(second, mark);
  for (bool more = true; more;) {
    const bool grew = a.grow(mark);
    more = b.grow(mark) || grew;
  }
  for (const int t : patch) mark[at(t)] = outside;
  return {std::move(a.triangles), std::move(b.triangles)};
}

}  // namespace glisson::contact::detail
