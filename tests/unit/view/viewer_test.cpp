// The viewer as a whole, without a window: what it draws is what its command line renders.
#include "viewer/view/viewer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "pipeline/gltf/import_gltf.h"
#include "viewer/barrido/frame_plan.h"
#include "viewer/view/commands.h"
#include "viewer/view/key_table.h"
#include "viewer/view/render_words.h"

namespace barrido::view {
namespace {

const std::string kModels = BARRIDO_SOURCE_DIR "/models/";

cli::RenderOptions small() {
  cli::RenderOptions options;
  options.settings.width = 80;
  options.settings.height = 60;
  return options;
}

TEST(Viewer, OpensAndStepsThroughFiles) {
  Viewer viewer(small());
  viewer.open({kModels + "sphere.glb", kModels + "torus.glb", kModels + "no such file.glb"});
  EXPECT_EQ(viewer.path(), kModels + "sphere.glb");
  viewer.step_file(1);
  EXPECT_EQ(viewer.path(), kModels + "torus.glb");
  viewer.step_file(-2);
  EXPECT_NE(viewer.message.find("no such file.glb"), std::string::npos);
  EXPECT_EQ(viewer.model(), nullptr);
  EXPECT_EQ(viewer.draw().rgba.size(), 80u * 60u);
  viewer.step_file(1);
  EXPECT_NE(viewer.model(), nullptr);
  EXPECT_EQ(viewer.message, "");
}

TEST(Viewer, KeepsTheModelWhenTheFileBreaks) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "barrido_viewer_test.glb";
  std::filesystem::copy_file(kModels + "torus.glb", path, std::filesystem::copy_options::overwrite_existing);
  Viewer viewer(small());
  viewer.open({path.string()});
  const Picture before = viewer.draw();
  std::ofstream(path) << "no model";
  viewer.reload();
  EXPECT_NE(viewer.message, "");
  EXPECT_EQ(viewer.draw().rgba, before.rgba);
  std::filesystem::remove(path);
}

TEST(Viewer, CommandLineNamesFileAndOutput) {
  Viewer viewer(small());
  viewer.open({kModels + "torus.glb"});
  viewer.active().settings.exposure_ev = 0.1f;
  EXPECT_EQ(viewer.command_line(kLeft),
            "barrido render --resolution 80,60 --exposure 0.1 -o torus.png -- " + kModels + "torus.glb");
}

TEST(Viewer, SplitShowsBothSides) {
  Viewer viewer(small());
  viewer.open({kModels + "lost_highlight.glb"});
  viewer.set_split(true);
  viewer.side(kRight).shadings = {pipeline::ShadeModel::gouraud};
  viewer.display.divider = 0.25;
  const Picture both = viewer.draw();
  ASSERT_TRUE(viewer.difference());
  EXPECT_GT(viewer.difference()->largest, 0);
  viewer.display.divider = 1.0;
  const Picture left = viewer.draw();
  viewer.display.divider = 0.0;
  const Picture right = viewer.draw();
  EXPECT_EQ(both.rgba, side_by_side(left, right, 0.25).rgba);
  viewer.display.difference = true;
  EXPECT_EQ(viewer.draw().rgba, heat_map(left, right, *viewer.difference()).rgba);
  viewer.set_active_side(kRight);
  viewer.set_split(false);
  EXPECT_EQ(viewer.draw().rgba, right.rgba) << "the side that was changed last stays";
}

TEST(Viewer, SidesAreCalledByWhatDiffers) {
  Viewer viewer(small());
  viewer.set_split(true);
  EXPECT_EQ(viewer.side_name(kLeft), "A");
  viewer.side(kRight).settings.min_filter = raster::MinFilter::nearest;
  viewer.side(kLeft).settings.wireframe = true;
  EXPECT_EQ(viewer.side_name(kLeft), "A  wireframe");
  EXPECT_EQ(viewer.side_name(kRight), "B  min-filter nearest");
  viewer.side(kRight).shadings = {pipeline::ShadeModel::gouraud};
  EXPECT_EQ(viewer.side_name(kLeft), "A  phong");
  EXPECT_EQ(viewer.side_name(kRight), "B  gouraud");
}

TEST(Viewer, CamerasOfBothSidesMoveTogether) {
  Viewer viewer(small());
  viewer.open({kModels + "torus.glb"});
  viewer.set_split(true);
  viewer.orbit(10, 5);
  viewer.zoom(1.5);
  viewer.roll(20);
  EXPECT_EQ(viewer.side(kLeft).settings.camera.position, viewer.side(kRight).settings.camera.position);
  EXPECT_EQ(viewer.side(kLeft).settings.camera.view_up, viewer.side(kRight).settings.camera.view_up);
  viewer.reset_camera();
  EXPECT_FALSE(viewer.side(kRight).settings.camera.position);
}

/// The first move of the mouse must not make the picture jump.
TEST(Viewer, AMoveOfNothingKeepsThePicture) {
  for (const char* const model : {"torus.glb", "room.glb", "showcase.glb"}) {
    Viewer viewer(small());
    viewer.open({kModels + model});
    const Picture before = viewer.draw();
    viewer.orbit(0.0, 0.0);
    const Difference difference = difference_of(before, viewer.draw());
    EXPECT_LT(difference.mean, 0.6) << model;
  }
}

/// What a file's camera shows must not be cut off by a move.
TEST(Viewer, AMovedFileCameraKeepsItsPlanes) {
  Viewer viewer(small());
  viewer.open({kModels + "room.glb"});
  const scene::Eye before = viewer.look()->eye;
  viewer.orbit(3.0, 0.0);
  viewer.toggle_orthographic();
  viewer.toggle_orthographic();
  const scene::Eye after = viewer.look()->eye;
  EXPECT_LE(after.near_plane, before.near_plane);
  EXPECT_GE(after.far_plane, before.far_plane);
  EXPECT_EQ(viewer.active().cameras, std::vector{0});
  viewer.reset_camera();
  EXPECT_TRUE(viewer.active().cameras.empty());
}

TEST(Viewer, TheInspectorTellsOfThePixelThatIsSeen) {
  Viewer viewer(small());
  viewer.open({kModels + "showcase.glb"});
  viewer.set_split(true);
  viewer.side(kRight).shadings = {pipeline::ShadeModel::flat};
  const Picture picture = viewer.draw();
  for (int y = 3; y < 60; y += 9) {
    for (int x = 1; x < 80; x += 13) {
      viewer.inspect(x, y);
      ASSERT_TRUE(viewer.inspected());
      const auto& [r, g, b, a] = viewer.inspected()->rgba;
      EXPECT_EQ(picture.rgba[static_cast<std::size_t>(y * 80 + x)],
                r | g << 8 | b << 16 | static_cast<std::uint32_t>(a) << 24)
          << x << "," << y;
      EXPECT_FALSE(viewer.inspected()->text.empty());
    }
  }
  viewer.inspect(80, 0);
  EXPECT_FALSE(viewer.inspected());
}

TEST(Viewer, CoarsePicturesAreSmaller) {
  Viewer viewer(small());
  viewer.open({kModels + "torus.glb"});
  EXPECT_EQ(viewer.draw(2).width, 40);
  EXPECT_EQ(viewer.draw().width, 80);
  EXPECT_FALSE(viewer.changed);
}

TEST(Viewer, FailuresAreToldAndGiveABlankPicture) {
  cli::RenderOptions options = small();
  options.environment_path = "no such folder";
  Viewer viewer(options);
  viewer.open({kModels + "torus.glb"});
  EXPECT_EQ(viewer.draw().rgba.front(), 0xff333333u);
  EXPECT_NE(viewer.message.find("no such folder"), std::string::npos);
}

TEST(Viewer, SeveralFramesBecomeOne) {
  const std::vector<std::string> words{"--shading", "all", "--turntable", "4", "--camera-index", "all"};
  Viewer viewer(cli::parse_view_options(words));
  EXPECT_EQ(viewer.words(), (std::vector<std::string>{"--resolution", "1280,720", "--shading", "flat",
                                                      "--camera-index", "0"}));
}

}  // namespace
}  // namespace barrido::view
