// The panel's part for textures that no file has: procedures, pictures given by path, mappings.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <optional>
#include <string>

#include "pipeline/scene/names.h"
#include "viewer/barrido-view/panel_parts.h"

namespace barrido::window {
namespace {

/// How an object's own size is changed: from a hundredth to a hundred of what the model is made of.
bool slide_size(const char* label, float& size) {
  return ImGui::SliderFloat(label, &size, 0.01f, 100.0f, "%.3f",
                            ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
}

bool edit_axis(glm::vec3& axis) {
  glm::vec3 wanted = axis;
  if (!ImGui::SliderFloat3("axis", &wanted.x, -1.0f, 1.0f, "%.2f") || wanted == glm::vec3(0.0f)) return false;
  axis = wanted;
  return true;
}

bool edit_noise(raster::Pattern& pattern) {
  bool changed = ImGui::SliderInt("octaves", &pattern.octaves, 1, raster::kMaxOctaves, "%d",
                                  ImGuiSliderFlags_AlwaysClamp);
  changed |= ImGui::SliderFloat("gain", &pattern.gain, 0.01f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  if (pattern.kind != raster::PatternKind::noise) {
    return ImGui::SliderFloat("turbulence", &pattern.turbulence, -4.0f, 4.0f, "%.2f") || changed;
  }
  changed |= ImGui::Checkbox("above a threshold", &pattern.has_threshold);
  if (!pattern.has_threshold) pattern.threshold = 0.0f;
  if (pattern.has_threshold) {
    changed |= ImGui::SliderFloat("threshold", &pattern.threshold, -1.0f, 1.0f, "%.2f",
                                  ImGuiSliderFlags_AlwaysClamp);
  }
  return changed;
}

bool edit_solid(scene::SolidTexture& solid) {
  raster::PatternKind kind = solid.pattern.kind;
  bool changed = choose("pattern", kind);
  if (changed) solid = scene::standard_solid(kind);
  changed |= choose("sticks to", solid.space);
  std::optional<float> scale = solid.scale > 0.0f ? std::optional(solid.scale) : std::nullopt;
  if (optional_value("scale", scale, 0.25f, [](float& s) { return slide_size("scale", s); })) {
    solid.scale = scale.value_or(0.0f);
    changed = true;
  }
  if (kind != raster::PatternKind::checker && kind != raster::PatternKind::noise) {
    changed |= edit_axis(solid.axis);
  }
  changed |= ImGui::ColorEdit3("dark", solid.pattern.colors[0].data(), ImGuiColorEditFlags_Float);
  changed |= ImGui::ColorEdit3("light", solid.pattern.colors[1].data(), ImGuiColorEditFlags_Float);
  if (kind >= raster::PatternKind::noise) changed |= edit_noise(solid.pattern);
  return changed;
}

bool edit_mapping(scene::MappingChoice& mapping) {
  bool changed = choose("from", mapping.ray);
  changed |= ImGui::Checkbox("at vertices", &mapping.at_vertices);
  changed |= edit_axis(mapping.axis);
  std::optional<float> size = mapping.size > 0.0f ? std::optional(mapping.size) : std::nullopt;
  if (optional_value("size", size, 1.0f, [](float& s) { return slide_size("size", s); })) {
    mapping.size = size.value_or(0.0f);
    changed = true;
  }
  glm::vec2 repeats = mapping.repeats;
  if (ImGui::SliderFloat2("repeats", &repeats.x, -8.0f, 8.0f, "%.2f") && repeats.x != 0.0f &&
      repeats.y != 0.0f) {
    mapping.repeats = repeats;
    changed = true;
  }
  return ImGui::SliderFloat2("offset", &mapping.offset.x, -1.0f, 1.0f, "%.2f") || changed;
}

bool choose_texture(cli::RenderOptions& options) {
  std::optional<scene::SolidTexture>& solid = options.settings.texture.solid;
  int choice = solid ? 1 : options.texture_path.empty() ? 0 : 2;
  bool changed = ImGui::RadioButton("the materials'", &choice, 0);
  ImGui::SameLine();
  changed |= ImGui::RadioButton("procedure", &choice, 1);
  ImGui::SameLine();
  changed |= ImGui::RadioButton("picture##texture", &choice, 2);
  static std::string path;
  if (!options.texture_path.empty()) path = options.texture_path;
  const bool entered = ImGui::InputText("picture of all", &path, ImGuiInputTextFlags_EnterReturnsTrue);
  if (entered) choice = 2;
  if (!changed && !entered) return false;
  options.texture_path = choice == 2 ? path : std::string();
  if (choice != 1) solid.reset();
  if (choice == 1 && !solid) solid = scene::standard_solid(raster::PatternKind::marble);
  return true;
}

}  // namespace

bool draw_textures(view::Viewer& viewer) {
  cli::RenderOptions& options = viewer.active();
  std::optional<scene::SolidTexture>& solid = options.settings.texture.solid;
  std::optional<scene::MappingChoice>& mapping = options.settings.texture.mapping;
  ImGui::TextDisabled("in place of every material's:");
  bool changed = choose_texture(options);
  if (solid) changed |= edit_solid(*solid);
  raster::MappingSurface surface = mapping ? mapping->surface : raster::MappingSurface::none;
  if (choose("mapping", surface)) {
    changed = true;
    if (surface == raster::MappingSurface::none) {
      mapping.reset();
    } else {
      if (!mapping) mapping.emplace();
      mapping->surface = surface;
    }
  }
  if (mapping) changed |= edit_mapping(*mapping);
  return changed;
}

}  // namespace barrido::window
