// validate() of rigid contact surfaces: each defect by its facet, and silence for surfaces that only look
// odd.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include <glisson/core/base/error.hpp>
#include <glisson/core/mesh/box_mesh.hpp>
#include <glisson/core/mesh/surface.hpp>
#include <glisson/core/model.hpp>

namespace glisson {
namespace {

/// A block of one element above a closed box of six quadrilaterals.
Model good_model() {
  Model model;
  model.mesh = box_mesh({1, 1, 1}, {1, 1, 1}, Shape::hexahedron);
  model.sections.push_back({"set", Formulation::h8, {"NH", {1000, 50000}, 1000, {}, {}, {}}, {0}, 0.075});
  model.fixed.push_back({{4, 5, 6, 7}, all_axes});
  model.time.total = 1;
  const Mesh box = box_mesh({1, 1, 1}, {2, 2, 1}, Shape::hexahedron);
  RigidSurface surface;
  surface.name = "ContactSurface at line 7";
  surface.surface = {box.X, outer_surface(box)};
  for (auto& X : surface.surface.X) X = X - Vec3<double>{0, 0, 2};
  model.surfaces.push_back(surface);
  return model;
}

const double nan = std::numeric_limits<double>::quiet_NaN();

struct Case {
  const char* words;  ///< of the message
  std::function<void(RigidSurface&)> spoil;
};

std::vector<Facet>& facets(RigidSurface& s) { return s.surface.facets; }
/// Nodes 8 to 10 beside the box.
void add_nodes(RigidSurface& s, const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  s.surface.X.insert(s.surface.X.end(), {a, b, c});
}

const Case refused[] = {
    {"friction coefficient is -0.1", [](RigidSurface& s) { s.friction = -0.1; }},
    {"friction coefficient is nan", [](RigidSurface& s) { s.friction = nan; }},
    {"friction coefficient is inf",
     [](RigidSurface& s) { s.friction = std::numeric_limits<double>::infinity(); }},
    {"it has no facet", [](RigidSurface& s) { facets(s).clear(); }},
    {"not finite", [](RigidSurface& s) { s.surface.X[2].y = nan; }},
    {"not finite", [](RigidSurface& s) { s.displacement.x = nan; }},
    {"not finite", [](RigidSurface& s) { s.angles.z = nan; }},
    {"not finite", [](RigidSurface& s) { s.centre.z = nan; }},
    {"its table has one pose", [](RigidSurface& s) { s.poses = {{}}; }},
    {"not finite",
     [](RigidSurface& s) {
       s.poses = {{}, {1, {0, nan, 0}, {1, 0, 0, 0}}};
     }},
    {"not finite",
     [](RigidSurface& s) {
       s.poses = {{nan, {}, {1, 0, 0, 0}}, {}};
     }},
    {"times of its poses do not increase: pose 1 is at 0",
     [](RigidSurface& s) {
       s.poses = {{}, {}};
     }},
    {"the quaternion of pose 1 does not have length 1",
     [](RigidSurface& s) {
       s.poses = {{}, {1, {}, {1, 0, 0, 0.1}}};
     }},
    {"facet 0 names node 8, but its nodes are 0 to 7", [](RigidSurface& s) { facets(s)[0].nodes[0] = 8; }},
    {"facet 3 names node -5", [](RigidSurface& s) { facets(s)[3].nodes[1] = -5; }},
    {"facet 6 names node 1 twice",
     [](RigidSurface& s) {
       facets(s).push_back({{0, 1, 1, -1}});
     }},
    {"facet 6 names node 0 twice",
     [](RigidSurface& s) {
       facets(s).push_back({{0, 1, 2, 0}});
     }},
    {"facet 6 has no area",
     [](RigidSurface& s) {
       add_nodes(s, {5, 0, 0}, {5.1, 0.1, 0.1}, {5.3, 0.3, 0.3});
       facets(s).push_back({{8, 9, 10, -1}});
     }},
    {"facet 6 has no area, so it has no front: its height is 1e-07 of its length",
     [](RigidSurface& s) {
       add_nodes(s, {5, 0, 0}, {6, 0, 0}, {5.5, 1e-7, 0});
       facets(s).push_back({{8, 9, 10, -1}});
     }},
    {"facet 0 crosses itself",
     [](RigidSurface& s) { std::swap(facets(s)[0].nodes[0], facets(s)[0].nodes[1]); }},
    {"facet 6 is not convex at its node 9",
     [](RigidSurface& s) {
       add_nodes(s, {5, 0, 0}, {5.1, 0.1, 0}, {5, 1, 0});
       s.surface.X.push_back({6, 0, 0});
       facets(s).push_back({{8, 11, 9, 10}});
     }},
    {"facets 2 and 6 have the same nodes", [](RigidSurface& s) { facets(s).push_back(facets(s)[2]); }},
    {"facets 2 and 6 have the same nodes",
     [](RigidSurface& s) {
       const auto n = facets(s)[2].nodes;
       facets(s).push_back({{n[3], n[2], n[1], n[0]}});
     }},
    {"face opposite sides",
     [](RigidSurface& s) {
       auto& n = facets(s)[1].nodes;
       std::swap(n[1], n[3]);
     }},
    {"3 facets (", [](RigidSurface& s) {
       add_nodes(s, {5, 0, 0}, {}, {});
       const auto n = facets(s)[0].nodes;
       facets(s).push_back({{n[0], n[1], 8, -1}});
     }}};

TEST(ValidateSurfaces, EachDefectIsRefusedWithItsFacet) {
  for (const Case& its : refused) {
    Model model = good_model();
    its.spoil(model.surfaces[0]);
    try {
      validate(model);
      ADD_FAILURE() << "accepted: " << its.words;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_NE(message.find(its.words), std::string::npos) << message << "\n  lacks: " << its.words;
      EXPECT_EQ(error.place().element.find("ContactSurface"), 0u) << message;
    }
  }
}

/// Two layers of four triangles around a node each, `thickness` apart there, on one square border.
void make_lens(RigidSurface& s, double thickness) {
  s.surface.X = {{0, 0, -1}, {2, 0, -1}, {2, 2, -1}, {0, 2, -1}, {1, 1, -1}, {1, 1, -1 + thickness}};
  facets(s).clear();
  for (int a = 0; a < 4; ++a) {
    facets(s).push_back({{(a + 1) % 4, a, 4, -1}});
    facets(s).push_back({{a, (a + 1) % 4, 5, -1}});
  }
}

/// A third of the thickness in the middle, against a thousandth of the facets' height of 1.
TEST(ValidateSurfaces, AClosedSurfaceWithoutVolumeIsRefused) {
  Model model = good_model();
  RigidSurface& s = model.surfaces[0];
  s.file = "sheet.xml";
  s.facet_lines = {100, 101, 102, 103, 104, 105, 106, 107};
  for (const double thickness : {0.0, 1e-9, 0.0029, -0.0029}) {
    make_lens(s, thickness);
    try {
      validate(model);
      ADD_FAILURE() << "accepted: " << thickness;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("hardly any volume"), std::string::npos) << error.what();
      EXPECT_EQ(error.place().file, "sheet.xml");
      EXPECT_EQ(error.place().line, 100);
    }
  }
  for (const double thickness : {0.0031, -0.0031}) {
    make_lens(s, thickness);
    EXPECT_NO_THROW(validate(model)) << "thin, or around a flat cavity";
  }
  make_lens(s, 0);
  facets(s).erase(facets(s).begin());
  EXPECT_NO_THROW(validate(model)) << "open";
}

/// The line of the facet that is named last, in the file that it is from.
TEST(ValidateSurfaces, FileAndLineOfTheFacetAreTold) {
  for (const Case& its : refused) {
    Model model = good_model();
    RigidSurface& s = model.surfaces[0];
    s.file = "floor.xml";
    its.spoil(s);
    for (std::size_t f = 0; f < s.surface.facets.size(); ++f) s.facet_lines.push_back(100 + int(f));
    try {
      validate(model);
    } catch (const Error& error) {
      const std::string words = its.words;
      if (words.find("facet") != 0 && words.find("3 facets") != 0) continue;
      EXPECT_EQ(error.place().file, "floor.xml") << error.what();
      const int line = words.find("facet 0") == 0 ? 100 : words.find("facet 3") == 0 ? 103 : 106;
      EXPECT_EQ(error.place().line, line) << error.what();
    }
  }
}

/// Open surfaces, parts that touch at a node or not at all, and nodes without a facet are fine.
TEST(ValidateSurfaces, WhatOnlyLooksOddIsTaken) {
  Model model = good_model();
  EXPECT_NO_THROW(validate(model));
  RigidSurface& s = model.surfaces[0];
  facets(s).pop_back();
  EXPECT_NO_THROW(validate(model)) << "open";
  add_nodes(s, {5, 0, 0}, {6, 0, 0}, {5, 1, 0});
  EXPECT_NO_THROW(validate(model)) << "nodes without a facet";
  facets(s).push_back({{8, 9, 10, -1}});
  EXPECT_NO_THROW(validate(model)) << "two parts";
  facets(s).push_back({{0, 8, 10, -1}});
  EXPECT_NO_THROW(validate(model)) << "parts that meet at a node";
}

}  // namespace
}  // namespace glisson
