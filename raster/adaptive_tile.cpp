#include "raster/adaptive_tile.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdlib>

#include "raster/reference/fragment_operations.h"
#include "raster/reference/samples.h"
#include "raster/slivers.h"

namespace barrido::raster {
namespace {

constexpr int kMostDepth = 4;
constexpr int kMostSide = (1 << kMostDepth) + 1;  ///< Places along a side of a pixel.

/// What is seen at a place.
struct Seen {
  reference::Color color{};  ///< Times alpha, and that.
  float depth = 1.0f;
  std::uint32_t shown = 0;  ///< 8 bits a channel, as it would be shown.
};

reference::Color mean(const reference::Color& a, const reference::Color& b, const reference::Color& c,
                      const reference::Color& d) {
  reference::Color result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = ((a[i] + b[i]) + (c[i] + d[i])) * 0.25f;
  return result;
}

/// A pixel that is cut into quarters: what is seen at the places of a grid over it, as far as that is known.
struct CutPixel {
  int column, row;
  std::vector<Seen> seen;  ///< side × side, lowest row first.
  std::bitset<kMostSide * kMostSide> known;
  std::vector<int> open;                                  ///< Squares of this level whose corners differ.
  std::bitset<kMostSide * kMostSide> is_cut[kMostDepth];  ///< By level: squares that were cut.
};

class AdaptiveTile {
 public:
  explicit AdaptiveTile(const SampledTile& tile)
      : tile_(tile),
        job_(tile.job),
        w_(tile.workspace),
        rule_(*tile.settings.adaptive),
        side_((1 << rule_.depth) + 1),
        limit_(static_cast<int>(rule_.threshold * 255.0f)),
        cut_of_(kTilePixels, -1) {
    if (!w_.places) w_.places = std::make_unique<TilePlaces>();
    w_.places->reach = tile.settings.reach();
    corners_.resize(static_cast<std::size_t>(job_.width + 1) * static_cast<std::size_t>(job_.height + 1));
  }

  void run() {
    look_at_corners();
    find_open_pixels();
    for (int level = 0; level < rule_.depth; ++level) cut_squares(level);
    for_each_pixel([&](int column, int row) { sum_pixel(column, row); });
    look_at_slivers();
  }

 private:
  template <class Visit>
  void for_each_pixel(const Visit& visit) const {
    for (int row = 0; row < job_.height; ++row) {
      for (int column = 0; column < job_.width; ++column) visit(column, row);
    }
  }

  Seen& corner(int column, int row) {
    return corners_[static_cast<std::size_t>(row) * static_cast<std::size_t>(job_.width + 1) +
                    static_cast<std::size_t>(column)];
  }

  void draw() {
    w_.clock.switch_to(Stage::clear);
    clear_tile(w_.surface, tile_.clear.color.data(), tile_.clear.depth);
    w_.clock.switch_to(Stage::spans);
    if (!job_.chunks->empty()) rasterize_tile(job_, w_);
    w_.clock.switch_to(Stage::resolve);
    show();
  }

  /// What is shown of float colours stands in the bytes, which such tiles do not use.
  void show() {
    if (w_.surface.format != ColorFormat::rgba32f) return;
    for (int row = 0; row < job_.height; ++row) {
      if (job_.places != nullptr && w_.places->wanted[row].none()) continue;
      const int at = row * kTileWidth;
      auto& planes = w_.surface.color_float;
      display_row({{planes[0] + at, planes[1] + at, planes[2] + at, planes[3] + at}, job_.width},
                  tile_.frame.display, w_.surface.color8 + at);
    }
  }

  /// Draws pixels at places of their own: those that `wanted` has.
  void draw_placed() {
    job_.places = w_.places.get();
    draw();
    job_.places = nullptr;
  }

  Seen seen_at(int column, int row) const {
    const int at = row * kTileWidth + column;
    const bool is_float = w_.surface.format == ColorFormat::rgba32f;
    reference::Color color = reference::unpack_rgba8(w_.surface.color8[at]);
    for (std::size_t c = 0; c < 4 && is_float; ++c) color[c] = w_.surface.color_float[c][at];
    const bool shows = is_float && tile_.settings.order == FilterOrder::display;
    reference::SampleSum one;
    reference::add_sample(color, w_.surface.depth[at], 1.0f, tile_.settings,
                          shows ? &tile_.frame.display : nullptr, one);
    return {one.color, w_.surface.depth[at], w_.surface.color8[at]};
  }

