// The fragment stage on one page: the stages that a fragment can pass between interpolation and the frame,
// their order, and the loop that takes a batch through them.
#include <cstring>

#include "raster/kernels/kernels.h"
#include "raster/reference/shading.h"

namespace barrido::raster {
namespace {

bool reads_primary(const FragmentState& state) {
  for (const TextureUnit& unit : state.texture_units) {
    const bool is_on = unit.texture != nullptr || unit.procedure != nullptr;
    const bool combines = unit.role == TextureRole::environment && unit.env_mode == TextureEnvMode::combine;
    if (is_on && combines) return true;
  }
  return false;
}

void take_colors(const FragmentStage&, TileWorkspace& workspace) {
  FragmentBatch& batch = workspace.batch;
  start_colors(*workspace.key, batch);
  if (reads_primary(*batch.state)) std::memcpy(workspace.primary, batch.color, sizeof(workspace.primary));
}

/// The fragments' places in the coordinates of the unit's procedure.
ProcedurePoints points_of(const FragmentBatch& batch, int unit, const float (*extent)[kBatchStride]) {
  const int first = batch.state->varyings.at(Meaning::texcoord, unit);
  ProcedurePoints points{batch.count, {}, {extent[0], extent[1], extent[2]}};
  const int coordinates = texcoord_kind(*batch.state, unit) == TexcoordKind::plain ? 2 : 3;
  for (int i = 0; i < coordinates; ++i) points.at[static_cast<std::size_t>(i)] = batch.varying[first + i];
  return points;
}

void apply_texture(const FragmentStage& stage, TileWorkspace& workspace) {
  FragmentBatch& batch = workspace.batch;
  const int unit = stage.unit;
  const TextureUnit& state = batch.state->texture_units[static_cast<std::size_t>(unit)];
  if (state.mapping.surface != MappingSurface::none) {
    map_coordinates(batch, unit);
    workspace.statistics.mapped += static_cast<std::uint64_t>(batch.count);
  }
  if (changes_tiles(*batch.state, unit)) change_tiles(batch, unit);
  const bool is_sampled_in_place =
      state.env_mode == TextureEnvMode::replace || state.env_mode == TextureEnvMode::modulate;
  if (state.procedure != nullptr || has_wide_filter(state) || !is_sampled_in_place) {
    sample_unit(workspace, unit);
    return combine_texture(batch, unit, workspace.texel, workspace.primary);
  }
  // The two commonest environments are applied as the texels are sampled.
  find_levels(workspace.lod_groups[unit], workspace.lod_group_count, unit, batch, workspace.levels);
  std::uint64_t& texels = workspace.statistics.texel_fetches;
  texels += state.env_mode == TextureEnvMode::replace
                ? sample_texture(batch, unit, workspace.levels, batch.color)
                : modulate_by_texture(batch, unit, workspace.levels);
}

void apply_shine(const FragmentStage& stage, TileWorkspace& workspace) {
  sample_unit(workspace, stage.unit);
  multiply_secondary(workspace.batch, workspace.texel);
}

}  // namespace

constinit const StageKind kTakeColors{
    .name = "colours",
    .reads = set_of(Meaning::color, Meaning::specular),
    .writes = set_of(Meaning::color, Meaning::specular),
    .vector = take_colors,
    .scalar = reference::take_colors,
    .story = "takes the colours that light made, the vertices gave or the primitive has, and clamps them",
    .clamps = true};
constinit const StageKind kApplyTexture{
    .name = "texture unit",
    .reads = set_of(Meaning::color, Meaning::texcoord, Meaning::normal),
    .writes = set_of(Meaning::color),
    .vector = apply_texture,
    .scalar = reference::apply_texture,
    .story = "makes a texel of the unit's coordinates and combines it with the colour so far",
    .clamps = true};
constinit const StageKind kApplyShine{.name = "specularity map",
                                      .reads = set_of(Meaning::specular, Meaning::texcoord),
                                      .writes = set_of(Meaning::specular),
                                      .vector = apply_shine,
                                      .scalar = reference::apply_shine,
                                      .story = "multiplies the highlights by the texel",
                                      .clamps = true};
constinit const StageKind kAddSecondary{
    .name = "colour sum",
    .reads = set_of(Meaning::color, Meaning::specular),
    .writes = set_of(Meaning::color),
    .vector = [](const FragmentStage&, TileWorkspace& workspace) { add_secondary(workspace.batch); },
    .scalar = reference::add_secondary,
    .story = "adds the highlights, which the textures have not darkened",
    .clock = Stage::write,
    .clamps = true};
constinit const StageKind kApplyFog{
    .name = "fog",
    .reads = set_of(Meaning::color, Meaning::fog),
    .writes = set_of(Meaning::color),
    .vector = [](const FragmentStage&, TileWorkspace& workspace) { apply_fog(workspace.batch); },
    .scalar = reference::apply_fog,
    .story = "mixes in the colour of the fog by the distance",
    .clock = Stage::write};

std::vector<FragmentStage> make_stages(const FragmentState& state, std::span<const FragmentStage> before,
                                       const StageInputs& inputs) {
  std::vector<FragmentStage> stages(before.begin(), before.end());
  stages.push_back(
      {.kind = &kTakeColors,
       .reads = {{{Meaning::color, inputs.color ? 4 : 0}, {Meaning::specular, inputs.specular ? 3 : 0}}}});
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    const int floats = inputs.coordinates[static_cast<std::size_t>(unit)];
    const TextureRole role = state.texture_units[static_cast<std::size_t>(unit)].role;
    if (floats == 0 || (role != TextureRole::environment && role != TextureRole::shine)) continue;
    const StageKind* kind = role == TextureRole::environment ? &kApplyTexture : &kApplyShine;
    const Mapping& mapping = state.texture_units[static_cast<std::size_t>(unit)].mapping;
    stages.push_back(
        {.kind = kind,
         .unit = unit,
         .reads = {{{Meaning::texcoord, floats, unit}, {Meaning::normal, needs_normal(mapping) ? 3 : 0}}}});
  }
  if (state.separate_specular) stages.push_back({.kind = &kAddSecondary});
  if (state.fog.enabled) stages.push_back({.kind = &kApplyFog, .reads = {{{Meaning::fog, 1}}}});
  return stages;
}

