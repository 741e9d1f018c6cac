#include "raster/reference/wide_filters.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "raster/base/portable_math.h"
#include "raster/textures/footprint_limits.h"

namespace barrido::raster::reference {
namespace {

/// A pixel's footprint in texels: (ux, vx) and (uy, vy) are the sides of a parallelogram.
CoordinateSlopes in_texels(const CoordinateSlopes& slopes, int width, int height) {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  return {slopes.ux * w, slopes.uy * w, slopes.vx * h, slopes.vy * h};
}

/// Samples of one pixel: at place + along·t for each of them, and the levels that they come from.
struct Probes {
  int count = 1;
  LevelChoice levels;
  CoordinateSlopes slopes;  ///< What `offset` multiplies; 0 where all probes fall together.
  bool at_corners = false;

  /// Of probe k, in pixels along x and y.
  std::array<float, 2> offset(int k) const {
    if (at_corners) return {(k & 1) != 0 ? 0.5f : -0.5f, (k & 2) != 0 ? 0.5f : -0.5f};
    return {static_cast<float>(k + 1) * (1.0f / static_cast<float>(count + 1)) - 0.5f, 0.0f};
  }
};

Probes corner_probes(const TextureUnit& unit, float lod, const CoordinateSlopes& slopes) {
  Probes probes;
  probes.at_corners = true;
  probes.levels = choose_levels(unit, lod);
  if (probes.levels.magnified) return probes;
  probes.count = 4;
  probes.slopes = slopes;
  return probes;
}

/// EXT_texture_filter_anisotropic: N = min(⌈Pmax/Pmin⌉, most) samples along the longer side, of the levels
/// for λ' = log2(Pmax/N).
Probes anisotropic_probes(const TextureUnit& unit, const CoordinateSlopes& slopes) {
  const CoordinateSlopes texels = in_texels(slopes, unit.texture->width(), unit.texture->height());
  const float a = texels.ux * texels.ux + texels.vx * texels.vx;
  const float b = texels.uy * texels.uy + texels.vy * texels.vy;
  const bool along_x = a > b;
  const float most = minimum(maximum(a, b), 1e30f);
  const float ratio = std::ceil(std::sqrt(most / minimum(a, b)));
  const float n = maximum(minimum(ratio, static_cast<float>(unit.max_anisotropy)), 1.0f);
  Probes probes;
  probes.count = static_cast<int>(n);
  probes.levels = choose_levels(unit, 0.5f * portable_log2(most / (n * n)));
  probes.slopes =
      along_x ? CoordinateSlopes{slopes.ux, 0, slopes.vx, 0} : CoordinateSlopes{slopes.uy, 0, slopes.vy, 0};
  return probes;
}

Probes probes_of(const TextureUnit& unit, float lod, const CoordinateSlopes& slopes) {
  return unit.min_filter == MinFilter::corners ? corner_probes(unit, lod, slopes)
                                               : anisotropic_probes(unit, slopes);
}

WideSample sample_probes(const TextureUnit& unit, const Place& place, const Probes& probes,
                         SampleTrace* trace) {
  Filtered sum{};
  for (int k = 0; k < probes.count; ++k) {
    const auto [x, y] = probes.offset(k);
    const Place at{place.face, sane_coordinate(place.u + (probes.slopes.ux * x + probes.slopes.uy * y)),
                   sane_coordinate(place.v + (probes.slopes.vx * x + probes.slopes.vy * y))};
    const std::size_t before = trace != nullptr ? trace->levels.size() : 0;
    const Filtered filtered = sample_at(unit, probes.levels, at, trace);
    for (std::size_t c = 0; c < 4; ++c) sum[c] += filtered[c];
    if (trace == nullptr) continue;
    for (std::size_t i = before; i < trace->levels.size(); ++i) trace->levels[i].probe = k;
  }
  WideSample sample;
  const float scale = channel_scale(*unit.texture) / static_cast<float>(probes.count);
  for (std::size_t c = 0; c < 4; ++c) sample.color[c] = static_cast<float>(sum[c]) * scale;
  sample.texels = static_cast<std::uint32_t>(probes.levels.texels() * probes.count);
  return sample;
}

// The mean of all texels under the footprint.

float sane_slope(float slope) { return std::fabs(slope) < kLargestSlope ? slope : 0.0f; }

/// The smallest level under which a side of `extent` texels of level 0 has at most 2^kMostSummedLog2.
int summed_level(float extent, int last) {
  const auto bits = static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(extent));
  return std::clamp(((bits + 0x7fffff) >> 23) - (127 + kMostSummedLog2), 0, last);
}

/// Where the middle of the footprint lies, in texels; wrapped, but mirrors are left to the texels.
float middle(float u, int size, Wrap wrap) {
  const auto texels = static_cast<float>(size);
  switch (wrap) {
    case Wrap::repeat:
      return (u - std::floor(u)) * texels;
    case Wrap::mirrored_repeat:
      return (u - 2.0f * std::floor(u * 0.5f)) * texels;
    case Wrap::clamp:
      return clamp_to_unit(u) * texels;
    case Wrap::clamp_to_edge:
    case Wrap::clamp_to_border:
      break;
  }
  return minimum(maximum(u * texels, -kBeyondEdgeTexels), texels + kBeyondEdgeTexels);
}

/// The texel that stands for column (or row) i; -1 and `size` are the apron.
int wrapped_texel(int i, int size, Wrap wrap) {
  const auto modulo = [](int a, int n) { return (a % n + n) % n; };
  switch (wrap) {
    case Wrap::repeat:
      return modulo(i, size);
    case Wrap::mirrored_repeat: {
      const int m = modulo(i, 2 * size);
      return m < size ? m : 2 * size - 1 - m;
    }
    case Wrap::clamp_to_edge:
      return std::clamp(i, 0, size - 1);
    case Wrap::clamp:
    case Wrap::clamp_to_border:
      break;
  }
  return std::clamp(i, -1, size);
}

/// A parallelogram about (0, 0), in texels.
class Parallelogram {
 public:
  float half_height = 0.0f;
  float corner_height = 0.0f;  ///< Of the two corners between the lowest and the highest, one below 0.

