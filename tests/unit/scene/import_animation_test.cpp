// Animations and skins out of files, and poses and deformed vertices made of them.
#include <cmath>
#include <numbers>

#include <oneapi/tbb/global_control.h>

#include "import_support.h"
#include "pipeline/scene/animate.h"

namespace barrido::scene::test {
namespace {

constexpr float kHalf = static_cast<float>(std::numbers::sqrt2 / 2);

/// One node and one channel that moves it; the key times are 1, 2 and 4 seconds.
Model animated(const char* path, const char* interpolation, const char* type,
               const std::vector<float>& output) {
  Model model = triangle();
  const int times = model.add_accessor(model.add_view(std::vector<float>{1, 2, 4}), kF32, "SCALAR", 3);
  const std::size_t components = std::string(type) == "VEC4" ? 4 : std::string(type) == "VEC3" ? 3 : 1;
  const int values = model.add_accessor(model.add_view(output), kF32, type, output.size() / components);
  model.document["animations"] = {
      {{"samplers", {{{"input", times}, {"output", values}, {"interpolation", interpolation}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}}};
  return model;
}

glm::vec3 translation_at(const Scene& scene, double time_s) {
  return glm::vec3(pose_at(scene, 0, time_s).world_from_node[0][3]);
}

TEST(Animate, LinearTranslationIsClampedAtItsEnds) {
  const Scene scene = animated("translation", "LINEAR", "VEC3", {0, 0, 0, 4, 0, 0, 4, 8, 0}).import();
  EXPECT_EQ(scene.animations[0].duration_s, 4.0f);
  EXPECT_EQ(translation_at(scene, -1), glm::vec3(0, 0, 0));
  EXPECT_EQ(translation_at(scene, 1), glm::vec3(0, 0, 0));
  EXPECT_EQ(translation_at(scene, 1.25), glm::vec3(1, 0, 0));
  EXPECT_EQ(translation_at(scene, 2), glm::vec3(4, 0, 0));
  EXPECT_EQ(translation_at(scene, 3), glm::vec3(4, 4, 0));
  EXPECT_EQ(translation_at(scene, 100), glm::vec3(4, 8, 0));
  EXPECT_EQ(translation_at(scene, std::nan("")), glm::vec3(0, 0, 0));
}

TEST(Animate, WithoutAnAnimationTheSceneStands) {
  const Scene scene = animated("translation", "LINEAR", "VEC3", std::vector<float>(9, 5.0f)).import();
  EXPECT_EQ(pose_at(scene, kNone, 2).world_from_node[0], glm::mat4(1.0f));
  EXPECT_THROW(pose_at(scene, 1, 0), std::out_of_range);
}

TEST(Animate, StepKeepsTheEarlierKey) {
  const Scene scene = animated("scale", "STEP", "VEC3", {1, 1, 1, 2, 2, 2, 3, 3, 3}).import();
  EXPECT_EQ(pose_at(scene, 0, 1.99).world_from_node[0][0].x, 1.0f);
  EXPECT_EQ(pose_at(scene, 0, 2).world_from_node[0][0].x, 2.0f);
  EXPECT_EQ(pose_at(scene, 0, 3.99).world_from_node[0][0].x, 2.0f);
  EXPECT_EQ(pose_at(scene, 0, 4).world_from_node[0][0].x, 3.0f);
}

TEST(Animate, CubicSplineAgainstItsFormula) {
  // A key: in-tangent, point, out-tangent. From key 1 (2 s) to key 2 (4 s) the duration is 2 s.
  const std::vector<float> keys = {0, 0, 0, 0, 0, 0, 0,  0, 0,  //
                                   0, 0, 0, 1, 0, 0, 3,  0, 0,  //
                                   5, 0, 0, 7, 0, 0, 99, 0, 0};
  const Scene scene = animated("translation", "CUBICSPLINE", "VEC3", keys).import();
  const double t = 0.25;
  const double expected = (2 * t * t * t - 3 * t * t + 1) * 1 + 2 * (t * t * t - 2 * t * t + t) * 3 +
                          (-2 * t * t * t + 3 * t * t) * 7 + 2 * (t * t * t - t * t) * 5;
  EXPECT_NEAR(translation_at(scene, 2.5).x, expected, 1e-5);
  EXPECT_EQ(translation_at(scene, 2).x, 1.0f);
  EXPECT_EQ(translation_at(scene, 4).x, 7.0f);
  EXPECT_EQ(translation_at(scene, 9).x, 7.0f);
}

TEST(Animate, RotationFollowsTheShorterArcAtEvenSpeed) {
  // 0, 90 degrees about z, and the same again written with the other sign.
  const std::vector<float> keys = {0, 0, 0, 1, 0, 0, kHalf, kHalf, 0, 0, -kHalf, -kHalf};
  const Scene scene = animated("rotation", "LINEAR", "VEC4", keys).import();
  for (const double fraction : {0.0, 0.1, 1.0 / 3.0, 0.5, 0.9, 1.0}) {
    const glm::mat4 matrix = pose_at(scene, 0, 1 + fraction).world_from_node[0];
    const double angle = fraction * std::numbers::pi / 2;
    EXPECT_NEAR(matrix[0].x, std::cos(angle), 1e-6) << fraction;
    EXPECT_NEAR(matrix[0].y, std::sin(angle), 1e-6) << fraction;
  }
  EXPECT_NEAR(pose_at(scene, 0, 3).world_from_node[0][0].y, 1.0f, 1e-6f);
}

TEST(Animate, RotationsAsNormalizedIntegers) {
  Model model = animated("rotation", "LINEAR", "VEC4", std::vector<float>(12));
  const std::vector<std::int16_t> keys = {0, 0, 0, 32767, 0, 0, 23170, 23170, 0, 0, 32767, 0};
  model.document["animations"][0]["samplers"][0]["output"] =
      model.add_accessor(model.add_view(keys), kI16, "VEC4", 3, true);
  const glm::mat4 matrix = pose_at(model.import(), 0, 2).world_from_node[0];
  EXPECT_NEAR(matrix[0].y, 1.0f, 1e-4f);
}

TEST(Animate, MorphWeights) {
  Model model = animated("weights", "LINEAR", "SCALAR", {0, 1, 1, 0, 1, 0});
  const int moved =
      model.add_accessor(model.add_view(std::vector<float>{1, 0, 0, 1, 0, 0, 1, 0, 0}), kF32, "VEC3", 3);
  const int lifted =
      model.add_accessor(model.add_view(std::vector<float>{0, 2, 0, 0, 2, 0, 0, 2, 0}), kF32, "VEC3", 3);
  primitive(model)["targets"] = {{{"POSITION", moved}}, {{"POSITION", lifted}}};
  const Scene scene = model.import();
  const Pose pose = pose_at(scene, 0, 1.25);
  EXPECT_EQ(pose.morph_weights[0], (std::vector<float>{0.25f, 0.75f}));
  const Primitive& first = scene.meshes[0].primitives[0];
  EXPECT_TRUE(is_deformed(scene, 0, first));
  const DeformedVertices vertices = deform(scene, pose, 0, first);
  EXPECT_EQ(vertices.positions, (std::vector<float>{0.25f, 1.5f, 0, 1.25f, 1.5f, 0, 0.25f, 2.5f, 0}));
  EXPECT_FALSE(vertices.in_world_space);
  EXPECT_TRUE(vertices.normals.empty());
}

TEST(Animate, ChannelsThatMoveNothingAreWarnings) {
  Model weights = animated("weights", "LINEAR", "SCALAR", {0, 0, 0});
  EXPECT_EQ(weights.import().warnings.size(), 1u);
  Model unknown = animated("pointer", "LINEAR", "SCALAR", {0, 0, 0});
  EXPECT_EQ(unknown.import().warnings.size(), 1u);
  Model matrix = animated("scale", "LINEAR", "VEC3", std::vector<float>(9));
  matrix.document["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const Scene scene = matrix.import();
  EXPECT_EQ(scene.warnings.size(), 1u);
  EXPECT_TRUE(scene.animations[0].channels.empty());
}

TEST(Animate, ChannelsWithBadKeysAreLeftOut) {
  const auto warning = [](const Model& model) {
    const Scene scene = model.import();
    EXPECT_TRUE(scene.animations[0].channels.empty());
    return scene.warnings.size() == 1 ? scene.warnings[0] : std::string();
  };
  EXPECT_CONTAINS(warning(animated("translation", "LINEAR", "VEC3", std::vector<float>(6))),
                  "animations[0].samplers[0].output: accessors[3] has 2 elements where 3 are due");
  EXPECT_CONTAINS(warning(animated("translation", "CUBICSPLINE", "VEC3", std::vector<float>(9))),
                  "has 3 elements where 9 are due");
  EXPECT_CONTAINS(warning(animated("rotation", "LINEAR", "VEC3", std::vector<float>(9))),
                  "output: accessors[3] with 3 components");
  Model model = animated("scale", "LINEAR", "VEC3", std::vector<float>(9));
  model.document["animations"][0]["samplers"][0]["input"] =
      model.add_accessor(model.add_view(std::vector<float>{1, 3, 2}), kF32, "SCALAR", 3);
  EXPECT_CONTAINS(warning(model), "samplers[0].input: the times of an animation must ascend");
}

TEST(Pose, TranslationsOfMapsCancelBeforeTheyAreRounded) {
  Model model = triangle();
  model.document["nodes"] = {{{"mesh", 0}, {"translation", {0.25, 0, 0}}},
                             {{"mesh", 0}, {"translation", {4.5, 0.125, 0}}},
                             {{"translation", {450000.5, 5600000, 0}}, {"children", {0, 1}}}};
  const Scene scene = model.import();
  const Pose pose = pose_at(scene, kNone, 0);
  EXPECT_EQ(pose.world_from_node[1][3] - pose.world_from_node[0][3], glm::vec4(4.25f, 0.125f, 0, 0));
  EXPECT_EQ(file_world_from_node(pose, 1)[3], glm::dvec4(450005.0, 5600000.125, 0, 1));
  EXPECT_LT(std::abs(pose.world_from_node[0][3].x), 4.0f);

  model.document["nodes"][2]["translation"] = {1e9, 0, 0};
  model.document["nodes"][0]["translation"] = {0.25 - 1e9, 0, 0};
  model.document["nodes"][1]["translation"] = {0.5 - 1e9, 0, 0};
  const Pose back = pose_at(model.import(), kNone, 0);
  EXPECT_EQ(back.origin, glm::dvec3(0.0)) << "what is near needs none";
  EXPECT_EQ(back.world_from_node[0][3].x, 0.25f);
  EXPECT_EQ(back.world_from_node[1][3].x, 0.5f);
}

TEST(Deform, ColoursAndTextureCoordinatesAreMorphedToo) {
  Model model = triangle();
  const auto add = [&](const std::vector<float>& numbers, const char* type) {
    return model.add_accessor(model.add_view(numbers), kF32, type, 3);
  };
  primitive(model)["attributes"]["COLOR_0"] = add(std::vector<float>(9, 0.25f), "VEC3");
  primitive(model)["attributes"]["TEXCOORD_0"] = add(std::vector<float>(6, 0.0f), "VEC2");
  primitive(model)["targets"] = {{{"COLOR_0", add({1, 0, 0, 0, 1, 0, 0, 0, -1}, "VEC3")},
                                  {"TEXCOORD_0", add({1, 2, 3, 4, 5, 6}, "VEC2")}}};
  model.document["meshes"][0]["weights"] = {0.5};
  const Scene scene = model.import();
  const DeformedVertices vertices = deform(scene, pose_at(scene, kNone, 0), 0, scene.meshes[0].primitives[0]);
  EXPECT_EQ(vertices.colors,
            (std::vector<float>{0.75f, 0.25f, 0.25f, 1, 0.25f, 0.75f, 0.25f, 1, 0.25f, 0.25f, 0, 1}));
  EXPECT_EQ(vertices.texcoords[0], (std::vector<float>{0.5f, 1, 1.5f, 2, 2.5f, 3}));
  EXPECT_TRUE(vertices.texcoords[1].empty());
}

TEST(Pose, ParentsMayComeAfterTheirChildren) {
  Model model;
  model.document["nodes"] = {
      {{"translation", {1, 0, 0}}},
      {{"rotation", {0, 0, kHalf, kHalf}}, {"translation", {0, 0, 5}}, {"children", {0}}},
      {{"scale", {2, 2, 2}}, {"children", {1}}}};
  const Pose pose = pose_at(model.import(), kNone, 0);
  const glm::vec4 origin = pose.world_from_node[0][3];
  EXPECT_NEAR(origin.x, 0.0f, 1e-6f);
  EXPECT_NEAR(origin.y, 2.0f, 1e-6f);
  EXPECT_NEAR(origin.z, 10.0f, 1e-6f);
}

/// The triangle hung on two joints: nodes 1 (moved by x + 10) and 2 (stretched by 2 along x and by 3
/// along z, then turned by 90 degrees about z).
Model skinned() {
  Model model = triangle();
  const auto add = [&](const char* name, const auto& numbers, int component_type, const char* type) {
    primitive(model)["attributes"][name] =
        model.add_accessor(model.add_view(numbers), component_type, type, 3);
  };
  add("JOINTS_0", std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, kU8, "VEC4");
  add("WEIGHTS_0", std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, kF32, "VEC4");
  add("NORMAL", std::vector<float>{1, 0, 0, kHalf, 0, kHalf, 0, 0, 1}, kF32, "VEC3");
  const std::vector<float> bind = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,  //
                                   1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1};
  const int matrices = model.add_accessor(model.add_view(bind), kF32, "MAT4", 2);
  model.document["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}};
  model.document["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {99, 99, 99}}},
                             {{"translation", {10, 0, 0}}},
                             {{"rotation", {0, 0, kHalf, kHalf}}, {"scale", {2, 1, 3}}}};
  return model;
}

void expect_near(const std::vector<float>& values, const std::vector<float>& expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-5f) << i;
}

TEST(Skin, CarriesVerticesIntoTheWorldWhateverTheNodesTransform) {
  const Scene scene = skinned().import();
  const Primitive& primitive = scene.meshes[0].primitives[0];
  EXPECT_TRUE(is_deformed(scene, 0, primitive));
  const DeformedVertices vertices = deform(scene, pose_at(scene, kNone, 0), 0, primitive);
  EXPECT_TRUE(vertices.in_world_space);
  // (0,0,0) + 10; (2,0,0) stretched and turned; the mean of (10,1,0) and of (2,1,0), stretched, turned.
  expect_near(vertices.positions, {10, 0, 0, 0, 4, 0, 4.5f, 1.5f, 0});
  // Normals shrink where surfaces stretch: (1, 0, 1) becomes (1/2, 0, 1/3), then turns.
  const float length = std::sqrt(13.0f);
  expect_near(vertices.normals, {1, 0, 0, 0, 3 / length, 2 / length, 0, 0, 1});
}

TEST(Skin, MirroredJointTurnsNormalsWithTheSurface) {
  Model model = skinned();
  model.document["nodes"][1]["scale"] = {-1, 1, 1};
  const Scene scene = model.import();
  const DeformedVertices vertices = deform(scene, pose_at(scene, kNone, 0), 0, scene.meshes[0].primitives[0]);
  expect_near({vertices.normals.begin(), vertices.normals.begin() + 3}, {-1, 0, 0});
}

TEST(Skin, SameMeshWithoutASkinIsNotDeformed) {
  Model model = skinned();
  model.document["nodes"][0].erase("skin");
  const Scene scene = model.import();
  EXPECT_FALSE(is_deformed(scene, 0, scene.meshes[0].primitives[0]));
}

TEST(Skin, BadSkinsAreErrors) {
  Model joints = skinned();
  joints.document["skins"][0]["joints"] = {1};
  EXPECT_CONTAINS(import_error(joints), "nodes[0]: meshes[0] names joint 1, but skins[0] has only 1");
  Model matrices = skinned();
  matrices.document["skins"][0]["joints"] = {1, 2, 1};
  EXPECT_CONTAINS(import_error(matrices), "skins[0].inverseBindMatrices: there are 2 matrices for 3 joints");
  Model format = skinned();
  format.document["skins"][0]["inverseBindMatrices"] = 0;
  EXPECT_CONTAINS(import_error(format), "inverseBindMatrices: accessors[0] with 3 components");
}

TEST(Skin, MatricesMayBeAbsent) {
  Model model = skinned();
  model.document["skins"][0].erase("inverseBindMatrices");
  EXPECT_EQ(model.import().skins[0].inverse_bind_matrices, std::vector<glm::mat4>(2, glm::mat4(1.0f)));
}

TEST(Skin, SameBitsForEveryNumberOfThreads) {
  Model model = skinned();
  constexpr std::size_t kCount = 10000;
  std::vector<float> positions(3 * kCount), weights;
  std::vector<std::uint8_t> joints;
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = std::sqrt(static_cast<float>(i));
  for (std::size_t i = 0; i < kCount; ++i) {
    const float first = static_cast<float>(i % 7) / 7.0f;
    weights.insert(weights.end(), {first, 1.0f - first, 0, 0});
    joints.insert(joints.end(), {0, 1, 0, 0});
  }
  json& attributes = primitive(model)["attributes"];
  attributes["POSITION"] = attributes["NORMAL"] =
      model.add_accessor(model.add_view(positions), kF32, "VEC3", kCount);
  attributes["WEIGHTS_0"] = model.add_accessor(model.add_view(weights), kF32, "VEC4", kCount);
  attributes["JOINTS_0"] = model.add_accessor(model.add_view(joints), kU8, "VEC4", kCount);
  const Scene scene = model.import();
  const Pose pose = pose_at(scene, kNone, 0);
  const auto deformed = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return deform(scene, pose, 0, scene.meshes[0].primitives[0]);
  };
  const DeformedVertices one = deformed(1), four = deformed(4);
  EXPECT_EQ(one.positions, four.positions);
  EXPECT_EQ(one.normals, four.normals);
}

}  // namespace
}  // namespace barrido::scene::test
