#include <gtest/gtest.h>

#include <glisson/core/load_curve.hpp>

namespace glisson {
namespace {

TEST(LoadCurve, EndsAtOne) {
  for (const auto shape :
       {LoadShape::poly345, LoadShape::ramp, LoadShape::ramp_hold, LoadShape::step, LoadShape::hilly})
    EXPECT_DOUBLE_EQ((LoadCurve{shape, 0, 2}(2.0)), 1.0);
}

}  // namespace
}  // namespace glisson
