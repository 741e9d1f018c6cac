#include "tests/osmesa/exact_texture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace barrido::crosscheck {
namespace {

using pipeline::TexGenMode;
using raster::MagFilter;
using raster::MinFilter;

/// OpenGL 1.3, section 2.10.4.
double generated(const pipeline::TexGenCoordinate& rule, int axis, const glm::dvec4& object,
                 const glm::dvec4& eye, const glm::dvec3& n) {
  if (rule.mode == TexGenMode::object_linear) return glm::dot(glm::dvec4(rule.object_plane), object);
  if (rule.mode == TexGenMode::eye_linear) return glm::dot(glm::dvec4(rule.eye_plane), eye);
  if (rule.mode == TexGenMode::normal_map) return n[axis];
  const glm::dvec3 u = glm::normalize(glm::dvec3(eye) / eye.w);
  const glm::dvec3 r = u - 2.0 * glm::dot(n, u) * n;
  if (rule.mode == TexGenMode::reflection_map) return r[axis];
  return r[axis] / (2.0 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1))) + 0.5;
}

glm::dvec4 coordinate(const DrawCall& draw, std::size_t unit, std::size_t vertex) {
  const Mesh& mesh = draw.mesh;
  const pipeline::TextureCoordinates& rules = draw.state.texture_coordinates[unit];
  const glm::dmat4 model_view(draw.state.eye_from_object);
  const glm::dvec4 object(glm::dvec3(mesh.position[vertex]),
                          mesh.position_components == 4 ? mesh.position[vertex].w : 1);
  glm::dvec3 n = glm::transpose(glm::inverse(glm::dmat3(model_view))) *
                 (mesh.normal.empty() ? glm::dvec3(0, 0, 1) : glm::dvec3(mesh.normal[vertex]));
  if (draw.state.normalize) n = glm::normalize(n);
  glm::dvec4 c{0, 0, 0, 1};
  if (!mesh.texcoord[unit].empty()) {
    for (int i = 0; i < mesh.texcoord_components[unit]; ++i) c[i] = mesh.texcoord[unit][vertex][i];
  }
  for (int axis = 0; axis < 4; ++axis) {
    const pipeline::TexGenCoordinate& rule = rules.generation[static_cast<std::size_t>(axis)];
    if (rule.enabled) c[axis] = generated(rule, axis, object, model_view * object, n);
  }
  return glm::dmat4(rules.matrix) * c;
}

/// Vertices move by half of 1/256 pixel at most, in both axes.
constexpr double kSnapping = 1.0 / 400.0;

double wrapped(double x, raster::Wrap wrap) {
  if (wrap == raster::Wrap::repeat) return x - std::floor(x);
  if (wrap == raster::Wrap::mirrored_repeat) {
    const double m = x - 2.0 * std::floor(0.5 * x);
    return m > 1.0 ? 2.0 - m : m;
  }
  return wrap == raster::Wrap::clamp_to_border ? std::clamp(x, -1.0, 2.0) : std::clamp(x, 0.0, 1.0);
}

}  // namespace

ExactUnit::ExactUnit(const DrawCall& draw, std::size_t unit)
    : unit_(draw.state.texture_units[unit]), texture_(*unit_.texture) {
  for (std::size_t v = 0; v < draw.mesh.position.size(); ++v)
    coordinates_.push_back(coordinate(draw, unit, v));
}

double ExactUnit::lod_of(double ux, double vx, double uy, double vy) const {
  ux *= texture_.width();
  uy *= texture_.width();
  vx *= texture_.height();
  vy *= texture_.height();
  const double square = std::max(ux * ux + vx * vx, uy * uy + vy * vy);
  return 0.5 * std::log2(std::max(square, 1e-30)) + unit_.lod_bias;
}

