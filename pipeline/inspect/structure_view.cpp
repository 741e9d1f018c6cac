#include "pipeline/inspect/structure_view.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "pipeline/inspect/view_observers.h"
#include "pipeline/inspect/view_scale.h"
#include "pipeline/scene/frame_observer.h"
#include "pipeline/scene/mip_colors.h"
#include "raster/fragments/primitive.h"

namespace barrido::inspect {
namespace {

/// In the order of the enumeration.
constexpr std::array<std::string_view, kStructureViewCount> kDescriptions{
    "how often each pixel is shaded, in drawing order",
    "triangles that cover each pixel, hidden ones too",
    "light evaluations, where they are made",
    "texels read for each pixel, in drawing order",
    "mip level of the visible picture",
    "a colour for each mip level",
    "texels to a pixel, as a power of two",
    "s in red, t in green; white where a picture begins anew",
    "a colour for each visible triangle",
    "distance from the eye along the line of sight",
    "normal as it is lit, in eye space",
    "second derivative of brightness, in 1/255",
    "samples taken of each pixel",
    "pixels whose corners alone lose something"};

/// Shows the frame to a function, and does not have it drawn.
class Onlooker final : public scene::FrameObserver {
 public:
  explicit Onlooker(std::function<void(const scene::ObservedFrame&)> look) : look_(std::move(look)) {}
  bool observe(const scene::ObservedFrame& frame) override {
    look_(frame);
    return false;
  }

