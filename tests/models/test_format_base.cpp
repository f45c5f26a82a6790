// The base file, read as it stands.
#include <tests/models/format_base.hpp>

namespace glisson::test {
namespace {

TEST(FormatBase, HoldsWhatItSays) {
  const Model model = parsed(base_xml);
  EXPECT_EQ(model.name, "test");
  EXPECT_EQ(model.mesh.node_count(), 8);
  EXPECT_EQ(model.mesh.element_count(), 5);
  ASSERT_EQ(model.sections.size(), 1U);
  EXPECT_EQ(model.sections[0].material.law, "NH");
  EXPECT_EQ(model.sections[0].material.parameters, (std::vector<double>{1000, 50000}));
  EXPECT_EQ(model.sections[0].elements.size(), 5U);
  ASSERT_EQ(model.fixed.size(), 1U);
  EXPECT_EQ(model.fixed[0].axes, all_axes);
  ASSERT_EQ(model.displacements.size(), 1U);
  EXPECT_EQ(model.displacements[0].nodes, (std::vector<int>{4, 5, 6, 7}));
  EXPECT_EQ(model.displacements[0].axes, 4U);
  EXPECT_EQ(model.displacements[0].curve.shape, LoadShape::poly345);
  EXPECT_EQ(model.displacements[0].curve.end, 1.0);
  EXPECT_EQ(model.time.step, 0.001);
  EXPECT_EQ(model.time.damping, 5.0);
}

}  // namespace
}  // namespace glisson::test
