#include "viewer/sheet/sheet.h"

#include <gtest/gtest.h>

#include <set>

#include "image_test_support.h"
#include "viewer/sheet/font.h"
#include "viewer/sheet/text.h"

namespace barrido::scene::test {
namespace {

using namespace sheet;

using Rgb = std::array<std::uint8_t, 3>;

Rgb pixel(const Image& image, int x, int y) {
  const std::size_t at = static_cast<std::size_t>(y * image.width + x) * 4;
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

Bytes uniform(int width, int height, std::array<std::uint8_t, 4> color) {
  Bytes rgba;
  for (int i = 0; i < width * height; ++i) rgba.insert(rgba.end(), color.begin(), color.end());
  return rgba;
}

/// The corner of the first pixel of a colour, searched row by row.
std::pair<int, int> find(const Image& image, const Rgb& color) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (pixel(image, x, y) == color) return {x, y};
    }
  }
  return {-1, -1};
}

TEST(Sheet, PicturesStandInAGridWithEqualGaps) {
  const std::vector<Bytes> colors{uniform(60, 40, {255, 0, 0, 255}), uniform(60, 40, {0, 255, 0, 255}),
                                  uniform(60, 40, {0, 0, 255, 255}), uniform(60, 40, {255, 255, 0, 255})};
  std::vector<SheetPicture> pictures;
  for (const Bytes& bytes : colors) pictures.push_back({60, 40, bytes, "one"});
  const Image sheet = compose_sheet(pictures, {"Title", 2, 1});
  const auto [x0, y0] = find(sheet, {255, 0, 0});
  const auto [x1, y1] = find(sheet, {0, 255, 0});
  const auto [x2, y2] = find(sheet, {0, 0, 255});
  const auto [x3, y3] = find(sheet, {255, 255, 0});
  EXPECT_EQ(y0, y1);
  EXPECT_EQ(y2, y3);
  EXPECT_EQ(x0, x2);
  EXPECT_EQ(x1, x3);
  EXPECT_EQ(x1 - x0 - 60, 12);             // the gap
  EXPECT_EQ(x0, 16);                       // the margin
  EXPECT_EQ(sheet.width - (x1 + 60), 16);  // the same on the right
  EXPECT_EQ(pixel(sheet, x1 + 59, y1 + 39), (Rgb{0, 255, 0}));
  EXPECT_EQ(pixel(sheet, 0, 0), (Rgb{38, 38, 38}));
  for (std::size_t i = 3; i < sheet.rgba.size(); i += 4) ASSERT_EQ(sheet.rgba[i], 255);
}

TEST(Sheet, SmallerPicturesStandInTheMiddleAndAlphaLetsTheGreyThrough) {
  const Bytes large = uniform(30, 30, {10, 200, 30, 255}), small = uniform(10, 20, {255, 0, 0, 255});
  const Bytes half = uniform(30, 30, {255, 255, 255, 128}), none = uniform(30, 30, {255, 255, 255, 0});
  const std::vector<SheetPicture> pictures{
      {30, 30, large, ""}, {10, 20, small, ""}, {30, 30, half, ""}, {30, 30, none, ""}};
  const Image sheet = compose_sheet(pictures, {"", 4, 1});
  EXPECT_EQ(sheet.width, 16 * 2 + 4 * 30 + 3 * 12);
  EXPECT_EQ(sheet.height, 16 * 2 + 30);
  EXPECT_EQ(find(sheet, {255, 0, 0}), (std::pair{16 + 42 + 10, 16 + 5}));
  EXPECT_EQ(pixel(sheet, 16 + 84, 16), (Rgb{147, 147, 147}));  // (255·128 + 38·127)/255
  EXPECT_EQ(pixel(sheet, 16 + 126, 16), (Rgb{38, 38, 38}));
}

TEST(Sheet, LabelsAreBelowTheirPictureAndNoWider) {
  const Bytes bytes = uniform(64, 8, {0, 0, 255, 255});
  const std::vector<SheetPicture> pictures{{64, 8, bytes, "a label far too long for its picture\nsecond"}};
  const Image sheet = compose_sheet(pictures, {"", 1, 1});
  int label_pixels = 0, dim_pixels = 0;
  for (int y = 0; y < sheet.height; ++y) {
    for (int x = 0; x < sheet.width; ++x) {
      const Rgb color = pixel(sheet, x, y);
      if (color == Rgb{214, 214, 214}) ++label_pixels;
      if (color == Rgb{150, 150, 150}) ++dim_pixels;
      if (color != Rgb{38, 38, 38}) {
        ASSERT_TRUE(x >= 16 && x < 16 + 64) << x;
      }
      if (y < 16 + 8) {
        ASSERT_NE(color, (Rgb{214, 214, 214}));
      }
    }
  }
  EXPECT_GT(label_pixels, 50);
  EXPECT_GT(dim_pixels, 50);
}

