#include "tests/osmesa/classify.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/osmesa/exact_light.h"
#include "tests/osmesa/exact_texture.h"

namespace barrido::crosscheck {
namespace {

/// One surface at a pixel, for finding near ties in depth.
struct Surface {
  double depth, slope;
};

/// Whether the draw's colours are the texels of unit 0 as they are, seen where nearest.
bool shows_plain_texels(const DrawCall& draw) {
  const pipeline::State& state = draw.state;
  return state.texture_units[0].env_mode == raster::TextureEnvMode::replace &&
         state.texture_units[1].texture == nullptr && state.depth.test &&
         state.depth.compare == raster::Compare::less && !state.lighting.separate_specular &&
         !state.fog.enabled && !state.blend.enabled && !state.alpha_test.enabled && !state.scissor.enabled;
}

class Classifier {
 public:
  explicit Classifier(const ScenePair& pair)
      : pair_(pair),
        rules_(static_cast<std::size_t>(pair.width * pair.height)),
        surfaces_(rules_.size()),
        fragments_(rules_.size(), 0) {}

  std::vector<PixelRule> run() {
    for (const DrawCall& draw : pair_.draws) add(draw);
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      if (has_depth_tie(surfaces_[i])) mark(i, PixelClass::tie);
      if (blends_) {
        // One rounding a layer; factors and equations that read the destination twice can double what came
        // before.
        rules_[i].layers *= (1 << std::clamp(fragments_[i], 1, 8)) - 1;
      }
    }
    return std::move(rules_);
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>((pair_.height - 1 - y) * pair_.width + x);
  }

  void mark(std::size_t i, PixelClass kind) { rules_[i].kind = std::max(rules_[i].kind, kind); }

