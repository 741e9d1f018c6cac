#include "viewer/barrido-view/panel.h"

#include <exception>
#include <filesystem>

#include "viewer/barrido-view/panel_parts.h"
#include "viewer/barrido/text_format.h"
#include "viewer/view/render_words.h"

namespace barrido::window {
namespace {

void draw_head(view::Viewer& viewer, const std::string& status) {
  const std::string name = std::filesystem::path(viewer.path()).filename().string();
  ImGui::TextUnformatted(name.empty() ? "no model" : name.c_str());
  const view::Costs& costs = viewer.costs();
  ImGui::Text("%d x %d   %.1f ms   %s triangles", viewer.width(), viewer.height(), costs.draw_ms,
              cli::grouped(costs.triangles).c_str());
  if (viewer.display.split && !viewer.display.osmesa) {
    ImGui::TextUnformatted("changes:");
    for (const int side : {view::kLeft, view::kRight}) {
      ImGui::SameLine();
      if (ImGui::RadioButton(side == view::kLeft ? "A, left" : "B, right", viewer.active_side() == side)) {
        viewer.set_active_side(side);
      }
    }
  }
  ImGui::TextDisabled("%s", status.empty() ? "H: keys   Tab: hide the panel" : status.c_str());
}

bool header(const char* label, bool open) {
  return ImGui::CollapsingHeader(label, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
}

bool draw_parts(view::Viewer& viewer) {
  cli::RenderOptions& options = viewer.active();
  bool changed = false;
  if (header("Shading", true)) changed |= draw_shading(options);
  if (header("Lights", true)) changed |= draw_lights(viewer);
  if (header("Textures", true)) changed |= draw_textures(options);
  if (header("Compare A | B", false)) changed |= draw_compare(viewer);
  if (header("Material", false)) changed |= draw_material(options);
  if (header("Environment", false)) changed |= draw_environment(viewer);
  if (header("Fog", false)) changed |= draw_fog(viewer);
  if (header("Camera", false)) changed |= draw_camera(viewer);
  if (header("Colour", false)) changed |= draw_color(options);
  if (header("Animation", false)) changed |= draw_animation(viewer);
  return changed;
}

/// Whether the command line would take these options.
std::string complaint_about(const cli::RenderOptions& options) {
  try {
    cli::parse_view_options(view::words_of(options));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

void draw_panel(view::Viewer& viewer, const std::string& status, float scale) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float width = kPanelUnits * scale;
  ImGui::SetNextWindowPos({size.x - width, 0.0f});
  ImGui::SetNextWindowSize({width, size.y});
  ImGui::Begin("Panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PushItemWidth(width * 0.55f);
  const cli::RenderOptions before = viewer.active();
  draw_head(viewer, status);
  ImGui::Separator();
  if (draw_parts(viewer)) {
    const std::string complaint = complaint_about(viewer.active());
    if (!complaint.empty()) {
      viewer.active() = before;
      viewer.message = complaint;
    }
    viewer.changed = true;
  }
  ImGui::PopItemWidth();
  ImGui::End();
}

}  // namespace barrido::window