TEST(Sheet, ColumnsAreChosenForAWideSheet) {
  const Bytes bytes = uniform(160, 90, {0, 0, 255, 255});
  const auto columns_for = [&](int count) {
    const std::vector<SheetPicture> pictures(static_cast<std::size_t>(count), {160, 90, bytes, "x"});
    return (compose_sheet(pictures).width - 2 * 16 + 12) / (160 + 12);
  };
  EXPECT_EQ(columns_for(1), 1);
  EXPECT_EQ(columns_for(4), 2);
  EXPECT_EQ(columns_for(9), 3);
  EXPECT_EQ(columns_for(12), 4);
}

TEST(Sheet, RefusesWhatCannotBe) {
  const Bytes bytes = uniform(2, 2, {0, 0, 0, 255});
  EXPECT_THROW(compose_sheet({}), std::invalid_argument);
  EXPECT_THROW(compose_sheet(std::vector<SheetPicture>{{2, 3, bytes, ""}}), std::invalid_argument);
  const Bytes wide = uniform(16384, 1, {0, 0, 0, 255});
  const std::vector<SheetPicture> many(5, {16384, 1, wide, ""});
  EXPECT_THROW(compose_sheet(many, {"", 5, 1}), InputError);
}

TEST(SheetFont, EveryCharacterHasItsOwnShape) {
  std::set<std::pair<std::uint64_t, std::uint64_t>> shapes;
  for (char32_t code = 33; code < 127; ++code) {
    const Glyph& glyph = glyph_of(code);
    shapes.insert({glyph.upper, glyph.lower});
    EXPECT_GE(glyph.width, 1);
    EXPECT_LE(glyph.width, 8);
    bool ends = false;  // the last column of the width holds ink
    for (int y = 0; y < kGlyphRows; ++y) ends = ends || glyph.pixel(glyph.width - 1, y);
    EXPECT_TRUE(ends) << static_cast<char>(code);
  }
  EXPECT_EQ(shapes.size(), 94u);
  EXPECT_EQ(&glyph_of(0x1f600), &glyph_of(127));
}

TEST(SheetText, ScalesAndWidths) {
  EXPECT_EQ(text_width("", {1, false}), 0);
  EXPECT_EQ(text_width("AB", {1, false}), 7 + 2 + 6);
  EXPECT_EQ(text_width("AB", {4, false}), 4 * 15);
  EXPECT_EQ(text_width("\xc3\x97", {1, false}), text_width("x", {1, false}));
  EXPECT_EQ(text_width("\xf0\x9f\x98\x80", {1, false}), glyph_of(127).width);  // one box for one character
  EXPECT_EQ(text_width("\xff\xc3", {1, false}), 2 * glyph_of(127).width + 2);  // no UTF-8: a box a byte
  for (const bool bold : {false, true}) {
    for (const int scale : {1, 2, 4}) {
      const TextMask mask = draw_text("Phong", {scale, bold});
      EXPECT_EQ(mask.width, text_width("Phong", {scale, bold}));
      EXPECT_EQ(mask.height, 16 * scale);
      // A stem of the P: `scale` pixels thick, twice that in bold.
      const int y = 11 * scale;
      int thickness = 0;
      while (mask.at(thickness, y)) ++thickness;
      EXPECT_EQ(thickness, bold ? 2 * scale : scale);
    }
  }
}

TEST(SheetText, SlopesAreSmoothedWhenScaledStemsAreNot) {
  const auto differing = [](const char* text) {
    const TextMask small = draw_text(text, {1, false}), large = draw_text(text, {2, false});
    int count = 0;
    for (int y = 0; y < large.height; ++y) {
      for (int x = 0; x < large.width; ++x) count += large.at(x, y) != small.at(x / 2, y / 2);
    }
    return count;
  };
  EXPECT_GT(differing("N"), 0);
  EXPECT_EQ(differing("-"), 0);
  EXPECT_EQ(differing("|"), 0);
}

TEST(SheetText, IsCutToFit) {
  EXPECT_EQ(fit_text("short", {1, false}, 100), "short");
  const std::string cut = fit_text("a long label \xc3\x97\xc3\x97\xc3\x97", {1, false}, 60);
  EXPECT_TRUE(cut.ends_with("..."));
  EXPECT_LE(text_width(cut, {1, false}), 60);
  EXPECT_EQ(fit_text("anything", {1, false}, 2), "");
}

}  // namespace
}  // namespace barrido::scene::test
