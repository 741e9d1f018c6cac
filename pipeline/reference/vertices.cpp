#include "pipeline/reference/vertices.h"

#include <algorithm>
#include <cmath>

#include "pipeline/bounded.h"

namespace barrido::pipeline::reference {
namespace {

float dot(const glm::vec3& a, const glm::vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
/// A plane's or a matrix row's product with a position, in the order that is written here.
float dot(const glm::vec4& a, const glm::vec4& b) {
  return ((a.x * b.x + a.y * b.y) + a.z * b.z) + a.w * b.w;
}
glm::vec4 row(const glm::mat4& m, int r) { return {m[0][r], m[1][r], m[2][r], m[3][r]}; }
float clamp_to_bound(float v) { return std::min(std::max(v, -kBound), kBound); }
float inverse_length(const glm::vec3& v) { return 1.0f / std::sqrt(std::max(dot(v, v), 1e-30f)); }

std::uint32_t outcode(const glm::vec4& clip, const VertexTransform& transform) {
  const bool depth_clamp = transform.depth_clamp;
  const glm::vec2 reach = clip.w * transform.side_reach;
  std::uint32_t code = 0;
  if (clip.x < -reach.x) code |= kOutsideLeft;
  if (clip.x > reach.x) code |= kOutsideRight;
  if (clip.y < -reach.y) code |= kOutsideBottom;
  if (clip.y > reach.y) code |= kOutsideTop;
  if (!depth_clamp && clip.z < -clip.w) code |= kOutsideNear;
  if (!depth_clamp && clip.z > clip.w) code |= kOutsideFar;
  return code;
}

/// floor(v·256 + ½): 1/256 pixel.
std::uint32_t snapped(float window) {
  const float units = window * static_cast<float>(raster::kSubpixelUnits) + 0.5f;
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(units))) << kOutcodeBits;
}

/// r = u − 2 n (n·u), u the unit vector from the eye to the vertex.
glm::vec3 reflection(const TexgenVertex& v) {
  const glm::vec3 u = v.point * inverse_length(v.point);
  const float n_dot_u = dot(v.normal, u);
  const glm::vec3 r = u - v.normal * (n_dot_u + n_dot_u);
  return {clamp_to_bound(r.x), clamp_to_bound(r.y), clamp_to_bound(r.z)};
}

float generated(const TexGenCoordinate& rule, int axis, const TexgenVertex& v) {
  switch (rule.mode) {
    case TexGenMode::object_linear:
      return clamp_to_bound(dot(rule.object_plane, v.object));
    case TexGenMode::eye_linear:
      return clamp_to_bound(dot(rule.eye_plane, v.eye));
    case TexGenMode::reflection_map:
      return reflection(v)[axis];
    case TexGenMode::normal_map:
      return v.normal[axis];
    case TexGenMode::sphere_map:
      break;
  }
  // s = r_x/m + ½, t = r_y/m + ½, m = 2 √(r_x² + r_y² + (r_z + 1)²).
  glm::vec3 middle = reflection(v);
  middle.z = middle.z + 1.0f;
  return middle[axis] * (0.5f * inverse_length(middle)) + 0.5f;
}

struct Point {
  std::int64_t x, y;
};

/// Twice the area on the left of the edge from a to b; 0 or more is inside, 1 where the edge is not the
/// triangle's own.
bool is_inside(const Point& a, const Point& b, const Point& centre) {
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  const bool owns_edge = dy < 0 || (dy == 0 && dx > 0);
  return dx * (centre.y - a.y) - dy * (centre.x - a.x) >= (owns_edge ? 0 : 1);
}

/// The pixels whose centres lie between the least and the greatest coordinate.
struct Centres {
  std::int64_t first, end;
  Centres(std::int64_t a, std::int64_t b, std::int64_t c) {
    const auto first_from = [](std::int64_t v) {
      return (v + raster::kSubpixelUnits / 2 - 1) >> raster::kSubpixelBits;
    };
    first = first_from(std::min({a, b, c}));
    end = first_from(std::max({a, b, c}));
  }
};

bool covers_a_centre(const std::array<Point, 3>& p, const Centres& columns, const Centres& rows) {
  for (std::int64_t y = rows.first; y < rows.end; ++y) {
    for (std::int64_t x = columns.first; x < columns.end; ++x) {
      const Point centre{x * raster::kSubpixelUnits + raster::kSubpixelUnits / 2,
                         y * raster::kSubpixelUnits + raster::kSubpixelUnits / 2};
      if (is_inside(p[0], p[1], centre) && is_inside(p[1], p[2], centre) && is_inside(p[2], p[0], centre)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

ProjectedVertex project(const VertexTransform& t, const glm::vec4& object) {
  ProjectedVertex out;
  const auto is_bounded = [](float v) { return std::fabs(v) < kBound; };
  const bool finite =
      is_bounded(object.x) && is_bounded(object.y) && is_bounded(object.z) && is_bounded(object.w);
  if (finite) out.object = object;
  glm::vec4 clip{0, 0, 0, 1};
  for (int r = 0; r < (t.unit_w ? 3 : 4); ++r) clip[r] = dot(row(t.clip_from_object, r), out.object);
  const bool has_w = t.unit_w ? finite : clip.w >= kMinW;
  out.q = t.unit_w || !has_w ? 1.0f : 1.0f / clip.w;
  glm::vec3 window;
  for (int axis = 0; axis < 3; ++axis) {
    window[axis] = (clip[axis] * out.q) * t.window_scale[axis] + t.window_offset[axis];
  }
  const bool placed =
      has_w && std::fabs(window.x) <= kGuardLimitPixels && std::fabs(window.y) <= kGuardLimitPixels;
  out.depth = t.depth_clamp ? clamp_to_bound(window.z) : std::min(window.z > 0.0f ? window.z : 0.0f, 1.0f);
  out.position.x = (placed ? snapped(window.x) : 0) | outcode(clip, t);
  if (!placed) out.position.x |= kOffGuardBand;
  if (!finite) out.position.x |= kNotANumber;
  out.position.y = placed ? snapped(window.y) : 0;
  for (int plane = 0; plane < t.plane_count; ++plane) {
    if (dot(t.planes[plane], out.object) < 0.0f) out.position.y |= 1u << plane;
  }
  return out;
}

EyeVertex to_eye(const VertexTransform& t, const glm::vec4& object) {
  EyeVertex out;
  for (int axis = 0; axis < 3; ++axis) {
    out.eye[axis] = clamp_to_bound(dot(row(t.eye_from_object, axis), object));
  }
  out.eye.w = t.unit_eye_w ? 1.0f : clamp_to_bound(dot(row(t.eye_from_object, 3), object));
  const float inverse_w = 1.0f / (out.eye.w == 0.0f ? 1.0f : out.eye.w);
  for (int axis = 0; axis < 3; ++axis) {
    out.point[axis] = t.unit_eye_w ? out.eye[axis] : clamp_to_bound(out.eye[axis] * inverse_w);
  }
  return out;
}

glm::vec3 eye_normal(const VertexTransform& t, const glm::vec3& n) {
  const glm::mat3& m = t.eye_normal_from_object;
  glm::vec3 eye;
  for (int axis = 0; axis < 3; ++axis) {
    eye[axis] = clamp_to_bound((m[0][axis] * n.x + m[1][axis] * n.y) + m[2][axis] * n.z);
  }
  return t.normalize ? eye * inverse_length(eye) : eye;
}

EyeTangents eye_tangents(const VertexTransform& t, const TangentVertex& v, bool has_bitangent, bool to_unit) {
  const auto bounded3 = [](const glm::vec3& a) {
    return glm::vec3(clamp_to_bound(a.x), clamp_to_bound(a.y), clamp_to_bound(a.z));
  };
  const auto eye_of = [&](const glm::vec3& a) {
    const glm::mat4& m = t.eye_from_object;
    glm::vec3 eye;
    for (int axis = 0; axis < 3; ++axis) {
      eye[axis] = (m[0][axis] * a.x + m[1][axis] * a.y) + m[2][axis] * a.z;
    }
    eye = bounded3(eye);
    return to_unit ? eye * inverse_length(eye) : eye;
  };
  const glm::vec3 tangent(v.tangent), &n = v.normal;
  glm::vec3 bitangent = v.bitangent;
  if (!has_bitangent) {
    const glm::vec3 product(n.y * tangent.z - n.z * tangent.y, n.z * tangent.x - n.x * tangent.z,
                            n.x * tangent.y - n.y * tangent.x);
    bitangent = bounded3(product * v.tangent.w);
  }
  return {eye_of(tangent), eye_of(bitangent)};
}

glm::vec4 generate_coordinates(const TextureCoordinates& rules, const TexgenVertex& vertex,
                               glm::vec4 coordinate) {
  for (int axis = 0; axis < 4; ++axis) {
    const TexGenCoordinate& rule = rules.generation[static_cast<std::size_t>(axis)];
    if (rule.enabled) coordinate[axis] = generated(rule, axis, vertex);
  }
  if (rules.matrix == glm::mat4(1.0f)) return coordinate;
  glm::vec4 product;
  for (int r = 0; r < 4; ++r) product[r] = dot(row(rules.matrix, r), coordinate);
  return product;
}

TriangleClass classify(const std::array<PackedPosition, 3>& corners, const CullRule& rule) {
  std::uint32_t any_x = 0, any_y = 0, all_x = ~0u, all_y = ~0u;
  std::array<Point, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    any_x |= corners[k].x;
    any_y |= corners[k].y;
    all_x &= corners[k].x;
    all_y &= corners[k].y;
    p[k] = {window_coordinate(corners[k].x), window_coordinate(corners[k].y)};
  }
  TriangleClass out;
  if ((all_x & kOutsideVolume) != 0 || (all_y & kOutcodeMask) != 0 || (any_x & kNotANumber) != 0) return out;
  out.clipped = (any_x & kNeedsClipping) != 0 || (any_y & kOutcodeMask) != 0;
  if (out.clipped) return out;
  const std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  const bool is_front = (area > 0) == rule.front_is_counter_clockwise;
  if (area == 0 || !(is_front ? rule.keep_front : rule.keep_back)) return out;
  const Centres columns(p[0].x, p[1].x, p[2].x), rows(p[0].y, p[1].y, p[2].y);
  if (columns.end <= columns.first || rows.end <= rows.first) return out;
  if (area < 0) std::swap(p[1], p[2]);
  const bool has_few = columns.end - columns.first < 3 && rows.end - rows.first < 3;
  out.visible = !has_few || covers_a_centre(p, columns, rows);
  out.back = out.visible && !is_front;
  return out;
}

}  // namespace barrido::pipeline::reference
