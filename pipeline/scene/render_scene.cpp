// How a scene becomes a frame: pose, eye and lights; one draw a primitive; then passes over the draws, the
// opaque ones first, what lies behind everything next, the transparent ones from back to front.
#include "pipeline/scene/render_scene.h"

#include <algorithm>
#include <map>
#include <utility>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "pipeline/scene/blended_order.h"
#include "pipeline/scene/environment_pass.h"
#include "pipeline/scene/frame.h"
#include "pipeline/scene/frame_observer.h"
#include "pipeline/scene/moving_properties.h"
#include "pipeline/scene/overlay.h"
#include "pipeline/scene/sample_loop.h"
#include "pipeline/scene/straight_alpha.h"
#include "pipeline/scene/why_empty.h"
#include "raster/base/portable_math.h"
#include "raster/tiles/pixel_layers.h"

namespace barrido::scene {
namespace {

constexpr int kDynamicMapSize = 256;
constexpr std::size_t kMaxDynamicMaps = 16;

/// One look at the draws of a frame.
struct Pass {
  View view;
  double aspect = 1.0;
  bool backdrop = false;
  Overlays overlays;
  int without_node = kNone;  ///< Whose surroundings are being rendered
  /// Cube maps of single nodes, in world space; the others reflect the frame's surroundings.
  const std::map<int, raster::Texture>* node_maps = nullptr;
  FrameObserver* observer = nullptr;
  std::optional<Backing> backing;
  const raster::SampleSettings* samples = nullptr;  ///< Null: one, at the pixel's centre.
};

glm::mat4 world_from_eye_rotation(const View& view) {
  return glm::mat4(glm::transpose(glm::mat3(view.eye_from_world)));
}

raster::FramebufferOptions frame_options(const RenderSettings& settings) {
  raster::FramebufferOptions options;
  options.width = settings.width;
  options.height = settings.height;
  options.keep_depth = settings.keep_depth;
  if (!uses_float_frame(settings)) return options;
  options.format = raster::ColorFormat::rgba32f;
  options.keep_float = settings.keep_float;
  options.display = {portable_exp2(settings.exposure_ev), settings.tone_map,
                     settings.color_management == ColorManagement::srgb};
  return options;
}

/// Where surfaces that are blended in any way, or cut out, lie before a background that lets something
/// through, colours must be made straight at the end.
std::optional<Backing> backing_of(const SceneFrame& frame) {
  const glm::vec4& c = frame.clear_color;
  const std::vector<Draw>& draws = frame.list.draws;
  const bool is_mixed = std::any_of(draws.begin(), draws.end(), [](const Draw& draw) {
    return draw.surface.alpha_mode != AlphaMode::opaque || draw.surface.blending != Blending::none;
  });
  if (!is_mixed || c.a >= 1.0f || frame.backdrop_in_view) return std::nullopt;
  return Backing{{c.r, c.g, c.b, c.a}, frame.view.clear_depth};
}

/// What making colours straight needs to know is kept until that is done.
raster::FramebufferOptions frame_options(const RenderSettings& settings, bool has_backing) {
  raster::FramebufferOptions options = frame_options(settings);
  options.keep_depth = options.keep_depth || has_backing;
  options.keep_float = options.keep_float || (has_backing && uses_float_frame(settings));
  return options;
}

void finish_colors(raster::Framebuffer& framebuffer, const std::optional<Backing>& backing,
                   const RenderSettings& settings) {
  if (backing) {
    make_straight(framebuffer, *backing);
    if (!settings.keep_depth) framebuffer.depth() = {};
    if (!settings.keep_float) framebuffer.color_float() = {};
  }
  // A background deeper than everything is the renderer's own device.
  for (float& depth : framebuffer.depth()) depth = std::min(depth, 1.0f);
}

/// A face of an environment map holds light, not a picture: no exposure, no tone reproduction.
raster::FramebufferOptions face_options(const RenderSettings& settings) {
  raster::FramebufferOptions options = frame_options(settings);
  options.width = options.height = kDynamicMapSize;
  options.keep_float = options.keep_depth = false;
  options.display.exposure_scale = 1.0f;
  options.display.tone_map = raster::ToneMap::clamp;
  return options;
}

/// Draws the frame's draws with one state each.
class PassRenderer {
 public:
  PassRenderer(const RenderSettings& settings, const SceneFrame& frame, const Pass& pass,
               ReflectionMaps& reflections, ReflectionMaps& node_reflections,
               raster::Framebuffer& framebuffer)
      : settings_(settings),
        frame_(frame),
        pass_(pass),
        reflections_(reflections),
        node_reflections_(node_reflections),
        framebuffer_(framebuffer),
        renderer_(framebuffer, {settings.visibility_first, settings.profile, pass.samples},
                  pass.observer != nullptr ? &assembled_ : nullptr),
        base_(base_state(settings, pass.view, frame.lights, frame.fog)),
        overlay_(settings, pass.view),
        surroundings_from_eye_(frame.surroundings_from_world * world_from_eye_rotation(pass.view)) {}

