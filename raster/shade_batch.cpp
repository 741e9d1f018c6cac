// The fragment stage on one page: what happens to a batch of fragments between interpolation and the frame.
#include <cstring>

#include "raster/kernels/kernels.h"

namespace barrido::raster {
namespace {

bool reads_primary(const FragmentState& state) {
  for (const TextureUnit& unit : state.texture_units) {
    if (unit.texture != nullptr && unit.env_mode == TextureEnvMode::combine) return true;
  }
  return false;
}

/// One texture unit on the batch's colours. @return texels read.
std::uint64_t apply_texture(TileWorkspace& workspace, int unit) {
  FragmentBatch& batch = workspace.batch;
  const TextureEnvMode mode = batch.state->texture_units[static_cast<std::size_t>(unit)].env_mode;
  find_levels(workspace.lod_groups[unit], workspace.lod_group_count, unit, batch, workspace.levels);
  if (mode == TextureEnvMode::replace) return sample_texture(batch, unit, workspace.levels, batch.color);
  if (mode == TextureEnvMode::modulate) return modulate_by_texture(batch, unit, workspace.levels);
  const std::uint64_t texels = sample_texture(batch, unit, workspace.levels, workspace.texel);
  combine_texture(batch, unit, workspace.texel, workspace.primary);
  return texels;
}

}  // namespace

void shade_batch(TileWorkspace& workspace) {
  FragmentBatch& batch = workspace.batch;
  const FragmentState& state = *batch.state;
  const Stage before = workspace.clock.switch_to(Stage::illumination);
  if (state.illumination.function != nullptr)
    state.illumination.function(state.illumination.parameters, batch);
  workspace.clock.switch_to(Stage::texture);
  start_colors(*workspace.key, batch);
  if (reads_primary(state)) std::memcpy(workspace.primary, batch.color, sizeof(workspace.primary));
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    if (!is_active(state, unit)) continue;
    workspace.statistics.texel_fetches += apply_texture(workspace, unit);
  }
  workspace.clock.switch_to(Stage::write);
  write_fragments(*workspace.key, batch, workspace.surface);
  workspace.clock.switch_to(before);
  const auto count = static_cast<std::uint64_t>(batch.count);
  workspace.statistics.interpolations += count * quantities_a_fragment(state.varyings);
  workspace.statistics.shaded_in[static_cast<std::size_t>(Loop::batch)] += count;
  batch.count = 0;
  batch.run_count = 0;
  workspace.lod_group_count = 0;
}

}  // namespace barrido::raster