/// OpenGL 1.3, table 3.19.
ExactUnit::Place ExactUnit::cube_place(const glm::dvec4& at, const glm::dvec4& dx,
                                       const glm::dvec4& dy) const {
  int major = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(at[axis]) > std::abs(at[major])) major = axis;
  }
  const double size = std::abs(at[major]);
  const double sign = at[major] < 0.0 ? -1.0 : 1.0;
  const auto s_of = [&](const glm::dvec4& r) {
    return major == 0 ? -sign * r.z : major == 1 ? r.x : sign * r.x;
  };
  const auto t_of = [&](const glm::dvec4& r) { return major == 1 ? sign * r.z : -r.y; };
  Place p;
  p.face = 2 * major + (sign < 0.0 ? 1 : 0);
  const double s = s_of(at) / size;
  const double t = t_of(at) / size;
  p.u = 0.5 * (s + 1.0);
  p.v = 0.5 * (t + 1.0);
  const auto slope = [&](double numerator, const glm::dvec4& d, double quotient) {
    return 0.5 * (numerator - quotient * sign * d[major]) / size;
  };
  p.lod =
      lod_of(slope(s_of(dx), dx, s), slope(t_of(dx), dx, t), slope(s_of(dy), dy, s), slope(t_of(dy), dy, t));
  // s and t are two units for a whole face.
  const double moved = 2.0 * kSnapping * std::exp2(p.lod - unit_.lod_bias) / texture_.width();
  p.face_tie = std::max(std::abs(s), std::abs(t)) > 1.0 - 1e-4 - moved;
  return p;
}

ExactUnit::Place ExactUnit::place_at(const ExactTriangle& triangle, double x, double y) const {
  const glm::dvec3 w = triangle.weights_over_w(x, y);
  glm::dvec4 at(0.0), dx(0.0), dy(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec4& c = coordinates_[triangle.vertex[i]];
    at += w[static_cast<int>(i)] * c;
    dx += triangle.over_w[i].x * c;
    dy += triangle.over_w[i].y * c;
  }
  if (texture_.is_cube()) return cube_place(at, dx, dy);
  Place p;
  p.u = at.x / at.w;
  p.v = at.y / at.w;
  p.lod = lod_of((dx.x - p.u * dx.w) / at.w, (dx.y - p.v * dx.w) / at.w, (dy.x - p.u * dy.w) / at.w,
                 (dy.y - p.v * dy.w) / at.w);
  return p;
}

bool ExactUnit::near_texel_edge(const Place& place, int level) const {
  const raster::MipLevel& size = texture_.level(level);
  const double texels_per_pixel = std::exp2(place.lod - unit_.lod_bias) * size.width / texture_.width();
  const double near = 0.01 + texels_per_pixel * kSnapping;
  const double x = place.u * size.width;
  const double y = place.v * size.height;
  return std::abs(x - std::floor(x + 0.5)) < near || std::abs(y - std::floor(y + 0.5)) < near;
}

std::array<double, 4> ExactUnit::bilinear(const Place& place, int level) const {
  const raster::MipLevel& size = texture_.level(level, place.face);
  const double x = wrapped(place.u, texture_.options().wrap_s) * size.width - 0.5;
  const double y = wrapped(place.v, texture_.options().wrap_t) * size.height - 0.5;
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const auto within = [](int at, int side) { return std::clamp(at, -1, side); };
  std::array<double, 4> sum{};
  for (int corner = 0; corner < 4; ++corner) {
    const int right = corner & 1;
    const int up = corner >> 1;
    const double weight = (right != 0 ? x - i : 1 - x + i) * (up != 0 ? y - j : 1 - y + j);
    const auto texel =
        texture_.texel(level, place.face, within(i + right, size.width), within(j + up, size.height));
    for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * static_cast<double>(texel[c]);
  }
  return sum;
}

