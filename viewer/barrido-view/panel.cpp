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

struct Part {
  std::string_view heading;
  bool open = false;
  bool (*by_hand)(view::Viewer& viewer) = nullptr;  ///< Drawn below the widgets of the options.
};

constexpr Part kParts[] = {
    {"Shading", true},
    {"Lights", true, draw_lights},
    {"Textures", true, draw_textures},
    {"Samples", false, draw_samples},
    {"Compare A | B", false, draw_compare},
    {"Material", false, draw_material},
    {"Environment", false, draw_environment},
    {"Fog", false, draw_fog},
    {"Camera", false, draw_camera},
    {"Colour", false, draw_background},
    {"Animation", false, draw_animation},
};

bool draw_part(view::Viewer& viewer, const Part& part) {
  bool changed = false;
  for (const cli::RenderOption& row : cli::render_option_table()) {
    if (row.heading() == part.heading) changed |= draw_option(viewer.active(), row);
  }
  if (part.by_hand != nullptr) changed |= part.by_hand(viewer);
  return changed;
}

bool draw_parts(view::Viewer& viewer) {
  bool changed = false;
  for (const Part& part : kParts) {
    const auto open = part.open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
    if (ImGui::CollapsingHeader(part.heading.data(), open)) changed |= draw_part(viewer, part);
  }
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
