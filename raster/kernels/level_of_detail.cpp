// The level of detail λ of a batch's fragments (OpenGL 1.3, section 3.8.8; docs/arithmetic.md, "Level of
// detail") and the mip levels it asks for: computed for groups of four pixels of a row, many rows at a time
// so that vectors are full, then given to each fragment of the group.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/level_of_detail.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstring>

#include "raster/kernels/level_of_detail-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Whole vectors: what is past the last fragment is as the last one.
void FindLevels(const LodGroups& groups, int group_count, int unit_number, const FragmentBatch& batch,
                SampleLevels& levels) {
  const F d;
  const I di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const TextureUnit& unit = batch.state->texture_units[unit_number];
  const UnitFilters filters = unit_filters(unit);
  if (!needs_lod(unit)) {
    const auto all = hn::Set(di, level_zero(filters.min_linear));
    for (int i = 0; i < batch.count; i += lanes) hn::Store(all, di, levels.packed + i);
    return;
  }
  alignas(64) std::int32_t of_group[kBatchStride];
  for (int g = 0; g < group_count; g += lanes) {
    const auto lod = hn::Add(lod_of_groups(groups, *batch.state, unit_number, g), hn::Set(d, unit.lod_bias));
    hn::Store(choose_levels(lod, filters, unit.texture->level_count() - 1), di, of_group + g);
  }
  spread(batch, of_group, levels.packed);
}

/// Width of the box of the pixel along coordinate `i` at the groups from g on.
HWY_INLINE VF extent_of_groups(const LodGroups& groups, const FragmentState& state, int unit, std::size_t i,
                               int g) {
  const F d;
  const Mapping& mapping = state.texture_units[unit].mapping;
  if (mapping.surface == MappingSurface::none) {
    const Differential<VF> c = point_coordinate(groups, state, unit, i, g);
    return maximum(hn::Abs(c.dx), hn::Abs(c.dy));
  }
  auto square_x = hn::Zero(d), square_y = square_x;
  steps_on_surface(groups, state, unit, g, square_x, square_y);
  return hn::Mul(hn::Sqrt(maximum(square_x, square_y)), hn::Set(d, mapping_density(mapping)[i]));
}

void FindExtents(const LodGroups& groups, int group_count, int unit, const FragmentBatch& batch,
                 float (*extent)[kBatchStride]) {
  const F d;
  const I di;
  const FragmentState& state = *batch.state;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const std::size_t coordinates = texcoord_kind(state, unit) == TexcoordKind::plain ? 2 : 3;
  alignas(64) std::int32_t of_group[kBatchStride];
  for (std::size_t i = 0; i < coordinates; ++i) {
    for (int g = 0; g < group_count; g += lanes) {
      hn::Store(hn::BitCast(di, extent_of_groups(groups, state, unit, i, g)), di, of_group + g);
    }
    spread(batch, of_group, reinterpret_cast<std::int32_t*>(extent[i]));
  }
  for (std::size_t i = coordinates; i < 3; ++i) std::memset(extent[i], 0, sizeof(extent[i]));
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(FindLevels);
HWY_EXPORT(FindExtents);

void find_extents(const LodGroups& groups, int group_count, int unit, const FragmentBatch& batch,
                  float (*extent)[kBatchStride]) {
  HWY_DYNAMIC_DISPATCH(FindExtents)(groups, group_count, unit, batch, extent);
}

void find_levels(const LodGroups& groups, int group_count, int unit, const FragmentBatch& batch,
                 SampleLevels& levels) {
  HWY_DYNAMIC_DISPATCH(FindLevels)(groups, group_count, unit, batch, levels);
}

}  // namespace barrido::raster
#endif
