// What stories say: names, fates, numbers that one can add up by hand, as text and as JSON.
#include <nlohmann/json.hpp>

#include "tests/unit/inspect/inspect_fixture.h"
#include "tests/unit/scene/frame_fixture.h"

namespace barrido::inspect {
namespace {

using Json = nlohmann::json;
using pipeline::ShadeModel;

/// A red square before a white one and a glass pane before both; one light from the eye.
class Story : public ::testing::Test {
 protected:
  Story() {
    scene::Material white = scene::testing::matte({1, 1, 1});
    white.name = "chalk";
    white.exact.diffuse = glm::vec3(1.0f);
    white.exact.ambient = glm::vec3(0.5f);
    white.exact.specular = glm::vec3(0.0f);
    scene::Material red = scene::testing::unlit({1, 0, 0, 1});
    red.name = "lacquer";
    scene::Material glass = scene::testing::unlit({0, 0, 1, 0.25f}, scene::AlphaMode::blend);
    glass.name = "glass";
    builder_.add_mesh_node(scene::testing::square(builder_.add_material(white)), {0, 0, 0});
    builder_.add_mesh_node(scene::testing::square(builder_.add_material(red)), {-1.5f, 0, -1.0f});
    builder_.add_mesh_node(scene::testing::square(builder_.add_material(glass)), {1.0f, 0, 1.0f});
    builder_.scene.nodes[0].name = "board";
    builder_.scene.source = "memory.glb";
    settings_ = scene::testing::front_view();
    settings_.color_management = scene::ColorManagement::none;
    settings_.ambient = glm::vec3(0.25f);
    scene::UserLight light;
    light.light.kind = scene::Light::Kind::directional;
    light.light.exact_intensity = 0.5f;
    light.direction = {0, 0, -1};
    settings_.lights = {light};
  }

  PixelStory tell(int x, int y) {
    scene::SceneRenderer renderer(builder_.scene);
    return inspect_pixel(builder_.scene, renderer, settings_, x, y);
  }