  explicit Parallelogram(CoordinateSlopes side) {
    const float extent =
        maximum(std::fabs(side.ux) + std::fabs(side.uy), std::fabs(side.vx) + std::fabs(side.vy));
    const float shrink = extent > kLongestFootprintSide ? kLongestFootprintSide / extent : 1.0f;
    side = {side.ux * shrink, side.uy * shrink, side.vx * shrink, side.vy * shrink};
    half_width_ = maximum((std::fabs(side.ux) + std::fabs(side.uy)) * 0.5f, kLeastFootprintWidth * 0.5f);
    half_height = maximum((std::fabs(side.vx) + std::fabs(side.vy)) * 0.5f, kLeastFootprintWidth * 0.5f);
    corner_height = std::fabs(std::fabs(side.vx) - std::fabs(side.vy)) * 0.5f;
    const float area = std::fabs(side.ux * side.vy - side.vx * side.uy);
    bands_[0] = band(side.uy, side.vy, area);
    bands_[1] = band(side.ux, side.vx, area);
  }

  struct Interval {
    float left, right;
  };
  /// At the height y, at least kLeastFootprintWidth wide.
  Interval at(float y) const {
    float left = -half_width_;
    float right = half_width_;
    for (const Band& b : bands_) {
      left = maximum(left, y * b.slope - b.half);
      right = minimum(right, y * b.slope + b.half);
    }
    if (right - left < kLeastFootprintWidth) {
      const float x = minimum(maximum((left + right) * 0.5f, -half_width_), half_width_);
      left = x - kLeastFootprintWidth * 0.5f;
      right = x + kLeastFootprintWidth * 0.5f;
    }
    return {left, right};
  }

