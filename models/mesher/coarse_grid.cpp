// Coverage of coarse voxels is summed in whole numbers (a voxel's edge is cut into 256 parts), so ties are
// exact and the result does not depend on the order of summation.
#include <algorithm>
#include <cmath>
#include <glisson/core/base/error.hpp>
#include <glisson/models/mesher/coarse_grid.hpp>
#include <unordered_map>

namespace glisson {
namespace {

std::string number(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Voxels per label. Neighbours mostly agree, so runs are counted first.
std::unordered_map<int, std::int64_t> count_labels(const LabelImage& image) {
  std::unordered_map<int, std::int64_t> counts;
  for (std::size_t i = 0; i < image.labels.size();) {
    std::size_t end = i + 1;
    while (end < image.labels.size() && image.labels[end] == image.labels[i]) ++end;
    counts[image.labels[i]] += static_cast<std::int64_t>(end - i);
    i = end;
  }
  return counts;
}

}  // namespace

std::string label_summary(const LabelImage& image) {
  std::vector<std::pair<std::int64_t, int>> order;
  for (const auto& [label, count] : count_labels(image))
    if (label != 0) order.emplace_back(-count, label);
  std::sort(order.begin(), order.end());
  if (order.empty()) return "none, every voxel is 0";
  constexpr std::size_t shown = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, order.size()); ++i)
    text += (i ? ", " : "") + std::to_string(order[i].second) + " (" + std::to_string(-order[i].first) +
            " voxels)";
  if (order.size() > shown) text += " and " + std::to_string(order.size() - shown) + " more";
  return text;
}

namespace detail {

std::array<double, 3> spacing_of(const LabelImage& image) {
  std::array<double, 3> spacing{};
  for (std::size_t b = 0; b < 3; ++b)
    spacing[b] = std::hypot(image.to_world[0][b], image.to_world[1][b], image.to_world[2][b]);
  return spacing;
}

Selection select(const LabelImage& image, const std::vector<int>& labels) {
  const auto counts = count_labels(image);
  Selection selection;
  const auto wanted = [&](int label) {
    return labels.empty() ? label != 0 : std::find(labels.begin(), labels.end(), label) != labels.end();
  };
  for (const auto& [label, count] : counts)
    if (wanted(label)) selection.labels.push_back(label);
  if (selection.labels.empty())
    throw Error(ErrorKind::input,
                "no voxel has a chosen label, so there is nothing to mesh. The labels of the image are: " +
                    label_summary(image) + ". Choose from these.");
  std::sort(selection.labels.begin(), selection.labels.end());
  for (const int label : selection.labels) selection.voxels.push_back(counts.at(label));

  selection.first = image.size;
  selection.last = {-1, -1, -1};
  int latest = 0;
  bool chosen = false, known = false;
  std::size_t at = 0;
  for (int k = 0; k < image.size[2]; ++k)
    for (int j = 0; j < image.size[1]; ++j)
      for (int i = 0; i < image.size[0]; ++i, ++at) {
        if (!known || image.labels[at] != latest) {
          latest = image.labels[at];
          chosen = std::binary_search(selection.labels.begin(), selection.labels.end(), latest);
          known = true;
        }
        if (!chosen) continue;
        const std::array<int, 3> voxel{i, j, k};
        for (std::size_t a = 0; a < 3; ++a) {
          selection.first[a] = std::min(selection.first[a], voxel[a]);
          selection.last[a] = std::max(selection.last[a], voxel[a]);
        }
      }
  return selection;
}

namespace {

constexpr std::int64_t parts = 256;
constexpr std::int64_t max_cells = std::int64_t{1} << 27;

/// Image voxels under one coarse voxel along one axis, and the parts of each that it covers.
struct Cover {
  int first = 0;
  std::vector<std::int64_t> length;  ///< [1/256 voxel]
  std::int64_t total = 0;            ///< length of the coarse voxel, outside the image included
};

Cover cover_of(std::int64_t c, double ratio, int size) {
  const auto cut = [&](std::int64_t edge) { return std::llround(static_cast<double>(edge) * ratio * parts); };
  const std::int64_t begin = cut(c), end = cut(c + 1);
  Cover cover;
  cover.total = end - begin;
  cover.first = static_cast<int>(std::min<std::int64_t>(begin / parts, size));
  for (std::int64_t v = cover.first; v < size && v * parts < end; ++v)
    cover.length.push_back(std::min(end, (v + 1) * parts) - std::max(begin, v * parts));
  return cover;
}

void require_options(const LabelImage& image, const MesherOptions& options) {
  if (!(options.voxel_mm > 0) || !std::isfinite(options.voxel_mm))
    throw Error(ErrorKind::usage, "the voxel size is " + number(options.voxel_mm) +
                                      " mm; it must be positive. Give the wanted edge length, e.g. 5.");
  if (!(options.scale > 0) || !std::isfinite(options.scale))
    throw Error(ErrorKind::usage,
                "the scale is " + number(options.scale) + "; it must be positive. Use 0.001 for metres.");
  const auto spacing = spacing_of(image);
  for (std::size_t a = 0; a < 3; ++a) {
    if (options.voxel_mm < spacing[a] * 8 / parts)
      throw Error(ErrorKind::usage, "the voxel size is " + number(options.voxel_mm) +
                                        " mm, less than 1/32 of the image's (" + number(spacing[a]) +
                                        " mm). Use at least the voxel size of the image.");
    if (options.voxel_mm > 4 * spacing[a] * image.size[a] && options.voxel_mm > 4000 * spacing[a])
      throw Error(ErrorKind::usage,
                  "the voxel size is " + number(options.voxel_mm) +
                      " mm, several times the whole image. Use less than the size of the organ.");
  }
}

void require_count(const LabelImage& image, const Selection& selection, const MesherOptions& options,
                   const CoarseGrid& grid) {
  const auto spacing = spacing_of(image);
  double volume = 0;
  for (const std::int64_t n : selection.voxels)
    volume += static_cast<double>(n) * spacing[0] * spacing[1] * spacing[2];
  const double per_voxel = options.element == Shape::tetrahedron ? 6 : 1;
  const double edge = options.voxel_mm;
  const double expected = per_voxel * volume / (edge * edge * edge);
  const auto limit = static_cast<double>(std::min<std::int64_t>(options.max_elements, 50'000'000));
  if (expected > limit)
    throw Error(ErrorKind::usage,
                "a voxel size of " + number(edge) + " mm would give about " +
                    std::to_string(std::llround(std::min(expected, 9e18))) +
                    " elements, more than the limit of " + std::to_string(std::llround(limit)) + ". Use " +
                    number(std::ceil(10.5 * edge * std::cbrt(expected / limit)) / 10) + " mm or more.");
  double cells = 1;
  for (std::size_t a = 0; a < 3; ++a) cells *= grid.size[a];
  if (cells > static_cast<double>(max_cells))
    throw Error(ErrorKind::usage, "a voxel size of " + number(edge) + " mm would need a grid of " +
                                      std::to_string(std::llround(cells)) +
                                      " coarse voxels, more than the limit of " + std::to_string(max_cells) +
                                      ". Use larger voxels.");
}

/// Coverage of one coarse voxel by each region; only regions that occur are touched.
class Tally {
 public:
  Tally(const LabelImage& image, const std::vector<int>& labels)
      : image_(image), labels_(labels), weight_(labels.size()) {}

