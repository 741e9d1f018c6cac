// KHR_animation_pointer: what each pointer moves, and what becomes of pointers that lead nowhere.
#include "import_support.h"
#include "pipeline/scene/animate.h"
#include "pipeline/scene/moving_properties.h"

namespace barrido::scene::test {
namespace {

/// A material, a spot light and a camera of each kind, and one channel from `from` to `to` in a second.
Model pointing(const std::string& pointer, const std::vector<float>& from, const std::vector<float>& to) {
  Model model = triangle();
  model.document["materials"] = {
      {{"emissiveFactor", {0.5, 0.25, 1.0}},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4.0}}}}},
       {"pbrMetallicRoughness",
        {{"baseColorTexture",
          {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2.0, 3.0}}}}}}}}}}}};
  model.document["textures"] = {{{"source", 0}}};
  model.document["images"] = {{{"uri", "none.png"}}};
  model.document["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"zfar", 10.0}}}},
      {{"type", "orthographic"},
       {"orthographic", {{"xmag", 1.0}, {"ymag", 1.0}, {"znear", 0.1}, {"zfar", 10.0}}}}};
  model.document["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}}};
  model.document["extensionsUsed"] = {"KHR_animation_pointer", "KHR_lights_punctual", "KHR_texture_transform",
                                      "KHR_materials_emissive_strength"};
  const int times = model.add_accessor(model.add_view(std::vector<float>{0, 1}), kF32, "SCALAR", 2);
  std::vector<float> values = from;
  values.insert(values.end(), to.begin(), to.end());
  const char* const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  const int output = model.add_accessor(model.add_view(values), kF32, types[from.size() - 1], 2);
  model.document["animations"] = {
      {{"samplers", {{{"input", times}, {"output", output}}}},
       {"channels",
        {{{"sampler", 0},
          {"target",
           {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}}}}}}};
  return model;
}

/// The scene's properties at a quarter of the way.
Scene moved_at_a_quarter(const Model& model) {
  const Scene scene = model.import();
  EXPECT_TRUE(has_moving_properties(scene));
  Scene moved = copy_without_pictures(scene);
  move_properties(scene, 0, 0.25, moved);
  return moved;
}

TEST(AnimationPointer, Colours) {
  const Scene scene = moved_at_a_quarter(
      pointing("/materials/0/pbrMetallicRoughness/baseColorFactor", {0, 0, 1, 1}, {1, 0, 0, 0}));
  EXPECT_EQ(scene.materials[0].base_color, glm::vec4(0.25f, 0, 0.75f, 0.75f));
}

TEST(AnimationPointer, EmissionKeepsTheOtherFactor) {
  EXPECT_EQ(
      moved_at_a_quarter(pointing("/materials/0/emissiveFactor", {0, 0, 0}, {1, 1, 1})).materials[0].emissive,
      glm::vec3(1.0f));
  EXPECT_EQ(
      moved_at_a_quarter(
          pointing("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", {0}, {8}))
          .materials[0]
          .emissive,
      glm::vec3(1.0f, 0.5f, 2.0f));
}

TEST(AnimationPointer, TextureTransformsKeepTheirOtherParts) {
  const std::string place =
      "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/";
  const glm::mat3 offset = moved_at_a_quarter(pointing(place + "offset", {0, 0}, {4, 8}))
                               .materials[0]
                               .base_color_texture.transform;
  EXPECT_EQ(offset * glm::vec3(1, 1, 1), glm::vec3(3, 5, 1));
  const glm::mat3 scale =
      moved_at_a_quarter(pointing(place + "scale", {2, 3}, {6, 3})).materials[0].base_color_texture.transform;
  EXPECT_EQ(scale * glm::vec3(1, 1, 1), glm::vec3(3, 3, 1));
  const glm::vec3 turned = moved_at_a_quarter(pointing(place + "rotation", {0}, {6.2831853f}))
                               .materials[0]
                               .base_color_texture.transform *
                           glm::vec3(1, 0, 1);
  EXPECT_NEAR(turned.x, 0, 1e-6);
  EXPECT_NEAR(turned.y, -2, 1e-6);  // a quarter turn counter-clockwise, with v pointing down
}

