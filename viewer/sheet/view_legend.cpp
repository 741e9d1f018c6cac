#include "viewer/sheet/view_legend.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "pipeline/inspect/story_words.h"
#include "pipeline/inspect/view_scale.h"
#include "pipeline/scene/mip_colors.h"
#include "viewer/sheet/text.h"

namespace barrido::sheet {
namespace {

using inspect::number;
using inspect::packed;
using inspect::Rgb8;
using inspect::StructureView;
using inspect::ViewScale;
using inspect::ViewValues;

constexpr Rgb8 kGround{24, 24, 24};
constexpr Rgb8 kBright{236, 236, 236};
constexpr Rgb8 kDim{168, 168, 168};
constexpr int kMargin = 8;
constexpr int kRow = 16;
constexpr int kGap = 4;

int text_scale(int width) {
  int scale = 1;
  while (scale < 8 && width >= 1600 * scale) scale *= 2;
  return scale;
}

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

/// The strip while it is drawn, in units of the text's scale.
class Strip {
 public:
  explicit Strip(int width)
      : width_(width),
        scale_(text_scale(width)),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(legend_height(width)),
                packed(kGround)) {}

  int scale() const { return scale_; }
  int width() const { return width_; }

  void fill(int left, int top, int right, int bottom, const auto& color_at) {
    for (int y = top; y < bottom; ++y) {
      for (int x = std::max(left, 0); x < std::min(right, width_); ++x) {
        pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x)] = packed(color_at(x));
      }
    }
  }

  /// @return where the text ends.
  int text(int left, int top, const std::string& words, const Rgb8& color, bool bold = false) {
    const TextStyle style{scale_, bold};
    const TextMask mask = draw_text(fit_text(words, style, width_ - left - kMargin * scale_), style);
    for (int y = 0; y < mask.height; ++y) {
      for (int x = 0; x < mask.width; ++x) {
        if (mask.at(x, y)) fill(left + x, top + y, left + x + 1, top + y + 1, [&](int) { return color; });
      }
    }
    return left + mask.width;
  }

  std::vector<std::uint32_t> take() { return std::move(pixels_); }

 private:
  int width_;
  int scale_;
  std::vector<std::uint32_t> pixels_;
};

/// A bar of the scale's colours between its ends' numbers.
void draw_bar(const ViewValues& values, int top, Strip& strip) {
  const int s = strip.scale();
  const ViewScale scale = scale_of(values);
  const TextStyle style{s, false};
  const std::string least = scale.least_word, most = scale.most_word;
  const int left = strip.text(kMargin * s, top, least, kBright) + 6 * s;
  const int right = std::max(strip.width() - (kMargin + 6) * s - text_width(most, style), left + 1);
  strip.fill(left, top + 2 * s, right, top + (kRow - 2) * s, [&](int x) {
    const double t = right - left > 1 ? static_cast<double>(x - left) / (right - left - 1) : 0.0;
    return color_of(values, static_cast<float>(scale.value_at(t)));
  });
  strip.text(right + 6 * s, top, most, kBright);
}

/// One patch a mip level, as wide as there is room for.
void draw_levels(int top, Strip& strip) {
  const int s = strip.scale();
  const int count = static_cast<int>(scene::kMipColors.size());
  const int cell = std::min(56 * s, (strip.width() - 2 * kMargin * s) / count);
  for (int level = 0; level < count; ++level) {
    const int left = kMargin * s + level * cell;
    strip.fill(left, top + 2 * s, left + cell - 20 * s, top + (kRow - 2) * s,
               [&](int) { return Rgb8(scene::mip_color(level)); });
    strip.text(left + cell - 16 * s, top, std::to_string(level), kBright);
  }
  strip.text(kMargin * s + count * cell, top, "and so on from the first colour", kDim);
}

/// The three axes as the colours that they give.
void draw_axes(int top, Strip& strip) {
  const int s = strip.scale();
  const std::pair<const char*, Rgb8> axes[] = {{"right", {255, 128, 128}},
                                               {"left", {0, 128, 128}},
                                               {"up", {128, 255, 128}},
                                               {"down", {128, 0, 128}},
                                               {"towards the eye", {128, 128, 255}}};
  int left = kMargin * s;
  for (const auto& [name, color] : axes) {
    strip.fill(left, top + 2 * s, left + 24 * s, top + (kRow - 2) * s,
               [shown = color](int) { return shown; });
    left = strip.text(left + 28 * s, top, name, kBright) + 10 * s;
  }
}

std::string figures(const ViewValues& v) {
  switch (v.view) {
    case StructureView::overdraw:
    case StructureView::layers:
    case StructureView::texels:
    case StructureView::samples:
      return "maximum " + number(v.most) + ", mean " + number(v.mean) + ", sum " + grouped(v.total);
    case StructureView::illuminations:
      return "maximum " + number(v.most) + ", mean " + number(v.mean) + ", sum " + grouped(v.total) +
             "; colours by square roots" +
             (v.outside > 0 ? ", and " + grouped(v.outside) + " outside the picture" : "");
    case StructureView::mip_level:
    case StructureView::texel_density:
    case StructureView::depth:
      return v.counted == 0
                 ? "nothing to be seen"
                 : "minimum " + number(v.least) + ", maximum " + number(v.most) + ", mean " + number(v.mean);
    case StructureView::triangles:
      return grouped(v.total) + (v.total == 1 ? " triangle is seen in " : " triangles are seen in ") +
             grouped(v.counted) + " pixels";
    case StructureView::mach_bands:
      return "minimum " + number(v.least) + ", maximum " + number(v.most) + ", mean magnitude " +
             number(v.mean);
    case StructureView::slivers:
      return grouped(v.total) + (v.total == 1 ? " pixel" : " pixels");
    case StructureView::mip_colors:
    case StructureView::coordinates:
    case StructureView::normals:
      break;
  }
  return "";
}

}  // namespace

int legend_height(int width) { return (2 * kMargin + 3 * kRow + 2 * kGap) * text_scale(width); }

std::vector<std::uint32_t> draw_legend(const ViewValues& values) {
  Strip strip(values.width);
  const int s = strip.scale();
  const std::string name(name_of(values.view));
  const std::string title = name + ": " + std::string(description_of(values.view));
  const bool fits = text_width(title, {s, true}) <= strip.width() - 2 * kMargin * s;
  strip.text(kMargin * s, kMargin * s, fits ? title : name, kBright, true);
  const int second = (kMargin + kRow + kGap) * s;
  switch (values.view) {
    case StructureView::mip_level:
    case StructureView::mip_colors:
      draw_levels(second, strip);
      break;
    case StructureView::triangles:
    case StructureView::coordinates:
      break;
    case StructureView::normals:
      draw_axes(second, strip);
      break;
    default:
      draw_bar(values, second, strip);
      break;
  }
  strip.text(kMargin * s, second + (kRow + kGap) * s, figures(values), kDim);
  return strip.take();
}

}  // namespace barrido::sheet
