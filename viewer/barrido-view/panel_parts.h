// Pieces of the panel. Each draws its widgets for the options of one side and returns whether something was
// changed; values that the command line would refuse are put right by the caller.
#pragma once

#include <imgui.h>

#include <array>
#include <optional>

#include "viewer/view/viewer.h"

namespace barrido::window {

bool draw_shading(cli::RenderOptions& options);
bool draw_textures(cli::RenderOptions& options);
bool draw_environment(view::Viewer& viewer);
bool draw_lights(view::Viewer& viewer);
bool draw_material(cli::RenderOptions& options);
bool draw_camera(view::Viewer& viewer);
bool draw_fog(view::Viewer& viewer);
bool draw_color(cli::RenderOptions& options);
bool draw_animation(view::Viewer& viewer);
bool draw_compare(view::Viewer& viewer);

/// A list of the names of an enumeration, in its order.
template <class Value, std::size_t Count>
bool choose(const char* label, Value& value, const std::array<const char*, Count>& names) {
  int index = static_cast<int>(value);
  if (!ImGui::Combo(label, &index, names.data(), static_cast<int>(Count))) return false;
  value = static_cast<Value>(index);
  return true;
}

/// The same with "the file's" in front for no value; `names` begins with the text for that.
template <class Value, std::size_t Count>
bool choose(const char* label, std::optional<Value>& value, const std::array<const char*, Count>& names) {
  int index = value ? static_cast<int>(*value) + 1 : 0;
  if (!ImGui::Combo(label, &index, names.data(), static_cast<int>(Count))) return false;
  value = index == 0 ? std::nullopt : std::optional(static_cast<Value>(index - 1));
  return true;
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
