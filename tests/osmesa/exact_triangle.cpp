#include "tests/osmesa/exact_triangle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace barrido::crosscheck {
namespace {

using pipeline::PrimitiveMode;
using Elements = std::vector<std::size_t>;

struct Window {
  double scale_x, scale_y, offset_x, offset_y;
};

Window window_of(const pipeline::Viewport& v, int frame_width, int frame_height) {
  const double half_width = 0.5 * (v.width == 0 ? frame_width : v.width);
  const double half_height = 0.5 * (v.height == 0 ? frame_height : v.height);
  return {half_width, half_height, v.x + half_width, v.y + half_height};
}

/// Polygons of the mesh as lists of elements in the order that decides their facing (OpenGL 1.3,
/// section 2.6.1).
std::vector<Elements> polygons_of(const Mesh& mesh) {
  const std::size_t n = mesh.element_count();
  std::vector<Elements> list;
  switch (mesh.mode) {
    case PrimitiveMode::triangles:
      for (std::size_t i = 0; i + 3 <= n; i += 3) list.push_back({i, i + 1, i + 2});
      break;
    case PrimitiveMode::triangle_strip:
      for (std::size_t i = 0; i + 3 <= n; ++i)
        list.push_back(i % 2 == 0 ? Elements{i, i + 1, i + 2} : Elements{i + 1, i, i + 2});
      break;
    case PrimitiveMode::triangle_fan:
      for (std::size_t i = 1; i + 2 <= n; ++i) list.push_back({0, i, i + 1});
      break;
    case PrimitiveMode::quads:
      for (std::size_t i = 0; i + 4 <= n; i += 4) list.push_back({i, i + 1, i + 2, i + 3});
      break;
    case PrimitiveMode::quad_strip:
      for (std::size_t i = 0; i + 4 <= n; i += 2) list.push_back({i, i + 1, i + 3, i + 2});
      break;
    case PrimitiveMode::polygon:
      if (n >= 3) {
        list.emplace_back(n);
        for (std::size_t i = 0; i < n; ++i) list.back()[i] = i;
      }
      break;
    default:
      break;
  }
  return list;
}

struct Corner {
  glm::dvec4 clip;
  std::vector<double> plane_distance;
};

Corner corner_of(const DrawCall& draw, std::size_t vertex) {
  const pipeline::State& state = draw.state;
  const glm::vec4& given = draw.mesh.position[vertex];
  const glm::dvec4 object(glm::dvec3(given), draw.mesh.position_components == 4 ? given.w : 1.0);
  const glm::dvec4 eye = glm::dmat4(state.eye_from_object) * object;
  Corner corner{glm::dmat4(state.clip_from_eye) * eye, {}};
  for (const glm::vec4& plane : state.clip_planes)
    corner.plane_distance.push_back(glm::dot(glm::dvec4(plane), eye));
  return corner;
}

Corner mix(const Corner& a, const Corner& b, double t) {
  Corner c{a.clip + t * (b.clip - a.clip), a.plane_distance};
  for (std::size_t i = 0; i < c.plane_distance.size(); ++i) {
    c.plane_distance[i] += t * (b.plane_distance[i] - a.plane_distance[i]);
  }
  return c;
}

/// Distance to clip plane `plane`: in front of the eye, near, far, then the user's.
double distance(const Corner& c, std::size_t plane, bool depth_clamp) {
  if (plane == 0) return c.clip.w - 1e-7;
  if (plane < 3) return depth_clamp ? 1.0 : c.clip.w + (plane == 1 ? c.clip.z : -c.clip.z);
  return c.plane_distance[plane - 3];
}

/// Cuts a closed polygon, or an open line of two corners.
void clip(std::vector<Corner>& corners, bool closed, bool depth_clamp) {
  const std::size_t planes = 3 + (corners.empty() ? 0 : corners[0].plane_distance.size());
  for (std::size_t plane = 0; plane < planes; ++plane) {
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner& a = corners[i];
      const Corner& b = corners[(i + 1) % corners.size()];
      const double da = distance(a, plane, depth_clamp);
      const double db = distance(b, plane, depth_clamp);
      if (da >= 0.0) kept.push_back(a);
      if ((closed || i + 1 < corners.size()) && (da >= 0.0) != (db >= 0.0))
        kept.push_back(mix(a, b, da / (da - db)));
    }
    corners = std::move(kept);
  }
}

