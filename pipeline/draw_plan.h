// One draw's state, compiled: everything that the vertex stage, assembly and the fragments need, worked out
// once. Enters: State and Geometry, checked here; leaves: plain constants at an address that stays the same
// until the frame is finished.
#pragma once

#include <array>
#include <optional>

#include "pipeline/cheap_phong.h"
#include "pipeline/fragment_counters.h"
#include "pipeline/geometry.h"
#include "pipeline/illumination.h"
#include "pipeline/layout.h"
#include "pipeline/state.h"
#include "pipeline/vertex_batch.h"
#include "raster/fragments/primitive.h"
#include "raster/tiles/samples.h"

namespace barrido::pipeline {

struct FrameSize {
  int width = 0;
  int height = 0;
  raster::SampleReach reach;  ///< Where pixels are sampled.
};

/// Which polygons go on to the rasterizer.
struct CullRule {
  bool keep_front = true;
  bool keep_back = true;
  bool front_is_counter_clockwise = true;
  /// Those that cover no pixel's centre too: pixels are sampled elsewhere.
  bool keep_between_centers = false;
};

/// A unit's coordinates: how they are made.
struct TexcoordPlan {
  bool is_on = false;
  raster::TexcoordKind kind = raster::TexcoordKind::plain;
  bool as_given = true;      ///< Neither generation nor matrix: straight from the array.
  int given_components = 4;  ///< How many have to be read from the array.
  TextureCoordinates rules;  ///< Bounded.
};

struct DrawPlan {
  /// @throws std::invalid_argument when state or geometry are impossible; says which value and why.
  DrawPlan(const State& state, const Geometry& geometry, FrameSize frame,
           FragmentCounters& fragment_counters);
  DrawPlan(const DrawPlan&) = delete;  // the fragment state points here
  DrawPlan& operator=(const DrawPlan&) = delete;

  raster::FragmentState fragment;
  raster::Topology topology = raster::Topology::triangles;
  float point_size = 1.0f;
  float line_width = 1.0f;

  ColorOrigin origin;
  std::optional<Illumination> illumination;  ///< Empty: lighting is off.
  raster::FlatColors constant_color{};       ///< Where has_constant_color().
  bool clamp_colors = true;
  bool needs_color = false;     ///< The colour array is read.
  bool needs_normal = false;    ///< Eye normals are made.
  bool needs_eye = false;       ///< Homogeneous eye positions are made.
  bool needs_point = false;     ///< Divided eye positions are made.
  bool needs_tangents = false;  ///< Eye tangents are made,
  bool unit_tangents = false;   ///< of unit length,
  bool has_bitangent = false;   ///< and the bitangents are given.
  /// Back faces have records (or flat colours) of their own, behind all those of front faces.
  bool has_back_side = false;
  /// Fragments must know which way their polygon faces.
  bool marks_back_faces = false;

  VertexTransform transform;
  std::array<TexcoordPlan, raster::kMaxTextureUnits> texcoords;
  /// What turns the slopes of a solid texture's values along its own three coordinates into a gradient in eye
  /// space; of the unit with heights.
  glm::mat3 eye_gradient{1.0f};
  CullRule cull;
  FragmentCounters* counters = nullptr;

  bool has_constant_color() const {
    return !origin.at_vertices && !origin.at_centroid && !origin.at_fragments;
  }
  int sides() const { return has_back_side ? 2 : 1; }
  int stride() const { return raster::record_stride(fragment.varyings.count); }

 private:
  /// Whether the draw's stages have a use for a unit of this role.
  bool uses(raster::TextureRole role) const;
  void plan_texcoords(const State& state, const Geometry& geometry);
  void plan_tangents(const State& state, const Geometry& geometry);
  void plan_stages();
};

}  // namespace barrido::pipeline