  pipeline::Statistics run() {
    raster::ClearValues clear;
    const glm::vec4& color = frame_.clear_color;
    const float weight = pass_.backing ? color.a : 1.0f;
    clear.color = {color.r * weight, color.g * weight, color.b * weight, color.a};
    clear.depth = pass_.view.clear_depth;
    renderer_.clear(clear);
    for (const Draw& draw : frame_.list.draws) {
      if (draw.surface.blending == Blending::none) submit(draw, draw.geometry);
    }
    if (pass_.backdrop) {
      const std::size_t draws = assembled_.draws.size();
      draw_backdrop(renderer_, {frame_.surroundings, surroundings_from_eye_}, pass_.view, pass_.aspect,
                    base_.clamp_colors);
      if (assembled_.draws.size() > draws) origins_.emplace_back().backdrop = true;
    }
    submit_blended();
    const std::size_t own = assembled_.draws.size();
    overlay_.draw(renderer_, base_, frame_, pass_.overlays);
    // Lines over the picture are nothing of the file's.
    origins_.resize(origins_.size() + assembled_.draws.size() - own);
    const bool drawn =
        pass_.observer == nullptr || pass_.observer->observe({assembled_, origins_, pass_.view, frame_.lights,
                                                              framebuffer_.options(), pass_.backing});
    if (drawn) renderer_.finish();
    drawn_ = drawn;
    return renderer_.statistics();
  }

  /// After run(): into how many slices blended triangles were sorted; 0: one by one.
  int slices() const { return order_.slices; }
  /// After run(): false when an observer did not want it.
  bool is_drawn() const { return drawn_; }

 private:
  void submit(const Draw& draw, const pipeline::Geometry& geometry) {
    if (draw.node == pass_.without_node) return;
    const bool write_alpha = frame_.clear_color.a < 1.0f;
    if (pass_.observer != nullptr) {
      origins_.push_back(
          {false, draw.node, draw.mesh, draw.primitive, draw.material, &draw.geometry, draw.displaced});
    }
    renderer_.draw(state_of(base_, settings_, pass_.view, draw, reflection_of(draw), write_alpha), geometry);
  }

  /// The triangles of all of them in one order.
  void submit_blended() {
    std::vector<const Draw*> blended;
    std::vector<BlendedDraw> ordered;
    for (const Draw& draw : frame_.list.draws) {
      if (draw.surface.blending == Blending::none || draw.node == pass_.without_node) continue;
      blended.push_back(&draw);
      ordered.push_back({&draw.geometry, distance_of(draw), draw.center});
    }
    if (settings_.transparency == Transparency::exact) {
      for (const Draw* draw : blended) submit(*draw, draw->geometry);
      return;
    }
    order_ = order_blended(ordered);
    for (const BlendedPiece& piece : order_.pieces) {
      pipeline::Geometry geometry = blended[piece.draw]->geometry;
      if (!piece.indices.empty()) {
        geometry.mode = pipeline::PrimitiveMode::triangles;
        geometry.indices = piece.indices;
      }
      submit(*blended[piece.draw], geometry);
    }
  }

  EyeDistance distance_of(const Draw& draw) const {
    return {pass_.view.eye_from_world * draw.world_from_object, is_parallel(pass_.view)};
  }

  Reflection reflection_of(const Draw& draw) {
    if (draw.surface.reflection_unit == kNone) return {};
    if (pass_.node_maps != nullptr) {
      const auto own = pass_.node_maps->find(draw.node);
      if (own != pass_.node_maps->end()) {
        return {&node_reflections_.get(own->second, draw.surface.reflection_exponent),
                world_from_eye_rotation(pass_.view)};
      }
    }
    return {&reflections_.get(*frame_.surroundings, draw.surface.reflection_exponent),
            surroundings_from_eye_};
  }