WindowPoint project(const Corner& c, const Window& window) {
  return {c.clip.x / c.clip.w * window.scale_x + window.offset_x,
          c.clip.y / c.clip.w * window.scale_y + window.offset_y};
}

bool place(ExactTriangle& t, const DrawCall& draw, const Window& window) {
  glm::dmat3 m;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec4& c = t.clip[static_cast<std::size_t>(i)];
    m[i] = {window.scale_x * c.x + window.offset_x * c.w, window.scale_y * c.y + window.offset_y * c.w, c.w};
  }
  const double determinant = glm::determinant(m);
  if (determinant == 0.0) return false;
  t.back = (determinant > 0.0) != (draw.state.front_face == pipeline::FrontFace::counter_clockwise);
  const glm::dmat3 rows = glm::transpose(glm::inverse(m));
  t.over_w = {rows[0], rows[1], rows[2]};
  using pipeline::CullFace;
  const CullFace cull = draw.state.cull_face;
  return cull != CullFace::front_and_back && cull != (t.back ? CullFace::back : CullFace::front);
}

ExactTriangle triangle_of(const DrawCall& draw, const Elements& polygon, std::size_t first) {
  ExactTriangle t;
  const std::array<std::size_t, 3> elements{polygon[0], polygon[first], polygon[first + 1]};
  for (std::size_t k = 0; k < 3; ++k) {
    t.vertex[k] = draw.mesh.vertex(elements[k]);
    const Corner corner = corner_of(draw, t.vertex[k]);
    t.clip[k] = corner.clip;
    t.plane_distance[k] = corner.plane_distance;
  }
  const pipeline::Viewport& v = draw.state.viewport;
  t.depth_scale = 0.5 * (static_cast<double>(v.depth_far) - v.depth_near);
  t.depth_bias = 0.5 * (static_cast<double>(v.depth_far) + v.depth_near);
  t.depth_clamp = draw.state.depth_clamp;
  return t;
}

}  // namespace

glm::dvec3 ExactTriangle::weights_over_w(double x, double y) const {
  const glm::dvec3 p{x, y, 1.0};
  return {glm::dot(over_w[0], p), glm::dot(over_w[1], p), glm::dot(over_w[2], p)};
}

double ExactTriangle::depth(const glm::dvec3& w) const {
  return (w[0] * clip[0].z + w[1] * clip[1].z + w[2] * clip[2].z) * depth_scale + depth_bias;
}

double ExactTriangle::depth_slope() const {
  glm::dvec3 slope(0.0);
  for (std::size_t i = 0; i < 3; ++i) slope += over_w[i] * clip[i].z;
  return std::max(std::abs(slope.x), std::abs(slope.y)) * std::abs(depth_scale);
}

bool ExactTriangle::covers(const glm::dvec3& w) const {
  if (w[0] < 0.0 || w[1] < 0.0 || w[2] < 0.0 || w[0] + w[1] + w[2] <= 0.0) return false;
  const double z = w[0] * clip[0].z + w[1] * clip[1].z + w[2] * clip[2].z;
  if (!depth_clamp && std::abs(z) > 1.0) return false;
  for (std::size_t p = 0; p < plane_distance[0].size(); ++p) {
    if (w[0] * plane_distance[0][p] + w[1] * plane_distance[1][p] + w[2] * plane_distance[2][p] < 0.0)
      return false;
  }
  return true;
}

