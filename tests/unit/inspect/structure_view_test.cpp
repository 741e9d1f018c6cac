// Views of cost and structure: counts are those of the statistics, and what is seen is what stories tell.
#include "pipeline/inspect/structure_view.h"

#include <cmath>

#include "pipeline/inspect/view_colors.h"
#include "pipeline/inspect/view_observers.h"
#include "tests/unit/inspect/inspect_fixture.h"
#include "tests/unit/scene/frame_fixture.h"
#include "viewer/sheet/view_legend.h"
#include "viewer/sheet/view_picture.h"

namespace barrido::inspect {
namespace {

using pipeline::ShadeModel;
using scene::RenderSettings;

constexpr ShadeModel kModes[] = {ShadeModel::flat, ShadeModel::gouraud, ShadeModel::cheap_phong,
                                 ShadeModel::phong};

RenderSettings small_frame(ShadeModel shading) {
  RenderSettings settings;
  settings.width = 180;
  settings.height = 130;
  settings.shading = shading;
  return settings;
}

struct Totals {
  std::uint64_t overdraw, layers, illuminations, texels;
  bool operator==(const Totals&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Totals& t) {
  return out << t.overdraw << " " << t.layers << " " << t.illuminations << " " << t.texels;
}

Totals totals_of_views(scene::SceneRenderer& renderer, const RenderSettings& settings) {
  const auto total = [&](StructureView view) {
    const ViewValues values = measure_view(renderer, settings, view);
    double sum = 0.0;
    for (const float value : values.values) sum += value;
    EXPECT_EQ(static_cast<std::uint64_t>(sum), values.total);
    return values.total + values.outside;
  };
  return {total(StructureView::overdraw), total(StructureView::layers), total(StructureView::illuminations),
          total(StructureView::texels)};
}

Totals totals_of_frame(scene::SceneRenderer& renderer, RenderSettings settings) {
  settings.visibility_first = false;
  pipeline::Statistics statistics;
  renderer.render(settings, &statistics);
  return {statistics.raster.fragments_shaded, statistics.raster.fragments_covered,
          statistics.illuminations_vertex + statistics.illuminations_fragment,
          statistics.raster.texel_fetches};
}

TEST(StructureView, CountsAddUpToTheStatistics) {
  for (const char* name : {"showcase.glb", "room.glb", "checker_ground.glb", "suzanne.glb"}) {
    const scene::Scene scene = model(name);
    scene::SceneRenderer renderer(scene);
    for (const ShadeModel shading : kModes) {
      for (const bool wireframe : {false, true}) {
        RenderSettings settings = small_frame(shading);
        settings.wireframe = wireframe;
        const Totals counted = totals_of_views(renderer, settings);
        EXPECT_EQ(counted, totals_of_frame(renderer, settings)) << name << wireframe;
        EXPECT_GT(counted.overdraw, 100u);
      }
    }
  }
}

TEST(StructureView, CountsAddUpWithMasksBlendingAndProvokingVertices) {
  scene::testing::SceneBuilder builder;
  scene::Material mask = scene::testing::matte({0.5f, 0.5f, 0.5f});
  mask.alpha_mode = scene::AlphaMode::mask;
  mask.base_color.a = 0.4f;
  const int masked = builder.add_material(mask);
  const int blended = builder.add_material(scene::testing::unlit({1, 0, 0, 0.5f}, scene::AlphaMode::blend));
  builder.add_mesh_node(scene::testing::square(builder.add_material(scene::testing::matte({1, 1, 1}))));
  builder.add_mesh_node(scene::testing::square(masked), {0.2f, 0.1f, 0.5f});
  const int behind = builder.add_material(scene::testing::matte({0, 1, 0}));
  builder.add_mesh_node(scene::testing::square(behind), {0.4f, 0.2f, 0.3f});  // seen through the masked one
  builder.add_mesh_node(scene::testing::square(blended), {-0.3f, 0.0f, 1.0f});
  builder.add_mesh_node(scene::testing::square(blended), {0.0f, -0.3f, 0.7f});
  scene::SceneRenderer renderer(builder.scene);
  RenderSettings settings = scene::testing::front_view();
  for (const ShadeModel shading : kModes) {
    settings.shading = shading;
    settings.flat_at = pipeline::FlatAt::provoking_vertex;
    EXPECT_EQ(totals_of_views(renderer, settings), totals_of_frame(renderer, settings));
  }
}

/// Every pixel's front fragment as the inspector tells it.
TEST(StructureView, WhatIsSeenIsWhatStoriesTell) {
  const scene::Scene scene = model("showcase.glb");
  scene::SceneRenderer renderer(scene);
  const RenderSettings settings = small_frame(ShadeModel::phong);
  const ViewValues triangles = measure_view(renderer, settings, StructureView::triangles);
  const ViewValues depth = measure_view(renderer, settings, StructureView::depth);
  const ViewValues levels = measure_view(renderer, settings, StructureView::mip_level);
  const ViewValues normals = measure_view(renderer, settings, StructureView::normals);
  int seen = 0;
  for (const PixelStory& story : inspect_pixels(scene, renderer, settings, random_pixels(settings, 300, 5))) {
    const auto at = static_cast<std::size_t>(story.y * settings.width + story.x);
    if (story.front < 0) {
      EXPECT_TRUE(std::isnan(triangles.values[at]) && std::isnan(depth.values[at]));
      continue;
    }
    ++seen;
    const FragmentStory& front = story.fragments[static_cast<std::size_t>(story.front)];
    EXPECT_EQ(depth.values[at], 1.0f / front.trace.q);
    EXPECT_FALSE(std::isnan(triangles.values[at]));
    for (std::size_t i = 0; i < front.textures.size(); ++i) {
      if (front.textures[i].cube || front.textures[i].role != "base color") continue;
      const auto& sample = front.trace.shading.units[i].sample;
      EXPECT_EQ(levels.values[at], static_cast<float>(sample.levels[0].level) + sample.far_weight);
    }
    ASSERT_EQ(front.illuminations.size(), 1u);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(normals.normals[at][static_cast<std::size_t>(c)], front.illuminations[0].normal[c], 1e-5f);
    }
  }
  EXPECT_GT(seen, 100);
}

TEST(StructureView, TwoTrianglesHaveTwoNumbersAndOneDistance) {
  scene::testing::SceneBuilder builder;
  builder.add_mesh_node(scene::testing::square(builder.add_material(scene::testing::matte({1, 1, 1}))));
  scene::SceneRenderer renderer(builder.scene);
  const RenderSettings settings = scene::testing::front_view();
  const ViewValues triangles = measure_view(renderer, settings, StructureView::triangles);
  EXPECT_EQ(triangles.total, 2u);
  const ViewValues depth = measure_view(renderer, settings, StructureView::depth);
  EXPECT_NEAR(depth.least, 5.0, 1e-4);
  EXPECT_NEAR(depth.most, 5.0, 1e-4);
  EXPECT_EQ(depth.counted, triangles.counted);
}

TEST(StructureView, FlatNormalsAreOneAPolygonAndFaceTheEyeOnBackSides) {
  scene::testing::SceneBuilder builder;
  scene::Material material = scene::testing::matte({1, 1, 1});
  material.double_sided = true;
  builder.add_mesh_node(scene::testing::square(builder.add_material(material)));
  scene::SceneRenderer renderer(builder.scene);
  for (const float z : {5.0f, -5.0f}) {
    for (const ShadeModel shading : kModes) {
      RenderSettings settings = scene::testing::front_view();
      settings.camera.position = glm::vec3(0, 0, z);
      settings.shading = shading;
      const ViewValues normals = measure_view(renderer, settings, StructureView::normals);
      const auto& n = normals.normals[static_cast<std::size_t>(settings.width * settings.height / 2 + 32)];
      EXPECT_NEAR(n[2], 1.0f, 1e-6f) << z;
    }
  }
}

TEST(StructureView, MipLevelsFollowTheDistance) {
  const scene::Scene scene = model("checker_ground.glb");
  scene::SceneRenderer renderer(scene);
  const RenderSettings settings = small_frame(ShadeModel::phong);
  const ViewValues levels = measure_view(renderer, settings, StructureView::mip_level);
  const auto column = [&](int y) { return levels.values[static_cast<std::size_t>(y * settings.width + 90)]; };
  EXPECT_LT(column(settings.height - 1), column(settings.height * 2 / 3));
  EXPECT_GT(levels.most, 2.0);
}

TEST(StructureView, TexelDensityIsWhatMipLevelsAreChosenBy) {
  const scene::Scene scene = model("checker_ground.glb");
  scene::SceneRenderer renderer(scene);
  RenderSettings settings = small_frame(ShadeModel::phong);
  settings.min_filter = raster::MinFilter::linear_mipmap_linear;
  const ViewValues levels = measure_view(renderer, settings, StructureView::mip_level);
  const ViewValues density = measure_view(renderer, settings, StructureView::texel_density);
  EXPECT_EQ(density.counted, levels.counted);
  for (std::size_t i = 0; i < levels.values.size(); ++i) {
    if (levels.values[i] > 0.0f && levels.values[i] < 5.0f) {
      EXPECT_NEAR(levels.values[i], density.values[i], 1.0f / 256.0f);
    }
  }
}

/// A plane over the ball: s grows to the right in red, t downwards in green.
TEST(StructureView, CoordinatesAreThoseOfTheMapping) {
  const scene::Scene scene = model("sphere.glb");
  scene::SceneRenderer renderer(scene);
  RenderSettings settings = small_frame(ShadeModel::phong);
  settings.texture.solid = scene::standard_solid(raster::PatternKind::checker);
  settings.texture.solid->space = scene::SolidTexture::Space::surface;
  settings.texture.solid->scale = 1.0f;
  settings.texture.mapping.emplace();
  settings.texture.mapping->surface = raster::MappingSurface::planar;
  settings.texture.mapping->axis = {0, 0, 1};
  const ViewValues view = measure_view(renderer, settings, StructureView::coordinates);
  const auto color = [&](int dx, int dy) {
    const auto index =
        static_cast<std::size_t>((settings.height / 2 + dy) * settings.width + settings.width / 2 + dx);
    return view.colors[index];
  };
  const int reach = settings.height / 6;
  const auto red = [](std::uint32_t c) { return static_cast<int>(c & 255); };
  const auto green = [](std::uint32_t c) { return static_cast<int>(c >> 8 & 255); };
  EXPECT_NEAR(red(color(0, 0)), 128, 12);
  EXPECT_NEAR(green(color(0, 0)), 128, 12);
  EXPECT_GT(red(color(reach, 0)), red(color(0, 0)) + 20);
  EXPECT_GT(green(color(0, reach)), green(color(0, 0)) + 20);
  settings.texture = {};
  const ViewValues nothing = measure_view(renderer, settings, StructureView::coordinates);
  EXPECT_EQ(nothing.counted, 0u);
}

std::vector<std::uint32_t> drawn(scene::SceneRenderer& renderer, const RenderSettings& settings) {
  const raster::Framebuffer frame = renderer.render(settings);
  return {frame.color8().begin(), frame.color8().end()};
}

TEST(StructureView, MipColorsReplacePicturesOnly) {
  const scene::Scene textured = model("checker_ground.glb");
  scene::SceneRenderer renderer(textured);
  const RenderSettings settings = small_frame(ShadeModel::phong);
  EXPECT_NE(measure_view(renderer, settings, StructureView::mip_colors).colors, drawn(renderer, settings));
  const scene::Scene plain = model("teapot.glb");
  scene::SceneRenderer plain_renderer(plain);
  EXPECT_EQ(measure_view(plain_renderer, settings, StructureView::mip_colors).colors,
            drawn(plain_renderer, settings));
}

ViewValues second_derivative(const std::vector<float>& row) {
  raster::FramebufferOptions options;
  options.width = static_cast<int>(row.size());
  options.height = 3;
  options.format = raster::ColorFormat::rgba32f;
  options.keep_float = true;
  raster::Framebuffer frame(options);
  for (std::size_t i = 0; i < frame.color_float().size(); ++i) {
    frame.color_float()[i] = row[i / 4 % row.size()];
  }
  ViewValues values;
  values.values.resize(row.size() * 3);
  differentiate(frame, values);
  return values;
}

TEST(MachBands, OnlyWhereTheSlopeChanges) {
  const ViewValues ramp = second_derivative({0.2f, 0.2f, 0.2f, 0.3f, 0.4f, 0.5f, 0.5f, 0.5f});
  const float expected[] = {0, 0, 25.5f, 0, 0, -25.5f, 0, 0};
  for (std::size_t x = 0; x < 8; ++x) EXPECT_NEAR(ramp.values[8 + x], expected[x], 1e-3f) << x;
}

/// CIE lightness by its definition.
double lightness(const Rgb8& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  const double y =
      0.2126 * linear(c[0] / 255.0) + 0.7152 * linear(c[1] / 255.0) + 0.0722 * linear(c[2] / 255.0);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(ViewColors, LightnessGrowsSteadily) {
  for (int i = 0; i < 16; ++i) {
    const double step = lightness(ordered_color((i + 1) / 16.0)) - lightness(ordered_color(i / 16.0));
    EXPECT_GT(step, 2.0) << i;
    EXPECT_LT(step, 9.0) << i;
    for (const double side : {-1.0, 1.0}) {
      EXPECT_GT(lightness(signed_color(side * (i + 1) / 16.0)), lightness(signed_color(side * i / 16.0)))
          << i << " " << side;
    }
  }
  EXPECT_EQ(signed_color(0.0), signed_color(-0.0));
  EXPECT_EQ(ordered_color(std::nan("")), ordered_color(0.0));
  EXPECT_EQ(ordered_color(7.0), ordered_color(1.0));
}

TEST(ViewPicture, LegendStandsBelowAndMovesNothing) {
  const scene::Scene scene = model("teapot.glb");
  scene::SceneRenderer renderer(scene);
  const RenderSettings settings = small_frame(ShadeModel::gouraud);
  for (int i = 0; i < kStructureViewCount; ++i) {
    const auto view = static_cast<StructureView>(i);
    EXPECT_FALSE(description_of(view).empty());
    const ViewValues values = measure_view(renderer, settings, view);
    const raster::Framebuffer plain = sheet::view_picture(values, false);
    const raster::Framebuffer with = sheet::view_picture(values, true);
    EXPECT_EQ(plain.height(), settings.height);
    EXPECT_EQ(with.height(), settings.height + sheet::legend_height(settings.width));
    EXPECT_TRUE(std::equal(plain.color8().begin(), plain.color8().end(), with.color8().begin()));
    const std::size_t legend = plain.color8().size();
    EXPECT_TRUE(std::any_of(with.color8().begin() + static_cast<std::ptrdiff_t>(legend), with.color8().end(),
                            [&](std::uint32_t c) { return c != with.color8()[legend]; }));
  }
}

TEST(ViewPicture, ExtremesHaveTheEndsOfTheScale) {
  ViewValues values;
  values.view = StructureView::overdraw;
  values.most = 4.0;
  EXPECT_EQ(color_of(values, 0.0f), ordered_color(0.0));
  EXPECT_EQ(color_of(values, 4.0f), ordered_color(1.0));
  EXPECT_EQ(color_of(values, std::nanf("")), kNothingColor);
}

TEST(ViewPicture, SmallFramesAndFramesWithoutRoomForALegend) {
  const scene::Scene scene = model("sphere.glb");
  scene::SceneRenderer renderer(scene);
  RenderSettings settings = small_frame(ShadeModel::flat);
  settings.width = settings.height = 1;
  EXPECT_EQ(sheet::draw_view(renderer, settings, StructureView::overdraw).height(),
            1 + sheet::legend_height(1));
  settings.height = raster::kMaxFrameSide;
  EXPECT_EQ(sheet::draw_view(renderer, settings, StructureView::overdraw).height(), raster::kMaxFrameSide);
}

}  // namespace
}  // namespace barrido::inspect
