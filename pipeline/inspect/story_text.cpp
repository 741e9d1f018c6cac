#include "pipeline/inspect/story_text_parts.h"
#include "pipeline/inspect/story_words.h"

namespace barrido::inspect {
namespace {

std::string named(const char* kind, int index, const std::string& name) {
  if (index == scene::kNone) return std::string(kind) + " none";
  return std::string(kind) + " " + std::to_string(index) + (name.empty() ? "" : " '" + name + "'");
}

/// "hidden: z 0.9 is not < 0.5".
std::string fate_words(const FragmentStory& f) {
  const auto& fate = f.trace.fate;
  switch (f.fate) {
    case Fate::visible:
      return "visible: z " + number(f.trace.depth) +
             (f.state.depth.test
                  ? " " + std::string(name_of(f.state.depth.compare)) + " " + number(fate.depth_before)
                  : "") +
             (f.state.blend.enabled ? ", blended" : "") +
             (fate.layer > 0 ? " as layer " + std::to_string(fate.layer) + " from behind" : "");
    case Fate::covered:
      return "drawn, then covered: z " + number(f.trace.depth);
    case Fate::hidden:
      return "hidden: z " + number(f.trace.depth) + " is not " + std::string(name_of(f.state.depth.compare)) +
             " " + number(fate.depth_before);
    case Fate::cut_out:
      return "cut out: alpha " + number(f.trace.shading.color[3]) + " is not " +
             std::string(name_of(f.state.alpha_test.compare)) + " " + number(f.state.alpha_test.reference);
    case Fate::scissored:
      break;
  }
  return "outside the scissor";
}

void tell_list(const PixelStory& story, Lines& lines) {
  if (story.fragments.empty()) {
    lines.add(0, "No triangle covers this pixel: it shows the background.");
    return;
  }
  lines.add(0, story.fragments.size() == 1 ? "One fragment:"
                                           : std::to_string(story.fragments.size()) +
                                                 " fragments, in the order in which they reach the pixel:");
  for (std::size_t i = 0; i < story.fragments.size(); ++i) {
    lines.add(1, std::to_string(i + 1) + "  " + source_words(story.fragments[i]));
    lines.add(3, fate_words(story.fragments[i]));
  }
}

void tell_display(const PixelStory& story, Lines& lines) {
  const std::string bytes = std::to_string(story.rgba8[0]) + ", " + std::to_string(story.rgba8[1]) + ", " +
                            std::to_string(story.rgba8[2]) + ", " + std::to_string(story.rgba8[3]);
  if (story.blended) {
    lines.add(0, "The fragments left " + tuple(*story.blended) +
                     ", weighted by alpha; straight, and opaque where something solid is seen:");
  }
  lines.add(0, "The pixel: " + tuple(story.color));
  if (story.format == raster::ColorFormat::rgba32f) {
    std::string steps;
    if (story.display.exposure_scale != 1.0f)
      steps += " x " + number(story.display.exposure_scale) + " (exposure),";
    steps += story.display.tone_map == raster::ToneMap::reinhard ? " c/(1 + c)," : " clamped to 0..1,";
    if (story.display.srgb_encode) steps += " encoded as sRGB,";
    steps.back() = ':';
    lines.add(1, "colour" + steps + " " + tuple(story.displayed));
  }
  lines.add(1, "x 255, rounded: " + bytes);
}

}  // namespace

std::string source_words(const FragmentStory& f) {
  if (f.backdrop) return "the environment behind everything";
  const std::string kind(name_of(f.topology));
  const std::string what = f.topology == raster::Topology::triangles ? "triangle "
                           : !f.of_polygon                           ? kind + " "
                           : f.topology == raster::Topology::lines   ? "edge of triangle "
                                                                     : "corner of triangle ";
  return what + std::to_string(f.triangle) + " of " + named("mesh", f.mesh, f.mesh_name) + " primitive " +
         std::to_string(f.primitive) + ", " + named("node", f.node, f.node_name) + ", " +
         named("material", f.material, f.material_name) + (f.back_facing ? ", seen from behind" : "");
}

std::string story_text(const PixelStory& story) {
  Lines lines;
  lines.add(0, "Pixel " + std::to_string(story.x) + "," + std::to_string(story.y) + " of " +
                   std::to_string(story.width) + " x " + std::to_string(story.height) +
                   ", counted from the upper left (in the window y = " + std::to_string(story.window_y) +
                   ", from the bottom)");
  lines.add(0, story.source + ", shading " + std::string(pipeline::shading_mode(story.shading).name));
  lines.blank();
  tell_list(story, lines);
  lines.add(0, "Background: " + tuple(story.clear) + ", z " + number(story.clear_depth));
  for (std::size_t i = 0; i < story.fragments.size(); ++i) {
    const FragmentStory& fragment = story.fragments[i];
    if (fragment.fate != Fate::visible) continue;
    lines.blank();
    lines.add(0, "Fragment " + std::to_string(i + 1) + ": " + source_words(fragment));
    tell_shading(story, fragment, lines);
    tell_fate(fragment, lines);
  }
  lines.blank();
  tell_display(story, lines);
  return lines.take();
}

}  // namespace barrido::inspect
