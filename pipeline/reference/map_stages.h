// The stages of maps once more, at one fragment and in plain floats: what pipeline/kernels/map_stages.cpp
// computes on vectors, bit for bit.
#pragma once

#include <array>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "raster/fragments/fragment_state.h"
#include "raster/reference/fragment.h"
#include "raster/reference/trace.h"

namespace barrido::pipeline::reference {

/// A normal with the directions in which a map's coordinates grow, eye space.
struct MappedSurface {
  glm::vec3 normal{0, 0, 1}, tangent{1, 0, 0}, bitangent{0, 1, 0};
};

/// See kNormalMap; `texel` is the map's, each channel in [0, 1].
glm::vec3 mapped_normal(const MappedSurface& surface, const glm::vec3& texel, float strength);
/// See kBumpMap; slopes along u and v.
glm::vec3 tilted_normal(const MappedSurface& surface, raster::BumpForm form, float slope_u, float slope_v);
/// The same for heights in space: slopes along the three coordinates, whose gradients are given.
glm::vec3 tilted_normal(const glm::vec3& normal, raster::BumpForm form, const glm::mat3& eye_gradient,
                        const glm::vec3& slopes);

// The scalar functions of the stages.
void map_normal(const raster::FragmentStage& stage, raster::reference::Fragment& fragment,
                raster::reference::ShadingTrace* trace);
void bump_normal(const raster::FragmentStage& stage, raster::reference::Fragment& fragment,
                 raster::reference::ShadingTrace* trace);
void map_occlusion(const raster::FragmentStage& stage, raster::reference::Fragment& fragment,
                   raster::reference::ShadingTrace* trace);

}  // namespace barrido::pipeline::reference
