#include "viewer/barrido-view/picture_marks.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "viewer/barrido/text_format.h"
#include "viewer/view/key_table.h"

namespace barrido::window {
namespace {

struct Rectangle {
  float x = 0, y = 0, width = 0, height = 0;  ///< Pixels
};

/// Windows over the picture that take the mouse, as they were drawn last.
std::vector<Rectangle>& rectangles() {
  static std::vector<Rectangle> all;
  return all;
}

/// With the border around it where ImGui takes the mouse to change its size.
void remember_window(float pixels_per_unit) {
  constexpr float kBorder = 4.0f;
  const ImVec2 place = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  rectangles().push_back({(place.x - kBorder) * pixels_per_unit, (place.y - kBorder) * pixels_per_unit,
                          (size.x + 2.0f * kBorder) * pixels_per_unit,
                          (size.y + 2.0f * kBorder) * pixels_per_unit});
}

constexpr ImGuiWindowFlags kNote = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoInputs;

constexpr float kHelpColumn = 600.0f;

/// The keys, section by section; in two columns the second begins after half of the lines.
void draw_keys(bool two_columns, float scale) {
  const auto table = view::key_table();
  const float indent = ImGui::GetCursorPosX();
  bool in_second = false;
  ImGui::BeginGroup();
  std::string_view section;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const view::KeyBinding& binding = table[i];
    if (binding.name.empty()) continue;
    if (binding.section != section) {
      if (two_columns && !in_second && i > table.size() / 2 - 4) {
        in_second = true;
        ImGui::EndGroup();
        ImGui::SameLine(indent + kHelpColumn * scale);
        ImGui::BeginGroup();
      }
      ImGui::TextColored({1.0f, 0.8f, 0.3f, 1.0f}, "%s", binding.section.data());
    }
    section = binding.section;
    ImGui::Text("  %s", binding.name.data());
    ImGui::SameLine(indent + 150.0f * scale);
    ImGui::TextUnformatted(binding.help.data());
  }
  ImGui::EndGroup();
}

/// Over the panel too where the window is narrow; it scrolls where it is low.
void draw_help(float scale, float pixels_per_unit) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = 12.0f * scale;
  const bool two_columns = screen.x >= (2.0f * kHelpColumn + 40.0f) * scale;
  const float wanted = (two_columns ? 2.0f * kHelpColumn + 20.0f : kHelpColumn + 20.0f) * scale;
  ImGui::SetNextWindowPos({screen.x * 0.5f, margin}, ImGuiCond_Always, {0.5f, 0.0f});
  ImGui::SetNextWindowSize({std::min(wanted, screen.x), 0.0f});
  ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {screen.x, std::max(screen.y - 2.0f * margin, 40.0f)});
  ImGui::SetNextWindowBgAlpha(0.92f);
  ImGui::SetNextWindowFocus();
  ImGui::Begin("Keys", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  draw_keys(two_columns, scale);
  remember_window(pixels_per_unit);
  ImGui::End();
}

void draw_counters(const view::Viewer& viewer, float scale) {
  ImGui::SetNextWindowPos({10.0f * scale, 10.0f * scale});
  ImGui::SetNextWindowBgAlpha(0.6f);
  ImGui::Begin("Counters", nullptr, kNote);
  const view::Costs& costs = viewer.costs();
  ImGui::Text("%8.2f ms   %d x %d", costs.draw_ms, viewer.picture().width, viewer.picture().height);
  ImGui::Text("%15s triangles", cli::grouped(costs.triangles).c_str());
  ImGui::Text("%15s fragments shaded", cli::grouped(costs.fragments).c_str());
  ImGui::Text("%15s illuminations", cli::grouped(costs.illuminations).c_str());
  ImGui::Text("%15s powers", cli::grouped(costs.powers).c_str());
  if (viewer.display.osmesa) ImGui::Text("%8.2f ms by OSMesa", costs.osmesa_ms);
  ImGui::End();
}

void draw_message(const std::string& message, float width, float height, float scale) {
  ImGui::SetNextWindowPos({10.0f * scale, height - 10.0f * scale}, ImGuiCond_Always, {0.0f, 1.0f});
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::Begin("Message", nullptr, kNote);
  ImGui::PushTextWrapPos(std::max(width - 30.0f * scale, 100.0f));
  ImGui::TextUnformatted(message.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
}

/// The colours of the heat map with their numbers.
void draw_heat_scale(int largest, float scale) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  constexpr int kSteps = 64;
  const float step = 3.0f * scale, height = 12.0f * scale;
  for (int i = 0; i < kSteps; ++i) {
    const float x = corner.x + step * static_cast<float>(i);
    ImGui::GetWindowDrawList()->AddRectFilled({x, corner.y}, {x + step, corner.y + height},
                                              view::heat_color(i / (kSteps - 1.0)));
  }
  ImGui::Dummy({step * kSteps, height});
  ImGui::Text("0%*d", 26, largest);
}

void draw_difference(const view::Viewer& viewer, float width, float scale) {
  const view::Difference& difference = *viewer.difference();
  ImGui::SetNextWindowPos({width - 10.0f * scale, 10.0f * scale}, ImGuiCond_Always, {1.0f, 0.0f});
  ImGui::SetNextWindowBgAlpha(0.7f);
  ImGui::Begin("Difference", nullptr, kNote);
  ImGui::Text("largest difference %d of 255", difference.largest);
  ImGui::Text("mean               %.4f", difference.mean);
  ImGui::Text("pixels that differ %s", cli::grouped(difference.pixels).c_str());
  ImGui::Text("by more than 1     %s", cli::grouped(difference.beyond_rounding).c_str());
  for (const std::string& what : viewer.osmesa_cannot()) {
    ImGui::TextColored({1.0f, 0.8f, 0.3f, 1.0f}, "OpenGL has no: %s", what.c_str());
  }
  if (viewer.display.difference) draw_heat_scale(difference.largest, scale);
  ImGui::End();
}

