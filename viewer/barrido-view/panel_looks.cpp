// Shading, textures, colour, fog and animation in the panel.
#include "viewer/barrido-view/panel_parts.h"
#include "viewer/view/commands.h"

namespace barrido::window {
namespace {

/// Of "picture" and all views.
const std::array<const char*, inspect::kStructureViewCount + 1>& view_names() {
  static const auto names = [] {
    std::array<const char*, inspect::kStructureViewCount + 1> all{"picture"};
    for (std::size_t i = 1; i < all.size(); ++i) {
      all[i] = inspect::name_of(static_cast<inspect::StructureView>(i - 1)).data();
    }
    return all;
  }();
  return names;
}

}  // namespace

bool draw_shading(cli::RenderOptions& options) {
  scene::RenderSettings& s = options.settings;
  bool changed = choose("shows", options.views[0], view_names());
  if (options.views[0])
    ImGui::TextWrapped("%s", std::string(inspect::description_of(*options.views[0])).c_str());
  changed |= choose("shading", options.shadings[0], std::array{"flat", "Gouraud", "cheap Phong", "Phong"});
  changed |= choose("highlights", s.lighting, std::array{"N·H (Blinn)", "R·V (Phong)"});
  changed |= choose("flat, lit at", s.flat_at, std::array{"provoking vertex", "centroid"});
  changed |= choose("cheap, power at", s.cheap_phong_power, std::array{"pixel", "vertex"});
  changed |= choose("colours", s.color_interpolation, std::array{"perspective", "linear on screen"});
  changed |= choose("culling", s.cull, std::array{"the materials'", "none", "back", "front"});
  changed |= ImGui::Checkbox("edges", &s.overlays.edges);
  ImGui::SameLine();
  changed |= ImGui::Checkbox("wireframe", &s.wireframe);
  ImGui::SameLine();
  changed |= ImGui::Checkbox("normals", &s.overlays.normals);
  changed |= optional_value("smooth normals", s.crease_angle_deg, 40.0f, [](float& degrees) {
    return ImGui::SliderFloat("crease", &degrees, 0.0f, 180.0f, "%.0f deg", ImGuiSliderFlags_AlwaysClamp);
  });
  return changed;
}

bool draw_textures(cli::RenderOptions& options) {
  scene::RenderSettings& s = options.settings;
  bool changed = ImGui::Checkbox("textures", &s.textures);
  changed |= choose("interpolation", s.texture_interpolation, std::array{"perspective", "affine"});
  changed |= choose("smaller", s.min_filter,
                    std::array{"the file's", "nearest", "linear", "nearest mip nearest", "linear mip nearest",
                               "nearest mip linear", "linear mip linear"});
  changed |= choose("larger", s.mag_filter, std::array{"the file's", "nearest", "linear"});
  return changed;
}

bool draw_color(cli::RenderOptions& options) {
  scene::RenderSettings& s = options.settings;
  bool changed =
      ImGui::SliderFloat("exposure", &s.exposure_ev, -8.0f, 8.0f, "%.2f EV", ImGuiSliderFlags_AlwaysClamp);
  changed |= choose("tone map", s.tone_map, std::array{"clamp", "Reinhard"});
  changed |= choose("colours", s.color_management, std::array{"managed (sRGB)", "as stored"});
  changed |= optional_value(
      "background", options.background_shown, std::array<float, 4>{0.2f, 0.2f, 0.2f, 1.0f},
      [](std::array<float, 4>& color) { return ImGui::ColorEdit3("background", color.data()); });
  return changed;
}

bool draw_fog(view::Viewer& viewer) {
  cli::RenderOptions& options = viewer.active();
  using raster::FogMode;
  bool changed = false;
  if (ImGui::Button(options.fog ? "next mode" : "fog")) {
    view::step_fog(viewer);
    changed = true;
  }
  if (!options.fog) return changed;
  raster::FogState& fog = options.fog->state;
  ImGui::SameLine();
  ImGui::TextUnformatted(fog.mode == FogMode::linear ? "linear" : fog.mode == FogMode::exp ? "exp" : "exp2");
  if (fog.mode == FogMode::linear) {
    changed |= ImGui::DragFloat("start", &fog.start, 0.02f);
    changed |= ImGui::DragFloat("end", &fog.end, 0.02f);
  } else {
    changed |=
        ImGui::DragFloat("density", &fog.density, 0.002f, 0.0f, 1e6f, "%.4f", ImGuiSliderFlags_AlwaysClamp);
  }
  changed |=
      optional_value("own colour", options.fog->color_shown, std::array<float, 3>{0.6f, 0.65f, 0.7f},
                     [](std::array<float, 3>& color) { return ImGui::ColorEdit3("colour", color.data()); });
  return changed;
}

bool draw_animation(view::Viewer& viewer) {
  if (viewer.model() == nullptr || viewer.model()->scene().animations.empty()) {
    ImGui::TextDisabled("the file has none");
    return false;
  }
  cli::RenderOptions& options = viewer.active();
  const auto& animations = viewer.model()->scene().animations;
  bool changed = false;
  int index = options.animation.value_or(0);
  if (animations.size() > 1 &&
      ImGui::SliderInt("animation", &index, 0, static_cast<int>(animations.size()) - 1, "%d",
                       ImGuiSliderFlags_AlwaysClamp)) {
    options.animation = index;
    changed = true;
  }
  auto time_s = static_cast<float>(options.time_s.value_or(0.0));
  const auto duration_s = static_cast<float>(viewer.model()->duration_s(index));
  if (ImGui::SliderFloat("time", &time_s, 0.0f, duration_s, "%.3f s", ImGuiSliderFlags_AlwaysClamp)) {
    for (const int side : {view::kLeft, view::kRight}) viewer.side(side).time_s = time_s;
    changed = true;
  }
  if (ImGui::Button(viewer.playing() ? "stop" : "play")) viewer.toggle_playing();
  return changed;
}

}  // namespace barrido::window
