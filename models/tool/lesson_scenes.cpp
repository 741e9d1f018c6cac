#include "models/tool/scene_parts.h"
#include "models/tool/scenes.h"

namespace barrido::models {
namespace {

constexpr Vec3 kWhite{0.72, 0.71, 0.68};

/// Walls of a room 2 × 2 × 2 about (0, 1, 0), open towards +Z; walls are cut up so that light at the vertices
/// has something to say.
void add_walls(GlbWriter& writer) {
  constexpr int kCells = 8;
  const int white = writer.add_material(make_material("white", kWhite, 0.0, 1.0));
  const int red = writer.add_material(make_material("red", {0.60, 0.06, 0.05}, 0.0, 1.0));
  const int green = writer.add_material(make_material("green", {0.12, 0.42, 0.09}, 0.0, 1.0));
  Mesh shell = make_grid({-1, 0, -1}, {2, 0, 0}, {0, 0, 2}, kCells, kCells);     // floor
  append(shell, make_grid({-1, 2, 1}, {2, 0, 0}, {0, 0, -2}, kCells, kCells));   // ceiling
  append(shell, make_grid({-1, 2, -1}, {2, 0, 0}, {0, -2, 0}, kCells, kCells));  // back
  const Mesh left = make_grid({-1, 2, 1}, {0, 0, -2}, {0, -2, 0}, kCells, kCells);
  const Mesh right = make_grid({1, 2, -1}, {0, 0, 2}, {0, -2, 0}, kCells, kCells);
  const Part parts[] = {{&shell, white}, {&left, red}, {&right, green}};
  writer.add_node({{"name", "walls"}, {"mesh", writer.add_mesh("walls", parts)}});
}

void add_boxes_and_lamp(GlbWriter& writer) {
  const int white = writer.add_material(make_material("box", kWhite, 0.0, 0.6));
  // Turned by the angles whose tangents are 1/3 and −1/3.
  Mesh boxes = make_standing_box({-0.35, 0, -0.35}, unit({3, 0, 1}), {0.6, 1.2, 0.6});
  append(boxes, make_standing_box({0.38, 0, 0.30}, unit({3, 0, -1}), {0.6, 0.6, 0.6}));
  writer.add_node({{"name", "boxes"}, {"mesh", writer.add_mesh("boxes", boxes, white)}});

  Json lamp = make_material("lamp", {0, 0, 0}, 0.0, 1.0);
  lamp["emissiveFactor"] = {1.0, 0.95, 0.85};
  const Mesh panel = make_grid({-0.3, 1.995, 0.3}, {0.6, 0, 0}, {0, 0, -0.6}, 1, 1);
  writer.add_node(
      {{"name", "lamp"}, {"mesh", writer.add_mesh("lamp", panel, writer.add_material(std::move(lamp)))}});
}

SceneFile make_room() {
  GlbWriter writer("Room");
  add_walls(writer);
  add_boxes_and_lamp(writer);
  add_camera(writer, {{0, 1, 4.6}, {0, 1, 0}, 0.30, 0.1, 20.0});
  add_exact_point_light(writer, "lamp", {0, 1.8, 0}, {1, 0.95, 0.85}, 1.3, {0.5, 0.3, 0.4});
  // The light that the floor throws back, as a dim light of its own (V8).
  add_exact_point_light(writer, "bounce", {0, 0.15, 1.2}, {1, 0.9, 0.8}, 0.4, {1, 0, 0.5});
  writer.set_scene_extras({{"ambient", json_of({0.06, 0.06, 0.06})}});
  return {"room.glb", writer.bytes()};
}

int add_unlit_checker(GlbWriter& writer, const Bytes& picture) {
  Json material = make_textured_material("checker", writer.add_texture("checker", picture), 0.0, 1.0);
  material["extensions"]["KHR_materials_unlit"] = Json::object();
  writer.declare_extension("KHR_materials_unlit");
  return writer.add_material(std::move(material));
}

/// One square of the picture is half a unit wide.
SceneFile make_checker_ground(const Bytes& picture) {
  GlbWriter writer("Checker ground to the horizon");
  const int material = add_unlit_checker(writer, picture);
  const Mesh ground = make_grid({-100, 0, -200}, {200, 0, 0}, {0, 0, 204}, 1, 1, {50, 51});
  writer.add_node({{"name", "ground"}, {"mesh", writer.add_mesh("ground", ground, material)}});
  add_camera(writer, {{0, 1.2, 3.5}, {0, 0.35, 0}, 0.5, 0.1, 500.0});
  writer.set_scene_extras({{"background", {0.34, 0.54, 0.78, 1.0}}});
  return {"checker_ground.glb", writer.bytes()};
}

/// Two triangles, wholly before the eye: where their diagonal runs, affine interpolation breaks the picture.
SceneFile make_checker_square(const Bytes& picture) {
  GlbWriter writer("Checker square in perspective");
  const int material = add_unlit_checker(writer, picture);
  const Mesh square = make_grid({-1.5, 0, -4}, {3, 0, 0}, {0, 0, 5.5}, 1, 1);
  writer.add_node({{"name", "square"}, {"mesh", writer.add_mesh("square", square, material)}});
  add_camera(writer, {{0, 1.5, 3.2}, {0, 0.05, 0}, 0.45, 0.1, 50.0});
  return {"checker_square.glb", writer.bytes()};
}

constexpr Vec4 kRed{0.9, 0.1, 0.1, 1};
constexpr Vec4 kYellow{0.95, 0.85, 0.1, 1};
constexpr Vec4 kBlue{0.1, 0.2, 0.9, 1};

/// Two strips that share the edge from `near` to `far`. The left one has no vertex in between, the right one
/// has `middle`, with the mean of the ends' colours.
void append_t_junction(std::vector<Mesh>& meshes, const Vec3& near, const Vec3& middle, const Vec3& far) {
  const Vec3 side{1.3, 0, 0};
  Mesh left;
  left.mode = Mode::triangle_strip;
  left.positions = {far - side, near - side, far, near};
  left.colors = {kYellow, kYellow, kBlue, kRed};
  Mesh right;
  right.mode = Mode::triangle_strip;
  right.positions = {far, middle, far + side, near + side};
  right.colors = {kBlue, (kRed + kBlue) * 0.5, kYellow, kYellow};
  Mesh corner;
  corner.mode = Mode::triangle_strip;
  corner.positions = {middle, near, near + side};
  corner.colors = {(kRed + kBlue) * 0.5, kRed, kYellow};
  for (Mesh* mesh : {&left, &right, &corner}) meshes.push_back(std::move(*mesh));
}

SceneFile make_t_junctions() {
  GlbWriter writer("T-junctions");
  Json material = make_material("vertex colours", {1, 1, 1}, 0.0, 1.0);
  material["extensions"]["KHR_materials_unlit"] = Json::object();
  material["doubleSided"] = true;
  const int index = writer.add_material(std::move(material));
  writer.declare_extension("KHR_materials_unlit");
  std::vector<Mesh> meshes;
  // On the left the vertex lies on the edge: only the colours part (S10). On the right it lies a little above
  // it, as when a finer grid meets a coarser one: there is a hole as well.
  append_t_junction(meshes, {-1.6, 0, 1.5}, {-1.6, 0, -2.25}, {-1.6, 0, -6});
  append_t_junction(meshes, {1.6, 0, 1.5}, {1.6, 0.12, -2.25}, {1.6, 0, -6});
  std::vector<Part> parts;
  parts.reserve(meshes.size());
  for (const Mesh& mesh : meshes) parts.push_back({&mesh, index});
  writer.add_node({{"name", "strips"}, {"mesh", writer.add_mesh("strips", parts)}});
  add_camera(writer, {{0, 1.6, 4.2}, {0, 0, -0.4}, 0.45, 0.1, 50.0});
  return {"t_junction.glb", writer.bytes()};
}

/// A square with its highlight in the middle: `cells` = 1 loses it under Gouraud, many keep it (S11).
SceneFile make_highlight(const std::string& file, int cells) {
  GlbWriter writer("Highlight inside a polygon");
  const ExactMaterial exact{{0.1, 0.12, 0.3}, {0.2, 0.25, 0.6}, {0.9, 0.9, 0.9}, 80.0};
  const int material = writer.add_material(make_exact_material("glossy", exact));
  const Mesh square = make_grid({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, cells, cells);
  writer.add_node({{"name", "square"}, {"mesh", writer.add_mesh("square", square, material)}});
  add_camera(writer, {{0, 0, 3}, {0, 0, 0}, 0.38, 0.1, 20.0});
  add_exact_point_light(writer, "light", {0.3, 0.3, 1.2}, {1, 1, 1}, 1.0, {1, 0, 0});
  writer.set_scene_extras({{"ambient", json_of({0.2, 0.2, 0.2})}});
  return {file, writer.bytes()};
}

}  // namespace

std::vector<SceneFile> make_lesson_scenes(const Textures& textures) {
  return {make_room(),
          make_checker_ground(textures.at("checker")),
          make_checker_square(textures.at("checker")),
          make_t_junctions(),
          make_highlight("lost_highlight.glb", 1),
          make_highlight("lost_highlight_fine.glb", 24)};
}

}  // namespace barrido::models