  /// The corners of all pixels: the lower left ones in one go, as a frame of one sample is drawn; then those
  /// that close the tile at its right and upper side.
  void look_at_corners() {
    job_.sample = {0, 0};
    draw();
    for_each_pixel([&](int column, int row) { corner(column, row) = seen_at(column, row); });
    const int last_column = job_.width - 1, last_row = job_.height - 1;
    for (const bool right : {false, true}) {
      for (const bool upper : {false, true}) {
        if (!right && !upper) continue;
        const SamplePlace place{right ? kSubpixelUnits : 0, upper ? kSubpixelUnits : 0};
        want_none();
        for (int row = upper ? last_row : 0; row <= last_row; ++row) {
          const int begin = right ? last_column : 0;
          for (int column = begin; column <= last_column; ++column) want(column, row, place);
        }
        draw_placed();
        for_each_wanted([&](int column, int row) {
          corner(column + (right ? 1 : 0), row + (upper ? 1 : 0)) = seen_at(column, row);
        });
      }
    }
  }

  void want_none() { std::fill(std::begin(w_.places->wanted), std::end(w_.places->wanted), PixelBits{}); }
  void want(int column, int row, const SamplePlace& place) {
    w_.places->wanted[row].put(column, 1);
    w_.places->set(row * kTileWidth + column, place);
  }
  template <class Visit>
  void for_each_wanted(const Visit& visit) const {
    for (int row = 0; row < job_.height; ++row) {
      for (PixelBits left = w_.places->wanted[row]; !left.none();) {
        const int column = left.first();
        left = left & PixelBits::of(column + 1, kTileWidth);
        visit(column, row);
      }
    }
  }

  bool differ(const Seen& a, const Seen& b) const {
    for (int shift = 0; shift < 32; shift += 8) {
      const int difference =
          static_cast<int>(a.shown >> shift & 0xff) - static_cast<int>(b.shown >> shift & 0xff);
      if (std::abs(difference) > limit_) return true;
    }
    return false;
  }
  bool differ(const Seen& a, const Seen& b, const Seen& c, const Seen& d) const {
    return differ(a, b) || differ(a, c) || differ(a, d) || differ(b, c) || differ(b, d) || differ(c, d);
  }

  void find_open_pixels() {
    for_each_pixel([&](int column, int row) {
      const Seen& a = corner(column, row);
      const Seen& b = corner(column + 1, row);
      const Seen& c = corner(column, row + 1);
      const Seen& d = corner(column + 1, row + 1);
      if (!differ(a, b, c, d)) return;
      cut_of_[static_cast<std::size_t>(row * kTileWidth + column)] = static_cast<int>(cut_.size());
      CutPixel& pixel = cut_.emplace_back();
      pixel.column = column;
      pixel.row = row;
      pixel.seen.resize(static_cast<std::size_t>(side_ * side_));
      const int last = side_ - 1;
      know(pixel, 0, 0, a);
      know(pixel, last, 0, b);
      know(pixel, 0, last, c);
      know(pixel, last, last, d);
      pixel.open = {0};
    });
  }

  int number(int i, int j) const { return j * side_ + i; }
  void know(CutPixel& pixel, int i, int j, const Seen& seen) const {
    pixel.seen[static_cast<std::size_t>(number(i, j))] = seen;
    pixel.known.set(static_cast<std::size_t>(number(i, j)));
  }
  const Seen& at(const CutPixel& pixel, int i, int j) const {
    return pixel.seen[static_cast<std::size_t>(number(i, j))];
  }

