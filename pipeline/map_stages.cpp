#include "pipeline/map_stages.h"

#include <cstring>

#include "pipeline/bounded.h"
#include "pipeline/draw_plan.h"
#include "pipeline/matrix.h"
#include "pipeline/reference/map_stages.h"
#include "raster/kernels/kernels.h"

namespace barrido::pipeline {
namespace {

using raster::FragmentBatch;
using raster::FragmentStage;
using raster::Meaning;
using raster::TextureRole;
using raster::TextureUnit;

const TextureUnit& unit_of(const FragmentStage& stage, const raster::FragmentState& state) {
  return state.texture_units[static_cast<std::size_t>(stage.unit)];
}

void map_normals(const FragmentStage& stage, raster::TileWorkspace& workspace) {
  raster::sample_unit(workspace, stage.unit);
  apply_normal_map(unit_of(stage, *workspace.batch.state).strength, workspace.texel, workspace.batch);
}

/// Heights with one coordinate moved by `step`, which stands where it was afterwards.
void sample_beside(const FragmentStage& stage, int axis, float step, raster::TileWorkspace& workspace,
                   float* heights) {
  FragmentBatch& batch = workspace.batch;
  const raster::FragmentState& state = *batch.state;
  const int first = state.varyings.at(Meaning::texcoord, stage.unit);
  float* coordinate = batch.varying[first + axis];
  const bool divides = texcoord_kind(state, stage.unit) == raster::TexcoordKind::projective;
  BatchRow kept;
  std::memcpy(kept, coordinate, sizeof(kept));
  shift_coordinate(kept, divides ? batch.varying[first + 2] : nullptr, step, batch.count, coordinate);
  raster::sample_unit(workspace, stage.unit);
  take_heights(workspace.texel, batch.count, heights);
  std::memcpy(coordinate, kept, sizeof(kept));
}

void bump_normals(const FragmentStage& stage, raster::TileWorkspace& workspace) {
  FragmentBatch& batch = workspace.batch;
  const TextureUnit& unit = unit_of(stage, *batch.state);
  const raster::TexcoordKind kind = texcoord_kind(*batch.state, stage.unit);
  const BumpSteps steps = bump_steps(unit, kind);
  alignas(64) BatchRow slopes[3];
  alignas(64) BatchRow heights;
  for (int axis = 0; axis < steps.axes; ++axis) {
    sample_beside(stage, axis, steps.step[axis], workspace, slopes[axis]);
    sample_beside(stage, axis, -steps.step[axis], workspace, heights);
    take_slopes(heights, steps.scale[axis], batch.count, slopes[axis]);
  }
  if (is_flat(kind)) return tilt_normals(unit.bump_form, slopes, batch);
  const auto& plan = *static_cast<const DrawPlan*>(stage.parameters);
  tilt_normals_in_space(unit.bump_form, plan.eye_gradient, slopes, batch);
}

void map_occlusion(const FragmentStage& stage, raster::TileWorkspace& workspace) {
  raster::sample_unit(workspace, stage.unit);
  apply_occlusion(unit_of(stage, *workspace.batch.state).strength, workspace.texel, workspace.batch);
}

}  // namespace

constinit const raster::StageKind kNormalMap{
    .name = "normal map",
    .reads = raster::set_of(Meaning::normal, Meaning::tangents, Meaning::texcoord),
    .writes = raster::set_of(Meaning::normal),
    .vector = map_normals,
    .scalar = reference::map_normal,
    .story = "puts the map's normal, in tangent space, in place of the interpolated one"};
constinit const raster::StageKind kBumpMap{
    .name = "bump map",
    .reads = raster::set_of(Meaning::normal, Meaning::tangents, Meaning::texcoord),
    .writes = raster::set_of(Meaning::normal),
    .vector = bump_normals,
    .scalar = reference::bump_normal,
    .story = "tilts the normal as the slopes of the heights ask for, and leaves the surface where it is"};
constinit const raster::StageKind kOcclusionMap{.name = "occlusion map",
                                                .reads = raster::set_of(Meaning::texcoord),
                                                .writes = raster::set_of(Meaning::occlusion),
                                                .vector = map_occlusion,
                                                .scalar = reference::map_occlusion,
                                                .story = "says how much of the ambient light arrives"};

std::optional<FragmentStage> map_stage(const DrawPlan& plan, int unit) {
  const auto index = static_cast<std::size_t>(unit);
  const raster::TexcoordKind kind = plan.texcoords[index].kind;
  const raster::Varying coordinates{Meaning::texcoord, floats_of(kind), unit};
  FragmentStage stage{.unit = unit, .parameters = &plan};
  switch (plan.fragment.texture_units[index].role) {
    case TextureRole::environment:
    case TextureRole::shine:
      return std::nullopt;
    case TextureRole::normal:
    case TextureRole::bump: {
      const bool bumps = plan.fragment.texture_units[index].role == TextureRole::bump;
      stage.kind = bumps ? &kBumpMap : &kNormalMap;
      stage.reads = {{coordinates, {Meaning::normal, 3}, {Meaning::tangents, is_flat(kind) ? 6 : 0}}};
      return stage;
    }
    case TextureRole::occlusion:
      break;
  }
  stage.kind = &kOcclusionMap;
  stage.reads = {{coordinates}};
  stage.makes = {Meaning::occlusion, 1};
  return stage;
}

BumpSteps bump_steps(const TextureUnit& unit, raster::TexcoordKind kind) {
  BumpSteps steps;
  steps.axes = is_flat(kind) ? 2 : 3;
  if (unit.procedure == nullptr) {
    steps.step[0] = 1.0f / static_cast<float>(unit.texture->width());
    steps.step[1] = 1.0f / static_cast<float>(unit.texture->height());
  }
  for (int axis = 0; axis < 3; ++axis) steps.scale[axis] = unit.strength / (2.0f * steps.step[axis]);
  return steps;
}

glm::mat3 solid_gradient(const State& state, std::size_t unit) {
  const TextureCoordinates& rules = state.texture_coordinates[unit];
  const glm::dmat3 eye_from_object_gradient = normal_matrix(bounded(glm::dmat4(state.eye_from_object)));
  glm::dmat3 gradients;
  for (int i = 0; i < 3; ++i) {
    const TexGenCoordinate& rule = rules.generation[static_cast<std::size_t>(i)];
    glm::dvec3 own(0.0);
    own[i] = 1.0;
    if (rule.enabled && rule.mode == TexGenMode::eye_linear) {
      gradients[i] = glm::dvec3(glm::dvec4(rule.eye_plane));
      continue;
    }
    if (rule.enabled && rule.mode == TexGenMode::object_linear)
      own = glm::dvec3(glm::dvec4(rule.object_plane));
    gradients[i] = eye_from_object_gradient * own;
  }
  const glm::dmat3 matrix{glm::dmat4(rules.matrix)};
  const glm::dmat3 product = gradients * glm::transpose(matrix);
  return {bounded(product[0]), bounded(product[1]), bounded(product[2])};
}

}  // namespace barrido::pipeline
