// The picture of a difference.
#include "viewer/compare/difference_picture.h"

#include <gtest/gtest.h>

#include "tests/unit/compare/pictures.h"

namespace barrido::compare::test {
namespace {

TEST(DifferencePicture, IsSignedOrAbsoluteAndScaled) {
  const auto a = flat(1, 1, 51), b = flat(1, 1, 102);
  const auto value = [](const DifferencePicture& picture) { return picture.rgba_float[0]; };
  EXPECT_NEAR(value(difference_picture(a, b, {})), -0.2f, 1e-6f);
  EXPECT_EQ(difference_picture(a, b, {}).rgba8[0], 0) << "bytes keep what is positive";
  EXPECT_NEAR(value(difference_picture(b, a, {})), 0.2f, 1e-6f);
  EXPECT_NEAR(value(difference_picture(a, b, {true, 4})), 0.8f, 1e-6f);
  EXPECT_EQ(difference_picture(a, b, {true, 4}).rgba8[0], 204);
  EXPECT_EQ(difference_picture(a, b, {true, 9}).rgba8[0], 255);
  EXPECT_EQ(difference_picture(a, b, {}).rgba8[3], 255) << "opaque";
}

TEST(DifferencePicture, ShowsADifferenceOfAlphaInAllColours) {
  auto a = flat(1, 1, 0), b = flat(1, 1, 0);
  b.rgba[3] = 0.6f;
  const DifferencePicture picture = difference_picture(a, b, {true, 1});
  EXPECT_EQ(picture.rgba8, (Bytes{102, 102, 102, 255}));
}

TEST(DifferencePicture, CoversBothPictures) {
  const DifferencePicture picture = difference_picture(flat(3, 1, 0), flat(2, 2, 0), {true, 1});
  EXPECT_EQ(picture.width, 3);
  EXPECT_EQ(picture.height, 2);
  EXPECT_EQ(picture.rgba8[0], 0) << "both are black";
  EXPECT_EQ(picture.rgba8[2 * 4], 255) << "only the first";
  EXPECT_EQ(picture.rgba8[3 * 4], 255) << "only the second";
  EXPECT_EQ(picture.rgba8[5 * 4], 0) << "neither";
}

}  // namespace
}  // namespace barrido::compare::test
