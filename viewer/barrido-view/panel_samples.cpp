// Pixel filter, shutter and lens in the panel: options that are more than a number or a word.
#include "raster/names.h"
#include "viewer/barrido-view/panel_parts.h"

namespace barrido::window {
namespace {

bool draw_filter(raster::PixelFilter& filter) {
  bool changed = choose("filter", filter.kind);
  if (changed) filter.radius = raster::default_radius(filter.kind);
  return ImGui::SliderFloat("radius", &filter.radius, 0.25f, 4.0f, "%.2f px", ImGuiSliderFlags_AlwaysClamp) ||
         changed;
}

bool draw_shutter(scene::Shutter& shutter) {
  float times[] = {shutter.open, shutter.close};
  if (!ImGui::SliderFloat2("shutter", times, -1.0f, 4.0f, "%.2f frames")) return false;
  shutter = {std::min(times[0], times[1]), std::max(times[0], times[1])};
  return true;
}

bool drag(const char* label, std::optional<float>& value, float standard, const char* format) {
  return optional_value(label, value, standard, [&](float& number) {
    return ImGui::DragFloat(label, &number, 0.01f * std::max(standard, 1e-3f), 1e-6f, 1e6f, format,
                            ImGuiSliderFlags_AlwaysClamp);
  });
}

/// One of radius and f-stop at a time; what is sharp only with a lens.
bool draw_lens(scene::SampleChoice& samples) {
  bool changed = false;
  if (drag("lens radius", samples.lens_radius, 0.05f, "%.4g")) {
    samples.f_stop.reset();
    changed = true;
  }
  if (drag("f-stop", samples.f_stop, 2.8f, "f/%.2g")) {
    samples.lens_radius.reset();
    changed = true;
  }
  if (!samples.has_lens()) {
    samples.focus_distance.reset();
    samples.focus_pixel.reset();
    return changed;
  }
  if (drag("focus distance", samples.focus_distance, 1.0f, "%.4g")) {
    samples.focus_pixel.reset();
    changed = true;
  }
  return changed;
}

}  // namespace

bool draw_samples(view::Viewer& viewer) {
  scene::SampleChoice& samples = viewer.active().settings.samples;
  bool changed = draw_filter(samples.filter);
  changed |= optional_value("motion blur", samples.shutter, scene::Shutter{0.0f, 0.5f}, draw_shutter);
  return draw_lens(samples) || changed;
}

}  // namespace barrido::window