  /// A square of a level is named by its lower left place. Its five new places are looked at, in all pixels
  /// that want one of them at once; then its quarters are asked.
  void cut_squares(int level) {
    const int size = (side_ - 1) >> level;
    const int half = size / 2;
    std::vector<std::vector<CutPixel*>> wanting(static_cast<std::size_t>(side_ * side_));
    for (CutPixel& pixel : cut_) {
      for (const int square : pixel.open) {
        const int i = square % side_, j = square / side_;
        const int places[5] = {number(i + half, j), number(i, j + half), number(i + half, j + half),
                               number(i + size, j + half), number(i + half, j + size)};
        for (const int place : places) {
          if (pixel.known.test(static_cast<std::size_t>(place))) continue;
          pixel.known.set(static_cast<std::size_t>(place));
          wanting[static_cast<std::size_t>(place)].push_back(&pixel);
        }
      }
    }
    for (int place = 0; place < side_ * side_; ++place)
      look_at(place, wanting[static_cast<std::size_t>(place)]);
    for (CutPixel& pixel : cut_) ask_quarters(pixel, level, size, half);
  }

  void look_at(int place, const std::vector<CutPixel*>& pixels) {
    if (pixels.empty()) return;
    want_none();
    for (const CutPixel* pixel : pixels) want(pixel->column, pixel->row, place_of(place));
    draw_placed();
    for (CutPixel* pixel : pixels) {
      pixel->seen[static_cast<std::size_t>(place)] = seen_at(pixel->column, pixel->row);
    }
  }

  SamplePlace place_of(int number) const {
    const int step = kSubpixelUnits / (side_ - 1);
    return {number % side_ * step, number / side_ * step};
  }

  void ask_quarters(CutPixel& pixel, int level, int size, int half) const {
    std::vector<int> open;
    for (const int square : pixel.open) {
      pixel.is_cut[level].set(static_cast<std::size_t>(square));
      if (level + 1 == rule_.depth) continue;
      const int i = square % side_, j = square / side_;
      for (int y = j; y < j + size; y += half) {
        for (int x = i; x < i + size; x += half) {
          if (differ(at(pixel, x, y), at(pixel, x + half, y), at(pixel, x, y + half),
                     at(pixel, x + half, y + half))) {
            open.push_back(number(x, y));
          }
        }
      }
    }
    pixel.open = std::move(open);
  }

  /// The mean over a square: of its quarters where it was cut, else of its corners.
  reference::Color mean_over(const CutPixel& pixel, int level, int i, int j) const {
    const int size = (side_ - 1) >> level;
    if (level == rule_.depth || !pixel.is_cut[level].test(static_cast<std::size_t>(number(i, j)))) {
      return mean(at(pixel, i, j).color, at(pixel, i + size, j).color, at(pixel, i, j + size).color,
                  at(pixel, i + size, j + size).color);
    }
    const int half = size / 2;
    return mean(mean_over(pixel, level + 1, i, j), mean_over(pixel, level + 1, i + half, j),
                mean_over(pixel, level + 1, i, j + half), mean_over(pixel, level + 1, i + half, j + half));
  }

  const CutPixel* cut_pixel(int column, int row) const {
    const int place = cut_of_[static_cast<std::size_t>(row * kTileWidth + column)];
    return place < 0 ? nullptr : &cut_[static_cast<std::size_t>(place)];
  }

  void sum_pixel(int column, int row) {
    const Seen& a = corner(column, row);
    const Seen& b = corner(column + 1, row);
    const Seen& c = corner(column, row + 1);
    const Seen& d = corner(column + 1, row + 1);
    reference::Color color = mean(a.color, b.color, c.color, d.color);
    float depth = std::min({a.depth, b.depth, c.depth, d.depth});
    int count = 4;
    if (const CutPixel* pixel = cut_pixel(column, row)) {
      color = mean_over(*pixel, 0, 0, 0);
      count = static_cast<int>(pixel->known.count());
      for (int i = 0; i < side_ * side_; ++i) {
        if (pixel->known.test(static_cast<std::size_t>(i))) {
          depth = std::min(depth, pixel->seen[static_cast<std::size_t>(i)].depth);
        }
      }
    }
    const int at = row * kTileWidth + column;
    for (std::size_t i = 0; i < 4; ++i) w_.sums->color[i][at] = color[i];
    w_.sums->weight[at] = 1.0f;
    w_.sums->depth[at] = std::min(w_.sums->depth[at], depth);
    if (tile_.settings.report != nullptr) {
      tile_.settings.report->counts[frame_index(column, row)] = static_cast<std::uint16_t>(count);
    }
  }

