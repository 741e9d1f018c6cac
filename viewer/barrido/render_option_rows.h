// How the rows of the table of options are put together: words for a row, and for its widget in the window's
// panel. For render_option_table.cpp alone.
#pragma once

#include "viewer/barrido/option_fields.h"
#include "viewer/barrido/render_option_table.h"

namespace barrido::cli {

using Options = RenderOptions;
using Settings = scene::RenderSettings;
using Camera = scene::CameraChoice;
using scene::MapOverride;
using scene::Overlays;
using scene::UserDisplacement;
using Samples = scene::SampleChoice;

constexpr auto kPicture = OptionScope::picture;
constexpr auto kDrawing = OptionScope::drawing;
constexpr auto kCall = OptionScope::call;
constexpr auto kOutput = OptionScope::output;

constexpr RenderOption option(std::string_view name, std::string_view form, OptionScope scope,
                              std::string_view help, const OptionValue& value, const Editor& editor = {}) {
  return {{"", name, "", value.kind, form, help, scope}, value, editor};
}

constexpr RenderOption with_short(std::string_view short_name, RenderOption row) {
  row.syntax.short_name = short_name;
  return row;
}

constexpr Editor widget(std::string_view label) { return {Editor::Kind::widget, label}; }

constexpr Editor beside(std::string_view label) {
  Editor editor = widget(label);
  editor.beside = true;
  return editor;
}

constexpr Editor slider(std::string_view label, Range range, const char* format, float start = 0.0f) {
  Editor editor = widget(label);
  editor.slider = range;
  editor.format = format;
  editor.start = start;
  return editor;
}

/// A list whose first entry, no value, is called `without`.
constexpr Editor list(std::string_view label, std::string_view without) {
  Editor editor = widget(label);
  editor.without = without;
  return editor;
}

constexpr Editor by_hand(std::string_view heading) { return {Editor::Kind::special, "", heading}; }
constexpr Editor no_editor(std::string_view why) { return {Editor::Kind::none, why}; }

constexpr Editor kViewEditor = [] {
  Editor editor = widget("shows");
  editor.heading = "Shading";
  editor.note = [](const Options& o) {
    return o.views[0] ? inspect::description_of(*o.views[0]) : std::string_view();
  };
  return editor;
}();

constexpr Editor kTexturesEditor = [] {
  Editor editor = widget("textures");
  editor.inverted = true;
  return editor;
}();

constexpr Editor kMapsEditor = [] {
  Editor editor = widget("maps");
  editor.inverted = true;
  return editor;
}();
constexpr Editor kMapPath = no_editor("a picture is given with the call");

constexpr OptionValue always_written(OptionValue value) {
  value.is_always_written = true;
  return value;
}

}  // namespace barrido::cli
