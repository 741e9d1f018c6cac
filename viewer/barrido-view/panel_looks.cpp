// Widgets that follow from the rows of the options; background, fog and animation by hand.
#include "viewer/barrido-view/panel_parts.h"
#include "viewer/view/commands.h"

namespace barrido::window {
namespace {

/// Entries from −1 (no value) or 0 on.
bool choose(cli::RenderOptions& options, const cli::RenderOption& row) {
  const int chosen = row.chosen(options);
  // Names are literals, so each ends in a zero byte.
  const auto name = [&row](int place) {
    return place < 0 ? row.editor.without.data() : row.value.titles[static_cast<std::size_t>(place)].data();
  };
  if (!ImGui::BeginCombo(row.editor.label.data(), name(chosen))) return false;
  bool changed = false;
  for (int place = row.value.is_optional ? -1 : 0; place < static_cast<int>(row.value.titles.size());
       ++place) {
    if (!ImGui::Selectable(name(place), place == chosen)) continue;
    row.choose(options, place);
    changed = place != chosen;
  }
  ImGui::EndCombo();
  return changed;
}

bool toggle(cli::RenderOptions& options, const cli::RenderOption& row) {
  bool on = row.value.write(options).empty() == row.editor.inverted;
  if (!ImGui::Checkbox(row.editor.label.data(), &on)) return false;
  cli::step_option(options, row.syntax.name, 1.0f);
  return true;
}

bool slide(cli::RenderOptions& options, const cli::RenderOption& row) {
  const auto [least, most] = row.editor.slider;
  const auto draw = [&, least = least, most = most](float& number) {
    return ImGui::SliderFloat(row.editor.label.data(), &number, static_cast<float>(least),
                              static_cast<float>(most), row.editor.format, ImGuiSliderFlags_AlwaysClamp);
  };
  const std::optional<double> number = row.number(options);
  std::optional<float> shown;
  if (number) shown = static_cast<float>(*number);
  const bool changed = row.value.is_optional
                           ? optional_value(row.editor.label.data(), shown, row.editor.start, draw)
                           : draw(*shown);
  if (!changed) return false;
  if (shown) {
    row.set_number(options, static_cast<double>(*shown));
  } else {
    row.assign(options, std::nullopt);
  }
  return true;
}

}  // namespace

bool draw_option(cli::RenderOptions& options, const cli::RenderOption& row) {
  if (row.editor.kind != cli::Editor::Kind::widget) return false;
  if (row.editor.beside) ImGui::SameLine();
  ImGui::PushID(row.syntax.name.data());
  const bool changed = row.value.kind == cli::OptionKind::flag ? toggle(options, row)
                       : row.value.names.empty()               ? slide(options, row)
                                                               : choose(options, row);
  const std::string_view note = row.editor.note != nullptr ? row.editor.note(options) : std::string_view();
  if (!note.empty()) ImGui::TextWrapped("%s", note.data());
  ImGui::PopID();
  return changed;
}

bool draw_background(view::Viewer& viewer) {
  return optional_value(
      "background", viewer.active().background_shown, std::array<float, 4>{0.2f, 0.2f, 0.2f, 1.0f},
      [](std::array<float, 4>& color) { return ImGui::ColorEdit3("background", color.data()); });
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
  ImGui::TextUnformatted(name_of(fog.mode).data());
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
