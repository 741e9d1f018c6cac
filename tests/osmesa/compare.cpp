#include "tests/osmesa/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace barrido::crosscheck {
namespace {

std::string text_of(const std::array<std::uint8_t, 4>& c) {
  return std::to_string(c[0]) + "," + std::to_string(c[1]) + "," + std::to_string(c[2]) + "," +
         std::to_string(c[3]);
}

std::string limit(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.find('.') + 2);
}

/// Whether a pixel is within what is allowed of a more exact colour than the 8-bit reference: the same in 16
/// bits, or in double precision.
bool passes_second_look(const std::array<std::uint8_t, 4>& color, const std::array<std::uint16_t, 4>& deep,
                        const PixelRule& rule, double allowed) {
  double from_deep = 0.0, from_exact = rule.color ? 0.0 : 256.0;
  for (std::size_t c = 0; c < 4; ++c) {
    from_deep = std::max(from_deep, std::abs(color[c] - deep[c] / 257.0));
    if (rule.color) from_exact = std::max(from_exact, std::abs(color[c] - (*rule.color)[c]));
  }
  return std::min(from_deep, from_exact) <= allowed;
}

}  // namespace

std::uint64_t excessive_pixels(const Figures& figures) {
  std::uint64_t sum = 0;
  for (const ClassFigures& f : figures.by_class) sum += f.excessive;
  return sum;
}

double per_million(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : 1e6 * static_cast<double>(part) / static_cast<double>(whole);
}

ClassFigures& ClassFigures::operator+=(const ClassFigures& other) {
  pixels += other.pixels;
  different += other.different;
  excessive += other.excessive;
  worst = std::max(worst, other.worst);
  for (std::size_t i = 0; i < histogram.size(); ++i) histogram[i] += other.histogram[i];
  return *this;
}

Figures& Figures::operator+=(const Figures& other) {
  pairs += other.pairs;
  pixels += other.pixels;
  for (std::size_t i = 0; i < kPixelClasses; ++i) by_class[i] += other.by_class[i];
  worst_depth = std::max(worst_depth, other.worst_depth);
  second_looks += other.second_looks;
  if (first_excess.empty()) first_excess = other.first_excess;
  return *this;
}

Figures compare(const Picture& barrido, const Picture& reference, const std::vector<PixelRule>& rules,
                const Gate& gate, const DeepPicture* deep) {
  Figures figures;
  figures.pairs = 1;
  figures.pixels = rules.size();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const PixelRule& rule = rules[i];
    ClassFigures& into = figures.by_class[static_cast<std::size_t>(rule.kind)];
    int worst = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      worst = std::max(
          worst, std::abs(static_cast<int>(barrido.color[i][c]) - static_cast<int>(reference.color[i][c])));
    }
    ++into.pixels;
    ++into.histogram[static_cast<std::size_t>(worst)];
    into.worst = std::max(into.worst, worst);
    into.different += worst > 0;
    const float allowed = static_cast<float>(gate.interior * rule.layers) + rule.allowance;
    bool excessive = worst > allowed;
    const bool interior = rule.kind == PixelClass::interior;
    // At edges roundings only: what covers a pixel is no matter of precision.
    const bool may_round = interior || static_cast<float>(worst) <= 2.0f * allowed + 1.0f;
    if (excessive && may_round && deep != nullptr &&
        passes_second_look(barrido.color[i], deep->color[i], rule, static_cast<double>(allowed))) {
      excessive = false;
      ++figures.second_looks;
    }
    into.excessive += excessive;
    if (!interior) continue;
    const double depth =
        std::abs(static_cast<double>(barrido.depth[i]) - static_cast<double>(reference.depth[i]));
    // Slopes are those of the steepest surface; positions are snapped to 1/256 pixel by both.
    figures.worst_depth = std::max(figures.worst_depth, depth - static_cast<double>(rule.depth_slope) * 0.01);
    if (excessive && figures.first_excess.empty()) {
      const auto width = static_cast<std::size_t>(barrido.width);
      figures.first_excess = "column " + std::to_string(i % width) + " row " + std::to_string(i / width) +
                             ": " + text_of(barrido.color[i]) + ", OpenGL has " + text_of(reference.color[i]);
    }
  }
  return figures;
}

std::string interior_failure(const Figures& figures, const Gate& gate) {
  if (!gate.held) return {};
  const ClassFigures& interior = figures.of(PixelClass::interior);
  if (interior.excessive > 0) {
    return std::to_string(interior.excessive) + " interior pixels differ by up to " +
           std::to_string(interior.worst) + "/255; " + figures.first_excess;
  }
  if (figures.worst_depth > gate.depth)
    return "depth differs by " + std::to_string(figures.worst_depth * 1e6) + "e-6";
  return {};
}

std::string feature_failure(const Figures& figures, const Gate& gate) {
  if (!gate.held) return {};
  const auto over = [&](std::uint64_t count, double ppm) {
    // A single pixel of a short run may be more than the parts per million allow.
    return count > 2 && per_million(count, figures.pixels) > ppm;
  };
  const ClassFigures& interior = figures.of(PixelClass::interior);
  const ClassFigures& edge = figures.of(PixelClass::edge);
  const ClassFigures& tie = figures.of(PixelClass::tie);
  if (over(interior.different, gate.interior_ppm)) {
    return limit(per_million(interior.different, figures.pixels)) + " ppm of interior pixels differ";
  }
  if (over(edge.excessive, gate.edge_ppm) || (gate.edge_ppm == 0 && edge.excessive > 0)) {
    return limit(per_million(edge.excessive, figures.pixels)) + " ppm of the pixels differ at edges";
  }
  if (over(tie.excessive, gate.tie_ppm)) {
    return limit(per_million(tie.excessive, figures.pixels)) + " ppm of the pixels differ at ties";
  }
  return {};
}

}  // namespace barrido::crosscheck