void draw_divider(const view::Viewer& viewer, float width, float height, float scale) {
  const auto column =
      static_cast<float>(view::divider_column(static_cast<int>(width), viewer.display.divider));
  ImDrawList* lines = ImGui::GetBackgroundDrawList();
  lines->AddLine({column, 0}, {column, height}, 0xffffffffu, scale);
  for (const int side : {view::kLeft, view::kRight}) {
    const bool active = viewer.active_side() == side, left = side == view::kLeft;
    const std::string name = viewer.side_name(side);
    const float wide = ImGui::CalcTextSize(name.c_str()).x;
    const ImVec2 place(left ? column - 8.0f * scale - wide : column + 8.0f * scale, 8.0f * scale);
    lines->AddRectFilled({place.x - 3.0f * scale, place.y - 1.0f * scale},
                         {place.x + wide + 3.0f * scale, place.y + ImGui::GetFontSize() + scale},
                         0x80000000u);
    lines->AddText(place, active ? 0xff40d0ffu : 0xffe0e0e0u, name.c_str());
  }
}

/// The font has no Greek.
std::string plain(const std::string& text) {
  std::string result = text;
  const std::pair<std::string, std::string> replacements[] = {{"Σ", "sum"}, {"λ", "lambda"}};
  for (const auto& [from, to] : replacements) {
    for (std::size_t at = result.find(from); at != std::string::npos; at = result.find(from, at)) {
      result.replace(at, from.size(), to);
    }
  }
  return result;
}

void draw_story(const view::Inspected& pixel, float width, float height, float scale, float pixels_per_unit) {
  const ImVec2 size(std::min(760.0f * scale, width * 0.8f), std::min(420.0f * scale, height * 0.6f));
  ImGui::SetNextWindowPos({width - size.x - 10.0f * scale, height - size.y - 10.0f * scale},
                          ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowBgAlpha(0.9f);
  ImGui::Begin("Pixel", nullptr,
               ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const ImVec4 color(static_cast<float>(pixel.rgba[0]) / 255.0f, static_cast<float>(pixel.rgba[1]) / 255.0f,
                     static_cast<float>(pixel.rgba[2]) / 255.0f, 1.0f);
  ImGui::ColorButton("colour", color, ImGuiColorEditFlags_NoTooltip);
  ImGui::SameLine();
  ImGui::Text("%d %d %d at %d,%d", pixel.rgba[0], pixel.rgba[1], pixel.rgba[2], pixel.x, pixel.y);
  ImGui::TextUnformatted(plain(pixel.text).c_str());
  remember_window(pixels_per_unit);
  ImGui::End();
  const float x = (static_cast<float>(pixel.x) + 0.5f) / pixels_per_unit;
  const float y = (static_cast<float>(pixel.y) + 0.5f) / pixels_per_unit;
  ImDrawList* marks = ImGui::GetBackgroundDrawList();
  marks->AddCircle({x, y}, 6.0f * scale, 0xff000000u, 0, 4.0f * scale);  // Seen on every colour.
  marks->AddCircle({x, y}, 6.0f * scale, 0xff40d0ffu, 0, 1.5f * scale);
}

void draw_light_handles(view::Viewer& viewer, float scale, float pixels_per_unit) {
  for (const LightHandle& handle : light_handles(viewer)) {
    const ImVec2 center(static_cast<float>(handle.x) / pixels_per_unit,
                        static_cast<float>(handle.y) / pixels_per_unit);
    ImGui::GetBackgroundDrawList()->AddCircle(center, 8.0f * scale, 0xff40d0ffu, 0, 1.5f * scale);
  }
}

}  // namespace

void draw_marks(view::Viewer& viewer, Pointer&, float scale, float pixels_per_unit) {
  rectangles().clear();
  const float width = static_cast<float>(viewer.width()) / pixels_per_unit;
  const float height = static_cast<float>(viewer.height()) / pixels_per_unit;
  if (viewer.display.split && !viewer.display.difference) draw_divider(viewer, width, height, scale);
  draw_light_handles(viewer, scale, pixels_per_unit);
  if (viewer.display.counters) draw_counters(viewer, scale);
  if ((viewer.display.difference || viewer.display.osmesa) && viewer.difference()) {
    draw_difference(viewer, width, scale);
  }
  if (viewer.display.inspector && viewer.inspected()) {
    draw_story(*viewer.inspected(), width, height, scale, pixels_per_unit);
  }
  if (viewer.files().empty()) {
    draw_message("Drop a glTF model here, or give one on the command line. H shows the keys.", width, height,
                 scale);
  } else if (!viewer.message.empty()) {
    draw_message(viewer.message, width, height, scale);
  }
  if (viewer.display.help) draw_help(scale, pixels_per_unit);
}

bool is_over_marks(double x, double y) {
  const auto& all = rectangles();
  return std::any_of(all.begin(), all.end(), [&](const Rectangle& r) {
    return x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height;
  });
}

}  // namespace barrido::window
