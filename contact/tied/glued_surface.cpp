#include <glisson/contact/tied/glued_surface.hpp>

#include <algorithm>
#include <cmath>

#include <glisson/contact/geometry/closest_points.hpp>

namespace glisson::contact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Shape = std::array<double, 4>;

Shape mixed(const std::array<Shape, 3>& of, double a, double b, double c) {
  Shape result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = a * of[0][i] + b * of[1][i] + c * of[2][i];
  return result;
}

Vec3<double> twice_the_area(const std::array<Vec3<double>, 3>& x) { return cross(x[1] - x[0], x[2] - x[0]); }
double length_of(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

/// Calls use(a, b, c) for the centres of the parts^2 equal triangles that a triangle is cut into.
template <class Use>
void for_each_part(int parts, Use&& use) {
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts - i; ++j) {
      const double a = (i + 1.0 / 3) / parts, b = (j + 1.0 / 3) / parts;
      use(a, b, 1 - a - b);
      if (j + 1 < parts - i) use(a + 1.0 / (3 * parts), b + 1.0 / (3 * parts), 1 - a - b - 2.0 / (3 * parts));
    }
}

/// Parts of a side of a piece: the kinks of the other surface's shape functions make an error of some
/// thousandths.
constexpr int parts = 12;

/// Solves M x = b for up to 4 unknowns by elimination; M is a mass matrix, which needs no pivots.
Shape solved(std::array<Shape, 4> M, Shape b, int count) {
  for (int k = 0; k < count; ++k)
    for (int i = k + 1; i < count; ++i) {
      const double f = M[at(i)][at(k)] / M[at(k)][at(k)];
      for (int j = k; j < count; ++j) M[at(i)][at(j)] -= f * M[at(k)][at(j)];
      b[at(i)] -= f * b[at(k)];
    }
  for (int k = count - 1; k >= 0; --k) {
    for (int j = k + 1; j < count; ++j) b[at(k)] -= M[at(k)][at(j)] * b[at(j)];
    b[at(k)] /= M[at(k)][at(k)];
  }
  return b;
}

/// Row i: the factors of the shape functions in dual function i of a facet with these samples.
std::array<Shape, 4> dual_factors(const std::vector<FacetSample>& samples) {
  std::array<Shape, 4> M{}, factors{};
  Shape integral{};
  const int count = samples[0].count;
  for (const FacetSample& s : samples)
    for (std::size_t i = 0; i < 4; ++i) {
      integral[i] += s.area * s.shape[i];
      for (std::size_t j = 0; j < 4; ++j) M[i][j] += s.area * s.shape[i] * s.shape[j];
    }
  for (int i = 0; i < count; ++i) {
    Shape wanted{};
    wanted[at(i)] = integral[at(i)];
    factors[at(i)] = solved(M, wanted, count);
  }
  return factors;
}

}  // namespace

GluedSurface::GluedSurface(const Model& model, const ContactFacets& facets, int body) : model_(model) {
  const int nodes = static_cast<int>(facets.nodes.size());
  for (const ContactFacet& facet : facets.facets) {
    if (facet.body != body || facet.back) continue;
    Facet its;
    for (int a = 0; a < facet.corner_count(); ++a) {
      const int p = facet.point[at(a)];
      its.node[at(a)] = facets.nodes[at(p < nodes ? p : facets.beside[at(p - nodes)].node)];
    }
    its.of_sheet = facet.sheet >= 0;
    if (its.node[0] == its.node[1] || its.node[1] == its.node[2] || its.node[2] == its.node[0]) continue;
    facets_.push_back(its);
  }
  edge_length_ = 1e300;
  for (int f = 0; f < facet_count(); ++f) cut(f);
  first_piece_.push_back(static_cast<int>(pieces_.size()));
  std::vector<Vec3<double>> x;
  std::vector<Triangle> triangles;
  for (const Piece& piece : pieces_) {
    const int first = static_cast<int>(x.size());
    x.insert(x.end(), piece.x.begin(), piece.x.end());
    triangles.push_back({first, first + 1, first + 2});
  }
  if (!triangles.empty()) hierarchy_ = build_hierarchy(triangles, x, {});
  for (const Piece& piece : pieces_) {  // the shape functions are linear in a piece
    const Facet& facet = facets_[at(piece.facet)];
    const double area = 0.5 * length_of(twice_the_area(piece.x));
    const Shape mean = mixed(piece.shape, 1.0 / 3, 1.0 / 3, 1.0 / 3);
    for (int i = 0; i < facet.count(); ++i) area_[facet.node[at(i)]] += area * mean[at(i)];
  }
}