TEST(AnimationPointer, Lights) {
  const std::string light = "/extensions/KHR_lights_punctual/lights/0/";
  EXPECT_EQ(moved_at_a_quarter(pointing(light + "color", {0, 0, 0}, {1, 2, 4})).lights[0].color,
            glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_EQ(moved_at_a_quarter(pointing(light + "intensity", {0}, {-4})).lights[0].intensity, 0.0f);
  EXPECT_EQ(moved_at_a_quarter(pointing(light + "range", {0}, {4})).lights[0].range, 1.0f);
  const Light narrow = moved_at_a_quarter(pointing(light + "spot/outerConeAngle", {0.1f}, {0.1f})).lights[0];
  EXPECT_EQ(narrow.outer_cone_rad, 0.1f);
  EXPECT_EQ(narrow.inner_cone_rad, 0.1f) << "an inner cone is never the wider one";
}

TEST(AnimationPointer, Cameras) {
  EXPECT_EQ(moved_at_a_quarter(pointing("/cameras/0/perspective/yfov", {0}, {1})).cameras[0].vertical_fov_rad,
            0.25f);
  EXPECT_EQ(moved_at_a_quarter(pointing("/cameras/1/orthographic/ymag", {1}, {5})).cameras[1].half_height,
            2.0f);
  const Camera far = moved_at_a_quarter(pointing("/cameras/0/perspective/zfar", {0}, {0.01f})).cameras[0];
  EXPECT_GT(far.far_plane, far.near_plane);
}

TEST(AnimationPointer, NodesMoveAsInTheCore) {
  const Scene scene = pointing("/nodes/0/translation", {0, 0, 0}, {4, 0, 0}).import();
  EXPECT_FALSE(has_moving_properties(scene));
  ASSERT_EQ(scene.animations[0].channels.size(), 1u);
  EXPECT_EQ(pose_at(scene, 0, 0.25).world_from_node[0][3].x, 1.0f);
}

TEST(AnimationPointer, WithoutAnAnimationAllIsAsInTheFile) {
  const Scene scene = pointing("/materials/0/emissiveFactor", {0, 0, 0}, {1, 1, 1}).import();
  Scene moved = copy_without_pictures(scene);
  move_properties(scene, 0, 0.25, moved);
  move_properties(scene, kNone, 0.25, moved);
  EXPECT_EQ(moved.materials[0].emissive, glm::vec3(2, 1, 4));
}

TEST(AnimationPointer, WhatLeadsNowhereIsLeftOutWithAWarning) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"/materials/0/normalTexture/scale", "animation of \"/materials/0/normalTexture/scale\" is not"},
      {"/materials/1/alphaCutoff", "\"/materials/1/alphaCutoff\": there are 1; this channel is left out"},
      {"/materials/-1/alphaCutoff", "is not supported"},
      {"/materials/99999999999/alphaCutoff", "is not supported"},
      {"/materials/0/alphaCutoff/", "is not supported"},
      {"/materials//alphaCutoff", "is not supported"},
      {"/cameras/7/perspective/yfov", "there are 2"},
      {"/nodes/7/scale", "names nodes[7], but there are 1"},
      {"", "is not supported"}};
  for (const auto& [pointer, words] : cases) {
    const Scene scene = pointing(pointer, {0}, {1}).import();
    EXPECT_FALSE(has_moving_properties(scene)) << pointer;
    bool found = false;
    for (const std::string& warning : scene.warnings)
      found = found || warning.find(words) != std::string::npos;
    EXPECT_TRUE(found) << pointer << ": " << (scene.warnings.empty() ? "" : scene.warnings.back());
  }
}

TEST(AnimationPointer, ValuesOfTheWrongShapeAreLeftOut) {
  const Scene scene = pointing("/materials/0/emissiveFactor", {0}, {1}).import();
  EXPECT_FALSE(has_moving_properties(scene));
}

}  // namespace
}  // namespace barrido::scene::test
