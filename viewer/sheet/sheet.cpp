#include "viewer/sheet/sheet.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "viewer/sheet/text.h"

namespace barrido::sheet {
namespace {

using Color = std::array<std::uint8_t, 3>;

constexpr Color kBackground{38, 38, 38};
constexpr Color kTitle{240, 240, 240};
constexpr Color kLabel{214, 214, 214};
constexpr Color kDimLabel{150, 150, 150};

constexpr int kMaxSide = 65535;
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// All measures of a sheet, in pixels.
struct Layout {
  int columns = 0, rows = 0;
  int cell_width = 0, cell_height = 0;  ///< Of the largest picture.
  int label_height = 0;                 ///< Below a picture, the space above the text included.
  int title_height = 0;                 ///< The space below the text included.
  int margin = 0, gap = 0;
  int scale = 1;

  std::int64_t width() const { return 2 * margin + std::int64_t{columns} * (cell_width + gap) - gap; }
  std::int64_t height() const {
    return 2 * margin + title_height + std::int64_t{rows} * (cell_height + label_height + gap) - gap;
  }
  int cell_left(int index) const { return margin + index % columns * (cell_width + gap); }
  int cell_top(int index) const {
    return margin + title_height + index / columns * (cell_height + label_height + gap);
  }
};

/// How far a sheet is from 16:10, with empty cells counted against it; smaller is better.
double ugliness(const Layout& layout, int count) {
  const double ratio = static_cast<double>(layout.width()) / static_cast<double>(layout.height()) / 1.6;
  const int empty = layout.columns * layout.rows - count;
  return std::max(ratio, 1.0 / ratio) + static_cast<double>(empty) / count;
}

/// Text stays readable when the sheet is looked at as a whole.
int scale_for(int picture_width) {
  int scale = 1;
  while (scale < 16 && picture_width > 560 * scale) scale *= 2;
  return scale;
}

Layout with_columns(Layout layout, int columns, int count) {
  layout.columns = columns;
  layout.rows = (count + columns - 1) / columns;
  return layout;
}

Layout lay_out(std::span<const SheetPicture> pictures, const SheetOptions& options) {
  Layout layout;
  std::size_t label_lines = 0;
  for (const SheetPicture& picture : pictures) {
    layout.cell_width = std::max(layout.cell_width, picture.width);
    layout.cell_height = std::max(layout.cell_height, picture.height);
    label_lines = std::max(label_lines, lines_of(picture.label).size());
  }
  layout.scale = options.text_scale > 0 ? options.text_scale : scale_for(layout.cell_width);
  const int line = text_height({layout.scale, false});
  layout.margin = 16 * layout.scale;
  layout.gap = 12 * layout.scale;
  // A glyph has two empty rows above it; the four below it, for descenders, count as part of the gap.
  layout.label_height =
      label_lines == 0 ? 0 : static_cast<int>(label_lines) * (line + layout.scale) - 3 * layout.scale;
  layout.title_height = options.title.empty() ? 0 : line + 8 * layout.scale;

  const int count = static_cast<int>(pictures.size());
  if (options.columns > 0) return with_columns(layout, std::min(options.columns, count), count);
  Layout best = with_columns(layout, 1, count);
  for (int columns = 2; columns <= count; ++columns) {
    const Layout candidate = with_columns(layout, columns, count);
    if (ugliness(candidate, count) < ugliness(best, count)) best = candidate;
  }
  return best;
}

/// The sheet while it is painted.
class Canvas {
 public:
  Canvas(int width, int height) {
    image_.name = "sheet";
    image_.width = width;
    image_.height = height;
    image_.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (std::size_t i = 0; i < image_.rgba.size(); i += 4) put(i, kBackground);
  }

  void paint_picture(const SheetPicture& picture, int left, int top) {
    const std::uint8_t* in = picture.rgba8.data();
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x, in += 4) {
        std::uint8_t* out = image_.rgba.data() + offset(left + x, top + y);
        for (std::size_t c = 0; c < 3; ++c) {
          out[c] = static_cast<std::uint8_t>((in[c] * in[3] + out[c] * (255 - in[3]) + 127) / 255);
        }
      }
    }
  }

  /// `left`, `top`: where the line's box begins; what does not fit into `max_width` is left out.
  void paint_text(std::string_view text, const TextStyle& style, const Color& color, int left, int top,
                  int max_width) {
    const TextMask mask = draw_text(fit_text(text, style, max_width), style);
    for (int y = 0; y < mask.height; ++y) {
      for (int x = 0; x < mask.width; ++x) {
        if (mask.at(x, y)) put(offset(left + x, top + y), color);
      }
    }
  }

  scene::Image take() { return std::move(image_); }

 private:
  std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
            static_cast<std::size_t>(x)) *
           4;
  }
  void put(std::size_t at, const Color& color) {
    std::copy(color.begin(), color.end(), image_.rgba.begin() + static_cast<std::ptrdiff_t>(at));
    image_.rgba[at + 3] = 255;
  }

  scene::Image image_;
};

void check_pictures(std::span<const SheetPicture> pictures) {
  if (pictures.empty()) throw std::invalid_argument("a sheet needs a picture");
  for (const SheetPicture& picture : pictures) {
    const bool positive = picture.width > 0 && picture.height > 0;
    if (!positive || picture.rgba8.size() != static_cast<std::size_t>(picture.width) *
                                                 static_cast<std::size_t>(picture.height) * 4) {
      throw std::invalid_argument("SheetPicture: the bytes do not fit the size");
    }
  }
}

}  // namespace

scene::Image compose_sheet(std::span<const SheetPicture> pictures, const SheetOptions& options) {
  check_pictures(pictures);
  const Layout layout = lay_out(pictures, options);
  if (layout.width() > kMaxSide || layout.height() > kMaxSide ||
      layout.width() * layout.height() > kMaxPixels) {
    throw scene::InputError("sheet", "",
                            std::to_string(layout.width()) + " × " + std::to_string(layout.height()) +
                                " pixels are too many; use a smaller resolution or fewer pictures");
  }
  Canvas canvas(static_cast<int>(layout.width()), static_cast<int>(layout.height()));
  if (!options.title.empty()) {
    canvas.paint_text(options.title, {layout.scale, true}, kTitle, layout.margin,
                      layout.margin - 2 * layout.scale, static_cast<int>(layout.width()) - 2 * layout.margin);
  }
  for (int i = 0; i < static_cast<int>(pictures.size()); ++i) {
    const SheetPicture& picture = pictures[static_cast<std::size_t>(i)];
    const int left = layout.cell_left(i), top = layout.cell_top(i);
    canvas.paint_picture(picture, left + (layout.cell_width - picture.width) / 2,
                         top + (layout.cell_height - picture.height) / 2);
    const TextStyle style{layout.scale, false};
    int line_top = top + layout.cell_height + 2 * layout.scale;
    const Color* color = &kLabel;
    for (const std::string_view line : lines_of(picture.label)) {
      canvas.paint_text(line, style, *color, left, line_top, layout.cell_width);
      line_top += text_height(style) + layout.scale;
      color = &kDimLabel;
    }
  }
  return canvas.take();
}

}  // namespace barrido::sheet
