// Cheap Phong shading (course S7): per light the two dot products are computed at the vertices and
// interpolated like colours; the model is evaluated per fragment from them.
//
// A light that weakens (attenuation, range, cone) has a factor f at each vertex. It is folded into what is
// interpolated anyway, so that no light costs a third varying, and such that the result at the vertices is
// exactly the full model: the diffuse dot carries f·(N·L); the highlight carries f^(1/n)·h, whose n-th power
// is f·h^n. The ambient light of all lights that weaken is one interpolated colour.
#pragma once

#include <span>

#include "pipeline/illumination.h"

namespace barrido::pipeline {

/// Floats interpolated: two a light, then three where a light that weakens has ambient colour.
int cheap_phong_varyings(const Illumination& illumination);

/// Whether the n-th power is taken at the vertices: because the draw says so, or because n is 0, when it says
/// no more than whether the light falls on the surface.
bool power_at_vertices(const Illumination& illumination, int side);

/// Evaluations of x^n for one vertex, and for one fragment.
int cheap_phong_vertex_powers(const Illumination& illumination, int side);
int cheap_phong_fragment_powers(const Illumination& illumination, int side);

/// Evaluates the dot products at every point. `columns` are arrays as those of SurfacePoints, one for each of
/// cheap_phong_varyings().
void cheap_phong_dots(const Illumination& illumination, const SurfacePoints& points,
                      std::span<float* const> columns);

/// Interpolated dot products of points of one side.
struct InterpolatedDots {
  int count = 0;
  bool back = false;
  std::span<const float* const> columns;       ///< As written by cheap_phong_dots.
  std::array<const float*, 4> color{};         ///< Unused unless Illumination::tracks_color.
  std::span<const float* const> visibility{};  ///< As SurfacePoints::visibility.
  const float* occlusion = nullptr;            ///< As SurfacePoints::occlusion.
};

/// C = base + ambient + Σ (f N·L)⁺ d + [N·L > 0] (f^(1/n) h)^n s. Not clamped.
void cheap_phong_colors(const Illumination& illumination, const InterpolatedDots& dots, const LitColors& out);

}  // namespace barrido::pipeline
