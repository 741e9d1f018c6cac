// From a scene and a choice of techniques to draws: cameras, lights, materials, order of drawing.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "pipeline/pictures/environment.h"
#include "pipeline/renderer.h"
#include "pipeline/scene/animate.h"
#include "pipeline/scene/sample_choice.h"
#include "pipeline/scene/scene.h"

namespace barrido::scene {

enum class ColorManagement : std::uint8_t {
  srgb,  ///< Texels are decoded to linear light, results encoded: glTF's way.
  none,  ///< Texels and results as they are: OpenGL 1.x and the course.
};

/// A light given by the user in place of the file's.
struct UserLight {
  enum class Space : std::uint8_t { world, camera };
  Light light;
  Space space = Space::world;  ///< camera: the light moves with the eye (presets key, fill, back).
  glm::vec3 position{0, 0, 0};
  glm::vec3 direction{0, 0, -1};  ///< In which it shines.
};

/// The view, resolved: where the eye is and what it sees.
struct View {
  glm::mat4 eye_from_world{1.0f};  ///< The world as the frame holds it: about Pose::origin.
  glm::mat4 clip_from_eye{1.0f};
  /// To begin with; more than 1 where so much lies between near and far plane that depths round to 1.
  float clear_depth = 1.0f;
};

struct CameraChoice {
  int camera_index =
      kNone;  ///< Of the cameras found in the scene's nodes, in order; kNone: the first, else framed.
  bool ignore_file_cameras = false;
  std::optional<glm::dvec3> position, focal_point;  ///< Of the file's world, where coordinates may be large.
  std::optional<float> view_angle_deg;
  glm::vec3 up{0, 1, 0};
  std::optional<glm::vec3> view_up;  ///< Which way the picture is held; empty: upright. Need not be a unit.
  std::optional<float> orthographic_height;        ///< Parallel rays; of what is seen, in the model's units.
  float azimuth_deg = 0.0f, elevation_deg = 0.0f;  ///< Turned about the focal point after all else.
};

enum class Background : std::uint8_t { color, environment };

/// How the colours of transparent surfaces are put in order.
enum class Transparency : std::uint8_t {
  sorted,  ///< Triangles are drawn by the distance of their middles.
  exact,   ///< Fragments are blended by their depth, pixel by pixel.
};

/// Properties given in place of those of every material.
struct MaterialOverride {
  std::optional<glm::vec3> base_color;
  std::optional<float> metallic, roughness;
  ExactMaterial exact;
};

/// A picture that the user lays on the surfaces of all materials that have TEXCOORD_0.
struct UserMap {
  std::string path;
  std::shared_ptr<const raster::Texture> picture;  ///< Read from there; null: nothing is drawn with it.
  glm::vec2 repeat{1, 1};
  float height = BumpMap().height;  ///< Of bump maps, as BumpMap::height
  raster::BumpForm form = raster::BumpForm::invariant;
};

/// Maps in place of those of every material.
struct MapOverride {
  bool drawn = true;                    ///< False: neither these nor the materials'.
  std::optional<UserMap> bump;          ///< Also in place of a normal map
  std::optional<UserMap> transparency;  ///< Its alpha is the opacity.
  std::optional<UserMap> specularity;
};

/// Displacement as the user wants it: of all surfaces, and in place of the materials' own.
struct UserDisplacement {
  std::string source;  ///< "constant" (height 1), a procedure, or a picture's path; empty: the materials'.
  std::optional<SolidTexture> solid;               ///< Of that procedure; in the object's space always.
  std::shared_ptr<const raster::Texture> picture;  ///< Of that path: linear, with mip levels.
  std::optional<float> scale, bias;                ///< See Displacement.
  std::optional<int> pieces;