  /// The region that fills the coarse voxel, or -1.
  int winner(const Cover& x, const Cover& y, const Cover& z) {
    for (std::size_t c = 0; c < z.length.size(); ++c)
      for (std::size_t b = 0; b < y.length.size(); ++b)
        add_row(x, y.first + static_cast<int>(b), z.first + static_cast<int>(c), y.length[b] * z.length[c]);
    std::int64_t sum = 0, most = 0;
    int best = -1;
    for (const int region : touched_) {
      std::int64_t& w = weight_[static_cast<std::size_t>(region)];
      sum += w;
      if (w > most || (w == most && region < best)) {
        most = w;
        best = region;
      }
      w = 0;
    }
    touched_.clear();
    const double volume =
        static_cast<double>(x.total) * static_cast<double>(y.total) * static_cast<double>(z.total);
    return 2 * static_cast<double>(sum) >= volume ? best : -1;
  }

 private:
  void add_row(const Cover& x, int j, int k, std::int64_t area) {
    for (std::size_t a = 0; a < x.length.size(); ++a) {
      const int region = region_of(image_.label(x.first + static_cast<int>(a), j, k));
      if (region < 0) continue;
      std::int64_t& w = weight_[static_cast<std::size_t>(region)];
      if (w == 0) touched_.push_back(region);
      w += x.length[a] * area;
    }
  }

  int region_of(int label) {
    if (label == latest_ && known_) return region_;
    known_ = true;
    latest_ = label;
    const auto found = std::lower_bound(labels_.begin(), labels_.end(), label);
    return region_ =
               found != labels_.end() && *found == label ? static_cast<int>(found - labels_.begin()) : -1;
  }

  const LabelImage& image_;
  const std::vector<int>& labels_;
  std::vector<std::int64_t> weight_;
  std::vector<int> touched_;
  int latest_ = 0, region_ = -1;
  bool known_ = false;
};

}  // namespace

CoarseGrid coarsen(const LabelImage& image, const Selection& selection, const MesherOptions& options) {
  require_options(image, options);
  CoarseGrid grid;
  const auto spacing = spacing_of(image);
  for (std::size_t a = 0; a < 3; ++a) {
    grid.ratio[a] = options.voxel_mm / spacing[a];
    const double first = std::max(0.0, std::floor(selection.first[a] / grid.ratio[a]) - 1);
    const double size = std::floor((selection.last[a] + 1) / grid.ratio[a]) + 2 - first;
    if (first + size > static_cast<double>(max_cells))
      throw Error(ErrorKind::usage, "a voxel size of " + number(options.voxel_mm) + " mm would need " +
                                        number(first + size) +
                                        " coarse voxels along one axis, more than the limit of " +
                                        std::to_string(max_cells) + ". Use larger voxels.");
    grid.first[a] = static_cast<int>(first);
    grid.size[a] = static_cast<int>(size);
  }
  require_count(image, selection, options, grid);
  std::array<std::vector<Cover>, 3> covers;
  for (std::size_t a = 0; a < 3; ++a)
    for (int c = 0; c < grid.size[a]; ++c)
      covers[a].push_back(cover_of(grid.first[a] + c, grid.ratio[a], image.size[a]));
  Tally tally(image, selection.labels);
  grid.region.reserve(covers[0].size() * covers[1].size() * covers[2].size());
  for (const Cover& z : covers[2])
    for (const Cover& y : covers[1])
      for (const Cover& x : covers[0]) grid.region.push_back(tally.winner(x, y, z));
  if (options.one_region)
    for (int& region : grid.region) region = std::min(region, 0);
  return grid;
}

}  // namespace detail
}  // namespace glisson
