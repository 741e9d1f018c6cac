#include "pipeline/inspect/story_text_parts.h"
#include "pipeline/inspect/story_words.h"

namespace barrido::inspect {
namespace {

/// "name       " of a light, so that the lines of its shares stand in columns.
std::string padded(std::string text, std::size_t width) {
  std::size_t characters = 0;
  for (const char byte : text) characters += (static_cast<unsigned char>(byte) & 0xc0u) != 0x80u;
  text.append(characters < width ? width - characters : 1, ' ');
  return text;
}

bool is_zero(const Rgb& c) { return c[0] == 0.0f && c[1] == 0.0f && c[2] == 0.0f; }

void tell_formula(const IlluminationStory& story, const std::string& highlight, Lines& lines) {
  if (story.interpolated_products) {
    const std::string power = story.highlights_are_powers ? highlight + "^n" : "(" + highlight + ")^n";
    lines.add(
        2, "I = ke + ka·Ia + Σ Ip·(kd·[f·N·L] + ks·[" + power + "]), with [ ] interpolated from the corners");
    return;
  }
  constexpr std::string_view kHighlight = "{highlight}";
  std::string formula(story.formula);
  const std::size_t at = formula.find(kHighlight);
  if (at != std::string::npos) formula.replace(at, kHighlight.size(), highlight);
  lines.add(2, formula);
}

void tell_light(const LightStory& light, const IlluminationStory& story, const std::string& highlight,
                Lines& lines) {
  const bool shines = !is_zero(light.specular) || light.power != 0.0f;
  if (!story.interpolated_products) {
    lines.add(2, "light '" + light.name + "': Ip = " + tuple(light.intensity) +
                     ", L = " + tuple(light.to_light) +
                     (light.weakening != 1.0f ? ", f = " + number(light.weakening) : ""));
  } else {
    lines.add(2, "light '" + light.name + "': Ip = " + tuple(light.intensity));
  }
  if (light.products) {
    lines.add(3, "interpolated: " + std::string(light.weakening != 1.0f ? "f·" : "") + "N·L " +
                     number((*light.products)[0]) + ", " + highlight + " " + number((*light.products)[1]));
    return;
  }
  const std::string factor = light.weakening != 1.0f ? "f·" : "";
  if (!is_zero(light.ambient)) lines.add(3, padded("ambient", 44) + "= " + tuple(light.ambient));
  lines.add(3, padded("diffuse   " + factor + "Ip·kd·max(" + number(light.n_dot_l) + ", 0)", 44) + "= " +
                   tuple(light.diffuse));
  if (!shines) return;
  const std::string power =
      story.highlights_are_powers
          ? "[" + highlight + "^n] " + number(light.highlight)
          : number(light.highlight) + "^" + number(story.shininess) + " -> " + number(light.power);
  lines.add(3, padded("specular  " + factor + "Ip·ks·(" + power + ")", 44) + "= " + tuple(light.specular));
}

}  // namespace

void tell_illumination(const IlluminationStory& story, pipeline::SpecularModel model, bool first,
                       Lines& lines) {
  const std::string highlight = model == pipeline::SpecularModel::blinn ? "N·H" : "R·V";
  const bool corner = !story.lights.empty() && story.lights[0].products.has_value();
  lines.add(1, (corner ? "Products at the " : "Illumination at the ") + story.place +
                   (story.back_side ? " (back side: N is turned round):" : ":"));
  if (first && !corner) tell_formula(story, highlight, lines);
  if (!story.interpolated_products) {
    lines.add(2, "N = " + tuple(story.normal) + ", V = " + tuple(story.to_viewer) +
                     ", P = " + tuple(story.position) + " (eye space)");
  }
  if (first && !corner) {
    lines.add(2, "kd = " + tuple(story.k_diffuse) + ", ks = " + tuple(story.k_specular) +
                     ", n = " + number(story.shininess));
    lines.add(2, "ka = " + tuple(story.k_ambient) + ", Ia = " + tuple(story.ambient_light) +
                     ", ke = " + tuple(story.emission));
  }
  if (!corner) lines.add(2, padded("ke + ka·Ia", 46) + "= " + tuple(story.base));
  if (!is_zero(story.interpolated_ambient)) {
    lines.add(2, padded("[ambient of lights that weaken]", 46) + "= " + tuple(story.interpolated_ambient));
  }
  for (const LightStory& light : story.lights) tell_light(light, story, highlight, lines);
  if (corner) return;
  if (is_zero(story.secondary)) {
    lines.add(2, padded("sum, with alpha", 46) + "= " + tuple(story.primary));
    return;
  }
  lines.add(2, padded("sum of ambient and diffuse, with alpha", 46) + "= " + tuple(story.primary));
  lines.add(2, padded("sum of highlights", 46) + "= " + tuple(story.secondary));
}

}  // namespace barrido::inspect