void GluedSurface::cut(int f) {
  const Facet& facet = facets_[at(f)];
  first_piece_.push_back(static_cast<int>(pieces_.size()));
  const auto X = [&](int a) { return model_.mesh.X[at(facet.node[at(a)])]; };
  const int count = facet.count();
  Vec3<double> centre;
  Shape of_centre{};
  for (int a = 0; a < count; ++a) {
    centre = centre + (1.0 / count) * X(a);
    of_centre[at(a)] = 1.0 / count;
    const auto side = X((a + 1) % count) - X(a);
    edge_length_ = std::min(edge_length_, length_of(side));
  }
  const auto corner = [](int a) {
    Shape s{};
    s[at(a)] = 1;
    return s;
  };
  if (count == 3) {
    add_piece(f, {corner(0), corner(1), corner(2)}, {X(0), X(1), X(2)});
    return;
  }
  for (int a = 0; a < 4; ++a) {
    const int b = (a + 1) % 4;
    add_piece(f, {corner(a), corner(b), of_centre}, {X(a), X(b), centre});
  }
}

void GluedSurface::add_piece(int facet, const std::array<Shape, 3>& shape,
                             const std::array<Vec3<double>, 3>& x) {
  const auto n = twice_the_area(x);
  const double length = length_of(n);
  pieces_.push_back({facet, shape, x, length > 0 ? (1 / length) * n : Vec3<double>{}});
}

/// Within 60 degrees: sides that stand across a glued surface at its border are not glued.
bool GluedSurface::faces(const FacetSample& sample, const Piece& piece, const Facet& facet) {
  const double opposite = -dot(sample.normal, piece.normal);
  return (sample.of_sheet || facet.of_sheet ? std::abs(opposite) : opposite) > 0.5;
}

std::vector<FacetSample> GluedSurface::samples(int f) const {
  std::vector<FacetSample> result;
  const Facet& facet = facets_[at(f)];
  for (int p = first_piece_[at(f)]; p < first_piece_[at(f + 1)]; ++p) {
    const Piece& piece = pieces_[at(p)];
    const double area = 0.5 * length_of(twice_the_area(piece.x)) / (parts * parts);
    for_each_part(parts, [&](double a, double b, double c) {
      result.push_back({a * piece.x[0] + b * piece.x[1] + c * piece.x[2],
                        piece.normal,
                        facet.of_sheet,
                        area,
                        facet.count(),
                        facet.node,
                        mixed(piece.shape, a, b, c),
                        {}});
    });
  }
  const auto factors = dual_factors(result);
  for (FacetSample& s : result)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) s.dual[i] += factors[i][j] * s.shape[j];
  return result;
}

NearPoint GluedSurface::nearest(const FacetSample& from, double distance) const {
  const Vec3<double>& x = from.x;
  std::vector<int> near, stack;
  triangles_near(hierarchy_, inflated(Box{x, x}, distance), near, stack);
  NearPoint best;
  for (const int p : near) {
    const Piece& piece = pieces_[at(p)];
    const Facet& facet = facets_[at(piece.facet)];
    if (!faces(from, piece, facet)) continue;
    const auto foot = closest_on_triangle(x, piece.x[0], piece.x[1], piece.x[2]);
    const double its = std::sqrt(foot.distance_squared);
    if (!(its < best.distance)) continue;
    best = {its, facet.count(), facet.node, mixed(piece.shape, foot.b[0], foot.b[1], foot.b[2])};
  }
  return best;
}

}  // namespace glisson::contact
