#include <glisson/contact/tied/tie_rows.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <glisson/contact/tied/glued_surface.hpp>
#include <glisson/core/base/error.hpp>
#include <glisson/core/base/number_text.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Row = std::map<int, double>;  // node: weight

[[noreturn]] void refuse(const TiedSurfaces& tie, const std::string& why) {
  throw Error(ErrorKind::input, why, {"", 0, tie.where});
}

/// A node's row needs this share of the area around it to face the other surface: with less it would hang on
/// a corner.
constexpr double least_share = 0.05;

/// Adds the rows of one tie. Returns the smallest distance between its surfaces [m].
double append_rows(const GluedSurface& a, const GluedSurface& b, double distance, std::vector<Row>& rows) {
  std::map<int, Row> its;
  std::map<int, double> covered;
  double nearest = 1e300;
  for (int f = 0; f < a.facet_count(); ++f)
    for (const FacetSample& sample : a.samples(f)) {
      const NearPoint other = b.nearest(sample, distance);
      nearest = std::min(nearest, other.distance);
      if (other.distance > distance) continue;
      for (int i = 0; i < sample.count; ++i) {
        const double dual = sample.area * sample.dual[at(i)];
        Row& row = its[sample.node[at(i)]];
        covered[sample.node[at(i)]] += sample.area * sample.shape[at(i)];
        for (int j = 0; j < sample.count; ++j) row[sample.node[at(j)]] += dual * sample.shape[at(j)];
        for (int k = 0; k < other.count; ++k) row[other.node[at(k)]] -= dual * other.weight[at(k)];
      }
    }
  for (auto& [node, row] : its)
    if (covered[node] > least_share * a.area_at(node)) rows.push_back(std::move(row));
  return nearest;
}

void append_tie(const Model& model, const ContactFacets& facets, const TiedSurfaces& tie,
                std::vector<Row>& rows) {
  const int first = body_named(model, tie.a, tie.where), second = body_named(model, tie.b, tie.where);
  if (first == second) refuse(tie, "it ties '" + tie.a + "' to itself; give two different sub-models");
  const GluedSurface a(model, facets, first), b(model, facets, second);
  for (const auto& [surface, name] : {std::pair{&a, &tie.a}, std::pair{&b, &tie.b}})
    if (surface->facet_count() == 0)
      refuse(tie, "'" + *name + "' has no outer surface of its own that could be tied");
  const double distance = tie.distance.value_or(0.1 * std::min(a.edge_length(), b.edge_length()));
  const std::size_t before = rows.size();
  const double nearest = append_rows(a, b, distance, rows);
  if (rows.size() > before) return;
  refuse(tie, "no part of the surface of '" + tie.a + "' lies within " + number_text(distance) + " of '" +
                  tie.b + "'" +
                  (nearest < 1e300 ? "; the nearest is " + number_text(nearest) + " away" : "") +
                  ". Give a larger Distance, or move one of them.");
}

/// Scales rows to sum weight^2 / m = 1 and leaves out what is rounding.
TieRows packed(const std::vector<Row>& rows, const std::vector<double>& mass) {
  TieRows packed;
  packed.row_begin.push_back(0);
  for (const Row& row : rows)
    for (const auto& [n, w] : row) packed.nodes.push_back(n);
  std::sort(packed.nodes.begin(), packed.nodes.end());
  packed.nodes.erase(std::unique(packed.nodes.begin(), packed.nodes.end()), packed.nodes.end());
  for (const Row& row : rows) {
    double largest = 0, sum = 0;
    for (const auto& [n, w] : row) largest = std::max(largest, std::abs(w));
    for (const auto& [n, w] : row)
      if (mass[at(n)] > 0) sum += w * w / mass[at(n)];
    if (!(sum > 0)) continue;  // all of it is held
    for (const auto& [n, w] : row) {
      if (std::abs(w) < 1e-12 * largest) continue;
      const auto place = std::lower_bound(packed.nodes.begin(), packed.nodes.end(), n);
      packed.node.push_back(static_cast<int>(place - packed.nodes.begin()));
      packed.weight.push_back(w / std::sqrt(sum));
    }
    packed.row_begin.push_back(static_cast<int>(packed.node.size()));
  }
  return packed;
}

/// y = W M^-1 W^T x
std::vector<double> coupled(const TieRows& rows, const std::vector<double>& mass,
                            const std::vector<double>& x) {
  std::vector<double> moved(rows.nodes.size(), 0.0), y(x.size(), 0.0);
  const auto for_each_entry = [&](auto&& use) {
    for (int c = 0; c < rows.row_count(); ++c)
      for (int i = rows.row_begin[at(c)]; i < rows.row_begin[at(c + 1)]; ++i)
        use(at(c), at(rows.node[at(i)]), rows.weight[at(i)]);
  };
  for_each_entry([&](std::size_t c, std::size_t n, double w) { moved[n] += w * x[c]; });
  for (std::size_t n = 0; n < moved.size(); ++n) {
    const double m = mass[at(rows.nodes[n])];
    moved[n] = m > 0 ? moved[n] / m : 0;
  }
  for_each_entry([&](std::size_t c, std::size_t n, double w) { y[c] += w * moved[n]; });
  return y;
}

/// Largest eigenvalue of shift x - A x (sign -1) or A x (shift 0, sign 1) by power iteration; from below, so
/// that the caller adds something.
double largest_eigenvalue(const TieRows& rows, const std::vector<double>& mass, double shift, double sign) {
  std::vector<double> x(at(rows.row_count()));
  for (std::size_t c = 0; c < x.size(); ++c) x[c] = 1 + std::cos(12.9898 * double(c));  // any direction
  double value = 0;
  for (int i = 0; i < 200; ++i) {
    const auto y = coupled(rows, mass, x);
    double norm = 0;
    for (std::size_t c = 0; c < x.size(); ++c) {
      x[c] = shift * x[c] + sign * y[c];
      norm += x[c] * x[c];
    }
    norm = std::sqrt(norm);
    if (!(norm > 0)) return 0;
    for (double& component : x) component /= norm;
    value = norm;
  }
  return value;
}

void set_bounds(TieRows& rows, const std::vector<double>& mass) {
  constexpr double widest = 400;  // ratio of the bounds: what lies below converges slowly, over several steps
  rows.high = 1.05 * largest_eigenvalue(rows, mass, 0, 1);
  rows.low = 0.8 * (rows.high - largest_eigenvalue(rows, mass, rows.high, -1));
  rows.low = std::max(rows.low, rows.high / widest);
  const double root = std::sqrt(rows.high / rows.low);
  const double shrink = root > 1 ? (root - 1) / (root + 1) : 0;
  rows.steps = shrink > 0 ? std::clamp(int(std::ceil(std::log(2e3) / -std::log(shrink))), 1, 60) : 1;
}

}  // namespace

TieRows tie_rows(const Model& model, const std::vector<double>& mass) {
  std::vector<Row> rows;
  const ContactFacets facets = contact_facets(model);
  for (const TiedSurfaces& tie : model.ties) append_tie(model, facets, tie, rows);
  TieRows result = packed(rows, mass);
  if (result.row_count() > 0) set_bounds(result, mass);
  return result;
}

}  // namespace glisson::contact
