// Materials, textures, samplers, images, and what extras.barrido adds to them.
#include <cmath>

#include "import_support.h"

namespace barrido::scene::test {
namespace {

/// 4 by 4 pixels, RGB.
const char* const kPng =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAQAAAAECAIAAAAmkwkpAAAAEElEQVR42mM4ESACRwzEcQDzAxLBrjWe+gAAAABJRU5E"
    "rkJggg==";

Model with_material(const json& material) {
  Model model = triangle();
  model.document["materials"] = json::array({material});
  return model;
}

/// A material whose base colour has texture 0, of image 0.
Model textured(const json& image, const json& texture_info = {{"index", 0}}) {
  Model model = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", texture_info}}}});
  model.document["images"] = json::array({image});
  model.document["textures"] = {{{"source", 0}}};
  return model;
}

TEST(ImportMaterials, DefaultsOfTheSpecification) {
  const Material material = with_material(json::object()).import().materials.at(0);
  EXPECT_EQ(material.base_color, glm::vec4(1, 1, 1, 1));
  EXPECT_EQ(material.metallic, 1.0f);
  EXPECT_EQ(material.roughness, 1.0f);
  EXPECT_EQ(material.emissive, glm::vec3(0, 0, 0));
  EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(material.alpha_cutoff, 0.5f);
  EXPECT_FALSE(material.double_sided);
  EXPECT_FALSE(material.unlit);
  EXPECT_EQ(material.base_color_texture.texture, kNone);
}

TEST(ImportMaterials, Factors) {
  const json factors = {
      {"baseColorFactor", {0.25, 0.5, 2, 0.75}}, {"metallicFactor", 0.5}, {"roughnessFactor", -1}};
  const Material material =
      with_material({{"pbrMetallicRoughness", factors},
                     {"emissiveFactor", {1, 0.5, 0}},
                     {"alphaMode", "MASK"},
                     {"alphaCutoff", 0.25},
                     {"doubleSided", true},
                     {"extensions",
                      {{"KHR_materials_unlit", json::object()},
                       {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}})
          .import()
          .materials.at(0);
  EXPECT_EQ(material.base_color, glm::vec4(0.25f, 0.5f, 1, 0.75f));
  EXPECT_EQ(material.metallic, 0.5f);
  EXPECT_EQ(material.roughness, 0.0f);
  EXPECT_EQ(material.emissive, glm::vec3(4, 2, 0));
  EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(material.alpha_cutoff, 0.25f);
  EXPECT_TRUE(material.double_sided);
  EXPECT_TRUE(material.unlit);
}

TEST(ImportMaterials, AlphaModes) {
  EXPECT_EQ(with_material({{"alphaMode", "BLEND"}}).import().materials[0].alpha_mode, AlphaMode::blend);
  const Scene unknown = with_material({{"alphaMode", "ADD"}}).import();
  EXPECT_EQ(unknown.materials[0].alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(unknown.warnings.size(), 1u);
}

TEST(ImportTextures, SamplersBecomeOpenGLsNames) {
  Model model = textured({{"uri", kPng}});
  const auto import = [&](const json& sampler) {
    model.document["samplers"] = json::array({sampler});
    model.document["textures"][0]["sampler"] = 0;
    return model.import();
  };
  const std::vector<std::pair<int, raster::MinFilter>> filters = {
      {9728, raster::MinFilter::nearest},
      {9729, raster::MinFilter::linear},
      {9984, raster::MinFilter::nearest_mipmap_nearest},
      {9985, raster::MinFilter::linear_mipmap_nearest},
      {9986, raster::MinFilter::nearest_mipmap_linear},
      {9987, raster::MinFilter::linear_mipmap_linear}};
  for (const auto& [number, filter] : filters) {
    EXPECT_EQ(import({{"minFilter", number}}).textures[0].min_filter, filter);
  }
  EXPECT_EQ(import({{"magFilter", 9728}}).textures[0].mag_filter, raster::MagFilter::nearest);
  EXPECT_EQ(import({{"magFilter", 9729}}).textures[0].mag_filter, raster::MagFilter::linear);
  const Texture wrapped = import({{"wrapS", 33071}, {"wrapT", 33648}}).textures[0];
  EXPECT_EQ(wrapped.wrap_s, raster::Wrap::clamp_to_edge);
  EXPECT_EQ(wrapped.wrap_t, raster::Wrap::mirrored_repeat);
  EXPECT_EQ(import(json::object()).textures[0].wrap_s, raster::Wrap::repeat);
  const Scene unknown = import({{"wrapS", 7}, {"minFilter", 1}, {"magFilter", 9984}});
  EXPECT_EQ(unknown.textures[0].wrap_s, raster::Wrap::repeat);
  EXPECT_EQ(unknown.textures[0].min_filter, raster::MinFilter::linear_mipmap_linear);
  EXPECT_EQ(unknown.warnings.size(), 3u);
}

TEST(ImportTextures, EveryUseOfAMaterial) {
  const json use = {{"index", 0}, {"texCoord", 1}};
  Model model = textured({{"uri", kPng}});
  model.document["materials"][0] = {
      {"pbrMetallicRoughness", {{"baseColorTexture", use}, {"metallicRoughnessTexture", use}}},
      {"normalTexture", use},
      {"occlusionTexture", use},
      {"emissiveTexture", use}};
  const Material material = model.import().materials.at(0);
  for (const TextureUse& made :
       {material.base_color_texture, material.metallic_roughness_texture, material.normal_texture,
        material.occlusion_texture, material.emissive_texture}) {
    EXPECT_EQ(made.texture, 0);
    EXPECT_EQ(made.texcoord_set, 1);
    EXPECT_EQ(made.transform, glm::mat3(1.0f));
  }
}

TEST(ImportTextures, TransformScalesThenTurnsThenMoves) {
  const json transform = {
      {"offset", {-0.2, -0.1}}, {"rotation", 0.3}, {"scale", {1.5, 1.5}}, {"texCoord", 1}};
  const json info = {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
  const TextureUse use = textured({{"uri", kPng}}, info).import().materials.at(0).base_color_texture;
  EXPECT_EQ(use.texcoord_set, 1);
  // u' = cos·su + sin·sv + offset, v' = −sin·su + cos·sv + offset.
  const glm::vec3 moved = use.transform * glm::vec3(0.5f, 0.25f, 1.0f);
  EXPECT_NEAR(moved.x, std::cos(0.3) * 0.75 + std::sin(0.3) * 0.375 - 0.2, 1e-6);
  EXPECT_NEAR(moved.y, -std::sin(0.3) * 0.75 + std::cos(0.3) * 0.375 - 0.1, 1e-6);
  EXPECT_EQ(moved.z, 1.0f);
}

TEST(ImportTextures, ThirdSetAndMissingImageAreWarnings) {
  const Scene third = textured({{"uri", kPng}}, {{"index", 0}, {"texCoord", 2}}).import();
  EXPECT_EQ(third.materials[0].base_color_texture.texcoord_set, 0);
  EXPECT_EQ(third.warnings.size(), 1u);
  Model model = textured({{"uri", kPng}});
  model.document["textures"] = json::array({json::object()});
  const Scene none = model.import();
  EXPECT_EQ(none.materials[0].base_color_texture.texture, kNone);
  EXPECT_EQ(none.warnings.size(), 1u);
}

TEST(ImportImages, FromUriAndFromBufferView) {
  const Scene by_uri = textured({{"uri", kPng}, {"name", "dots"}}).import();
  ASSERT_EQ(by_uri.images.size(), 1u);
  EXPECT_EQ(by_uri.images[0].width, 4);
  EXPECT_EQ(by_uri.images[0].rgba.size(), 64u);
  EXPECT_EQ(by_uri.images[0].name, "dots");

  const TemporaryFolder folder;
  Model model = textured({{"mimeType", "image/png"}});
  const std::vector<std::uint8_t> png = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
      0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00,
      0x00, 0x1f, 0x15, 0xc4, 0x89, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x44, 0x41, 0x54, 0x78,
      0xda, 0x63, 0xf8, 0xcf, 0xc0, 0xf0, 0x1f, 0x00, 0x05, 0x00, 0x01, 0xff, 0x56, 0xc7,
      0x2f, 0x0d, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  model.document["images"][0]["bufferView"] = model.add_view(png);
  const Scene by_view = import_gltf(folder.write("model.glb", model.glb()));
  EXPECT_EQ(by_view.images[0].rgba, (PixelBytes{255, 0, 0, 255}));
  EXPECT_EQ(by_view.images[0].name, "images[0]");
}

TEST(ImportImages, OnlyThoseThatAreUsedAreRead) {
  Model model = textured({{"uri", kPng}});
  model.append("images", {{"uri", "missing.png"}});
  model.append("textures", {{"source", 1}});
  const Scene scene = model.import();
  EXPECT_EQ(scene.images[0].width, 4);
  EXPECT_EQ(scene.images[1].width, 0);

  model.document["materials"][0]["normalTexture"] = {{"index", 1}};
  EXPECT_EQ(model.import().warnings,
            std::vector<std::string>{"images[1] (missing.png): no such file; drawn without this picture"});
  model.document["materials"][0].erase("normalTexture");
  model.document["materials"][0]["emissiveTexture"] = {{"index", 1}};
  EXPECT_EQ(model.import().warnings,
            std::vector<std::string>{"images[1] (missing.png): no such file; drawn without this picture"});
  ImportOptions options;
  options.image_roles = kAllImages & ~kEmissiveImage;
  EXPECT_TRUE(model.import(options).warnings.empty());
  options.load_images = false;
  EXPECT_EQ(model.import(options).images[0].width, 0);
}

TEST(ImportImages, BrokenOnesAreWarningsInTheirOrder) {
  const auto warning = [](const json& image) {
    const Scene scene = textured(image).import();
    EXPECT_EQ(scene.images[0].width, 0);
    return scene.warnings.size() == 1 ? scene.warnings[0] : std::string();
  };
  EXPECT_CONTAINS(warning({{"uri", "data:image/png;base64,AAAA"}}), "images[0]: neither PNG nor JPEG");
  EXPECT_CONTAINS(warning(json::object()), "images[0]: has neither a uri nor a bufferView");
  EXPECT_CONTAINS(warning({{"uri", "../a.png"}}), "images[0] (../a.png): the path leaves");
  Model model = textured({{"uri", kPng}});
  for (int i = 1; i < 20; ++i) {
    model.append("images", {{"uri", "data:image/png;base64,AAAA"}});
    model.append("textures", {{"source", 20 - i}});
    model.append("materials", {{"emissiveTexture", {{"index", i}}}});
  }
  const Scene scene = model.import();
  ASSERT_EQ(scene.warnings.size(), 19u);
  EXPECT_CONTAINS(scene.warnings[0], "images[1]: ");
  EXPECT_CONTAINS(scene.warnings[18], "images[19]: ");
  EXPECT_EQ(scene.images[0].width, 4);
}

TEST(ImportImages, LargerThanTheLimit) {
  ImportOptions options;
  options.max_image_pixels = 15;
  const Scene scene = textured({{"uri", kPng}}).import(options);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_CONTAINS(scene.warnings[0], "a picture may have at most 15");
}

TEST(ImportImages, MemoryIsAnError) {
  ImportOptions options;
  options.budget = std::make_shared<Budget>(BudgetLimits{std::uint64_t{100'000}, std::nullopt});
  options.budget->take(99'900, "", "");
  EXPECT_CONTAINS(input_error([&] {
                    textured({{"uri", kPng}}).import(options);
                  }),
                  "--max-memory allows more");
}

}  // namespace
}  // namespace barrido::scene::test