std::vector<ExactTriangle> exact_triangles(const DrawCall& draw, int frame_width, int frame_height) {
  std::vector<ExactTriangle> list;
  if (draw.state.polygon_mode != pipeline::PolygonMode::fill) return list;
  const Window window = window_of(draw.state.viewport, frame_width, frame_height);
  for (const Elements& polygon : polygons_of(draw.mesh)) {
    for (std::size_t first = 1; first + 1 < polygon.size(); ++first) {
      ExactTriangle t = triangle_of(draw, polygon, first);
      if (!place(t, draw, window)) continue;
      const raster::PolygonOffset& offset = draw.state.polygon_offset;
      if (offset.enabled) t.depth_bias += t.depth_slope() * offset.factor + offset.units * 0x1p-24;
      std::vector<Corner> corners;
      for (std::size_t k = 0; k < 3; ++k) corners.push_back({t.clip[k], t.plane_distance[k]});
      clip(corners, true, t.depth_clamp);
      for (const Corner& c : corners) t.outline.push_back(project(c, window));
      if (!t.outline.empty()) list.push_back(std::move(t));
    }
  }
  return list;
}

std::vector<std::array<WindowPoint, 2>> exact_strokes(const DrawCall& draw, int frame_width,
                                                      int frame_height) {
  const Mesh& mesh = draw.mesh;
  const Window window = window_of(draw.state.viewport, frame_width, frame_height);
  std::vector<std::array<std::size_t, 2>> pairs;
  const std::size_t n = mesh.element_count();
  const bool as_points =
      mesh.mode == PrimitiveMode::points || draw.state.polygon_mode == pipeline::PolygonMode::point;
  if (mesh.mode == PrimitiveMode::points) {
    for (std::size_t i = 0; i < n; ++i) pairs.push_back({i, i});
  } else if (mesh.mode < PrimitiveMode::triangles) {
    const std::size_t step = mesh.mode == PrimitiveMode::lines ? 2 : 1;
    for (std::size_t i = 0; i + 1 < n; i += step) pairs.push_back({i, i + 1});
    if (mesh.mode == PrimitiveMode::line_loop && n > 1) pairs.push_back({n - 1, 0});
  }
  std::vector<std::array<WindowPoint, 2>> strokes;
  const auto add = [&](std::vector<Corner> corners, bool closed) {
    clip(corners, closed, draw.state.depth_clamp);
    for (std::size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
      const std::size_t next = as_points && closed ? i : (i + 1) % corners.size();
      strokes.push_back({project(corners[i], window), project(corners[next], window)});
    }
  };
  for (const auto& [a, b] : pairs)
    add({corner_of(draw, mesh.vertex(a)), corner_of(draw, mesh.vertex(b))}, false);
  if (draw.state.polygon_mode == pipeline::PolygonMode::fill) return strokes;
  for (const Elements& polygon : polygons_of(mesh)) {
    std::vector<Corner> corners;
    for (const std::size_t element : polygon) corners.push_back(corner_of(draw, mesh.vertex(element)));
    add(std::move(corners), true);  // what clipping makes are corners and edges too (section 2.11)
  }
  return strokes;
}

double distance_to_segment(const WindowPoint& p, const WindowPoint& a, const WindowPoint& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  const double ex = a.x + t * dx - p.x;
  const double ey = a.y + t * dy - p.y;
  return std::sqrt(ex * ex + ey * ey);
}

bool cut_to_frame(WindowPoint& a, WindowPoint& b, int width, int height, double margin) {
  const WindowPoint from = a;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  double begin = 0.0, end = 1.0;
  const auto cut = [&](double start, double slope, double low, double high) {
    if (slope == 0.0) return start >= low && start <= high;
    const double t0 = (low - start) / slope;
    const double t1 = (high - start) / slope;
    begin = std::max(begin, std::min(t0, t1));
    end = std::min(end, std::max(t0, t1));
    return begin <= end;
  };
  if (!cut(from.x, dx, -margin, width + margin) || !cut(from.y, dy, -margin, height + margin)) return false;
  a = {from.x + begin * dx, from.y + begin * dy};
  b = {from.x + end * dx, from.y + end * dy};
  return true;
}

}  // namespace barrido::crosscheck