  scene::testing::SceneBuilder builder_;
  scene::RenderSettings settings_;
};

TEST_F(Story, SharesOfALightAreThoseOfTheFormula) {
  for (const ShadeModel shading : {ShadeModel::flat, ShadeModel::gouraud, ShadeModel::phong}) {
    settings_.shading = shading;
    const PixelStory story = tell(30, 32);
    const FragmentStory& front = story.fragments.at(static_cast<std::size_t>(story.front));
    EXPECT_EQ(front.material_name, "chalk");
    EXPECT_EQ(front.node_name, "board");
    for (const IlluminationStory& light : front.illuminations) {
      EXPECT_EQ(light.base[0], 0.125f);  // k_a·I_a
      EXPECT_EQ(light.lights.at(0).n_dot_l, 1.0f);
      EXPECT_EQ(light.lights.at(0).diffuse[1], 0.5f);  // I_p·k_d·(N·L)
      EXPECT_EQ(light.primary[2], 0.625f);
    }
    EXPECT_EQ(front.illuminations.size(), shading == ShadeModel::gouraud ? 3u : 1u);
    EXPECT_EQ(story.rgba8, (std::array<std::uint8_t, 4>{159, 159, 159, 255}));  // 0.625·255, to nearest
  }
}

TEST_F(Story, WeightsPutTheCornersWhereThePixelIs) {
  const PixelStory story = tell(20, 40);
  const FragmentStory& front = story.fragments.at(static_cast<std::size_t>(story.front));
  double x = 0, y = 0, sum = 0;
  for (const CornerStory& corner : front.corners) {
    x += corner.weight * corner.window_x;  // w is the same at all corners of the board
    y += corner.weight * corner.window_y;
    sum += corner.weight;
    EXPECT_NEAR(corner.weight, corner.screen_weight, 1e-3);
  }
  EXPECT_NEAR(x, 20.5, 0.02);
  EXPECT_NEAR(y, 64 - 40 - 0.5, 0.02);
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_EQ(story.window_y, 23);
}

TEST_F(Story, HiddenAndBlendedFragmentsAreTold) {
  const std::string hidden = story_text(tell(15, 32));
  EXPECT_NE(hidden.find("hidden: z "), std::string::npos) << hidden;
  EXPECT_NE(hidden.find("'lacquer'"), std::string::npos) << hidden;
  EXPECT_NE(hidden.find("node 0 'board'"), std::string::npos) << hidden;
  EXPECT_NE(hidden.find("max(1, 0)"), std::string::npos) << hidden;
  EXPECT_NE(hidden.find("x 255, rounded: 159, 159, 159, 255"), std::string::npos) << hidden;
  const PixelStory through_glass = tell(40, 32);
  const std::string blended = story_text(through_glass);
  EXPECT_NE(blended.find("Blending (add): (0, 0, 1, 0.25)"), std::string::npos) << blended;
  EXPECT_EQ(through_glass.fragments.size(), 2u);
  EXPECT_EQ(through_glass.fragments[0].fate, Fate::visible);
  EXPECT_EQ(through_glass.fragments[1].fate, Fate::visible);
}

TEST_F(Story, BlendedTrianglesKeepTheirNumbersOfTheFile) {
  const PixelStory lower = tell(52, 45), upper = tell(38, 18);
  EXPECT_EQ(lower.fragments.back().triangle, 0u);
  EXPECT_EQ(upper.fragments.back().triangle, 1u);
}

TEST(StoryText, CheapPhongTellsTheProductsThatItInterpolates) {
  const scene::Scene scene = model("room.glb");
  scene::SceneRenderer renderer(scene);
  scene::RenderSettings settings;
  settings.width = 200;
  settings.height = 140;
  settings.shading = ShadeModel::cheap_phong;
  int told = 0;
  for (const PixelStory& story : inspect_pixels(scene, renderer, settings, random_pixels(settings, 20, 2))) {
    for (const FragmentStory& fragment : story.fragments) {
      if (!fragment.from_products) continue;
      if (fragment.fate == Fate::visible) {
        EXPECT_NE(story_text(story).find("interpolated: f·N·L"), std::string::npos);
      }
      for (std::size_t i = 0; i < fragment.from_products->lights.size(); ++i) {
        double sum = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
          sum += fragment.corners[k].weight * (*fragment.illuminations[k].lights[i].products)[0];
        }
        EXPECT_NEAR(sum, fragment.from_products->lights[i].n_dot_l, 2e-3);
        ++told;
      }
    }
  }
  EXPECT_GT(told, 10);
}

TEST_F(Story, BackgroundIsSaidToBeThat) {
  const PixelStory story = tell(63, 0);
  EXPECT_EQ(story.front, -1);
  EXPECT_NE(story_text(story).find("No triangle covers this pixel"), std::string::npos);
  EXPECT_EQ(story.rgba8, (std::array<std::uint8_t, 4>{0, 0, 0, 255}));
}

TEST_F(Story, PixelsOutsideAreRefused) {
  for (const auto& [x, y] : {std::pair{64, 0}, {0, 64}, {-1, 0}, {0, -1}}) {
    EXPECT_THROW(tell(x, y), std::out_of_range) << x << "," << y;
  }
}

TEST_F(Story, CoveredFragmentsAreToldFromVisibleOnes) {
  builder_.scene.scenes[0].nodes = {1, 0};  // The red square, farther away, is drawn first.
  std::swap(builder_.scene.nodes[0], builder_.scene.nodes[1]);
  const PixelStory story = tell(15, 32);
  ASSERT_EQ(story.fragments.size(), 2u);
  EXPECT_EQ(story.fragments[0].fate, Fate::covered);
  EXPECT_EQ(story.fragments[1].fate, Fate::visible);
}

/// A reader of the JSON can add everything up again.
TEST(StoryJson, AddsUp) {
  const scene::Scene scene = model("showcase.glb");
  scene::SceneRenderer renderer(scene);
  scene::RenderSettings settings;
  settings.width = 200;
  settings.height = 140;
  int illuminated = 0, sampled = 0;
  for (const PixelStory& story : inspect_pixels(scene, renderer, settings, random_pixels(settings, 40, 11))) {
    const Json json = Json::parse(story_json(story));
    EXPECT_EQ(json["schema"], "barrido-inspect-1");
    EXPECT_EQ(json["pixel"]["x"], story.x);
    Json frame = json["clear"]["color"];
    for (const Json& fragment : json["fragments"]) {
      if (fragment["frame"].contains("before")) {
        EXPECT_EQ(fragment["frame"]["before"], frame);
        frame = fragment["frame"]["after"];
      }
      for (const Json& light : fragment["illuminations"]) {
        for (std::size_t c = 0; c < 3; ++c) {
          float sum = light["base"][c].get<float>(), highlights = 0.0f;
          for (const Json& one : light["lights"]) {
            sum = sum + one["diffuse"][c].get<float>();
            highlights = highlights + one["specular"][c].get<float>();
          }
          EXPECT_EQ(sum, light["primary"][c].get<float>());
          EXPECT_EQ(highlights, light["secondary"][c].get<float>());
        }
        ++illuminated;
      }
      for (const Json& unit : fragment["textures"]) {
        for (const Json& level : unit["levels"]) {
          double weights = 0.0;
          for (const Json& texel : level["texels"]) weights += texel["weight"].get<double>();
          EXPECT_NEAR(weights, 1.0, 1e-9);
        }
        ++sampled;
      }
    }
    EXPECT_EQ(frame, json["color"]);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(json["display"]["result"][c].get<double>() * 255.0, json["rgba8"][c].get<double>(), 0.5001);
    }
  }
  EXPECT_GT(illuminated, 10);
  EXPECT_GT(sampled, 10);
}

TEST(StoryJson, NamesThatAreNoUtf8AreReplaced) {
  PixelStory story;
  story.source = "\xff.glb";
  EXPECT_TRUE(Json::accept(story_json(story)));
}

}  // namespace
}  // namespace barrido::inspect
