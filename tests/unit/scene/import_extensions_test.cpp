// Extensions of nodes, primitives and textures: instances, variants, pictures in other formats.
#include "import_support.h"
#include "pipeline/scene/animate.h"
#include "pipeline/scene/scene_nodes.h"

namespace barrido::scene::test {
namespace {

Model with_instances() {
  Model model = triangle();
  const int translations =
      model.add_accessor(model.add_view(std::vector<float>{1, 0, 0, 0, 2, 0, 0, 0, 3}), kF32, "VEC3", 3);
  const int scales =
      model.add_accessor(model.add_view(std::vector<float>{1, 1, 1, 2, 2, 2, 3, 3, 3}), kF32, "VEC3", 3);
  model.document["nodes"][0]["translation"] = {10, 0, 0};
  model.document["nodes"][0]["name"] = "leaf";
  model.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", translations}, {"SCALE", scales}};
  model.document["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  return model;
}

TEST(Instances, AreNodesBelowTheirs) {
  const Scene scene = with_instances().import();
  ASSERT_EQ(scene.nodes.size(), 4u);
  EXPECT_EQ(scene.nodes[0].mesh, kNone);
  const Pose pose = pose_at(scene, kNone, 0.0);
  EXPECT_EQ(glm::vec3(pose.world_from_node[1][3]), glm::vec3(11, 0, 0));
  EXPECT_EQ(glm::vec3(pose.world_from_node[3][3]), glm::vec3(10, 0, 3));
  EXPECT_EQ(static_cast<float>(pose.world_from_node[3][0].x), 3.0f);
  EXPECT_EQ(scene.nodes[2].name, "leaf[1]");
  EXPECT_EQ(nodes_of_scene(scene, 0).size(), 4u);
}

TEST(Instances, ThatLieAreRefused) {
  const auto error = [](const char* attribute, const json& value) {
    Model model = with_instances();
    model.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"][attribute] = value;
    return import_error(model);
  };
  EXPECT_CONTAINS(error("SCALE", 99), "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.SCALE: ");
  EXPECT_CONTAINS(error("SCALE", -1), "must be the number of an accessor");
  EXPECT_CONTAINS(error("SCALE", 1), "is not allowed here");
  Model many = with_instances();
  const int zeros = many.add_accessor(-1, kF32, "VEC3", 50'000'000);
  many.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", zeros}};
  EXPECT_CONTAINS(import_error(many), "of memory");
}

Model with_variants() {
  Model model = triangle();
  model.document["materials"] = {{{"name", "a"}}, {{"name", "b"}}, {{"name", "c"}}};
  model.document["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "day"}},
                                                                        {{"name", "night"}}};
  primitive(model)["material"] = 0;
  primitive(model)["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 1}, {"variants", {0}}}, {{"material", 2}, {"variants", {1}}}};
  model.document["extensionsUsed"] = {"KHR_materials_variants"};
  return model;
}

TEST(Variants, GivePrimitivesOtherMaterials) {
  const Scene scene = with_variants().import();
  EXPECT_EQ(scene.variants, (std::vector<std::string>{"day", "night"}));
  EXPECT_EQ(scene.meshes[0].primitives[0].variant_materials, (std::map<int, int>{{0, 1}, {1, 2}}));
  EXPECT_EQ(resolve_variant(scene, "night"), 1);
  EXPECT_EQ(resolve_variant(scene, ""), kNone);
  EXPECT_CONTAINS(input_error([&] { resolve_variant(scene, "noon"); }),
                  "variant noon: there is no such variant; the file has day, night");
}

TEST(Variants, ThatLieAreRefused) {
  Model model = with_variants();
  primitive(model)["extensions"]["KHR_materials_variants"]["mappings"][0]["material"] = 3;
  EXPECT_CONTAINS(import_error(model), "mappings[0].material");
  model = with_variants();
  primitive(model)["extensions"]["KHR_materials_variants"]["mappings"][1]["variants"] = {2};
  EXPECT_CONTAINS(import_error(model), "mappings[1].variants");
}

const char* const kPng =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAQAAAAECAIAAAAmkwkpAAAAEElEQVR42mM4ESACRwzEcQDzAxLBrjWe+gAAAABJRU5E"
    "rkJggg==";

TEST(Textures, TakeTheirOwnPictureWhereTheExtensionsCannotBeRead) {
  for (const char* name : {"EXT_texture_webp", "KHR_texture_basisu"}) {
    Model model = triangle();
    model.document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    model.document["images"] = {{{"uri", "data:image/webp;base64,UklGRgAAAABXRUJQAAAA"}}, {{"uri", kPng}}};
    model.document["textures"] = {{{"source", 1}, {"extensions", {{name, {{"source", 0}}}}}}};
    model.document["extensionsUsed"] = {name};
    const Scene scene = model.import();
    EXPECT_EQ(scene.textures[0].image, 1);
    EXPECT_EQ(scene.images[1].width, 4);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_CONTAINS(scene.warnings[0], "images[1] is used in its place");
  }
}

}  // namespace
}  // namespace barrido::scene::test
