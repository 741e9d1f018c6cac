// Pieces of the panel. Each draws its widgets and returns whether something was changed; values that the
// command line would refuse are put right by the caller.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>

#include "pipeline/scene/names.h"
#include "viewer/barrido/render_option_table.h"
#include "viewer/view/viewer.h"

namespace barrido::window {

/// The widget of an option, from its row of the table; nothing for options that have none.
bool draw_option(cli::RenderOptions& options, const cli::RenderOption& row);

bool draw_environment(view::Viewer& viewer);
bool draw_lights(view::Viewer& viewer);
bool draw_material(view::Viewer& viewer);
bool draw_textures(view::Viewer& viewer);
bool draw_camera(view::Viewer& viewer);
bool draw_fog(view::Viewer& viewer);
bool draw_background(view::Viewer& viewer);
bool draw_animation(view::Viewer& viewer);
bool draw_samples(view::Viewer& viewer);
bool draw_compare(view::Viewer& viewer);

/// A list of the names of an enumeration.
template <class Value>
bool choose(const char* label, Value& value) {
  bool changed = false;
  const auto names = names_of<Value>();
  const auto now =
      std::find_if(names.begin(), names.end(), [&](const auto& row) { return row.value == value; });
  if (!ImGui::BeginCombo(label, now->title.data())) return false;
  for (const Named<Value>& row : names) {
    if (!ImGui::Selectable(row.title.data(), row.value == value)) continue;
    changed = row.value != value;
    value = row.value;
  }
  ImGui::EndCombo();
  return changed;
}

/// A box to switch a value on, and its widget: `widget(value)` returns whether it was changed.
template <class Value, class Widget>
bool optional_value(const char* label, std::optional<Value>& value, const Value& standard,
                    const Widget& widget) {
  ImGui::PushID(label);
  bool on = value.has_value();
  bool changed = ImGui::Checkbox("##on", &on);
  if (changed) value = on ? std::optional(standard) : std::nullopt;
  ImGui::SameLine();
  if (value) {
    changed |= widget(*value);
  } else {
    ImGui::TextUnformatted(label);
  }
  ImGui::PopID();
  return changed;
}

}  // namespace barrido::window
