#include <bit>
#include <stdexcept>

#include "pipeline/inspect/fragment_story.h"
#include "pipeline/inspect/pixel_story.h"
#include "pipeline/scene/draw_state.h"
#include "pipeline/scene/scene_nodes.h"
#include "raster/reference/fragment_operations.h"
#include "raster/reference/resolve.h"

namespace barrido::inspect {
namespace {

/// What the lights of a frame are called, in order.
std::vector<std::string> light_names(const scene::Scene& scene, const scene::RenderSettings& settings,
                                     std::size_t count) {
  std::vector<std::string> names;
  if (settings.lights.empty()) {
    const int root = scene::resolve_scene_index(scene, settings.scene_index);
    for (const int node : scene::light_nodes(scene, scene::nodes_of_scene(scene, root))) {
      const scene::Node& from = scene.nodes[static_cast<std::size_t>(node)];
      const std::string& own = scene.lights[static_cast<std::size_t>(from.light)].name;
      names.push_back(!from.name.empty() ? from.name : own);
    }
    if (names.empty()) names = {"key", "fill", "back"};
  }
  names.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (names[i].empty()) names[i] = "light " + std::to_string(i + 1);
  }
  return names;
}

/// Whether nothing of the pixel's former colour is left after the fragment.
bool covers_all(const FragmentStory& fragment) {
  const raster::FragmentState& s = fragment.state;
  return !s.blend.enabled && s.color_mask[0] && s.color_mask[1] && s.color_mask[2];
}

void decide_fates(PixelStory& story) {
  bool covered = false;
  for (std::size_t i = story.fragments.size(); i-- > 0;) {
    FragmentStory& fragment = story.fragments[i];
    const raster::reference::FateTrace& fate = fragment.trace.fate;
    fragment.fate = fragment.trace.outside_scissor ? Fate::scissored
                    : !fate.alpha_passed           ? Fate::cut_out
                    : !fate.depth_passed           ? Fate::hidden
                    : covered                      ? Fate::covered
                                                   : Fate::visible;
    if (fragment.fate != Fate::visible && fragment.fate != Fate::covered) continue;
    if (story.front < 0) story.front = static_cast<int>(i);
    covered = covered || covers_all(fragment);
  }
}

class PixelObserver final : public scene::FrameObserver {
 public:
  PixelObserver(const scene::Scene& scene, const scene::RenderSettings& settings,
                std::vector<PixelStory>& stories)
      : scene_(scene), settings_(settings), stories_(stories) {}

  bool observe(const scene::ObservedFrame& frame) override {
    const std::vector<FrameChunk> places = chunks_of(frame);
    std::vector<const raster::PrimitiveChunk*> chunks;
    for (const FrameChunk& place : places) chunks.push_back(place.chunk->chunk);
    const std::vector<std::string> names = light_names(scene_, settings_, frame.lights.lights.size());
    for (PixelStory& story : stories_) {
      raster::reference::PixelTrace trace = raster::reference::trace_pixel(
          chunks, frame.assembled.clear, frame.options, story.x, story.window_y);
      const FragmentContext context{scene_, frame, names, story.x, story.window_y};
      for (raster::reference::FragmentTrace& fragment : trace.fragments) {
        const FrameChunk& place = places[fragment.chunk];
        story.fragments.push_back(tell_fragment(context, place, std::move(fragment)));
      }
      tell_frame(frame, story);
      if (frame.backing) make_straight(*frame.backing, trace, story);
      tell_result(trace, story);
    }
    return false;
  }

 private:
  static void tell_frame(const scene::ObservedFrame& frame, PixelStory& story) {
    story.perspective = !scene::is_parallel(frame.view);
    story.format = frame.options.format;
    story.display = frame.options.display;
  }

  static void make_straight(const scene::Backing& backing, raster::reference::PixelTrace& trace,
                            PixelStory& story) {
    const Color straight = scene::straight_color(trace.color, trace.depth, backing);
    if (straight == trace.color) return;
    story.blended = trace.color;
    trace.color = straight;
    trace.color8 = story.format == raster::ColorFormat::rgba32f
                       ? raster::reference::display_color(story.display, straight)
                       : raster::reference::pack_rgba8(straight);
  }

  static void tell_result(const raster::reference::PixelTrace& trace, PixelStory& story) {
    story.clear = trace.clear;
    story.clear_depth = trace.clear_depth;
    story.color = trace.color;
    story.depth = trace.depth;
    story.rgba8 = std::bit_cast<std::array<std::uint8_t, 4>>(trace.color8);
    for (std::size_t c = 0; c < 3; ++c) {
      story.displayed[c] = story.format == raster::ColorFormat::rgba32f
                               ? raster::reference::display_channel(story.display, trace.color[c])
                               : trace.color[c];
    }
  }

  const scene::Scene& scene_;
  const scene::RenderSettings& settings_;
  std::vector<PixelStory>& stories_;
};

PixelStory begin_story(const scene::Scene& scene, const scene::RenderSettings& settings,
                       const PixelPosition& pixel) {
  const auto& [x, y] = pixel;
  if (x < 0 || y < 0 || x >= settings.width || y >= settings.height) {
    throw std::out_of_range("pixel " + std::to_string(x) + "," + std::to_string(y) +
                            " is outside the frame of " + std::to_string(settings.width) + " x " +
                            std::to_string(settings.height) + " pixels (0,0 is the upper left one)");
  }
  PixelStory story;
  story.source = scene.source;
  story.width = settings.width;
  story.height = settings.height;
  story.x = x;
  story.y = y;
  story.window_y = settings.height - 1 - y;
  story.shading = settings.shading;
  story.lighting = settings.lighting;
  return story;
}

}  // namespace

std::vector<PixelStory> inspect_pixels(const scene::Scene& scene, scene::SceneRenderer& renderer,
                                       const scene::RenderSettings& settings,
                                       std::span<const PixelPosition> pixels) {
  std::vector<PixelStory> stories;
  for (const PixelPosition& pixel : pixels) stories.push_back(begin_story(scene, settings, pixel));
  PixelObserver observer(scene, settings, stories);
  renderer.render(settings, nullptr, &observer);
  for (PixelStory& story : stories) decide_fates(story);
  return stories;
}

PixelStory inspect_pixel(const scene::Scene& scene, scene::SceneRenderer& renderer,
                         const scene::RenderSettings& settings, int x, int y) {
  const PixelPosition pixel{x, y};
  return std::move(inspect_pixels(scene, renderer, settings, {&pixel, 1}).front());
}

}  // namespace barrido::inspect
