#include "models/tool/scene_parts.h"
#include "models/tool/scenes.h"
#include "models/tool/teapot.h"

namespace barrido::models {
namespace {

void add_object(GlbWriter& writer, const std::string& name, const Mesh& mesh, Json material,
                const Vec3& position, double scale = 1.0) {
  const int index = writer.add_mesh(name, mesh, writer.add_material(std::move(material)));
  Json node{{"name", name}, {"mesh", index}, {"translation", json_of(position)}};
  if (scale != 1.0) node["scale"] = json_of(Vec3(scale));
  writer.add_node(std::move(node));
}

}  // namespace

SceneFile make_showcase(const Textures& textures, int teapot_cells) {
  GlbWriter writer("Showcase");
  const auto texture = [&](const std::string& name) { return writer.add_texture(name, textures.at(name)); };
  const int checker = texture("checker");
  const int marble = texture("marble");
  const int bricks = texture("bricks");

  Json silver = make_material("polished metal", {0.95, 0.90, 0.82}, 1.0, 0.12);
  silver["doubleSided"] = true;
  add_object(writer, "teapot", make_teapot(teapot_cells), std::move(silver), {-0.9, 0, -0.5}, 0.62);
  add_object(writer, "mirror ball", make_sphere(0.85, 48, 24),
             make_material("mirror", {0.92, 0.95, 0.98}, 1.0, 0.03), {1.75, 0.85, -0.2});
  add_object(writer, "marble ball", make_sphere(0.5, 36, 18),
             make_textured_material("marble", marble, 0.0, 0.25), {0.55, 0.5, 1.45});
  add_object(writer, "ring", make_torus(0.55, 0.22, 48, 24, {5, 2}),
             make_textured_material("bricks", bricks, 0.0, 0.8), {-1.25, 0.22, 1.85});
  add_object(writer, "floor", make_grid({-24, 0, -32}, {48, 0, 0}, {0, 0, 40}, 24, 20, {12, 10}),
             make_textured_material("floor", checker, 0.0, 0.9), {0, 0, 0});

  add_camera(writer, {{0.6, 1.9, 7.6}, {0.2, 0.95, 0}, 0.30, 0.1, 100.0});
  // Key, fill and back light (V2); lux = π × the course's intensity.
  add_sun(writer, "key", {3.0, 5.0, 4.0}, {1.0, 0.96, 0.88}, 2.4);
  add_sun(writer, "fill", {-5.0, 2.5, 3.5}, {0.80, 0.88, 1.0}, 0.9);
  add_sun(writer, "back", {-1.5, 4.0, -5.0}, {1.0, 1.0, 1.0}, 0.9);
  writer.set_scene_extras(
      {{"ambient", json_of({0.18, 0.19, 0.21})}, {"background", {0.34, 0.54, 0.78, 1.0}}});
  return {"showcase.glb", writer.bytes()};
}

}  // namespace barrido::models
