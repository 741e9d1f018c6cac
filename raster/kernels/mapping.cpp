// Coordinates that are made or changed at each fragment: two-part mapping (T4 to T8) and tiles (T9), for one
// batch of fragments.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/mapping.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/mapping-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void MapCoordinates(FragmentBatch& batch, int unit) {
  const hn::ScalableTag<float> d;
  const FragmentState& state = *batch.state;
  const Mapping& mapping = state.texture_units[unit].mapping;
  const IntermediateSurface surface(mapping);
  float(*at)[kBatchStride] = batch.varying + state.varyings.at(Meaning::texcoord, unit);
  const float(*normals)[kBatchStride] =
      needs_normal(mapping) ? batch.varying + state.varyings.at(Meaning::normal) : at;
  const auto load = [&](const float(*from)[kBatchStride], int i) HWY_ATTR {
    return IntermediateSurface::Point{hn::LoadU(d, from[0] + i), hn::LoadU(d, from[1] + i),
                                      hn::LoadU(d, from[2] + i)};
  };
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto point = load(at, i), normal = load(normals, i);
    const auto face = surface.face_of(point, normal);
    auto s = hn::Zero(d), t = s;
    surface.coordinates(surface.place(point, normal, face), face, s, t);
    hn::StoreU(s, d, at[0] + i);
    hn::StoreU(t, d, at[1] + i);
  }
}

/// See tile_hash().
template <class VI>
HWY_INLINE VI hash_of_tiles(VI i, VI j) {
  const hn::DFromV<VI> di;
  const hn::RebindToUnsigned<decltype(di)> du;
  auto h = hn::Xor(hn::Mul(hn::BitCast(du, i), hn::Set(du, 0x9e3779b1u)),
                   hn::Mul(hn::BitCast(du, j), hn::Set(du, 0x85ebca77u)));
  h = hn::Mul(hn::Xor(h, hn::ShiftRight<15>(h)), hn::Set(du, 0x2c1b3c6du));
  h = hn::Mul(hn::Xor(h, hn::ShiftRight<12>(h)), hn::Set(du, 0x297a2d39u));
  return hn::BitCast(di, hn::Xor(h, hn::ShiftRight<15>(h)));
}

void ChangeTiles(FragmentBatch& batch, int unit) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const TileChange change = batch.state->texture_units[unit].tiles;
  float(*at)[kBatchStride] = batch.varying + batch.state->varyings.at(Meaning::texcoord, unit);
  const auto limit = hn::Set(d, 2097152.0f);
  const auto one = hn::Set(d, 1.0f);
  for (int i = 0; i < batch.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto s = minimum(maximum(hn::LoadU(d, at[0] + i), hn::Neg(limit)), limit);
    const auto t = minimum(maximum(hn::LoadU(d, at[1] + i), hn::Neg(limit)), limit);
    const auto hash = hash_of_tiles(floor_to_integer(s), floor_to_integer(t));
    const auto has = [&](std::int32_t bit)
                         HWY_ATTR { return hn::RebindMask(d, hn::TestBit(hash, hn::Set(di, bit))); };
    auto x = hn::Sub(s, hn::Floor(s)), y = hn::Sub(t, hn::Floor(t));
    if (change != TileChange::shift) {
      const auto half_turn = has(2), quarter_turn = has(1);
      x = hn::IfThenElse(half_turn, hn::Sub(one, x), x);
      y = hn::IfThenElse(half_turn, hn::Sub(one, y), y);
      const auto turned = hn::IfThenElse(quarter_turn, hn::Sub(one, y), x);
      y = hn::IfThenElse(quarter_turn, x, y);
      x = turned;
    }
    if (change != TileChange::rotate) {
      const auto part = [&](auto bits) HWY_ATTR {
        return hn::Mul(hn::ConvertTo(d, hn::And(bits, hn::Set(di, 255))), hn::Set(d, 1.0f / 256.0f));
      };
      x = hn::Add(x, part(hn::ShiftRight<8>(hash)));
      y = hn::Add(y, part(hn::ShiftRight<16>(hash)));
    }
    hn::StoreU(x, d, at[0] + i);
    hn::StoreU(y, d, at[1] + i);
  }
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(MapCoordinates);
HWY_EXPORT(ChangeTiles);

void map_coordinates(FragmentBatch& batch, int unit) { HWY_DYNAMIC_DISPATCH(MapCoordinates)(batch, unit); }
void change_tiles(FragmentBatch& batch, int unit) { HWY_DYNAMIC_DISPATCH(ChangeTiles)(batch, unit); }

}  // namespace barrido::raster
#endif
