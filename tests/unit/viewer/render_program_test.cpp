// `barrido render` from model to picture: sizes, names, techniques, and the same bits however it is run.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/pictures/image_io.h"
#include "raster/base/simd_target.h"
#include "tests/unit/viewer/program.h"
#include "tests/unit/viewer/tiny_models.h"

namespace barrido::test {
namespace {

using Words = std::vector<std::string>;

class Render : public ::testing::Test {
 protected:
  Render() {
    write_square(folder_.path() / "square.gltf");
    write_animated(folder_.path() / "animated.gltf");
    write_textured_glb(folder_.path() / "bumps.glb", 12);
  }

  Outcome render(Words words) const {
    words.insert(words.begin(), "render");
    return run(words, {folder_.path(), "", false, 0});
  }

  /// Renders at 64 × 48, expects success, and returns the lines of --hash.
  Words hashes(Words words) const {
    words.insert(words.end(), {"--hash", "--resolution", "64,48"});
    const Outcome outcome = render(words);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    return lines_of(outcome.out);
  }

  /// The hash of the one frame.
  std::string hash(const Words& words) const {
    const Words lines = hashes(words);
    EXPECT_EQ(lines.size(), 1u);
    return lines.empty() ? "" : lines[0].substr(0, 64);
  }

  scene::Image picture(const std::string& name) const { return scene::read_image(folder_.path() / name); }