  std::size_t frame_index(int column, int row) const {
    const int x = job_.column * kTileWidth + column;
    const int y = job_.row * kTileHeight + row;
    return static_cast<std::size_t>(tile_.frame.height - 1 - y) *
               static_cast<std::size_t>(tile_.frame.width) +
           static_cast<std::size_t>(x);
  }

  /// Triangles that touch a pixel between its samples: what is seen there, too, counts for its area.
  void look_at_slivers() {
    const TileArea area{job_.column * kTileWidth, job_.row * kTileHeight, job_.width, job_.height, {}};
    std::vector<SamplePlace> places;
    SliverSearch search(area, [&](int at) -> const std::vector<SamplePlace>& {
      list_places(at % kTileWidth, at / kTileWidth, places);
      return places;
    });
    for (const BinnedChunk* binned : *job_.chunks) {
      if (binned->chunk().topology != Topology::triangles) continue;
      for (const std::uint16_t number : binned->primitives_in(job_.column, job_.row)) {
        search.add(binned->chunk().primitives[number]);
      }
    }
    if (!search.any()) return;
    report_slivers(search);
    if (rule_.keeps_slivers) {
      for (int round = 0; round < kMostSlivers; ++round) add_slivers(search, round);
    }
  }

  void list_places(int column, int row, std::vector<SamplePlace>& places) const {
    places = {{0, 0}, {kSubpixelUnits, 0}, {0, kSubpixelUnits}, {kSubpixelUnits, kSubpixelUnits}};
    const CutPixel* pixel = cut_pixel(column, row);
    for (int i = 0; pixel != nullptr && i < side_ * side_; ++i) {
      if (pixel->known.test(static_cast<std::size_t>(i))) places.push_back(place_of(i));
    }
  }

  void report_slivers(const SliverSearch& search) {
    if (tile_.settings.report == nullptr) return;
    for_each_pixel([&](int column, int row) {
      const auto& pixel = search.pixels()[static_cast<std::size_t>(row * kTileWidth + column)];
      if (pixel.count == 0) return;
      tile_.settings.report->slivers[frame_index(column, row)] = 1;
      if (rule_.keeps_slivers) {
        tile_.settings.report->counts[frame_index(column, row)] += static_cast<std::uint16_t>(pixel.count);
      }
    });
  }

  /// The next sliver of each pixel that has one: colours seen there take its area from those seen so far.
  void add_slivers(const SliverSearch& search, int round) {
    want_none();
    bool any = false;
    for_each_pixel([&](int column, int row) {
      const auto& pixel = search.pixels()[static_cast<std::size_t>(row * kTileWidth + column)];
      if (round >= pixel.count) return;
      want(column, row, pixel.slivers[static_cast<std::size_t>(round)].place);
      any = true;
    });
    if (!any) return;
    draw_placed();
    for_each_wanted([&](int column, int row) {
      const int at = row * kTileWidth + column;
      const auto& pixel = search.pixels()[static_cast<std::size_t>(at)];
      // Those that follow take their part of this one too, so that each has its own area in the end.
      float later = 0.0f;
      for (int i = round + 1; i < pixel.count; ++i) later += pixel.slivers[static_cast<std::size_t>(i)].area;
      const float own = pixel.slivers[static_cast<std::size_t>(round)].area;
      const float area = std::min(later < 1.0f ? own / (1.0f - later) : 1.0f, 1.0f);
      const Seen seen = seen_at(column, row);
      for (std::size_t c = 0; c < 4; ++c) {
        float& sum = w_.sums->color[c][at];
        sum = sum * (1.0f - area) + seen.color[c] * area;
      }
      w_.sums->depth[at] = std::min(w_.sums->depth[at], seen.depth);
    });
  }

  const SampledTile& tile_;
  TileJob& job_;
  TileWorkspace& w_;
  const AdaptiveSettings rule_;
  const int side_;   ///< Places along a side of the grid.
  const int limit_;  ///< Differences of 8-bit channels above this are too much.
  std::vector<Seen> corners_;
  std::vector<CutPixel> cut_;
  std::vector<int> cut_of_;  ///< By pixel: its number in cut_, or −1.
};

}  // namespace

void add_adaptive_samples(const SampledTile& tile) { AdaptiveTile(tile).run(); }

}  // namespace barrido::raster