  const RenderSettings& settings_;
  const SceneFrame& frame_;
  const Pass& pass_;
  ReflectionMaps& reflections_;
  ReflectionMaps& node_reflections_;
  raster::Framebuffer& framebuffer_;
  pipeline::AssembledFrame assembled_;  // both only where somebody observes
  std::vector<DrawOrigin> origins_;
  pipeline::Renderer renderer_;
  pipeline::State base_;
  Overlay overlay_;
  glm::mat4 surroundings_from_eye_;
  BlendedOrder order_;  // index lists of this pass, until it is finished
  bool drawn_ = false;
};

}  // namespace

struct SceneRenderer::Implementation {
  explicit Implementation(const Scene& drawn)
      : at_rest(drawn),
        moved(has_moving_properties(drawn) ? std::make_unique<Scene>(copy_without_pictures(drawn)) : nullptr),
        scene(moved ? *moved : drawn),
        caches(std::make_unique<SceneCaches>(drawn)) {}

  /// Pictures and colours that are multiplied by factors are kept: not for ever, where the factors move.
  void move(const RenderSettings& settings) {
    constexpr int kMomentsKept = 64;
    if (!moved) return;
    const std::pair moment(settings.animation, settings.time_s);
    if (moment == last_moment) return;
    last_moment = moment;
    move_properties(at_rest, settings.animation, settings.time_s, *moved);
    if (++moments % kMomentsKept == 0) caches = std::make_unique<SceneCaches>(at_rest);
  }

  const Scene& at_rest;
  std::unique_ptr<Scene> moved;  ///< Null where nothing moves but nodes.
  const Scene& scene;            ///< Whichever is drawn.
  std::unique_ptr<SceneCaches> caches;
  std::optional<std::pair<int, double>> last_moment;
  int moments = 0;
  std::vector<std::string> warnings;

  void draw(const SampleGo& go, FrameObserver* observer, std::optional<raster::Framebuffer>& framebuffer,
            pipeline::Statistics& work);
  double focus_from_pixel(RenderSettings settings);
  Lens lens_of(const RenderSettings& settings);

  raster::Texture environment_of(int node, const glm::dvec3& center, const RenderSettings& settings,
                                 const SceneFrame& frame, pipeline::Statistics& work) {
    std::vector<raster::Framebuffer> faces;
    ReflectionMaps unused;
    for (int face = 0; face < raster::kCubeFaces; ++face) {
      const Sphere& sphere = frame.posed.bounds.sphere;
      const Pass pass{cube_face_view(face, center, {sphere.center - frame.posed.pose.origin, sphere.radius}),
                      1.0,
                      frame.backdrop_in_reflection,
                      {},
                      node,
                      nullptr,
                      nullptr,
                      {},
                      nullptr};
      faces.emplace_back(face_options(settings));
      add(work, PassRenderer(settings, frame, pass, caches->reflections, unused, faces.back()).run());
    }
    return cube_of_frames(faces, color_encoding(settings));
  }

  void warn(const SceneFrame& frame, const RenderSettings& settings, const pipeline::Statistics& drawn,
            int slices) {
    if (std::string reason = why_empty(frame, settings, drawn); !reason.empty()) warnings.push_back(reason);
    if (const std::uint64_t crowded = drawn.raster.crowded_fragments; crowded > 0) {
      warnings.push_back("more than " + std::to_string(raster::kMaxPixelLayers) +
                         " transparent layers lie in some pixels: of the farthest, " +
                         std::to_string(crowded) + (crowded == 1 ? " fragment is" : " fragments are") +
                         " blended in the order of drawing");
    }
    if (slices == 0) return;
    warnings.push_back(
        "transparent surfaces lie within each other too often to sort all their triangles: "
        "they are sorted in " +
        std::to_string(slices) + " slices");
  }

