#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "pipeline/assembly_input.h"
#include "pipeline/frame_memory.h"
#include "pipeline/inspect/corner_vertex.h"
#include "pipeline/inspect/fragment_story.h"
#include "pipeline/vertex_stage.h"

namespace barrido::inspect {
namespace {

using pipeline::AssembledDraw;
using pipeline::reference::SurfacePoint;

glm::vec4 clip_position(const AssembledDraw& draw, const glm::vec3& object) {
  return draw.plan->transform.clip_from_object * glm::vec4(object, 1.0f);
}

CornerStory tell_corner(const AssembledDraw& draw, std::uint32_t vertex, bool back) {
  const VertexAgain again(draw, vertex);
  CornerStory corner;
  corner.vertex = vertex;
  corner.object = again.object();
  const glm::vec4 eye = draw.plan->transform.eye_from_object * glm::vec4(corner.object, 1.0f);
  corner.eye = eye.w != 0.0f ? glm::vec3(eye) / eye.w : glm::vec3(eye);
  corner.normal = again.normal();
  corner.w = clip_position(draw, corner.object).w;
  corner.depth = again.record(back)[raster::kRecordDepth];
  const pipeline::PackedPosition& window = again.window();
  if ((pipeline::outcode(window) & (pipeline::kOffGuardBand | pipeline::kNotANumber)) == 0) {
    constexpr float kUnit = 1.0f / raster::kSubpixelUnits;
    corner.window_x = static_cast<float>(pipeline::window_coordinate(window.x)) * kUnit;
    corner.window_y = static_cast<float>(pipeline::window_coordinate(window.y)) * kUnit;
  }
  if (const raster::FlatColors* lit = again.lit(back)) {
    corner.lit = Color{lit->color[0], lit->color[1], lit->color[2], lit->color[3]};
    if (draw.plan->fragment.separate_specular) {
      corner.lit_secondary = Rgb{lit->specular[0], lit->specular[1], lit->specular[2]};
    }
  }
  return corner;
}

/// Perspective-correct weights of the pixel's centre, also where the triangle reaches behind the eye: the
/// combination of the corners' (x, y, w) in the direction of the centre (Olano and Greer 1997).
void weigh_corners(const FragmentContext& context, const AssembledDraw& draw,
                   std::vector<CornerStory>& corners) {
  const pipeline::VertexTransform& t = draw.plan->transform;
  const glm::dvec3 center((context.x + 0.5 - t.window_offset.x) / t.window_scale.x,
                          (context.y + 0.5 - t.window_offset.y) / t.window_scale.y, 1.0);
  glm::dmat3 edges(0.0);
  for (int k = 0; k < 3; ++k) {
    const glm::vec4 clip = clip_position(draw, corners[static_cast<std::size_t>(k)].object);
    edges[k] = glm::dvec3(clip.x, clip.y, clip.w);
  }
  if (glm::determinant(edges) == 0.0) return;
  const glm::dvec3 weight = glm::inverse(edges) * center;
  const double sum = weight.x + weight.y + weight.z;
  for (int k = 0; k < 3; ++k) corners[static_cast<std::size_t>(k)].weight = weight[k] / sum;
}

/// Weights linear on the screen: areas of the triangles that the centre makes with the edges.
void weigh_on_screen(const FragmentContext& context, const raster::PrimitiveRecord& p,
                     std::vector<CornerStory>& corners) {
  const auto area = [&](double ax, double ay, double bx, double by) {
    const double cx = (context.x + 0.5) * raster::kSubpixelUnits;
    const double cy = (context.y + 0.5) * raster::kSubpixelUnits;
    return (ax - cx) * (by - cy) - (bx - cx) * (ay - cy);
  };
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    corners[k].screen_weight = area(p.x[a], p.y[a], p.x[b], p.y[b]);
    sum += corners[k].screen_weight;
  }
  for (CornerStory& corner : corners) corner.screen_weight = sum != 0.0 ? corner.screen_weight / sum : 0.0;
}

/// Weights along a line's major axis.
void weigh_line(const FragmentContext& context, const raster::PrimitiveRecord& p,
                std::vector<CornerStory>& corners) {
  const bool x_major = raster::reference::is_x_major(p);
  const std::int32_t(&along)[3] = x_major ? p.x : p.y;
  const double center = ((x_major ? context.x : context.y) + 0.5) * raster::kSubpixelUnits;
  const double t = (center - along[0]) / (along[1] - along[0]);
  corners[0].screen_weight = 1.0 - t;
  corners[1].screen_weight = t;
  const double near_share = (1.0 - t) / corners[0].w;
  const double far_share = t / corners[1].w;
  corners[0].weight = near_share / (near_share + far_share);
  corners[1].weight = far_share / (near_share + far_share);
}

}  // namespace

VertexAgain::VertexAgain(const AssembledDraw& draw, std::uint32_t vertex) : draw_(draw), vertex_(vertex) {
  const pipeline::DrawPlan& plan = *draw.plan;
  out_ = pipeline::allocate_vertices(plan, vertex, 1, memory_);
  out_.surfaces = memory_.allocate<pipeline::SurfaceVertex>(out_.capacity);
  if (plan.origin.makes_vertex_colors()) {
    const auto sides = static_cast<std::size_t>(plan.sides());
    out_.flat_colors = memory_.allocate<raster::FlatColors>(sides * out_.capacity);
  }
  pipeline::run_vertex_stage(plan, draw.geometry, 0, 1, out_);
}