  bool names_picture() const { return !source.empty() && source != "constant" && !solid; }
};

/// Lines drawn over the finished picture.
struct Overlays {
  bool edges = false;    ///< Of the triangles that are seen.
  bool normals = false;  ///< Of the vertices that are seen.
  bool light_markers = false;
  bool mapping = false;  ///< The intermediate surfaces of mappings, their seams and poles.
};

/// Every choice that `barrido render` offers for one frame.
struct RenderSettings {
  int width = 1280, height = 720;
  pipeline::ShadeModel shading = pipeline::ShadeModel::phong;
  pipeline::FlatAt flat_at = pipeline::FlatAt::centroid;
  pipeline::CheapPhongPower cheap_phong_power = pipeline::CheapPhongPower::pixel;
  pipeline::SpecularModel lighting = pipeline::SpecularModel::blinn;
  pipeline::ColorInterpolation color_interpolation = pipeline::ColorInterpolation::perspective;
  pipeline::TextureInterpolation texture_interpolation = pipeline::TextureInterpolation::perspective;
  std::optional<raster::MinFilter> min_filter;  ///< Empty: the file's.
  std::optional<raster::MagFilter> mag_filter;
  int max_anisotropy = 1;  ///< Samples along a footprint at most, of materials' pictures
  bool textures = true;
  TextureChoice texture;    ///< In place of every material's.
  bool mip_colors = false;  ///< Base colour pictures show a colour for each mip level.
  CameraChoice camera;
  std::vector<UserLight> lights;  ///< Any: these replace the file's.
  bool no_lights = false;
  std::vector<int> lights_off;  ///< Places, from 0, among the lights that the frame would have.
  std::optional<glm::vec3> ambient;
  std::shared_ptr<const raster::Texture> environment;  ///< Cube map; null: none.
  bool dynamic_environment = false;                    ///< Rendered from each reflecting object's centre.
  Background background = Background::color;
  std::optional<glm::vec4> background_color;
  std::optional<raster::FogState> fog;
  bool fog_takes_background = false;       ///< The colour of `fog` is the background's, whoever gave that.
  std::optional<pipeline::CullFace> cull;  ///< Empty: as the materials say.
  Transparency transparency = Transparency::sorted;
  bool wireframe = false;
  Overlays overlays;
  MaterialOverride material;
  MapOverride maps;
  UserDisplacement displacement;
  std::optional<std::uint64_t> max_memory;  ///< Bytes for displaced surfaces; empty: Budget's default.
  std::optional<float> crease_angle_deg;    ///< Set: normals are averaged where a model has none.
  ColorManagement color_management = ColorManagement::srgb;
  float exposure_ev = 0.0f;
  raster::ToneMap tone_map = raster::ToneMap::clamp;
  int scene_index = kNone;  ///< kNone: the file's default.
  std::string variant;      ///< Name of a variant of materials; empty: none.
  int animation = kNone;
  double time_s = 0.0;
  SampleChoice samples;                           ///< What a pixel is an average over.
  raster::SampleReport* sample_report = nullptr;  ///< Filled by adaptive sampling unless null.
  double frames_per_second = 30.0;                ///< What the shutter's times are counted in.
  float turn_a_frame_deg = 0.0f;  ///< The eye goes so far round the focal point while a frame lasts.
  bool keep_float = false;        ///< Keep float colours for exr and hdr.
  bool keep_depth = false;        ///< Keep the depth for reading; 1 where nothing was drawn.
  bool visibility_first = true;
  raster::StageProfile* profile = nullptr;  ///< Where the time goes is added here; null: no clock is read.
};

class FrameObserver;

/// The moment of a frame, `frames` frames after its own: of the animation, and of a turntable.
RenderSettings at_moment(const RenderSettings& settings, double frames);

/// A scene made ready for drawing many frames: textures with their mip chains are built once and kept.
class SceneRenderer {
 public:
  /// `scene` must outlive the renderer.
  explicit SceneRenderer(const Scene& scene);
  ~SceneRenderer();

  /// Draws one frame into a new framebuffer. `observer`, unless null, is shown the frame first and may say
  /// that it need not be drawn; the framebuffer is empty then. It is shown the frame of one sample, at the
  /// pixels' centres, whatever SampleChoice says; and that is drawn.
  raster::Framebuffer render(const RenderSettings& settings, pipeline::Statistics* statistics = nullptr,
                             FrameObserver* observer = nullptr);

  /// The view that `render` would use.
  View view(const RenderSettings& settings) const;

  /// Warnings of the last render that are not in Scene::warnings ("more than 64 lights: the first 64 are
  /// used").
  const std::vector<std::string>& warnings() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace barrido::scene
