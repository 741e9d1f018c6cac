// `barrido inspect`: the pixel it explains is the one that `barrido render` writes; and `--view`'s files.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/pictures/image_io.h"
#include "tests/unit/viewer/program.h"
#include "tests/unit/viewer/tiny_models.h"

namespace barrido::test {
namespace {

class Inspect : public ::testing::Test {
 protected:
  Inspect() {
    write_animated(folder_.path() / "animated.gltf");
    write_textured_glb(folder_.path() / "bumps.glb", 4);
  }

  Outcome barrido(const std::vector<std::string>& words) const {
    return run(words, {folder_.path(), "", false, 0});
  }

  TemporaryFolder folder_;
};

TEST_F(Inspect, ExplainsThePixelThatRenderWrites) {
  const std::vector<std::string> frame{
      "bumps.glb", "--resolution", "40,30",      "--shading", "gouraud", "--azimuth",          "20",
      "--ambient", "0.2,0.2,0.2",  "--exposure", "0.5",       "--fog",   "exp:0.2:0.3,0.4,0.5"};
  std::vector<std::string> render{"render", "-o", "x.png"};
  render.insert(render.end(), frame.begin(), frame.end());
  ASSERT_EQ(barrido(render).status, 0);
  const scene::Image image = scene::read_image(folder_.path() / "x.png");
  for (const auto& [x, y] : {std::pair{20, 15}, {12, 9}, {0, 0}, {39, 29}, {25, 18}}) {
    std::vector<std::string> words{"inspect", "--json", "--pixel",
                                   std::to_string(x) + "," + std::to_string(y)};
    words.insert(words.end(), frame.begin(), frame.end());
    const Outcome outcome = barrido(words);
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto json = nlohmann::json::parse(outcome.out);
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_EQ(json["rgba8"][c], image.rgba[static_cast<std::size_t>(y * 40 + x) * 4 + c]) << x << "," << y;
    }
  }
}

TEST_F(Inspect, TextNamesThePixelBothWays) {
  const Outcome outcome = barrido({"inspect", "animated.gltf", "-p", "3,4", "--resolution", "40,30"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(lines_of(outcome.out).at(0),
            "Pixel 3,4 of 40 x 30, counted from the upper left (in the window y = 25, from the bottom)");
}

TEST_F(Inspect, MistakesAreOneLine) {
  const std::pair<std::vector<std::string>, std::string> cases[] = {
      {{"inspect"}, "inspect: no FILE given; see barrido inspect --help"},
      {{"inspect", "bumps.glb"}, "inspect: no pixel given; say --pixel X,Y"},
      {{"inspect", "bumps.glb", "-p", "3"}, "--pixel: '3': expected X,Y, two whole numbers from 0"},
      {{"inspect", "bumps.glb", "-p", "-1,2"}, "--pixel: '-1,2': expected X,Y, two whole numbers from 0"},
      {{"inspect", "bumps.glb", "-p", "9,7", "--resolution", "9,9"},
       "--pixel: '9,7': the frame has 9 x 9 pixels, 0,0 to 8,8 (see --resolution)"},
      {{"inspect", "bumps.glb", "a.glb", "-p", "1,1"}, "inspect: one FILE at a time"},
      {{"inspect", "bumps.glb", "-p", "1,1", "--shading", "all"}, "--shading: inspect takes one mode"},
      {{"inspect", "bumps.glb", "-p", "1,1", "--camera-index", "all"},
       "--camera-index: inspect takes one camera"},
      {{"inspect", "bumps.glb", "-p", "1,1", "--sheet"}, "unknown option '--sheet'; did you mean '--seed'?"},
      {{"render", "bumps.glb", "-o", "x.png", "--view", "overdrw"},
       "--view: 'overdrw': expected one of picture, overdraw, layers, illuminations, texels, mip-level, "
       "mip-colors, texel-density, coordinates, triangles, depth, normals, mach-bands, samples, slivers; did "
       "you mean "
       "'overdraw'? (or several with commas between, or all)"},
      {{"render", "bumps.glb", "-o", "x.png", "--view", "depth,depth"},
       "--view: 'depth,depth': depth is given twice"},
      {{"render", "bumps.glb", "-o", "x.png", "--view", "depth,picture"},
       "--output: 'x.png': the frames need different names: add {view}, or use --sheet"},
      {{"render", "bumps.glb", "--view", "depth", "--stats"}, "--view: cannot be used together with --stats"},
  };
  for (const auto& [words, message] : cases) {
    const Outcome outcome = barrido(words);
    EXPECT_EQ(outcome.status, 2) << message;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.error, "barrido: " + message + "\n");
  }
}

TEST_F(Inspect, ViewsAreWrittenInEveryFormatAndInSheets) {
  for (const char* extension : {"png", "jpg", "tif", "exr"}) {
    const std::string name = std::string("v-{view}.") + extension;
    const Outcome outcome =
        barrido({"render", "bumps.glb", "-o", name, "--view", "picture,texels", "--resolution", "60,40"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const scene::Image view = scene::read_image(folder_.path() / (std::string("v-texels.") + extension));
    const scene::Image picture = scene::read_image(folder_.path() / (std::string("v-picture.") + extension));
    EXPECT_EQ(picture.height, 40);
    EXPECT_GT(view.height, 40);
    EXPECT_EQ(view.width, 60);
  }
  const Outcome sheet = barrido({"render", "bumps.glb", "-o", "s.png", "--sheet", "--shading", "all",
                                 "--view", "mach-bands", "--resolution", "60,40", "--hash"});
  EXPECT_EQ(sheet.status, 0) << sheet.error;
  EXPECT_EQ(lines_of(sheet.out).size(), 4u);
  EXPECT_NE(sheet.out.find("bumps/cheap-phong/mach-bands"), std::string::npos) << sheet.out;
}

}  // namespace
}  // namespace barrido::test