 private:
  /// Between two parallel sides: |x − y·slope| ≤ half.
  struct Band {
    float slope = 0.0f;
    float half = 2.0f * kLongestFootprintSide;
  };
  /// Between the sides in direction (x, y) of the parallelogram.
  static Band band(float x, float y, float area) {
    if (!(std::fabs(y) >= kLeastFootprintRise)) return {};
    return {x / y, area * 0.5f / std::fabs(y)};
  }

  Band bands_[2];
  float half_width_;
};

struct TexelRange {
  int first, end;
};
/// The texels that [low, high] meets, at least one.
TexelRange texels_between(float low, float high) {
  const int first = static_cast<int>(std::floor(low));
  return {first, std::max(static_cast<int>(std::ceil(high)), first + 1)};
}

/// The mean of max(c, 0) while c goes from p to q at an even pace.
float mean_of_positive(float p, float q) {
  if (p > 0.0f && q > 0.0f) return (p + q) * 0.5f;
  const float most = maximum(maximum(p, q), 0.0f);
  return most * most / maximum(2.0f * std::fabs(p - q), 1e-30f);
}

/// What a strip of a row of texels, with a straight side at its left and its right, covers of each texel.
class Strip {
 public:
  Strip(Parallelogram::Interval low, Parallelogram::Interval high, float x, float height)
      : left_{x + low.left, x + high.left}, right_{x + low.right, x + high.right}, height_(height) {
    columns = texels_between(minimum(left_[0], left_[1]), maximum(right_[0], right_[1]));
  }

  TexelRange columns{};

  float area(int i) const {
    return maximum((left_of(static_cast<float>(i + 1)) - left_of(static_cast<float>(i))) * height_, 0.0f);
  }

 private:
  /// Of the strip, left of x; a row high.
  float left_of(float x) const {
    return mean_of_positive(x - left_[0], x - left_[1]) - mean_of_positive(x - right_[0], x - right_[1]);
  }

  float left_[2], right_[2];
  float height_;
};

/// Σ wᵢ(tᵢ − t₀), so that texels of one colour have exactly that for their mean.
class WeightedMean {
 public:
  void add(const Filtered& texel, float weight) {
    if (count_++ == 0) base_ = texel;
    for (std::size_t c = 0; c < 4; ++c) {
      sum_[c] += (static_cast<float>(texel[c]) - static_cast<float>(base_[c])) * weight;
    }
    weight_ += weight;
  }
  Color color(float scale) const {
    Color mean{};
    for (std::size_t c = 0; c < 4; ++c) {
      mean[c] = clamp_to_unit((static_cast<float>(base_[c]) + sum_[c] / weight_) * scale);
    }
    return mean;
  }
  std::uint32_t count() const { return count_; }
  float weight() const { return weight_; }