double ExactUnit::level_difference(const Place& place, int level) const {
  const int last = texture_.level_count() - 1;
  const int from = std::clamp(level, 0, last);
  const int to = std::clamp(level + 1, 0, last);
  double largest = 0.0;
  if (unit_.min_filter == MinFilter::nearest_mipmap_linear) {  // the texels that hold the place
    const auto texel = [&](int l) {
      const raster::MipLevel& size = texture_.level(l, place.face);
      const auto at = [](double c, int n) {
        return std::clamp(static_cast<int>(std::floor(c * n)), 0, n - 1);
      };
      return texture_.texel(l, place.face, at(wrapped(place.u, texture_.options().wrap_s), size.width),
                            at(wrapped(place.v, texture_.options().wrap_t), size.height));
    };
    const auto a = texel(from);
    const auto b = texel(to);
    for (std::size_t c = 0; c < 4; ++c)
      largest = std::max(largest, std::abs(static_cast<double>(a[c]) - b[c]));
    return largest;
  }
  const auto a = bilinear(place, from);
  const auto b = bilinear(place, to);
  for (std::size_t c = 0; c < 4; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
  return largest;
}

double ExactUnit::snapping_difference(const ExactTriangle& triangle, double x, double y, const Place& place,
                                      int level) const {
  const auto middle = bilinear(place, level);
  double largest = 0.0;
  for (const double dx : {-kSnapping, kSnapping}) {
    for (const double dy : {-kSnapping, kSnapping}) {
      const Place moved = place_at(triangle, x + dx, y + dy);
      if (moved.face != place.face) continue;
      const auto sample = bilinear(moved, level);
      for (std::size_t c = 0; c < 4; ++c) largest = std::max(largest, std::abs(sample[c] - middle[c]));
    }
  }
  return largest;
}

std::optional<std::array<double, 4>> ExactUnit::texel_at(const ExactTriangle& triangle, double x,
                                                         double y) const {
  const bool trilinear = unit_.min_filter == MinFilter::linear_mipmap_linear;
  if (unit_.mag_filter == MagFilter::nearest || !(trilinear || unit_.min_filter == MinFilter::linear))
    return std::nullopt;
  const Place p = place_at(triangle, x, y);
  if (p.face_tie) return std::nullopt;
  const int last = texture_.level_count() - 1;
  const double lod = trilinear ? std::clamp(p.lod, 0.0, static_cast<double>(last)) : 0.0;
  const int level = static_cast<int>(lod);
  std::array<double, 4> texel = bilinear(p, level);
  const std::array<double, 4> next = bilinear(p, std::min(level + 1, last));
  for (std::size_t c = 0; c < 4; ++c) texel[c] += (lod - level) * (next[c] - texel[c]);
  return texel;
}

SampleRule ExactUnit::rule_at(const ExactTriangle& triangle, double x, double y) const {
  const Place p = place_at(triangle, x, y);
  const MinFilter min = unit_.min_filter;
  const bool mipmapped = min >= MinFilter::nearest_mipmap_nearest;
  const bool between = min >= MinFilter::nearest_mipmap_linear;
  const bool min_nearest = min == MinFilter::nearest || min == MinFilter::nearest_mipmap_nearest ||
                           min == MinFilter::nearest_mipmap_linear;
  const bool mag_nearest = unit_.mag_filter == MagFilter::nearest;
  SampleRule rule;
  rule.tie = p.face_tie;
  if (!mipmapped && min_nearest == mag_nearest) {
    rule.tie |= min_nearest && near_texel_edge(p, 0);
    if (!min_nearest) rule.allowance = 255.0 * snapping_difference(triangle, x, y, p, 0);
    return rule;
  }
  // The level is chosen for small groups of pixels: two by two by some, four in a row by others.
  double slack = kLodSlack;
  for (const double dx : {-1.5, 0.0, 1.5}) {
    for (const double dy : {-1.0, 0.0, 1.0}) {
      const Place q = place_at(triangle, x + dx, y + dy);
      rule.tie |= q.face != p.face;
      slack = std::max(slack, kLodSlack + std::abs(q.lod - p.lod));
    }
  }
  const bool half =
      !mag_nearest && (min == MinFilter::nearest_mipmap_nearest || min == MinFilter::nearest_mipmap_linear);
  const double threshold = half ? 0.5 : 0.0;
  const bool may_magnify = p.lod - slack <= threshold;
  const bool may_minify = p.lod + slack > threshold;
  if (may_magnify && may_minify && (min_nearest != mag_nearest || half)) rule.tie = true;
  if (may_magnify && mag_nearest) rule.tie |= near_texel_edge(p, 0);
  if (may_magnify && !mag_nearest) rule.allowance = 255.0 * snapping_difference(triangle, x, y, p, 0);
  if (!may_minify) return rule;
  const int last = texture_.level_count() - 1;
  const auto clamped = [last](double level) {
    return std::clamp(static_cast<int>(std::floor(level)), 0, last);
  };
  const int low = mipmapped ? clamped(p.lod - slack + (between ? 0.0 : 0.5)) : 0;
  const int high = mipmapped ? clamped(p.lod + slack + (between ? 1.0 : 0.5)) : 0;
  if (mipmapped && !between) rule.tie |= low != high;
  for (int level = low; min_nearest && level <= high; ++level) rule.tie |= near_texel_edge(p, level);
  double moved = 0.0;
  for (int level = low; !min_nearest && level <= high; ++level) {
    moved = std::max(moved, snapping_difference(triangle, x, y, p, level));
  }
  double apart = 0.0;
  for (int level = low; between && level < high; ++level) apart = std::max(apart, level_difference(p, level));
  rule.allowance = std::max(rule.allowance, 255.0 * (moved + slack * apart));
  return rule;
}

}  // namespace barrido::crosscheck