glm::vec3 VertexAgain::object() const {
  const pipeline::Attribute& a = draw_.geometry.position;
  const float* from = a.data + std::size_t{vertex_} * static_cast<std::size_t>(a.stride);
  return {from[0], from[1], a.components > 2 ? from[2] : 0.0f};
}

glm::vec3 VertexAgain::normal() const {
  const float(&n)[3] = out_.surfaces->normal;
  return {n[0], n[1], n[2]};
}

SurfacePoint VertexAgain::point(bool back) const {
  const pipeline::SurfaceVertex& s = *out_.surfaces;
  SurfacePoint point;
  point.position = {s.position[0], s.position[1], s.position[2]};
  point.normal = normal();
  point.color = {s.color[0], s.color[1], s.color[2], s.color[3]};
  point.back = back;
  return point;
}

const float* VertexAgain::record(bool back) const {
  const std::size_t side = back && draw_.plan->has_back_side ? out_.capacity : 0;
  return out_.records + side * static_cast<std::size_t>(out_.stride);
}

const raster::FlatColors* VertexAgain::lit(bool back) const {
  if (out_.flat_colors == nullptr) return nullptr;
  return out_.flat_colors + (back && draw_.plan->has_back_side ? out_.capacity : 0);
}

std::vector<std::uint32_t> corner_vertices(const FrameChunk& place, const raster::PrimitiveRecord& primitive,
                                           std::uint32_t source) {
  const AssembledDraw& draw = *place.draw;
  const pipeline::AssemblyInput input{*draw.plan, draw.geometry, draw.vertices};
  std::vector<std::uint32_t> corners;
  if (place.chunk->chunk->topology == raster::Topology::triangles) {
    const std::uint32_t count = std::min<std::uint32_t>(input.corner_count(), 3);
    for (std::uint32_t k = 0; k < count; ++k) {
      corners.push_back(input.corner_vertex(source, k) + draw.vertices.first);
    }
    return corners;
  }
  const std::size_t count = place.chunk->chunk->topology == raster::Topology::lines ? 2 : 1;
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t number = primitive.vertex[k];
    if (number >= place.chunk->chunk->shared_count) return {};
    corners.push_back(number % draw.vertices.capacity + draw.vertices.first);
  }
  return corners;
}

bool is_clipped(const raster::PrimitiveChunk& chunk, const raster::PrimitiveRecord& primitive) {
  const int count = chunk.topology == raster::Topology::triangles ? 3
                    : chunk.topology == raster::Topology::lines   ? 2
                                                                  : 1;
  return std::any_of(primitive.vertex, primitive.vertex + count,
                     [&](std::uint32_t number) { return number >= chunk.shared_count; });
}

bool faces_back(const FrameChunk& place, const raster::PrimitiveRecord& primitive, std::uint32_t source) {
  const AssembledDraw& draw = *place.draw;
  if (!pipeline::is_polygonal(draw.geometry.mode)) return false;
  double area = 0.0;
  if (place.chunk->chunk->topology == raster::Topology::triangles) {
    const auto& [x, y, vertex, flat] = primitive;
    area =
        static_cast<double>(x[1] - x[0]) * (y[2] - y[0]) - static_cast<double>(x[2] - x[0]) * (y[1] - y[0]);
  } else {
    const pipeline::AssemblyInput input{*draw.plan, draw.geometry, draw.vertices};
    glm::dmat3 corners(0.0);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const VertexAgain again(draw, input.corner_vertex(source, k) + draw.vertices.first);
      const glm::vec4 clip = clip_position(draw, again.object());
      corners[static_cast<int>(k)] = glm::dvec3(clip.x, clip.y, clip.w);
    }
    area = glm::determinant(corners);
  }
  return area != 0.0 && (area > 0.0) != draw.plan->cull.front_is_counter_clockwise;
}

std::vector<CornerStory> tell_corners(const FragmentContext& context, const FrameChunk& place,
                                      const raster::PrimitiveRecord& primitive, std::uint32_t source) {
  const AssembledDraw& draw = *place.draw;
  const raster::PrimitiveChunk& chunk = *place.chunk->chunk;
  const bool back = faces_back(place, primitive, source);
  std::vector<CornerStory> corners;
  for (const std::uint32_t vertex : corner_vertices(place, primitive, source)) {
    corners.push_back(tell_corner(draw, vertex, back));
    const scene::Displaced* displaced = place.origin->displaced;
    if (displaced != nullptr && vertex < displaced->amount.size()) {
      corners.back().displaced = displaced->amount[vertex];
    }
  }
  if (corners.size() == 3) {
    weigh_corners(context, draw, corners);
    if (!is_clipped(chunk, primitive)) weigh_on_screen(context, primitive, corners);
  } else if (corners.size() == 2) {
    weigh_line(context, primitive, corners);
  } else if (corners.size() == 1) {
    corners[0].weight = corners[0].screen_weight = 1.0;
  }
  return corners;
}

}  // namespace barrido::inspect