 private:
  std::function<void(const scene::ObservedFrame&)> look_;
};

void look(scene::SceneRenderer& renderer, const scene::RenderSettings& settings,
          std::function<void(const scene::ObservedFrame&)> with) {
  Onlooker onlooker(std::move(with));
  renderer.render(settings, nullptr, &onlooker);
}

/// Settings whose vertices carry normals, whatever the shading.
scene::RenderSettings with_normals(const scene::RenderSettings& settings) {
  scene::RenderSettings lit = settings;
  if (pipeline::shading_mode(settings.shading).lit.flat) {
    lit.flat_at = pipeline::FlatAt::centroid;
  } else {
    lit.shading = pipeline::ShadeModel::phong;
  }
  return lit;
}

void summarize(ViewValues& values) {
  double sum = 0.0;
  for (const float value : values.values) {
    if (!(value == value)) continue;
    values.least = values.counted == 0 ? value : std::min(values.least, static_cast<double>(value));
    values.most = values.counted == 0 ? value : std::max(values.most, static_cast<double>(value));
    sum += values.view == StructureView::mach_bands ? std::abs(value) : value;
    ++values.counted;
  }
  if (values.counted > 0) values.mean = sum / static_cast<double>(values.counted);
}

Rgb8 normal_color(const std::array<float, 3>& n) {
  if (!(n[0] == n[0])) return kNothingColor;
  Rgb8 color{};
  for (std::size_t c = 0; c < 3; ++c) {
    color[c] = static_cast<std::uint8_t>((std::clamp(n[c], -1.0f, 1.0f) * 0.5f + 0.5f) * 255.0f + 0.5f);
  }
  return color;
}

/// Between the colours of two levels as the filter is between their texels.
Rgb8 level_color(float value) {
  const int level = static_cast<int>(value);
  const scene::MipColor &a = scene::mip_color(level), &b = scene::mip_color(level + 1);
  const float share = value - static_cast<float>(level);
  Rgb8 color{};
  for (std::size_t c = 0; c < 3; ++c) {
    const float mixed = static_cast<float>(a[c]) + share * static_cast<float>(b[c] - a[c]);
    color[c] = static_cast<std::uint8_t>(mixed + 0.5f);
  }
  return color;
}

std::uint32_t pixel_of(const ViewValues& values, std::size_t i) {
  if (!values.colors.empty()) return values.colors[i];
  if (values.view == StructureView::normals) return packed(normal_color(values.normals[i]));
  return packed(color_of(values, values.values[i]));
}

/// Of adaptive sampling what it did; slivers are looked for by it whatever the settings say.
void count_samples(scene::SceneRenderer& renderer, scene::RenderSettings settings, ViewValues& values) {
  const bool counts = values.view == StructureView::samples;
  if (counts && settings.samples.sampling != scene::Sampling::adaptive) {
    std::fill(values.values.begin(), values.values.end(), static_cast<float>(settings.samples.count));
  } else {
    scene::SampleChoice& choice = settings.samples;
    if (choice.sampling != scene::Sampling::adaptive) choice = {};
    choice.sampling = scene::Sampling::adaptive;
    raster::SampleReport report;
    report.counts.resize(values.values.size());
    report.slivers.resize(values.values.size());
    settings.sample_report = &report;
    renderer.render(settings);
    for (std::size_t i = 0; i < values.values.size(); ++i) {
      values.values[i] = static_cast<float>(counts ? report.counts[i] : report.slivers[i]);
    }
  }
  for (const float value : values.values) values.total += static_cast<std::uint64_t>(value);
}

}  // namespace

std::string_view description_of(StructureView view) { return kDescriptions[static_cast<std::size_t>(view)]; }

ViewValues measure_view(scene::SceneRenderer& renderer, const scene::RenderSettings& settings,
                        StructureView view) {
  ViewValues values;
  values.view = view;
  values.width = settings.width;
  values.height = settings.height;
  const std::size_t pixels =
      static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
  values.values.assign(pixels, std::numeric_limits<float>::quiet_NaN());
  switch (view) {
    case StructureView::overdraw:
    case StructureView::layers:
    case StructureView::illuminations:
    case StructureView::texels:
      look(renderer, settings, [&](const scene::ObservedFrame& frame) { count_work(frame, values); });
      break;
    case StructureView::coordinates:
      values.colors.assign(pixels, packed(kNothingColor));
      [[fallthrough]];
    case StructureView::mip_level:
    case StructureView::texel_density:
    case StructureView::triangles:
    case StructureView::depth:
      look(renderer, settings, [&](const scene::ObservedFrame& frame) { look_at_front(frame, values); });
      break;
    case StructureView::normals:
      values.normals.assign(pixels, {values.values[0], values.values[0], values.values[0]});
      look(renderer, with_normals(settings), [&](const scene::ObservedFrame& frame) {
        look_at_normals(frame, settings.flat_at == pipeline::FlatAt::provoking_vertex, values);
      });
      break;
    case StructureView::mip_colors: {
      scene::RenderSettings colored = settings;
      colored.mip_colors = true;
      const raster::Framebuffer frame = renderer.render(colored);
      values.colors.assign(frame.color8().begin(), frame.color8().end());
      break;
    }
    case StructureView::mach_bands: {
      scene::RenderSettings floats = settings;
      floats.keep_float = true;
      differentiate(renderer.render(floats), values);
      break;
    }
    case StructureView::samples:
    case StructureView::slivers:
      count_samples(renderer, settings, values);
      break;
  }
  summarize(values);
  return values;
}

Rgb8 color_of(const ViewValues& values, float value) {
  if (!(value == value)) return kNothingColor;
  if (values.view == StructureView::triangles) return distinct_color(static_cast<std::uint32_t>(value));
  if (values.view == StructureView::mip_level) return level_color(value);
  const ViewScale scale = scale_of(values);
  const double place = scale.place_of(value);
  // A second derivative below zero is where it is lighter than around.
  if (scale.is_signed) return signed_color(values.view == StructureView::mach_bands ? -place : place);
  return ordered_color(values.view == StructureView::depth ? 1.0 - place : place);
}

std::vector<std::uint32_t> colors_of(const ViewValues& values) {
  std::vector<std::uint32_t> colors(values.values.size());
  for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = pixel_of(values, i);
  return colors;
}

}  // namespace barrido::inspect
