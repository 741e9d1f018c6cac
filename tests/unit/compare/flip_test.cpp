// FLIP against the program of its authors: pip's flip-evaluator 1.7 was given the pictures below (bytes/255
// as floats, the exposures and the tone mapping left to it); the expected figures are those of its error
// maps, summed up in double precision.
#include "viewer/compare/flip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/compare/pictures.h"
#include "viewer/compare/flip_filters.h"

namespace barrido::compare::test {
namespace {

constexpr int kWidth = 96, kHeight = 64;

scene::StoredPicture gradient(int shift) {
  return picture_of(kWidth, kHeight, [shift](int x, int y, int c) {
    const int sx = std::min(x + shift, kWidth - 1);
    return c == 0 ? sx * 255 / (kWidth - 1) : c == 1 ? y * 255 / (kHeight - 1) : (sx + y) % 256;
  });
}

scene::StoredPicture noise(std::uint32_t seed) {
  return picture_of(kWidth, kHeight, [seed](int x, int y, int c) {
    const auto ux = static_cast<std::uint32_t>(x), uy = static_cast<std::uint32_t>(y),
               uc = static_cast<std::uint32_t>(c);
    const std::uint32_t mixed = (ux * 2654435761u + uy * 40503u + uc * 977u + seed * 7919u) * 2246822519u;
    return static_cast<int>(mixed >> 24);
  });
}

scene::StoredPicture lines(int shift) {
  return picture_of(kWidth, kHeight, [shift](int x, int, int) { return (x + shift) % 8 == 0 ? 255 : 32; });
}

scene::StoredPicture discs(int radius) {
  return picture_of(kWidth, kHeight, [radius](int x, int y, int c) {
    const int dx = x % 32 - 16, dy = y % 32 - 16;
    constexpr int kInside[] = {220, 60, 30}, kOutside[] = {40, 90, 160};
    return dx * dx + dy * dy < radius * radius ? kInside[c] : kOutside[c];
  });
}

scene::StoredPicture radiance(int variant, float factor) {
  scene::StoredPicture picture{kWidth, kHeight, 3, true, false, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double base = static_cast<double>(1 << (x / 16 + y / 32)) / 8;
      const double light = (x + y * 3 + variant) % 16 == 0 ? 20.0 : 0.0;
      for (int c = 0; c < 3; ++c) {
        const double value = base * (1 + (c * variant) % 3 * 0.5) + light;
        picture.rgba.push_back(static_cast<float>(value) * factor);
      }
      picture.rgba.push_back(1.0f);
    }
  }
  return picture;
}

struct Case {
  const char* name;
  scene::StoredPicture expected, actual;
  double mean, weighted_median, max;
};

TEST(Flip, AgreesWithTheProgramOfItsAuthors) {
  const Case cases[] = {
      {"gradient", gradient(0), gradient(2), 0.0854537, 0.099208, 0.136973},
      {"noise", noise(1), noise(2), 0.3505060, 0.401001, 0.978212},
      {"lines", lines(0), lines(1), 0.5022982, 0.560250, 0.991994},
      {"discs", discs(10), discs(11), 0.1582653, 0.257419, 0.444979},
      {"black and white", flat(kWidth, kHeight, 0), flat(kWidth, kHeight, 255), 0.9673883, 0.967388,
       0.967388},
      {"grey", flat(kWidth, kHeight, 127), flat(kWidth, kHeight, 128), 0.0298980, 0.029898, 0.029898},
      {"gradient and noise", gradient(0), noise(1), 0.8455374, 0.898367, 0.987073},
      {"radiance", radiance(0, 1), radiance(1, 1), 0.4410072, 0.449729, 0.984410},
      {"dark radiance", radiance(1, 1.0f / 64), radiance(2, 1.0f / 64), 0.4613247, 0.469147, 0.826239},
  };
  for (const Case& one : cases) {
    const FlipFigures figures = flip(one.expected, one.actual).figures;
    EXPECT_NEAR(figures.mean, one.mean, 1e-5) << one.name;
    EXPECT_NEAR(figures.weighted_median, one.weighted_median, 5e-5) << one.name;
    EXPECT_NEAR(figures.max, one.max, 5e-5) << one.name;
  }
}

TEST(Flip, ChoosesTheExposuresOfItsAuthors) {
  const auto exposures = flip(radiance(0, 1), radiance(1, 1)).figures.exposures;
  ASSERT_TRUE(exposures);
  EXPECT_NEAR(exposures->start, -3.724058, 1e-5);
  EXPECT_NEAR(exposures->stop, 1.083297, 1e-5);
  EXPECT_EQ(exposures->count, 5);
  EXPECT_FALSE(flip(gradient(0), gradient(1)).figures.exposures);
}

TEST(Flip, OfEqualPicturesIsZero) {
  const FlipMap map = flip(noise(1), noise(1));
  EXPECT_EQ(map.figures.mean, 0.0);
  EXPECT_EQ(map.figures.max, 0.0);
  EXPECT_EQ(map.figures.weighted_median, 0.0);
}

TEST(Flip, DoesNotDependOnHowThePictureIsCutIntoBands) {
  // A row of a tall picture sees the same around it as in a picture that begins just above.
  const auto tall = picture_of(40, 200, [](int x, int y, int c) { return (x * 7 + y * 13 + c * 50) % 256; });
  const auto other = picture_of(40, 200, [](int x, int y, int c) { return (x * 9 + y * 11 + c * 50) % 256; });
  const auto cut = [](const scene::StoredPicture& picture, int begin, int end) {
    scene::StoredPicture part = picture;
    part.height = end - begin;
    part.rgba.assign(picture.rgba.begin() + begin * 40 * 4, picture.rgba.begin() + end * 40 * 4);
    return part;
  };
  const FlipMap whole = flip(tall, other), part = flip(cut(tall, 50, 150), cut(other, 50, 150));
  for (int y = 70; y < 130; ++y) {
    for (int x = 0; x < 40; ++x) {
      ASSERT_EQ(whole.errors[static_cast<std::size_t>(y * 40 + x)],
                part.errors[static_cast<std::size_t>((y - 50) * 40 + x)]);
    }
  }
}

TEST(Flip, LooksAtWhatBothPicturesCover) {
  auto wide = noise(1);
  const FlipMap map = flip(wide, flat(10, 200, 0));
  EXPECT_EQ(map.width, 10);
  EXPECT_EQ(map.height, kHeight);
  EXPECT_EQ(map.errors.size(), 640u);
}

TEST(Flip, SeesTransparencyOverGrey) {
  auto transparent = flat(32, 32, 255), grey = picture_of(32, 32, [](int, int, int) { return 255; });
  for (std::size_t i = 0; i < transparent.rgba.size(); i += 4) {
    transparent.rgba[i + 3] = 0.0f;
    for (std::size_t c = 0; c < 3; ++c) grey.rgba[i + c] = 0.5f;
  }
  EXPECT_NEAR(flip(transparent, grey).figures.mean, 0.0, 1e-4);
  EXPECT_GT(flip(transparent, flat(32, 32, 255)).figures.mean, 0.3);
}

TEST(Flip, StaysFiniteWhateverTheFloats) {
  auto strange = radiance(0, 1);
  const float values[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -5.0f, -std::numeric_limits<float>::infinity(), 3e38f};
  for (std::size_t i = 0; i < std::size(values); ++i) strange.rgba[i * 40] = values[i];
  auto black = radiance(0, 0.0f);
  for (const auto* expected : {&strange, &black}) {
    const FlipMap map = flip(*expected, radiance(1, 1));
    for (const float error : map.errors) ASSERT_TRUE(error >= 0.0f && error <= 1.0f);
  }
}

TEST(FlipFilters, HaveTheWeightsOfThePaper) {
  const FlipFilters filters = make_flip_filters(kPixelsPerDegree);
  const auto sum = [](const Kernel& kernel, auto keep) {
    double total = 0.0;
    for (const float weight : kernel.weights) total += keep(weight) ? static_cast<double>(weight) : 0.0;
    return total;
  };
  const auto any = [](float) { return true; };
  EXPECT_NEAR(sum(filters.achromatic, any), 1.0, 1e-6);
  EXPECT_NEAR(sum(filters.red_green, any), 1.0, 1e-6);
  const double narrow = sum(filters.blue_yellow, any), wide = sum(filters.blue_yellow_wide, any);
  EXPECT_NEAR(narrow * narrow + wide * wide, 1.0, 1e-6);
  EXPECT_NEAR(sum(filters.gaussian, any), 1.0, 1e-6);
  for (const Kernel* kernel : {&filters.edge, &filters.point}) {
    EXPECT_NEAR(sum(*kernel, [](float w) { return w > 0; }), 1.0, 1e-6);
    EXPECT_NEAR(sum(*kernel, [](float w) { return w < 0; }), -1.0, 1e-6);
  }
  EXPECT_EQ(filters.max_radius(), 10);
}

}  // namespace
}  // namespace barrido::compare::test
