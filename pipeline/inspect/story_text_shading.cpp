#include <algorithm>
#include <cmath>

#include "pipeline/inspect/story_text_parts.h"
#include "pipeline/inspect/story_words.h"

namespace barrido::inspect {
namespace {

using raster::Meaning;
using raster::reference::ShadingTrace;
using raster::reference::UnitTrace;

std::string at(int x, int y) { return std::to_string(x) + ", " + std::to_string(y); }

void tell_corners(const FragmentStory& f, Lines& lines) {
  if (f.corners.empty()) return;
  lines.add(1, f.clipped ? "Corners in the file; clipping left a piece of it here:" : "Corners:");
  for (const CornerStory& c : f.corners) {
    std::string line =
        "vertex " + std::to_string(c.vertex) + " at " + tuple(c.object) + ": weight " + number(c.weight);
    if (!f.clipped && c.screen_weight != c.weight) {
      line += " (" + number(c.screen_weight) + " on the screen)";
    }
    lines.add(2, line);
    if (c.displaced) lines.add(3, "displaced by " + number(*c.displaced) + " along its normal");
    lines.add(3, "window (" + number(c.window_x) + ", " + number(c.window_y) + "), z = " + number(c.depth) +
                     ", w = " + number(c.w));
    if (c.lit) {
      lines.add(
          3, "colour " + tuple(*c.lit) + (c.lit_secondary ? ", highlights " + tuple(*c.lit_secondary) : ""));
    }
  }
}

/// "0.5 + 0.001·12": a quantity at the span's first pixel and its step.
std::string along(const raster::reference::SpanQuantity& quantity, int steps) {
  return number(quantity.row) + " + " + std::to_string(steps) + "·" + number(quantity.ddx) + " = " +
         number(quantity.at(static_cast<float>(steps)));
}

void tell_span(const FragmentStory& f, int x, Lines& lines) {
  const auto& trace = f.trace;
  const int steps = x - trace.along.anchor;
  const int begin = trace.span.first, last = trace.span.end - 1;
  lines.add(1, "Scanline y = " + std::to_string(trace.span.y) +
                   (begin == last ? ": pixel " + std::to_string(begin)
                                  : ": pixels " + std::to_string(begin) + " to " + std::to_string(last) +
                                        "; from the first of them " + std::to_string(steps) +
                                        (steps == 1 ? " step" : " steps")));
  lines.add(2, "z   = " + along(trace.along.quantities[raster::kRecordDepth], steps));
  lines.add(2, "1/w = " + along(trace.along.quantities[raster::kRecordQ], steps) +
                   ", w = " + number(1.0 / trace.q));
  const raster::VaryingList& varyings = f.state.varyings;
  const auto tell = [&](const char* name, Meaning meaning) {
    if (!varyings.has(meaning)) return;
    const int at = varyings.at(meaning);
    const auto first = trace.varyings.begin() + at;
    const std::vector<float> values(first, first + varyings.floats(meaning));
    lines.add(2, std::string(name) + " = " + tuple(values) +
                     (at < varyings.affine_count ? " (linear on the screen)" : ""));
  };
  tell("colour", Meaning::color);
  tell("highlights", Meaning::specular);
  tell("normal", Meaning::normal);
  tell("eye position", Meaning::eye_position);
}

/// Gouraud's sum over the corners.
void tell_gouraud(const FragmentStory& f, Lines& lines) {
  const raster::VaryingList& varyings = f.state.varyings;
  if (f.corners.empty() || !f.corners[0].lit || !varyings.has(Meaning::color)) return;
  const bool on_screen = varyings.at(Meaning::color) < varyings.affine_count;
  if (f.clipped && on_screen) return;
  std::string sum;
  for (const CornerStory& c : f.corners) {
    sum += (sum.empty() ? "" : " + ") + number(on_screen ? c.screen_weight : c.weight) + "·" + tuple(*c.lit);
  }
  lines.add(1, "Interpolated: " + sum);
}

std::string texture_words(const UnitTrace& unit, const TextureStory& texture,
                          const raster::TextureUnit& state) {
  std::string words = "Texture unit " + std::to_string(unit.unit) + ", " + texture.role;
  if (!texture.image.empty()) words += " '" + texture.image + "'";
  words += ", " + std::to_string(texture.width) + " x " + std::to_string(texture.height);
  if (texture.cube) words += " cube map, face " + std::string(name_of_face(unit.sample.face));
  return words + ", " +
         std::string(unit.sample.magnified ? name_of(state.mag_filter) : name_of(state.min_filter)) +
         (unit.sample.magnified ? " (magnified)" : "") + ":";
}

/// The shape of the pixel on the texture, where the filter follows it.
void tell_footprint(const raster::reference::SampleTrace& sample, Lines& lines) {
  if (!sample.footprint) return;
  const auto& f = *sample.footprint;
  const auto side = [](const float(&to)[2]) { return std::hypot(to[0], to[1]); };
  lines.add(2, "footprint: sides " + tuple(std::span<const float>(f.along_x, 2)) + " and " +
                   tuple(std::span<const float>(f.along_y, 2)) + " in texels, " + number(side(f.along_x)) +
                   " and " + number(side(f.along_y)) + " long; " +
                   (f.probes == 0   ? "all texels under it"
                    : f.probes == 1 ? "one sample"
                                    : std::to_string(f.probes) + " samples"));
}

void tell_sample(const UnitTrace& unit, const TextureStory& texture, Lines& lines) {
  const auto& sample = unit.sample;
  const bool plain = !texture.cube;
  const float place[] = {sample.u, sample.v};  // after a mapping and tiles
  lines.add(2, (plain ? "s, t = " + tuple(place) : "direction = " + tuple(unit.coordinates)) +
                   (plain ? "" : ", place on the face " + number(sample.u) + ", " + number(sample.v)) +
                   "; level of detail λ = " + number(sample.lod));
  tell_footprint(sample, lines);
  int probe = 0;
  for (const auto& level : sample.levels) {
    if (level.probe != probe) lines.add(2, "sample " + std::to_string((probe = level.probe) + 1) + ":");
    lines.add(2, "level " + std::to_string(level.level) + " (" + std::to_string(level.width) + " x " +
                     std::to_string(level.height) + "):");
    constexpr std::size_t kMostTold = 16;
    const std::size_t told = std::min(level.texels.size(), kMostTold);
    for (std::size_t i = 0; i < told; ++i) {
      const auto& texel = level.texels[i];
      lines.add(3, "texel " + at(texel.i, texel.j) + " " + tuple(texel.color) +
                       (level.texels.size() > 1 ? " x " + number(texel.weight) : ""));
    }
    if (told < level.texels.size()) {
      lines.add(3, "and " + std::to_string(level.texels.size() - told) + " texels more");
    }
    if (level.texels.size() > 1) lines.add(3, "= " + tuple(level.color));
  }
  if (sample.footprint && sample.footprint->probes > 1) {
    lines.add(2, "mean of the " + std::to_string(sample.footprint->probes) + " samples" +
                     (sample.levels.size() > static_cast<std::size_t>(sample.footprint->probes)
                          ? ", " + number(sample.far_weight) + " of each from the smaller level"
                          : "") +
                     " = " + tuple(sample.color));
  } else if (sample.levels.size() > 1) {
    lines.add(2, number(1.0f - sample.far_weight) + " of level " + std::to_string(sample.levels[0].level) +
                     " + " + number(sample.far_weight) + " of level " +
                     std::to_string(sample.levels[1].level) + " = " + tuple(sample.color));
  }
}

std::string argument(const raster::CombineChannel& c, std::size_t k) {
  const std::string source(name_of(c.source[k]));
  switch (c.operand[k]) {
    case raster::CombineOperand::color:
      return source;
    case raster::CombineOperand::one_minus_color:
      return "(1 - " + source + ")";
    case raster::CombineOperand::alpha:
      return source + " alpha";
    case raster::CombineOperand::one_minus_alpha:
      break;
  }
  return "(1 - " + source + " alpha)";
}

/// The formula of a texture environment.
std::string environment_words(const raster::TextureUnit& state) {
  const raster::CombineChannel& c = state.combine.rgb;
  const std::string a = argument(c, 0), b = argument(c, 1), k = argument(c, 2);
  switch (state.env_mode) {
    case raster::TextureEnvMode::modulate:
      return "previous·texture";
    case raster::TextureEnvMode::replace:
      return "texture";
    case raster::TextureEnvMode::add:
      return "previous + texture";
    case raster::TextureEnvMode::decal:
      return "previous·(1 - texture alpha) + texture·texture alpha";
    case raster::TextureEnvMode::blend:
      return "previous·(1 - texture) + constant·texture";
    case raster::TextureEnvMode::combine:
      break;
  }
  switch (c.function) {
    case raster::CombineFunction::replace:
      return a;
    case raster::CombineFunction::modulate:
      return a + "·" + b;
    case raster::CombineFunction::add:
      return a + " + " + b;
    case raster::CombineFunction::add_signed:
      return a + " + " + b + " - 0.5";
    case raster::CombineFunction::subtract:
      return a + " - " + b;
    case raster::CombineFunction::dot3_rgb:
    case raster::CombineFunction::dot3_rgba:
      return "4 (" + a + " - 0.5)·(" + b + " - 0.5), of R, G and B together";
    case raster::CombineFunction::interpolate:
      break;
  }
  return a + "·" + k + " + " + b + "·(1 - " + k + ")";
}

/// What stages and procedures tell that have no record of their own.
void tell_notes(const std::vector<raster::reference::Note>& notes, int level, Lines& lines) {
  for (const raster::reference::Note& note : notes) {
    lines.add(level, std::string(note.name) + " = " +
                         (note.values.size() == 1 ? number(note.values[0]) : tuple(note.values)));
  }
}

template <class Value>
std::string title_of(Value value) {
  for (const Named<Value>& row : names_of<Value>()) {
    if (row.value == value) return std::string(row.title);
  }
  return {};
}

/// How the unit's coordinates come about, where they are not simply the file's.
void tell_mapping(const UnitTrace& unit, const raster::TextureUnit& state, Lines& lines) {
  if (state.mapping.surface == raster::MappingSurface::none) return;
  lines.add(2, "two-part mapping of " + tuple(unit.coordinates) + " to " + title_of(state.mapping.surface) +
                   ", reached by " + title_of(state.mapping.ray));
}

void tell_unit(const UnitTrace& unit, const TextureStory& texture, const raster::TextureUnit& state,
               Lines& lines) {
  if (state.procedure != nullptr) {
    lines.add(1, "Texture unit " + std::to_string(unit.unit) + ", " + texture.role + ": " +
                     std::string(state.procedure->story));
    lines.add(2, "at " + tuple(unit.coordinates));
    tell_mapping(unit, state, lines);
    tell_notes(unit.notes, 2, lines);
    lines.add(2, "texel " + tuple(unit.sample.color));
  } else {
    lines.add(1, texture_words(unit, texture, state));
    tell_mapping(unit, state, lines);
    tell_notes(unit.notes, 2, lines);
    tell_sample(unit, texture, lines);
  }
  const std::string formula = environment_words(state);
  lines.add(
      2, formula + ", with previous " + tuple(unit.previous) +
             (formula.find("constant") != std::string::npos ? ", constant " + tuple(state.env_color) : ""));
  lines.add(2, "= " + tuple(unit.color));
}

/// Maps with stages of their own; what they made of their texels stands in the notes.
void tell_maps(const FragmentStory& f, Lines& lines) {
  for (std::size_t i = 0; i < f.maps.size(); ++i) {
    const UnitTrace& map = f.trace.shading.maps[i];
    const raster::TextureUnit& state = f.state.texture_units[static_cast<std::size_t>(map.unit)];
    const TextureStory& texture = f.maps[i];
    if (state.procedure != nullptr) {
      lines.add(1, "Unit " + std::to_string(map.unit) + ", " + std::string(name_of(state.role)) + " by " +
                       texture.role + ": " + std::string(state.procedure->story));
    } else {
      lines.add(1, texture_words(map, texture, state));
      tell_sample(map, texture, lines);
    }
    lines.add(2, "texel " + tuple(map.sample.color) + ", strength " + number(state.strength));
    tell_notes(map.notes, 2, lines);
  }
}

void tell_combination(const FragmentStory& f, Lines& lines) {
  const ShadingTrace& shading = f.trace.shading;
  for (std::size_t i = 0; i < shading.units.size(); ++i) {
    const auto unit = static_cast<std::size_t>(shading.units[i].unit);
    tell_unit(shading.units[i], f.textures[i], f.state.texture_units[unit], lines);
  }
  if (shading.sum && shading.secondary != Color{}) {
    lines.add(1, "Highlights " + tuple(std::span<const float>(shading.secondary.data(), 3)) +
                     " are added after the textures = " + tuple(*shading.sum));
  }
  if (shading.fog) {
    lines.add(1, "Fog (" + std::string(name_of(f.state.fog.mode)) + ") at distance " +
                     number(shading.fog->distance) + ": f = " + number(shading.fog->fraction) +
                     "; f·colour + (1 - f)·" + tuple(std::span<const float>(f.state.fog.color.data(), 3)) +
                     " = " + tuple(shading.fog->color));
  }
}

}  // namespace

void tell_shading(const PixelStory& pixel, const FragmentStory& f, Lines& lines) {
  tell_corners(f, lines);
  tell_span(f, pixel.x, lines);
  tell_maps(f, lines);
  for (const IlluminationStory& story : f.illuminations) {
    tell_illumination(story, pixel.lighting, &story == f.illuminations.data(), lines);
  }
  if (f.from_products) tell_illumination(*f.from_products, pixel.lighting, true, lines);
  tell_gouraud(f, lines);
  const ShadingTrace& shading = f.trace.shading;
  lines.add(1, "Colour of the fragment " + tuple(shading.primary) +
                   (shading.secondary != Color{}
                        ? ", highlights " + tuple(std::span<const float>(shading.secondary.data(), 3))
                        : "") +
                   (shading.primary != shading.lit_primary ? " (clamped to 0..1)" : ""));
  tell_notes(shading.notes, 1, lines);
  tell_combination(f, lines);
}

void tell_fate(const FragmentStory& f, Lines& lines) {
  const auto& fate = f.trace.fate;
  if (f.state.alpha_test.enabled) {
    lines.add(1, "Alpha test: " + number(f.trace.shading.color[3]) + " " +
                     std::string(name_of(f.state.alpha_test.compare)) + " " +
                     number(f.state.alpha_test.reference) + (fate.alpha_passed ? ": passed" : ": failed"));
  }
  if (!fate.alpha_passed) return;
  if (f.state.depth.test) {
    lines.add(1, "Depth test: z " + number(f.trace.depth) + " " +
                     std::string(name_of(f.state.depth.compare)) + " " + number(fate.depth_before) +
                     (fate.depth_passed ? ": passed" : ": failed") +
                     (fate.depth_passed && !f.state.depth.write ? ", z is not written" : ""));
  }
  if (!fate.depth_passed) return;
  if (f.state.blend.enabled) {
    lines.add(1, "Blending (" + std::string(name_of(f.state.blend.equation)) + "): " + tuple(fate.incoming) +
                     "·" + tuple(fate.source_factor) + ", frame " + tuple(fate.before) + "·" +
                     tuple(fate.destination_factor) + " = " + tuple(fate.blended));
  }
  lines.add(1, "Frame: " + tuple(fate.before) + " becomes " + tuple(fate.after));
}

}  // namespace barrido::inspect
