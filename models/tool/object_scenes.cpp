#include <cmath>

#include "models/tool/scene_parts.h"
#include "models/tool/scenes.h"
#include "models/tool/teapot.h"

namespace barrido::models {
namespace {

/// The classical three-quarter view of the teapot, and light from the upper left, so that the form shows.
void add_teapot_camera_and_lights(GlbWriter& writer) {
  add_camera(writer, {{3.0, 3.2, 9.2}, {0.36, 1.42, 0}, 0.275, 0.5, 50.0});
  add_sun(writer, "key", {-3.0, 4.5, 5.0}, {1.0, 0.97, 0.92}, 2.9);
  add_sun(writer, "fill", {6.0, 1.0, 4.0}, {0.85, 0.92, 1.0}, 0.45);
  add_sun(writer, "back", {1.5, 4.0, -5.0}, {1.0, 1.0, 1.0}, 0.6);
  writer.set_scene_extras({{"ambient", json_of({0.06, 0.06, 0.07})}});
}

SceneFile make_plain_teapot(int cells) {
  GlbWriter writer("Utah teapot");
  Json material = make_material("porcelain", {0.52, 0.17, 0.08}, 0.0, 0.3);
  material["doubleSided"] = true;  // The lid does not quite close the body.
  const int mesh = writer.add_mesh("teapot", make_teapot(cells), writer.add_material(std::move(material)));
  writer.add_node({{"name", "teapot"}, {"mesh", mesh}});
  add_teapot_camera_and_lights(writer);
  return {"teapot.glb", writer.bytes()};
}

SceneFile make_patch_teapot(const Bytes& picture, int cells) {
  GlbWriter writer("Utah teapot, one picture a patch");
  Json material = make_textured_material("patches", writer.add_texture("patch", picture), 0.0, 0.4);
  material["doubleSided"] = true;
  const int mesh = writer.add_mesh("teapot", make_teapot(cells), writer.add_material(std::move(material)));
  writer.add_node({{"name", "teapot"}, {"mesh", mesh}});
  add_teapot_camera_and_lights(writer);
  return {"teapot_patches.glb", writer.bytes()};
}

/// k_a, k_d, k_s and n as in the course's figures, under one light from the upper left.
SceneFile make_lit_sphere() {
  GlbWriter writer("Sphere under one light");
  constexpr Vec3 kColor{0.2, 0.35, 0.8};
  const ExactMaterial exact{kColor, kColor, {0.6, 0.6, 0.6}, 30.0};
  const int material = writer.add_material(make_exact_material("course", exact));
  const int mesh = writer.add_mesh("sphere", make_sphere(1.0, 24, 12), material);
  writer.add_node({{"name", "sphere"}, {"mesh", mesh}});
  add_camera(writer, {{0, 0, 6}, {0, 0, 0}, 0.22, 0.5, 50.0});
  add_exact_point_light(writer, "light", {-4, 5, 6}, {1, 1, 1}, 0.9, {1, 0, 0});
  writer.set_scene_extras({{"ambient", json_of({0.15, 0.15, 0.15})}});
  return {"sphere.glb", writer.bytes()};
}

SceneFile make_brick_torus(const Bytes& picture) {
  GlbWriter writer("Torus of bricks");
  const int material =
      writer.add_material(make_textured_material("bricks", writer.add_texture("bricks", picture), 0.0, 0.7));
  const int mesh = writer.add_mesh("torus", make_torus(1.0, 0.42, 64, 32, {6, 3}), material);
  writer.add_node({{"name", "torus"}, {"mesh", mesh}});
  add_camera(writer, {{0, 3.2, 4.4}, {0, -0.05, 0}, 0.30, 0.5, 50.0});
  return {"torus.glb", writer.bytes()};
}

/// The same bricks standing out of their mortar, by maps alone.
SceneFile make_relief_torus(const Textures& textures) {
  GlbWriter writer("Torus of bricks with maps of normals, occlusion and highlights");
  const auto texture = [&](const char* name) {
    return Json{{"index", writer.add_texture(name, textures.at(name))}};
  };
  Json material{{"name", "bricks"}};
  material["pbrMetallicRoughness"] = {
      {"baseColorTexture", texture("bricks")}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.45}};
  material["normalTexture"] = texture("brick_normals");
  material["occlusionTexture"] = texture("brick_occlusion");
  material["extensions"]["KHR_materials_specular"]["specularColorTexture"] = texture("brick_shine");
  writer.declare_extension("KHR_materials_specular");
  const int mesh = writer.add_mesh("torus", make_torus(1.0, 0.42, 64, 32, {6, 3}),
                                   writer.add_material(std::move(material)));
  writer.add_node({{"name", "torus"}, {"mesh", mesh}});
  add_camera(writer, {{0, 3.2, 4.4}, {0, -0.05, 0}, 0.30, 0.5, 50.0});
  add_sun(writer, "key", {-4.0, 3.0, 3.0}, {1.0, 0.97, 0.92}, 2.6);
  writer.set_scene_extras({{"ambient", json_of({0.25, 0.25, 0.28})}});
  return {"relief.glb", writer.bytes()};
}

/// A wheel in the plane z = 0: rim, hub and spokes, none of them marked.
Mesh make_wheel(int spokes) {
  constexpr double kTurn = 6.283185307179586;
  Mesh wheel = make_torus(1.0, 0.09, 96, 16, {1, 1});
  append(wheel, make_torus(0.12, 0.07, 32, 16, {1, 1}));
  for (std::vector<Vec3>* vectors : {&wheel.positions, &wheel.normals}) {
    for (Vec3& v : *vectors) v = {v.x, -v.z, v.y};  // from about y to about z
  }
  for (int i = 0; i < spokes; ++i) {
    const Vec3 out{std::cos(kTurn * i / spokes), std::sin(kTurn * i / spokes), 0};
    const Vec3 across{-out.y, out.x, 0};
    append(wheel, make_grid(out * 0.1 + across * 0.035, out * 0.88, across * -0.07, 1, 1));
  }
  return wheel;
}

/// Twelve spokes, 30° apart, that go on by 28° from one picture to the next where there are 30 a second: they
/// seem to turn back by 2°.
SceneFile make_turning_wheel() {
  constexpr int kSpokes = 12;
  constexpr double kDegreesAPicture = 28.0, kPicturesASecond = 30.0;
  GlbWriter writer("Wheel");
  Json material = make_material("brass", {0.75, 0.55, 0.2}, 0.0, 0.4);
  material["doubleSided"] = true;
  const int mesh = writer.add_mesh("wheel", make_wheel(kSpokes), writer.add_material(std::move(material)));
  writer.add_turning(writer.add_node({{"name", "wheel"}, {"mesh", mesh}}),
                     360.0 / (kDegreesAPicture * kPicturesASecond));
  add_camera(writer, {{0, 0, 5}, {0, 0, 0}, 0.26, 0.5, 50.0});
  return {"wheel.glb", writer.bytes()};
}

}  // namespace

std::vector<SceneFile> make_object_scenes(const Textures& textures, int teapot_cells) {
  return {make_plain_teapot(teapot_cells),
          make_patch_teapot(textures.at("patch"), teapot_cells),
          make_lit_sphere(),
          make_brick_torus(textures.at("bricks")),
          make_relief_torus(textures),
          make_turning_wheel()};
}

}  // namespace barrido::models
