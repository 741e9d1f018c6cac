// Why a pixel has its colour: every fragment that covers it, from the triangle in the file to the numbers
// that were added up. Enters: a scene and the settings of a frame; leaves: a PixelStory, plain data that can
// be told as text or JSON. The numbers are taken from the arithmetic that draws (raster/reference and the
// illumination kernels), so the story's end is the frame's pixel, bit for bit.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/layout.h"
#include "pipeline/scene/render_scene.h"
#include "pipeline/scene/scene.h"
#include "raster/reference/trace.h"

namespace barrido::inspect {

using raster::reference::Color;
using Rgb = std::array<float, 3>;

/// One light at one place. Dot products, powers, factors and shares are the kernel's own numbers; vectors are
/// worked out again for reading.
struct LightStory {
  std::string name;                ///< "key", the node's name, or "light 2".
  glm::vec3 to_light{0, 0, 1};     ///< L, eye space, unit length.
  glm::vec3 half_vector{0, 0, 1};  ///< H (Blinn), unit length.
  glm::vec3 reflection{0, 0, 1};   ///< R = 2(N·L)N − L (Phong).
  Rgb intensity{};                 ///< I_p
  float n_dot_l = 0.0f;            ///< Not clamped. Of interpolated products: times the weakening.
  float highlight = 0.0f;          ///< N·H or R·V, not clamped; 0 where nothing shines.
  float power = 0.0f;              ///< highlight^n where N·L > 0, else 0.
  float weakening = 1.0f;          ///< Attenuation, range and cone.
  Rgb ambient{};                   ///< Share of the sum; of lights that weaken.
  Rgb diffuse{};                   ///< Share of the sum: weakening · I_p · k_d · max(N·L, 0)
  Rgb specular{};                  ///< Share of the sum: weakening · I_p · k_s · power
  /// At corners under cheap Phong, what is interpolated: weakening·(N·L), and highlight·weakening^(1/n) or
  /// its power.
  std::optional<std::array<float, 2>> products;
};

/// One evaluation of the illumination model. primary = base + Σ (ambient + diffuse), secondary = Σ specular,
/// added in this order in floats.
struct IlluminationStory {
  std::string place;             ///< "fragment", "centroid", "vertex 17", "provoking vertex 17".
  glm::vec3 position{0, 0, 0};   ///< Eye space.
  glm::vec3 normal{0, 0, 1};     ///< N as it is lit: unit length, turned round on back sides.
  glm::vec3 to_viewer{0, 0, 1};  ///< V
  bool back_side = false;        ///< −N and the back material.
  bool interpolated_products =
      false;  ///< Cheap Phong: products come from the vertices, vectors are not known.
  bool highlights_are_powers = false;  ///< Cheap Phong with the power at the vertices.
  std::string_view formula;            ///< As ShadingMode::formula.
  Rgb k_ambient{}, k_diffuse{}, k_specular{}, emission{};
  float shininess = 0.0f;  ///< n
  Rgb ambient_light{};     ///< I_a
  Rgb base{};              ///< emission + k_a·I_a, and the ambient shares of lights that do not weaken.
  std::vector<LightStory> lights;
  Rgb interpolated_ambient{};  ///< Cheap Phong: ambient shares of the lights that weaken.
  Color primary{};             ///< Not clamped; with the secondary where that is not kept apart.
  Rgb secondary{};             ///< Added after the textures; 0 where it is not kept apart.
  bool exact = true;           ///< The shares add up to the kernel's own result in every bit.
};

/// A corner of the triangle (or end of the line) in the file.
struct CornerStory {
  std::uint32_t vertex = 0;          ///< Number in the arrays that are drawn.
  glm::vec3 object{0, 0, 0};         ///< Position in object space.
  glm::vec3 eye{0, 0, 0};            ///< … in eye space.
  glm::vec3 normal{0, 0, 0};         ///< Eye space, as lit; 0 where the draw needs none.
  float window_x = 0, window_y = 0;  ///< Pixels, snapped to 1/256, y up; 0 behind the eye.
  float depth = 0;                   ///< Window z.
  float w = 1;                       ///< Clip-space w.
  double weight = 0;                 ///< Perspective-correct barycentric coordinate of the pixel's centre.
  double screen_weight = 0;          ///< Linear on the screen; 0 for clipped triangles.
  std::optional<float> displaced;    ///< How far displacement has moved it, along its normal.
  std::optional<Color> lit;          ///< Gouraud: the colour that is interpolated.
  std::optional<Rgb> lit_secondary;
};

/// The picture behind a texture unit; one for each of FragmentTrace::shading.units.
struct TextureStory {
  /// "base color", "environment", "emission" or "constant"; a procedure's name; of maps their role.
  std::string role;
  std::string image;  ///< Name of the picture in the file; empty where there is none.
  bool cube = false;
  int width = 0, height = 0, levels = 0;
};

/// What became of a fragment.
enum class Fate : std::uint8_t {
  visible,   ///< Its colour is (part of) the pixel's.
  covered,   ///< Was drawn, and later drawn over.
  hidden,    ///< Failed the depth test.
  cut_out,   ///< Failed the alpha test.
  scissored  ///< Outside the scissor.
};

struct FragmentStory {
  Fate fate = Fate::visible;
  bool backdrop = false;  ///< The environment behind everything; has no names.
  int node = scene::kNone, mesh = scene::kNone, primitive = 0, material = scene::kNone;
  std::string node_name, mesh_name, material_name;
  std::uint32_t triangle = 0;  ///< Of the primitive in the file; or its point or line.
  raster::Topology topology = raster::Topology::triangles;  ///< As drawn: wireframes are lines.
  bool of_polygon = true;                                   ///< False: a point or line of the file.
  bool clipped = false;         ///< What covers the pixel is a piece that clipping left.
  bool back_facing = false;     ///< Seen from behind.
  std::string_view shading;     ///< Name of the pipeline::ColorOrigin.
  raster::FragmentState state;  ///< Without textures and stages.
  std::vector<TextureStory> textures;
  std::vector<TextureStory> maps;  ///< One for each of FragmentTrace::shading.maps.
  std::vector<CornerStory> corners;
  std::vector<IlluminationStory> illuminations;    ///< Phong 1, Gouraud and cheap Phong one a corner, flat 1.
  std::optional<IlluminationStory> from_products;  ///< Cheap Phong: the model from interpolated products.
  raster::reference::FragmentTrace trace;
};

struct PixelStory {
  std::string source;         ///< The model's path.
  int width = 0, height = 0;  ///< Of the frame.
  int x = 0, y = 0;           ///< Pixel, y from the top row as in picture files.
  int window_y = 0;           ///< height − 1 − y: from the bottom row as in window coordinates.
  pipeline::ShadeModel shading = pipeline::ShadeModel::phong;
  pipeline::SpecularModel lighting = pipeline::SpecularModel::blinn;
  bool perspective = true;
  raster::ColorFormat format = raster::ColorFormat::rgba8;
  raster::DisplayTransform display;  ///< Of float frames.
  Color clear{};                     ///< Background as the frame holds it.
  float clear_depth = 1.0f;
  std::vector<FragmentStory> fragments;  ///< In drawing order.
  Color color{};                         ///< The pixel as the frame holds it: what the fragments left.
  /// Over a background that lets something through: what the fragments left, before the colour was made
  /// straight.
  std::optional<Color> blended;
  std::array<float, 3> displayed{};  ///< Exposed, tone-mapped and encoded, before rounding to 8 bits.
  float depth = 1.0f;
  std::array<std::uint8_t, 4> rgba8{};  ///< The pixel of the picture.
  /// The scene's nearest surface, as is seen: the last fragment that passed its depth test; −1: background.
  int front = -1;
};

/// Traces pixel (x, y), y counted from the top row. Costs about as much as the vertices of a frame.
/// @throws std::out_of_range naming the frame's size when the pixel is outside; scene::InputError as render.
PixelStory inspect_pixel(const scene::Scene& scene, scene::SceneRenderer& renderer,
                         const scene::RenderSettings& settings, int x, int y);

/// A pixel of a picture, y from the top row.
struct PixelPosition {
  int x = 0, y = 0;
};

/// The same for several pixels of one frame, in their order; costs little more than one.
std::vector<PixelStory> inspect_pixels(const scene::Scene& scene, scene::SceneRenderer& renderer,
                                       const scene::RenderSettings& settings,
                                       std::span<const PixelPosition> pixels);

/// The story told as the course's formula with numbers, in UTF-8; lines end in "\n".
std::string story_text(const PixelStory& story);

/// The same as JSON, indented; the schema is docs/inspect.md.
std::string story_json(const PixelStory& story);

}  // namespace barrido::inspect
