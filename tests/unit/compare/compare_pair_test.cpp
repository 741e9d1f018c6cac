// Pairs of files of every kind: what is on the same footing, what is told, and that no file stops the others.
#include "viewer/compare/compare_pair.h"

#include <gtest/gtest.h>

#include "tests/unit/compare/pictures.h"

namespace barrido::compare::test {
namespace {

namespace fs = std::filesystem;
using scene::test::PngFile;

class ComparePair : public testing::Test {
 protected:
  Pair pair(const std::string& a, const std::string& b) const {
    return {b, a.empty() ? fs::path() : folder_ / a, b.empty() ? fs::path() : folder_ / b, folder_ / a};
  }
  Result compare(const std::string& a, const std::string& b, const Settings& settings = {}) const {
    return compare_pair(pair(a, b), settings).result;
  }
  /// A PNG whose samples are all `sample`.
  void write_kind(const std::string& name, std::uint8_t color_type, std::uint8_t bit_depth,
                  std::uint32_t sample) {
    PngFile file;
    file.width = 5;
    file.height = 3;
    file.color_type = color_type;
    file.bit_depth = bit_depth;
    file.sample = [sample](std::uint32_t, std::uint32_t, int) { return sample; };
    scene::test::write_bytes(folder_ / name, file.build());
  }
  bool has_module() {
    const Bytes rgba(4);
    return scene::test::module_is_here([&] { scene::encode_image("exr", {1, 1, rgba, {}}); });
  }
  TemporaryFolder folder_;
};

TEST_F(ComparePair, EqualPicturesAreTheSameWithoutFlipBeingReckoned) {
  write_png(folder_ / "a.png", flat(8, 8, 7));
  write_png(folder_ / "b.png", flat(8, 8, 7));
  const ComparedPair compared = compare_pair(pair("a.png", "b.png"), {});
  EXPECT_EQ(compared.result.outcome, Outcome::same);
  EXPECT_EQ(compared.result.note, "");
  ASSERT_TRUE(compared.result.flip);
  EXPECT_EQ(compared.result.flip->mean, 0.0);
  EXPECT_TRUE(compared.flip.errors.empty());
}

TEST_F(ComparePair, ADifferenceOfOneByteIsDifferentUnlessAllowed) {
  write_png(folder_ / "a.png", flat(8, 8, 100));
  write_png(folder_ / "b.png",
            picture_of(8, 8, [](int x, int y, int c) { return x + y + c == 0 ? 101 : 100; }));
  EXPECT_EQ(compare("a.png", "b.png").outcome, Outcome::different);
  Settings settings;
  settings.thresholds.fail = 0.004;
  EXPECT_EQ(compare("a.png", "b.png", settings).outcome, Outcome::warning);
  settings.thresholds.warn = 0.004;
  EXPECT_EQ(compare("a.png", "b.png", settings).outcome, Outcome::same);
  settings.thresholds.fail_flip = 1e-5;
  EXPECT_EQ(compare("a.png", "b.png", settings).outcome, Outcome::different) << "FLIP sees it";
  settings.flip = false;
  EXPECT_FALSE(compare("a.png", "b.png", settings).flip);
}

TEST_F(ComparePair, SixteenBitsAreComparedWhole) {
  write_kind("a.png", 2, 16, 0x8000);
  write_kind("b.png", 2, 16, 0x8001);  // Both are 0x80 in eight bits.
  const Result result = compare("a.png", "b.png");
  EXPECT_EQ(result.outcome, Outcome::different);
  EXPECT_NEAR(result.figures->max, 1.0 / 65535, 1e-7);
  write_kind("c.png", 2, 8, 0x80);
  EXPECT_NEAR(compare("c.png", "b.png").figures->max, (0x8080 - 0x8001) / 65535.0, 1e-7);
}

TEST_F(ComparePair, KindsOfPngThatShowTheSameAreTheSame) {
  struct Kind {
    std::uint8_t color_type, bit_depth;
    std::uint32_t white;
    int channels;
  };
  const Kind kinds[] = {{0, 1, 1, 1},   {0, 4, 15, 1},  {0, 16, 65535, 1},
                        {2, 8, 255, 3}, {4, 8, 255, 2}, {6, 16, 65535, 4}};
  write_kind("rgb.png", 2, 8, 255);
  for (const Kind& kind : kinds) {
    write_kind("other.png", kind.color_type, kind.bit_depth, kind.white);
    const Result result = compare("rgb.png", "other.png");
    EXPECT_EQ(result.outcome, Outcome::same) << int{kind.color_type};
    EXPECT_EQ(result.actual->channels, kind.channels);
    EXPECT_EQ(result.note.empty(), kind.channels == 3);
  }
  EXPECT_EQ(compare("rgb.png", "other.png").note, "RGB expected, RGBA found");
}

TEST_F(ComparePair, DifferentSizesAlwaysDiffer) {
  write_png(folder_ / "a.png", flat(8, 8, 0));
  write_png(folder_ / "b.png", flat(8, 9, 0));
  Settings settings;
  settings.thresholds.fail = settings.thresholds.warn = 2;
  const Result result = compare("a.png", "b.png", settings);
  EXPECT_EQ(result.outcome, Outcome::different);
  EXPECT_EQ(result.note, "size 8 x 8 expected, 8 x 9 found");
}

TEST_F(ComparePair, BytesMeetFloatsInLinearLight) {
  if (!has_module()) GTEST_SKIP() << "built without OpenImageIO";
  const auto picture = picture_of(16, 16, [](int x, int y, int c) { return x * 16 + y + c; });
  Bytes rgba;
  for (const float value : picture.rgba) rgba.push_back(static_cast<std::uint8_t>(value * 255.0f + 0.5f));
  write_png(folder_ / "a.png", picture);
  scene::write_image(folder_ / "b.exr", {16, 16, rgba, {}});
  const Result result = compare("a.png", "b.exr");
  EXPECT_LT(result.figures->max, 2e-5);
  EXPECT_EQ(result.note, "RGB expected, RGBA found; bytes and floats, compared in linear light");
}

TEST_F(ComparePair, FloatsWithAlphaAreComparedAsStored) {
  if (!has_module()) GTEST_SKIP() << "built without OpenImageIO";
  // EXR stores colours multiplied by alpha: 8 · 0.25 against 4 · 0.25.
  scene::write_image(folder_ / "a.exr", {1, 1, {}, std::vector<float>{8, 0, 0, 0.25f}});
  scene::write_image(folder_ / "b.exr", {1, 1, {}, std::vector<float>{4, 0, 0, 0.25f}});
  const Result result = compare("a.exr", "b.exr");
  EXPECT_NEAR(result.figures->max, 1.0, 1e-6);
  EXPECT_TRUE(result.flip->exposures);
}

TEST_F(ComparePair, OnlyOneSide) {
  write_png(folder_ / "a.png", flat(8, 8, 0));
  EXPECT_EQ(compare("a.png", "").outcome, Outcome::missing);
  EXPECT_EQ(compare("", "a.png").outcome, Outcome::added);
}

TEST_F(ComparePair, FilesThatCannotBeReadAreResults) {
  write_png(folder_ / "a.png", flat(80, 80, 7));
  const std::string whole = read_text(folder_ / "a.png");
  write_text(folder_ / "cut.png", whole.substr(0, whole.size() - 30));
  write_text(folder_ / "empty.png", "");
  write_text(folder_ / "text.png", "hello");
  PngFile huge;
  huge.claimed_side = 16000;
  huge.sample = [](std::uint32_t, std::uint32_t, int) { return 0u; };
  scene::test::write_bytes(folder_ / "huge.png", huge.build());
  for (const char* name : {"cut.png", "empty.png", "text.png", "huge.png"}) {
    for (const auto& [a, b] : {std::pair<std::string, std::string>{"a.png", name}, {name, "a.png"}}) {
      const Result result = compare(a, b);
      EXPECT_EQ(result.outcome, Outcome::error) << name;
      EXPECT_EQ(result.note.find((folder_ / name).string() + ": "), 0u) << result.note;
      EXPECT_FALSE(result.figures);
    }
  }
  EXPECT_TRUE(compare("cut.png", "a.png").actual) << "the other file is read all the same";
}

}  // namespace
}  // namespace barrido::compare::test