  std::map<int, raster::Texture> environments(const RenderSettings& settings, const SceneFrame& frame,
                                              pipeline::Statistics& work) {
    std::map<int, raster::Texture> maps;
    const std::map<int, glm::dvec3> nodes = reflecting_nodes(frame);
    if (nodes.size() > kMaxDynamicMaps) {
      warnings.push_back("more than " + std::to_string(kMaxDynamicMaps) +
                         " reflecting objects: the first have environments of their own");
    }
    for (const auto& [node, center] : nodes) {
      if (maps.size() == kMaxDynamicMaps) break;
      maps.emplace(node, environment_of(node, center, settings, frame, work));
    }
    return maps;
  }
};

/// Draws into `framebuffer`, which is made when it is not there yet.
void SceneRenderer::Implementation::draw(const SampleGo& go, FrameObserver* observer,
                                         std::optional<raster::Framebuffer>& framebuffer,
                                         pipeline::Statistics& work) {
  const RenderSettings& settings = go.settings;
  std::vector<std::string> unused;
  move(settings);
  const SceneFrame frame = prepare_frame(scene, settings, *caches, go.warns ? warnings : unused, go.look);
  const std::optional<Backing> backing = backing_of(frame);
  const bool is_sampled = go.samples != nullptr;
  if (is_sampled) set_background(*go.samples, frame, backing);
  if (!framebuffer) framebuffer.emplace(frame_options(settings, backing.has_value() && !is_sampled));
  std::map<int, raster::Texture> node_maps;
  if (settings.dynamic_environment) node_maps = environments(settings, frame, work);
  ReflectionMaps node_reflections;
  const Pass pass{frame.view,        frame.aspect, frame.backdrop_in_view,
                  settings.overlays, kNone,        &node_maps,
                  observer,          backing,      go.samples};
  PassRenderer renderer(settings, frame, pass, caches->reflections, node_reflections, *framebuffer);
  const pipeline::Statistics own = renderer.run();
  add(work, own);
  work.displaced_vertices = frame.list.displaced_vertices;
  work.displaced_triangles = frame.list.displaced_triangles;
  if (!renderer.is_drawn()) return;
  // Sums of samples have become straight colours already.
  finish_colors(*framebuffer, is_sampled ? std::nullopt : backing, settings);
  if (go.warns) warn(frame, settings, own, renderer.slices());
}

/// The distance that is seen at the pixel to focus on; 0 where there is nothing.
double SceneRenderer::Implementation::focus_from_pixel(RenderSettings settings) {
  const PixelPlace place = *settings.samples.focus_pixel;
  if (place.x >= settings.width || place.y >= settings.height) return 0.0;
  settings.samples = {};
  settings.keep_depth = true;
  std::optional<raster::Framebuffer> framebuffer;
  pipeline::Statistics unused;
  draw({settings, nullptr, {}, false}, nullptr, framebuffer, unused);
  const View view = choose_view(scene, pose_scene(scene, settings, *caches), settings);
  return distance_at(view, framebuffer->depth()[framebuffer->index(place.x, settings.height - 1 - place.y)]);
}

Lens SceneRenderer::Implementation::lens_of(const RenderSettings& settings) {
  if (!settings.samples.has_lens()) return {};
  move(settings);
  const double seen = settings.samples.focus_pixel ? focus_from_pixel(settings) : 0.0;
  return choose_lens(scene, pose_scene(scene, settings, *caches), settings, seen, warnings);
}

SceneRenderer::SceneRenderer(const Scene& scene) : implementation_(std::make_unique<Implementation>(scene)) {}
SceneRenderer::~SceneRenderer() = default;

raster::Framebuffer SceneRenderer::render(const RenderSettings& settings, pipeline::Statistics* statistics,
                                          FrameObserver* observer) {
  Implementation& self = *implementation_;
  self.warnings.clear();
  pipeline::Statistics work;
  std::optional<raster::Framebuffer> framebuffer;
  if (observer != nullptr) {
    self.draw({settings}, observer, framebuffer, work);
  } else {
    for_each_go(settings, self.lens_of(settings),
                [&](const SampleGo& go) { self.draw(go, nullptr, framebuffer, work); });
  }
  if (statistics != nullptr) *statistics = work;
  return std::move(*framebuffer);
}

RenderSettings at_moment(const RenderSettings& settings, double frames) {
  RenderSettings then = settings;
  then.time_s += frames / settings.frames_per_second;
  then.camera.azimuth_deg += static_cast<float>(static_cast<double>(settings.turn_a_frame_deg) * frames);
  return then;
}

View SceneRenderer::view(const RenderSettings& settings) const {
  Implementation& self = *implementation_;
  self.move(settings);
  return choose_view(self.scene, pose_scene(self.scene, settings, *self.caches), settings);
}

const std::vector<std::string>& SceneRenderer::warnings() const { return implementation_->warnings; }

}  // namespace barrido::scene
