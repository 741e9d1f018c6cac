// Barrido | OSMesa: an independent OpenGL draws the same draws, and the two pictures agree but for rounding
// and pixels on edges.
#include <gtest/gtest.h>

#include "viewer/view/key_table.h"
#include "viewer/view/viewer.h"

namespace barrido::view {
namespace {

using pipeline::ShadeModel;

const std::string kModels = BARRIDO_SOURCE_DIR "/models/";

class OsmesaSide : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = osmesa::why_missing(); !why.empty()) GTEST_SKIP() << why;
  }

  static cli::RenderOptions small() {
    cli::RenderOptions options;
    options.settings.width = 160;
    options.settings.height = 120;
    return options;
  }
};

TEST_F(OsmesaSide, AgreesInEveryShadingMode) {
  for (const char* const model : {"lost_highlight.glb", "showcase.glb", "room.glb"}) {
    Viewer viewer(small());
    viewer.open({kModels + model});
    viewer.set_osmesa(true);
    for (const ShadeModel shading :
         {ShadeModel::flat, ShadeModel::gouraud, ShadeModel::cheap_phong, ShadeModel::phong}) {
      viewer.active().shadings = {shading};
      viewer.draw();
      ASSERT_TRUE(viewer.difference()) << viewer.message;
      EXPECT_EQ(viewer.message, "");
      EXPECT_LT(viewer.difference()->mean, 0.3) << model << " " << static_cast<int>(shading);
      EXPECT_LT(viewer.difference()->beyond_rounding, 160u * 120u / 25) << model;
      EXPECT_EQ(viewer.osmesa_cannot().size(), 0u) << viewer.osmesa_cannot()[0];
    }
  }
}

TEST_F(OsmesaSide, ShowsItsPictureRightOfTheDivider) {
  Viewer viewer(small());
  viewer.open({kModels + "torus.glb"});
  viewer.set_osmesa(true);
  viewer.display.divider = 1.0;
  const Picture barrido = viewer.draw();
  viewer.display.divider = 0.0;
  const Picture other = viewer.draw();
  EXPECT_NE(barrido.rgba, other.rgba) << "two programs never round alike everywhere";
  viewer.display.divider = 0.5;
  EXPECT_EQ(viewer.draw().rgba, side_by_side(barrido, other, 0.5).rgba);
  EXPECT_EQ(viewer.draw(2).width, 80);
}

TEST_F(OsmesaSide, TellsWhatOpenglHasNot) {
  Viewer viewer(small());
  viewer.open({kModels + "torus.glb"});
  viewer.set_osmesa(true);
  scene::RenderSettings& settings = viewer.active().settings;
  settings.color_management = scene::ColorManagement::srgb;
  settings.lighting = pipeline::SpecularModel::phong;
  settings.lights.assign(9, {});
  viewer.active().shadings = {ShadeModel::gouraud};
  viewer.draw();
  EXPECT_EQ(viewer.osmesa_cannot(),
            (std::vector<std::string>{"managed colours (sRGB)", "lights after the eighth",
                                      "R·V highlights at vertices"}));
}

TEST_F(OsmesaSide, AViewIsNotComparedWithIt) {
  Viewer viewer(small());
  viewer.open({kModels + "torus.glb"});
  viewer.set_osmesa(true);
  viewer.active().views = {inspect::StructureView::overdraw};
  const Picture picture = viewer.draw();
  EXPECT_FALSE(viewer.difference());
  EXPECT_EQ(picture.height, 120 + viewer.legend_height());
  viewer.display.difference = true;
  EXPECT_EQ(viewer.draw().rgba, picture.rgba);
}

TEST_F(OsmesaSide, GivesBackWhatItPutAside) {
  Viewer viewer(small());
  viewer.open({kModels + "torus.glb"});
  viewer.set_split(true);
  viewer.set_active_side(kRight);
  viewer.active().shadings = {ShadeModel::gouraud};
  const std::vector<std::string> before = viewer.words();
  EXPECT_TRUE(press(viewer, key_of('Q'), kPlain));
  EXPECT_TRUE(viewer.display.split);
  viewer.set_active_side(kRight);
  EXPECT_EQ(viewer.active_side(), kLeft);
  EXPECT_EQ(viewer.active().shadings[0], ShadeModel::gouraud);
  EXPECT_EQ(viewer.active().settings.color_management, scene::ColorManagement::none);
  EXPECT_TRUE(press(viewer, key_of('Q'), kPlain));
  EXPECT_FALSE(viewer.display.split);
  EXPECT_EQ(viewer.words(), before);
}

TEST_F(OsmesaSide, TheInspectorTellsItsColour) {
  Viewer viewer(small());
  viewer.open({kModels + "torus.glb"});
  viewer.set_osmesa(true);
  viewer.draw();
  viewer.inspect(150, 60);
  ASSERT_TRUE(viewer.inspected());
  EXPECT_EQ(viewer.inspected()->text.find("OSMesa's colour here: "), 0u);
}

}  // namespace
}  // namespace barrido::view