 private:
  Filtered base_{};
  Color sum_{};
  float weight_ = 0.0f;
  std::uint32_t count_ = 0;
};

WideSample mean_of_footprint(const TextureUnit& unit, const Place& place, const CoordinateSlopes& given,
                             SampleTrace* trace) {
  const Texture& texture = *unit.texture;
  const TextureOptions& options = texture.options();
  // The apron of a cube map's face holds what lies beyond an edge.
  const Wrap wrap_s = texture.is_cube() ? Wrap::clamp_to_border : options.wrap_s;
  const Wrap wrap_t = texture.is_cube() ? Wrap::clamp_to_border : options.wrap_t;
  const CoordinateSlopes slopes{sane_slope(given.ux), sane_slope(given.uy), sane_slope(given.vx),
                                sane_slope(given.vy)};
  const CoordinateSlopes base = in_texels(slopes, texture.width(), texture.height());
  const float extent =
      maximum(std::fabs(base.ux) + std::fabs(base.uy), std::fabs(base.vx) + std::fabs(base.vy));
  const int level = summed_level(extent, texture.level_count() - 1);
  const MipLevel& size = texture.level(level, place.face);
  const Parallelogram footprint(in_texels(slopes, size.width, size.height));
  const float x = middle(place.u, size.width, wrap_s);
  const float y = middle(place.v, size.height, wrap_t);
  const float bottom = y - footprint.half_height;
  const float top = y + footprint.half_height;
  LevelTrace* remembered = nullptr;
  if (trace != nullptr) {
    remembered = &trace->levels.emplace_back(LevelTrace{0, level, size.width, size.height, {}, {}});
  }
  WeightedMean mean;
  // Strips between whole rows and the footprint's corners: within each, both of its sides are straight.
  for (float low = bottom; low < top;) {
    const float whole = std::floor(low);
    float high = minimum(whole + 1.0f, top);
    for (const float corner : {y - footprint.corner_height, y + footprint.corner_height}) {
      if (corner > low) high = minimum(high, corner);
    }
    const Strip strip(footprint.at(low - y), footprint.at(high - y), x, high - low);
    const int row = wrapped_texel(static_cast<int>(whole), size.height, wrap_t);
    for (int i = strip.columns.first; i < strip.columns.end; ++i) {
      const float weight = strip.area(i);
      const int column = wrapped_texel(i, size.width, wrap_s);
      mean.add(fetch(texture, level, place.face, column, row), weight);
      if (remembered == nullptr) continue;
      remembered->texels.push_back({column, row, texture.texel(level, place.face, column, row), weight});
    }
    low = high;
  }
  const float scale = texture.format() == TexelFormat::rgba8 ? 1.0f / 255.0f : 1.0f / 65535.0f;
  const Color color = mean.color(scale);
  if (remembered != nullptr) {
    for (TexelTrace& texel : remembered->texels) texel.weight /= mean.weight();
    remembered->color = color;
  }
  return {color, mean.count()};
}

void remember(const TextureUnit& unit, const Place& place, float lod, const CoordinateSlopes& slopes,
              const LevelChoice& levels, int probes, SampleTrace& trace) {
  const CoordinateSlopes texels = in_texels(slopes, unit.texture->width(), unit.texture->height());
  trace.face = place.face;
  trace.u = place.u;
  trace.v = place.v;
  trace.lod = lod + unit.lod_bias;
  trace.magnified = levels.magnified;
  trace.far_weight = static_cast<float>(levels.fraction) * (1.0f / 256.0f);
  trace.footprint = FootprintTrace{{texels.ux, texels.vx}, {texels.uy, texels.vy}, probes};
}

}  // namespace

LevelChoice choose_wide_levels(const TextureUnit& unit, float lod, const CoordinateSlopes& slopes) {
  if (unit.min_filter != MinFilter::footprint) return probes_of(unit, lod, slopes).levels;
  LevelChoice choice = choose_levels(unit, lod);
  if (choice.magnified) return choice;
  const CoordinateSlopes base =
      in_texels({sane_slope(slopes.ux), sane_slope(slopes.uy), sane_slope(slopes.vx), sane_slope(slopes.vy)},
                unit.texture->width(), unit.texture->height());
  choice.first =
      summed_level(maximum(std::fabs(base.ux) + std::fabs(base.uy), std::fabs(base.vx) + std::fabs(base.vy)),
                   unit.texture->level_count() - 1);
  return choice;
}

WideSample sample_wide(const TextureUnit& unit, TexcoordKind kind, const float (&coordinates)[3], float lod,
                       const CoordinateSlopes& slopes, SampleTrace* trace) {
  Place place = place_of(kind, coordinates);
  if (unit.texture->is_cube()) place = {place.face, clamp_to_unit(place.u), clamp_to_unit(place.v)};
  Probes probes;
  probes.levels = choose_levels(unit, lod);
  const bool sums = unit.min_filter == MinFilter::footprint && !probes.levels.magnified;
  if (unit.min_filter != MinFilter::footprint) probes = probes_of(unit, lod, slopes);
  const WideSample sample =
      sums ? mean_of_footprint(unit, place, slopes, trace) : sample_probes(unit, place, probes, trace);
  if (trace != nullptr) {
    remember(unit, place, lod, slopes, probes.levels, sums ? 0 : probes.count, *trace);
    trace->color = sample.color;
  }
  return sample;
}

}  // namespace barrido::raster::reference