  TemporaryFolder folder_;
};

TEST_F(Render, WritesAPictureOfTheSizeAskedFor) {
  const Outcome outcome = render({"square.gltf", "-o", "a.png", "--resolution", "65,33"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.error, "");
  const scene::Image image = picture("a.png");
  EXPECT_EQ(image.width, 65);
  EXPECT_EQ(image.height, 33);
  const std::size_t middle = (16 * 65 + 32) * 4;
  EXPECT_GT(image.rgba[middle], 2 * image.rgba[middle + 1]) << "the square is red";
  EXPECT_NE(image.rgba[middle], image.rgba[0]) << "the corner is background";
}

TEST_F(Render, FormatsComeFromTheExtension) {
  for (const char* name : {"a.png", "a.jpg", "a.JPEG"}) {
    EXPECT_EQ(render({"square.gltf", "-o", name, "--resolution", "32,32"}).status, 0) << name;
    EXPECT_EQ(picture(name).width, 32) << name;
  }
}

TEST_F(Render, FloatFormatsHoldValuesOverTheMaximum) {
  for (const char* name : {"a.exr", "a.HDR"}) {
    const Outcome outcome =
        render({"square.gltf", "-o", name, "--ambient", "9,9,9", "--resolution", "32,32"});
    if (outcome.error.find("needs the module") != std::string::npos) GTEST_SKIP() << outcome.error;
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    const scene::FloatImage image = scene::read_float_image(folder_.path() / name);
    EXPECT_GT(image.rgba[(16 * 32 + 16) * 4], 2.0f) << name;
  }
}

TEST_F(Render, TemplatesNameEachFrame) {
  const Outcome outcome = render({"square.gltf", "bumps.glb", "-o", "out/{model}/{shading}-{frame:02}.png",
                                  "--shading", "flat,phong", "--turntable", "2", "--resolution", "16,16"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(
      folder_.files(),
      (Words{"animated.gltf", "bumps.glb", "out/bumps/flat-00.png", "out/bumps/flat-01.png",
             "out/bumps/phong-00.png", "out/bumps/phong-01.png", "out/square/flat-00.png",
             "out/square/flat-01.png", "out/square/phong-00.png", "out/square/phong-01.png", "square.gltf"}));
}

TEST_F(Render, HashLinesNameTheFramesInOrder) {
  const Words lines = hashes({"bumps.glb", "--shading", "all"});
  ASSERT_EQ(lines.size(), 4u);
  const char* labels[] = {"bumps/flat", "bumps/gouraud", "bumps/cheap-phong", "bumps/phong"};
  std::set<std::string> different;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(lines[i].substr(64), std::string("  ") + labels[i]);
    EXPECT_EQ(lines[i].find_first_not_of("0123456789abcdef"), 64u);
    different.insert(lines[i].substr(0, 64));
  }
  EXPECT_EQ(different.size(), 4u) << "the shading modes differ";
  EXPECT_EQ(hashes({"bumps.glb", "-o", "b.png"})[0].substr(64), "  b.png");
}

TEST_F(Render, TheHashIsOfThePixelsInTheFile) {
  const std::string drawn = hash({"bumps.glb", "-o", "b.png"});
  const std::string again = hash({"bumps.glb", "-o", "c.png", "--compression", "9"});
  EXPECT_EQ(drawn, again);
  EXPECT_EQ(picture("b.png").rgba, picture("c.png").rgba);
  EXPECT_NE(read_text(folder_.path() / "b.png"), read_text(folder_.path() / "c.png"));
}

TEST_F(Render, ThreadsInstructionsAndVisibilityChangeNoPixel) {
  const Words base{"bumps.glb", "square.gltf", "animated.gltf", "--shading", "all"};
  const auto with = [&](Words more) {
    Words words = base;
    words.insert(words.end(), more.begin(), more.end());
    return hashes(words);
  };
  const Words expected = with({});
  ASSERT_EQ(expected.size(), 12u);
  EXPECT_EQ(with({"--threads", "1"}), expected);
  EXPECT_EQ(with({"--threads", "2"}), expected);
  EXPECT_EQ(with({"--threads", "5"}), expected);
  EXPECT_EQ(with({"--visibility-first", "off"}), expected);
  for (const raster::SimdTarget target : raster::available_simd_targets()) {
    const std::string name(raster::name_of(target));
    EXPECT_EQ(with({"--simd", name}), expected) << name;
    EXPECT_EQ(with({"--simd", name, "--threads", "1"}), expected) << name;
  }
}

TEST_F(Render, TheBackgroundIsWhatWasTyped) {
  const Words ways[] = {{}, {"--exposure", "1"}, {"--tone-map", "reinhard"}, {"--color-management", "none"}};
  for (const Words& way : ways) {
    Words words{"square.gltf", "-o", "a.png", "--background", "0.2,0.4,1,0.6", "--resolution", "40,20"};
    words.insert(words.end(), way.begin(), way.end());
    EXPECT_EQ(render(words).status, 0);
    const scene::Image image = picture("a.png");
    const std::vector<std::uint8_t> corner(image.rgba.begin(), image.rgba.begin() + 4);
    EXPECT_EQ(corner, (std::vector<std::uint8_t>{51, 102, 255, 153})) << (way.empty() ? "" : way[0]);
  }
}

TEST_F(Render, FogHasTheColourTypedOrTheBackgrounds) {
  const auto all_alike = [this](const Words& more) {
    Words words{"square.gltf", "-o", "a.png", "--resolution", "40,20"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(render(words).status, 0);
    const scene::Image image = picture("a.png");
    return std::equal(image.rgba.begin() + 4, image.rgba.end(), image.rgba.begin());
  };
  EXPECT_TRUE(all_alike({"--fog", "exp:1000"}));
  EXPECT_TRUE(all_alike({"--fog", "exp2:1000", "--background", "0.1,0.2,0.3"}));
  EXPECT_TRUE(all_alike({"--fog", "linear:0,0.001:0.1,0.2,0.3", "--background", "0.1,0.2,0.3"}));
  EXPECT_FALSE(all_alike({"--fog", "exp:1000:1,0,0"}));
  EXPECT_FALSE(all_alike({"--fog", "exp:0"}));
}

TEST_F(Render, TechniquesChangeThePicture) {
  const std::string plain = hash({"bumps.glb"});
  const Words changes[] = {{"--shading", "flat"},
                           {"--lighting", "phong"},
                           {"--no-textures"},
                           {"--mag-filter", "nearest"},
                           {"--wireframe"},
                           {"--light", "directional:dir=1,0,-1"},
                           {"--light", "point:pos=0,0,2:attenuation=1,0,1"},
                           {"--light", "spot:pos=0,0,3:cone=5,15"},
                           {"--no-lights"},
                           {"--ambient", "1,0,0"},
                           {"--camera-position", "1,2,3"},
                           {"--camera-view-angle", "90"},
                           {"--up", "+X"},
                           {"--azimuth", "30"},
                           {"--elevation", "30"},
                           {"--color-management", "none"},
                           {"--exposure", "1"},
                           {"--tone-map", "reinhard"},
                           {"--fog", "exp:0.3"},
                           {"--background", "1,1,1"}};
  std::set<std::string> seen{plain};
  for (const Words& change : changes) {
    Words words{"bumps.glb"};
    words.insert(words.end(), change.begin(), change.end());
    EXPECT_TRUE(seen.insert(hash(words)).second) << change[0] << " changed nothing, or as another did";
  }
}

TEST_F(Render, ShadingVariantsChangeTheirModeOnly) {
  const auto differ = [this](const char* shading, const char* option, const char* value) {
    return hash({"bumps.glb", "--shading", shading, "--light", "point:pos=0.3,0.2,0.6"}) !=
           hash({"bumps.glb", "--shading", shading, "--light", "point:pos=0.3,0.2,0.6", option, value});
  };
  EXPECT_TRUE(differ("flat", "--flat-at", "provoking"));
  EXPECT_FALSE(differ("phong", "--flat-at", "provoking"));
  EXPECT_TRUE(differ("cheap-phong", "--cheap-phong-power", "vertex"));
  EXPECT_FALSE(differ("gouraud", "--cheap-phong-power", "vertex"));
}

TEST_F(Render, CamerasAndMomentsOfTheFile) {
  const Words cameras = hashes({"animated.gltf", "--camera-index", "all"});
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[0].substr(64), "  animated/phong/camera0");
  EXPECT_NE(cameras[0].substr(0, 64), cameras[1].substr(0, 64));
  EXPECT_EQ(hash({"animated.gltf"}), cameras[0].substr(0, 64)) << "the first camera is the default";
  EXPECT_NE(hash({"animated.gltf", "--camera-index", "none"}), cameras[0].substr(0, 64));

  const Words frames = hashes({"animated.gltf", "--frames", "0:2", "--fps", "2"});
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[1].substr(64), "  animated/phong/frame1");
  EXPECT_EQ(frames[1].substr(0, 64), hash({"animated.gltf", "--time", "0.5"}));
  EXPECT_EQ(frames[2].substr(0, 64), hash({"animated.gltf", "--time", "1", "--animation", "0"}));
  EXPECT_NE(frames[1].substr(0, 64), frames[2].substr(0, 64));
}

TEST_F(Render, ASheetHoldsAllFrames) {
  const Outcome outcome = render({"square.gltf", "bumps.glb", "-o", "sheet.png", "--sheet", "--shading",
                                  "all", "--resolution", "64,48", "--hash"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(lines_of(outcome.out).size(), 8u);
  const scene::Image sheet = picture("sheet.png");
  EXPECT_GT(sheet.width * sheet.height, 8 * 64 * 48);
}

TEST_F(Render, StatsAreTextOrJson) {
  const Outcome text = render({"bumps.glb", "--stats", "--shading", "flat,phong", "--resolution", "64,48"});
  EXPECT_EQ(text.status, 0) << text.error;
  EXPECT_NE(text.out.find("flat: 1 frame, drawn in "), std::string::npos);
  EXPECT_NE(text.out.find("phong: 1 frame, drawn in "), std::string::npos);
  const Outcome outcome =
      render({"bumps.glb", "--stats=json", "--hash", "--shading", "flat,phong", "--resolution", "64,48"});
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["frames"].size(), 2u);
  EXPECT_EQ(json["frames"][1]["sha256"], hash({"bumps.glb"}));
  EXPECT_GT(json["modes"]["phong"]["powers"], json["modes"]["flat"]["powers"]);
  EXPECT_EQ(json["frames"][0]["stages"]["vertices"], 13 * 13);
  EXPECT_EQ(json["frames"][0]["stages"]["primitives_in"], 2 * 12 * 12);
}

TEST_F(Render, ThreadsAndInstructionsAreTheOnesAskedFor) {
  for (const raster::SimdTarget target : raster::available_simd_targets()) {
    const std::string name(raster::name_of(target));
    const Outcome outcome =
        render({"square.gltf", "--stats=json", "--resolution", "8,8", "--simd", name, "--threads", "3"});
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["simd"], name);
    EXPECT_EQ(json["threads"], 3);
  }
}

TEST_F(Render, AnEnvironmentIsReflectedAndSeen) {
  const int width = 64, height = 32;
  std::vector<std::uint8_t> sky(width * height * 4, 255);
  for (std::size_t i = 0; i < sky.size(); i += 4) sky[i] = 0;
  scene::write_image(folder_.path() / "sky.png", {width, height, sky, {}});
  EXPECT_EQ(render({"square.gltf", "-o", "a.png", "--environment", "sky.png", "--background", "environment",
                    "--resolution", "40,20"})
                .status,
            0);
  const scene::Image image = picture("a.png");
  EXPECT_EQ(std::vector<std::uint8_t>(image.rgba.begin(), image.rgba.begin() + 3),
            (std::vector<std::uint8_t>{0, 255, 255}));
  EXPECT_NE(hash({"square.gltf", "--environment", "sky.png"}), hash({"square.gltf"}));
  EXPECT_EQ(render({"square.gltf", "-o", "b.png", "--environment", "dynamic"}).status, 0);
}

}  // namespace
}  // namespace barrido::test
