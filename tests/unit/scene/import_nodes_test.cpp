// The hierarchy of nodes, scenes, cameras and lights.
#include <cmath>

#include "import_support.h"

namespace barrido::scene::test {
namespace {

Model nodes(const json& list) {
  Model model;
  model.document["nodes"] = list;
  return model;
}

TEST(ImportNodes, TransformsAreKeptAsGiven) {
  const Scene scene = nodes({{{"translation", {1, 2, 3}}, {"rotation", {0, 0, 2, 0}}, {"scale", {4, 5, -6}}},
                             {{"matrix", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}}},
                             json::object()})
                          .import();
  EXPECT_EQ(scene.nodes[0].transform.translation, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.nodes[0].transform.rotation, glm::quat(0, 0, 0, 1));  // Made unit length; w first.
  EXPECT_EQ(scene.nodes[0].transform.scale, glm::vec3(4, 5, -6));
  EXPECT_FALSE(scene.nodes[0].transform.matrix);
  ASSERT_TRUE(scene.nodes[1].transform.matrix);
  EXPECT_EQ((*scene.nodes[1].transform.matrix)[3], glm::dvec4(13, 14, 15, 16));  // Column-major.
  EXPECT_EQ(scene.nodes[2].transform.scale, glm::vec3(1, 1, 1));
}

TEST(ImportNodes, ExtremeNumbersStayFinite) {
  const Scene scene = nodes({{{"translation", {1e300, -1e300, 0}}, {"rotation", {1e300, 0, 0, 1e300}}},
                             {{"rotation", {0, 0, 0, 0}}}})
                          .import();
  EXPECT_TRUE(std::isfinite(scene.nodes[0].transform.translation.x));
  EXPECT_NEAR(scene.nodes[0].transform.rotation.x, std::sqrt(0.5f), 1e-7f);
  EXPECT_EQ(scene.nodes[1].transform.rotation, glm::quat(1, 0, 0, 0));
  EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST(ImportNodes, ParentsAreKnown) {
  const Scene scene = nodes({json::object(), {{"children", {0, 2}}}, json::object()}).import();
  EXPECT_EQ(scene.nodes[0].parent, 1);
  EXPECT_EQ(scene.nodes[1].parent, kNone);
  EXPECT_EQ(scene.nodes[1].children, (std::vector<int>{0, 2}));
}

TEST(ImportNodes, TwoParentsAreAnError) {
  EXPECT_CONTAINS(import_error(nodes({{{"children", {2}}}, {{"children", {2}}}, json::object()})),
                  "nodes[2]: is a child of nodes[0] and of nodes[1]");
  EXPECT_CONTAINS(import_error(nodes({{{"children", {1, 1}}}, json::object()})), "nodes[1]: is a child of");
}

TEST(ImportNodes, CyclesAreErrors) {
  EXPECT_CONTAINS(import_error(nodes({{{"children", {0}}}})), "nodes[0]: is part of a cycle");
  EXPECT_CONTAINS(
      import_error(nodes({json::object(), {{"children", {2}}}, {{"children", {3}}}, {{"children", {1}}}})),
      "nodes[1]: is part of a cycle");
}

TEST(ImportNodes, VeryDeepHierarchyNeedsNoStack) {
  json list = json::array();
  constexpr int kDepth = 100000;
  for (int i = 0; i + 1 < kDepth; ++i) list.push_back({{"children", {i + 1}}});
  list.push_back(json::object());
  EXPECT_EQ(nodes(list).import().nodes.back().parent, kDepth - 2);
}

TEST(ImportScenes, SeveralAndTheDefaultOne) {
  Model model = nodes({json::object(), json::object()});
  model.document["scenes"] = {{{"name", "first"}, {"nodes", {0}}}, {{"nodes", {1, 0}}}};
  EXPECT_EQ(model.import().default_scene, 0);
  model.document["scene"] = 1;
  const Scene scene = model.import();
  EXPECT_EQ(scene.default_scene, 1);
  EXPECT_EQ(scene.scenes[0].name, "first");
  EXPECT_EQ(scene.scenes[1].nodes, (std::vector<int>{1, 0}));
}

TEST(ImportScenes, WithoutAnyAllRootsAreDrawn) {
  const Scene scene = nodes({json::object(), {{"children", {0}}}, json::object()}).import();
  ASSERT_EQ(scene.scenes.size(), 1u);
  EXPECT_EQ(scene.scenes[0].nodes, (std::vector<int>{1, 2}));
}

TEST(ImportScenes, NodeWithAParentIsNoRoot) {
  Model model = nodes({{{"children", {1}}}, json::object()});
  model.document["scenes"] = {{{"nodes", {0, 1}}}};
  const Scene scene = model.import();
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_CONTAINS(scene.warnings[0], "scenes[0].nodes: nodes[1] is not a root");
}

Model cameras(const json& list) {
  Model model;
  model.document["cameras"] = list;
  return model;
}

TEST(ImportCameras, PerspectiveFiniteAndInfinite) {
  const Scene scene =
      cameras({{{"type", "perspective"},
                {"perspective", {{"yfov", 0.5}, {"znear", 0.25}, {"zfar", 8}, {"aspectRatio", 2}}}},
               {{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 1}}}}})
          .import();
  EXPECT_EQ(scene.cameras[0].vertical_fov_rad, 0.5f);
  EXPECT_EQ(scene.cameras[0].near_plane, 0.25f);
  EXPECT_EQ(scene.cameras[0].far_plane, 8.0f);
  EXPECT_EQ(scene.cameras[0].aspect, 2.0f);
  EXPECT_EQ(scene.cameras[1].far_plane, 0.0f);
  EXPECT_EQ(scene.cameras[1].aspect, 0.0f);
  EXPECT_LT(scene.cameras[1].vertical_fov_rad, 3.15f);  // Half a turn has no projection.
  EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST(ImportCameras, Orthographic) {
  json camera = {{"type", "orthographic"},
                 {"orthographic", {{"xmag", 2}, {"ymag", -3}, {"znear", 0}, {"zfar", 4}}}};
  const Scene scene = cameras(json::array({camera})).import();
  EXPECT_EQ(scene.cameras[0].kind, Camera::Kind::orthographic);
  EXPECT_EQ(scene.cameras[0].half_width, 2.0f);
  EXPECT_EQ(scene.cameras[0].half_height, 3.0f);
  EXPECT_EQ(scene.cameras[0].far_plane, 4.0f);
  camera["orthographic"]["xmag"] = 0;
  EXPECT_CONTAINS(import_error(cameras(json::array({camera}))),
                  "cameras[0].orthographic: xmag and ymag must not be 0");
}

Scene import_lights(const json& list) {
  Model model;
  model.document["extensionsUsed"] = {"KHR_lights_punctual"};
  model.document["extensions"]["KHR_lights_punctual"]["lights"] = list;
  model.document["nodes"] = {{{"extensions", {{"KHR_lights_punctual", {{"light", list.size() - 1}}}}}}};
  return model.import();
}

TEST(ImportLights, KindsAndDefaults) {
  const Scene scene =
      import_lights({{{"type", "directional"}},
                     {{"type", "point"}, {"color", {0.5, 0.25, 1}}, {"intensity", 30}, {"range", 7}},
                     {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}});
  EXPECT_EQ(scene.lights[0].kind, Light::Kind::directional);
  EXPECT_EQ(scene.lights[0].intensity, 1.0f);
  EXPECT_EQ(scene.lights[0].range, 0.0f);
  EXPECT_EQ(scene.lights[1].kind, Light::Kind::point);
  EXPECT_EQ(scene.lights[1].color, glm::vec3(0.5f, 0.25f, 1));
  EXPECT_EQ(scene.lights[1].intensity, 30.0f);
  EXPECT_EQ(scene.lights[1].range, 7.0f);
  EXPECT_EQ(scene.lights[2].kind, Light::Kind::spot);
  EXPECT_EQ(scene.lights[2].inner_cone_rad, 0.1f);
  EXPECT_EQ(scene.lights[2].outer_cone_rad, 0.2f);
  EXPECT_EQ(scene.nodes[0].light, 2);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(ImportLights, ImpossibleValuesAreBroughtIntoRange) {
  const Scene scene = import_lights({{{"type", "spot"},
                                      {"intensity", -1e30},
                                      {"range", -1},
                                      {"spot", {{"innerConeAngle", 3}, {"outerConeAngle", 2}}}}});
  EXPECT_EQ(scene.lights[0].intensity, 0.0f);
  EXPECT_EQ(scene.lights[0].range, 0.0f);
  EXPECT_LE(scene.lights[0].outer_cone_rad, 1.5708f);
  EXPECT_LE(scene.lights[0].inner_cone_rad, scene.lights[0].outer_cone_rad);
  EXPECT_EQ(scene.warnings.size(), 3u);
}

}  // namespace
}  // namespace barrido::scene::test