  /// Calls visit(x, y) for the pixels around a segment that is within the frame.
  template <class Visit>
  void around(const WindowPoint& a, const WindowPoint& b, double reach, const Visit& visit) {
    const int y0 = std::max(0, static_cast<int>(std::floor(std::min(a.y, b.y) - reach - 0.5)));
    const int y1 = std::min(pair_.height - 1, static_cast<int>(std::ceil(std::max(a.y, b.y) + reach)));
    const int x0 = std::max(0, static_cast<int>(std::floor(std::min(a.x, b.x) - reach - 0.5)));
    const int x1 = std::min(pair_.width - 1, static_cast<int>(std::ceil(std::max(a.x, b.x) + reach)));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) visit(x, y);
    }
  }

  void add_edge(WindowPoint a, WindowPoint b, double reach) {
    if (!cut_to_frame(a, b, pair_.width, pair_.height, reach + 1.0)) return;
    around(a, b, reach, [&](int x, int y) {
      if (distance_to_segment({x + 0.5, y + 0.5}, a, b) <= reach) mark(index(x, y), PixelClass::edge);
    });
  }

  void add(const DrawCall& draw) {
    blends_ |= draw.state.blend.enabled;
    gain_ = gain_of(draw.state);
    shows_texels_ = pair_.draws.size() == 1 && shows_plain_texels(draw);
    std::vector<ExactUnit> units;
    for (std::size_t i = 0; i < 2; ++i) {
      if (draw.state.texture_units[i].texture != nullptr) units.emplace_back(draw, i);
    }
    const ExactLights lights(draw);
    for (const ExactTriangle& triangle : exact_triangles(draw, pair_.width, pair_.height)) {
      add(triangle, draw, units, lights);
    }
    const bool points = draw.mesh.mode == pipeline::PrimitiveMode::points ||
                        draw.state.polygon_mode == pipeline::PolygonMode::point;
    for (const auto& [a, b] : exact_strokes(draw, pair_.width, pair_.height)) {
      if (points) {
        add_point(a, draw.state.point_size);
      } else {
        add_edge(a, b, 0.5 * draw.state.line_width + 1.5);
      }
    }
  }

  /// A square whose sides are edges; its pixels deep inside are interior.
  void add_point(const WindowPoint& p, double size) {
    const double half = 0.5 * std::max(1.0, std::floor(size + 0.5));
    around(p, p, half + 1.5, [&](int x, int y) {
      const double away = std::max(std::abs(x + 0.5 - p.x), std::abs(y + 0.5 - p.y));
      if (std::abs(away - half) <= 1.0) mark(index(x, y), PixelClass::edge);
    });
  }

  void add(const ExactTriangle& triangle, const DrawCall& draw, const std::vector<ExactUnit>& units,
           const ExactLights& lights) {
    const auto& outline = triangle.outline;
    WindowPoint low = outline[0], high = outline[0];
    for (std::size_t i = 0; i < outline.size(); ++i) {
      add_edge(outline[i], outline[(i + 1) % outline.size()], 1.0);
      low = {std::min(low.x, outline[i].x), std::min(low.y, outline[i].y)};
      high = {std::max(high.x, outline[i].x), std::max(high.y, outline[i].y)};
    }
    low = {std::max(low.x, 0.0), std::max(low.y, 0.0)};
    high = {std::min(high.x, static_cast<double>(pair_.width)),
            std::min(high.y, static_cast<double>(pair_.height))};
    const double slope = triangle.depth_slope();
    around(low, high, 0.0, [&](int x, int y) {
      const glm::dvec3 weights = triangle.weights_over_w(x + 0.5, y + 0.5);
      if (!triangle.covers(weights)) return;
      const std::size_t at = index(x, y);
      PixelRule& rule = rules_[at];
      ++fragments_[at];
      rule.layers = std::max(rule.layers, gain_);
      rule.depth_slope = std::max(rule.depth_slope, static_cast<float>(slope));
      if (shows_texels_ && units.size() == 1 && is_nearest(surfaces_[at], triangle.depth(weights)))
        rule.color = in_steps(units[0].texel_at(triangle, x + 0.5, y + 0.5));
      if (draw.state.depth.test) surfaces_[at].push_back({triangle.depth(weights), slope});
      for (const ExactUnit& unit : units) {
        const SampleRule sample = unit.rule_at(triangle, x + 0.5, y + 0.5);
        if (sample.tie) mark(at, PixelClass::tie);
        rule.allowance = std::max(rule.allowance, static_cast<float>(sample.allowance));
      }
      if (lights.has_steps() && lights.near_step(triangle, x + 0.5, y + 0.5)) mark(at, PixelClass::tie);
    });
  }

  static bool is_nearest(const std::vector<Surface>& surfaces, double depth) {
    return std::all_of(surfaces.begin(), surfaces.end(),
                       [depth](const Surface& s) { return depth < s.depth; });
  }

  static std::optional<std::array<double, 4>> in_steps(std::optional<std::array<double, 4>> color) {
    if (color) {
      for (double& channel : *color) channel *= 255.0;
    }
    return color;
  }

  /// How much a rounding in a texture can grow until the end of the units.
  static int gain_of(const pipeline::State& state) {
    float gain = 1.0f;
    for (const raster::TextureUnit& unit : state.texture_units) {
      if (unit.texture == nullptr || unit.env_mode != raster::TextureEnvMode::combine) continue;
      gain *= std::max(unit.combine.rgb.scale, unit.combine.alpha.scale);
    }
    return static_cast<int>(gain);
  }

  bool has_depth_tie(const std::vector<Surface>& surfaces) const {
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const double to_clear = std::abs(surfaces[i].depth - static_cast<double>(pair_.clear.depth));
      if (to_clear < 1e-6 + 0.01 * surfaces[i].slope) return true;
      for (std::size_t j = 0; j < i; ++j) {
        const double apart = std::abs(surfaces[i].depth - surfaces[j].depth);
        const double slopes = surfaces[i].slope + surfaces[j].slope;
        // The same surface twice is no tie: both renderers must get the same depth both times.
        if (apart > 0.0 && apart < 5e-7 + 0.01 * std::min(slopes, 1.0)) return true;
      }
    }
    return false;
  }

  const ScenePair& pair_;
  std::vector<PixelRule> rules_;
  std::vector<std::vector<Surface>> surfaces_;
  std::vector<int> fragments_;
  bool blends_ = false;
  bool shows_texels_ = false;
  int gain_ = 1;
};

}  // namespace

std::vector<PixelRule> classify(const ScenePair& pair) { return Classifier(pair).run(); }

}  // namespace barrido::crosscheck