void sample_unit(TileWorkspace& workspace, int unit) {
  FragmentBatch& batch = workspace.batch;
  const TextureUnit& state = batch.state->texture_units[static_cast<std::size_t>(unit)];
  if (state.procedure != nullptr) {
    find_extents(workspace.lod_groups[unit], workspace.lod_group_count, unit, batch, workspace.extent);
    workspace.statistics.patterns += static_cast<std::uint64_t>(batch.count);
    workspace.statistics.noise +=
        state.procedure->vector(state, points_of(batch, unit, workspace.extent), workspace.texel);
    return;
  }
  const LodGroups& groups = workspace.lod_groups[unit];
  if (has_wide_filter(state)) {
    workspace.statistics.texel_fetches +=
        sample_wide(groups, workspace.lod_group_count, batch, unit, workspace.texel);
    return;
  }
  find_levels(groups, workspace.lod_group_count, unit, batch, workspace.levels);
  workspace.statistics.texel_fetches += sample_texture(batch, unit, workspace.levels, workspace.texel);
}

void shade_batch(TileWorkspace& workspace) {
  FragmentBatch& batch = workspace.batch;
  const FragmentState& state = *batch.state;
  const Stage before = workspace.clock.switch_to(state.stages.front().kind->clock);
  for (const FragmentStage& stage : state.stages) {
    workspace.clock.switch_to(stage.kind->clock);
    stage.kind->vector(stage, workspace);
  }
  workspace.clock.switch_to(Stage::write);
  if (workspace.key->sorted) {
    keep_layers(workspace);
  } else {
    write_fragments(*workspace.key, batch, workspace.surface);
  }
  workspace.clock.switch_to(before);
  const auto count = static_cast<std::uint64_t>(batch.count);
  workspace.statistics.interpolations += count * quantities_a_fragment(state.varyings);
  workspace.statistics.shaded_in[static_cast<std::size_t>(Loop::batch)] += count;
  batch.count = 0;
  batch.run_count = 0;
  workspace.lod_group_count = 0;
}

}  // namespace barrido::raster
