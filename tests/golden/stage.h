// What the scenes of the golden pictures are built with: a small frame, shapes that own their vertices, and
// textures drawn by formula. Only Barrido's public interface is used, so that a scene reads as a program of a
// user.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "pipeline/matrix.h"
#include "pipeline/renderer.h"
#include "raster/textures/texture.h"

namespace barrido::golden {

using pipeline::PrimitiveMode;
using pipeline::State;

inline constexpr int kWidth = 160;
inline constexpr int kHeight = 120;

/// Vertex arrays that own their memory; an empty one is absent.
struct Shape {
  PrimitiveMode mode = PrimitiveMode::triangles;
  std::vector<glm::vec4> position;
  std::vector<glm::vec3> normal;
  std::vector<glm::vec3> tangent, bitangent;  ///< P_u and P_v.
  std::vector<glm::vec4> color;
  std::vector<glm::vec4> texcoord;  ///< Of both units.
  int texcoord_components = 2;
  std::vector<std::uint32_t> indices;
};

/// A frame and all that is drawn into it, which is kept until the picture is finished.
class Stage {
 public:
  Stage();
  explicit Stage(const raster::FramebufferOptions& options);

  /// Another background or depth than dark grey and 1; before the first draw.
  void clear(const glm::vec4& color, float depth = 1.0f);
  void draw(const State& state, Shape shape);
  const raster::Texture* keep(raster::Texture texture);
  const raster::Framebuffer& finish();

 private:
  raster::Framebuffer frame_;
  std::unique_ptr<pipeline::Renderer> renderer_;
  std::deque<Shape> shapes_;
  std::deque<raster::Texture> textures_;
};

struct Scene {
  const char* name;
  void (*draw)(Stage& stage);
  raster::FramebufferOptions (*frame)() = nullptr;  ///< Where 8 bits a channel are not it.
};

/// A perspective view (45° high) of the z = 0 plane from `distance`, depth test on, in the whole frame.
State view_from(float distance);
/// The plane z = 0 from (−1, −1) to (1, 1) fills the viewport, without depth test.
State flat_view();
/// The same state drawing into one cell of a grid, counted from the upper left, a pixel apart from its
/// neighbours. What view_from() shows keeps its proportions; a flat view fills the cell.
State in_cell(State state, int cell, int columns, int rows);
/// `state` with the object moved or turned first.
State placed(State state, const glm::mat4& object);
glm::mat4 translation(float x, float y, float z);
glm::mat4 scaling(float x, float y, float z);
glm::mat4 turned(float degrees, const glm::dvec3& axis);

/// Two triangles (x0, y0)–(x1, y1) at depth z, facing +Z, texture coordinates 0..repeat, t = 0 at the bottom.
Shape rectangle(float x0, float y0, float x1, float y1, float z = 0, float repeat = 1);
/// A grid of cells × cells over [−1, 1]² that faces +Z.
Shape plane(int cells, float repeat = 1);
/// A floor y = −1 from z = 1 (behind the eye for view_from(1)) to z = −depth.
Shape ground(float depth, float repeat);
/// Unit sphere, smooth normals; counter-clockwise outside.
Shape sphere(int slices, int stacks);
/// A cube of half side 1 without its +Z face: quads with a colour for each face.
Shape open_box();
Shape triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec4& color);
Shape with_color(Shape shape, const glm::vec4& color);

/// A texture whose texel (i, j) of side × side is rule(i, j), components in [0, 1]; t = 0 is row 0.
raster::Texture texture_of(int side, const raster::TextureOptions& options,
                           const std::function<glm::vec4(int, int)>& rule);
/// An F in four colours: what is turned, mirrored or upside down is seen at once.
raster::Texture letter(const raster::TextureOptions& options = {});
raster::Texture checker(int side, const raster::TextureOptions& options = {});
/// Six faces, each in a colour of its own (+X red, −X cyan, +Y green, −Y magenta, +Z blue, −Z yellow) with a
/// bright corner at s = t = 0.
raster::Texture marked_cube(int side, const raster::TextureOptions& options);

std::vector<Scene> visibility_scenes();
std::vector<Scene> primitive_scenes();
std::vector<Scene> lighting_scenes();
std::vector<Scene> texture_scenes();
std::vector<Scene> texgen_scenes();
std::vector<Scene> map_scenes();
std::vector<Scene> environment_scenes();
std::vector<Scene> fragment_scenes();

}  // namespace barrido::golden
