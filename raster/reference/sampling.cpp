#include "raster/reference/sampling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/reference/cube_face.h"

namespace barrido::raster::reference {
namespace {

Place cube_place(const float (&direction)[3]) {
  const CubeFace face = select_cube_face(direction);
  const float major = face.major.of(direction);
  if (!(major > 0.0f)) return {face.face, 0.5f, 0.5f};
  const float w = 1.0f / major;
  return {face.face, (face.sc.of(direction) * w + 1.0f) * 0.5f, (face.tc.of(direction) * w + 1.0f) * 0.5f};
}

float wrapped(float u, Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return u - std::floor(u);
    case Wrap::mirrored_repeat: {
      const float m = u - 2.0f * std::floor(u * 0.5f);
      return m > 1.0f ? 2.0f - m : m;
    }
    case Wrap::clamp:
    case Wrap::clamp_to_edge:
      return clamp_to_unit(u);
    case Wrap::clamp_to_border:
      break;
  }
  return u;
}

int nearest_index(float u, int size, Wrap wrap) {
  const float index = std::floor(wrapped(u, wrap) * static_cast<float>(size));
  const bool border = wrap == Wrap::clamp_to_border;
  const auto lowest = static_cast<float>(border ? -1 : 0);
  const auto highest = static_cast<float>(border ? size : size - 1);
  return static_cast<int>(minimum(maximum(index, lowest), highest));
}

Filtered sample_nearest(const Texture& texture, int level, const Place& place, Wrap wrap_s, Wrap wrap_t,
                        LevelTrace* trace) {
  const MipLevel& size = texture.level(level, place.face);
  const int i = nearest_index(place.u, size.width, wrap_s);
  const int j = nearest_index(place.v, size.height, wrap_t);
  Filtered texel = fetch(texture, level, place.face, i, j);
  if (trace != nullptr) trace->texels.push_back({i, j, texture.texel(level, place.face, i, j), 1.0f});
  if (texture.format() == TexelFormat::rgba8) {
    for (std::uint32_t& channel : texel) channel *= 256;
  }
  return texel;
}

/// Two neighbouring texels along one axis: texel `first` and the next, the next with weight fraction/256.
struct Neighbours {
  int first = 0;
  std::uint32_t fraction = 0;
};

Neighbours linear_neighbours(float u, int size, Wrap wrap) {
  // Half a texel, less half a step of 1/256: the floor below rounds to the nearest step.
  const float position = (wrapped(u, wrap) * static_cast<float>(size) - (0.5f - 0x1p-9f)) * 256.0f;
  const float bounded = minimum(maximum(position, -256.0f), 256.0f * static_cast<float>(size));
  const int fixed = static_cast<int>(std::floor(bounded));
  return {fixed >> 8, static_cast<std::uint32_t>(fixed & 255)};
}

std::uint32_t high_half(std::uint32_t a, std::uint32_t b) { return (a * b) >> 16; }

/// From a (fraction 0) towards b (fraction 256) on 16-bit numbers; never outside the two.
std::uint32_t mix(std::uint32_t a, std::uint32_t b, std::uint32_t fraction) {
  return (a - high_half(a, fraction << 8)) + high_half(b, fraction << 8);
}

Filtered mix(const Filtered& a, const Filtered& b, std::uint32_t fraction) {
  Filtered result{};
  for (std::size_t c = 0; c < 4; ++c) result[c] = mix(a[c], b[c], fraction);
  return result;
}

/// Texels i and i + 1 of row j, filtered along the row.
Filtered filter_row(const Texture& texture, int level, int face, const Neighbours& across, int j) {
  const int width = texture.level(level, face).width;
  const Filtered left = fetch(texture, level, face, across.first, j);
  // At first = width the weight is 0, and there is no texel behind the apron.
  const Filtered right = fetch(texture, level, face, std::min(across.first + 1, width), j);
  if (texture.format() == TexelFormat::rgba16) return mix(left, right, across.fraction);
  Filtered row{};
  for (std::size_t c = 0; c < 4; ++c) {
    row[c] = left[c] * (256 - across.fraction) + right[c] * across.fraction;
  }
  return row;
}

/// The four texels with their weights. A texel behind the apron has none and is not read.
void remember_texels(const Texture& texture, int level, int face, const Neighbours& across,
                     const Neighbours& down, LevelTrace& trace) {
  const MipLevel& size = texture.level(level, face);
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 2; ++column) {
      const std::uint32_t share = (column == 1 ? across.fraction : 256 - across.fraction) *
                                  (row == 1 ? down.fraction : 256 - down.fraction);
      const int i = std::min(across.first + column, size.width);
      const int j = std::min(down.first + row, size.height);
      trace.texels.push_back(
          {i, j, texture.texel(level, face, i, j), static_cast<float>(share) * (1.0f / 65536.0f)});
    }
  }
}

Filtered sample_linear(const Texture& texture, int level, const Place& place, Wrap wrap_s, Wrap wrap_t,
                       LevelTrace* trace) {
  const MipLevel& size = texture.level(level, place.face);
  const Neighbours across = linear_neighbours(place.u, size.width, wrap_s);
  const Neighbours down = linear_neighbours(place.v, size.height, wrap_t);
  const Filtered near_row = filter_row(texture, level, place.face, across, down.first);
  const Filtered far_row =
      filter_row(texture, level, place.face, across, std::min(down.first + 1, size.height));
  if (trace != nullptr) remember_texels(texture, level, place.face, across, down, *trace);
  return mix(near_row, far_row, down.fraction);
}

Color color_of(const Texture& texture, const Filtered& filtered) {
  const float scale = channel_scale(texture);
  Color color{};
  for (std::size_t c = 0; c < 4; ++c) color[c] = static_cast<float>(filtered[c]) * scale;
  return color;
}

Filtered sample_level(const Texture& texture, int level, const Place& place, bool linear,
                      SampleTrace* trace) {
  // Cube maps have no wrap modes: the apron holds what stands beyond an edge.
  const TextureOptions& options = texture.options();
  const Wrap wrap_s = texture.is_cube() ? Wrap::clamp_to_edge : options.wrap_s;
  const Wrap wrap_t = texture.is_cube() ? Wrap::clamp_to_edge : options.wrap_t;
  LevelTrace* remembered = nullptr;
  if (trace != nullptr) {
    const MipLevel& size = texture.level(level, place.face);
    remembered = &trace->levels.emplace_back(LevelTrace{0, level, size.width, size.height, {}, {}});
  }
  const Filtered filtered = linear ? sample_linear(texture, level, place, wrap_s, wrap_t, remembered)
                                   : sample_nearest(texture, level, place, wrap_s, wrap_t, remembered);
  if (remembered != nullptr) remembered->color = color_of(texture, filtered);
  return filtered;
}

bool is_linear_within_level(MinFilter filter) {
  return filter == MinFilter::linear || filter == MinFilter::linear_mipmap_nearest ||
         filter == MinFilter::linear_mipmap_linear;
}

/// The λ up to which the magnification filter is used.
float magnification_limit(const TextureUnit& unit) {
  const bool nearest_mipmap = unit.min_filter == MinFilter::nearest_mipmap_nearest ||
                              unit.min_filter == MinFilter::nearest_mipmap_linear;
  return unit.mag_filter == MagFilter::linear && nearest_mipmap ? 0.5f : 0.0f;
}

}  // namespace

float sane_coordinate(float value) { return std::fabs(value) < 4194304.0f ? value : 0.0f; }

Place place_of(TexcoordKind kind, const float (&coordinates)[3]) {
  switch (kind) {
    case TexcoordKind::direct:
      return cube_place(coordinates);
    case TexcoordKind::projective:
      return {0, sane_coordinate(coordinates[0] / coordinates[2]),
              sane_coordinate(coordinates[1] / coordinates[2])};
    case TexcoordKind::plain:
      break;
  }
  return {0, sane_coordinate(coordinates[0]), sane_coordinate(coordinates[1])};
}

Filtered fetch(const Texture& texture, int level, int face, int i, int j) {
  const MipLevel& where = texture.level(level, face);
  const std::size_t texel = static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(where.pitch_texels) +
                            static_cast<std::size_t>(i + 1);
  const std::uint8_t* base = texture.data() + where.offset_bytes;
  Filtered channels{};
  for (std::size_t c = 0; c < 4; ++c) {
    channels[c] = texture.format() == TexelFormat::rgba8
                      ? base[texel * 4 + c]
                      : reinterpret_cast<const std::uint16_t*>(base)[texel * 4 + c];
  }
  return channels;
}

float channel_scale(const Texture& texture) {
  return texture.format() == TexelFormat::rgba8 ? 1.0f / 65280.0f : 1.0f / 65535.0f;
}

Filtered sample_at(const TextureUnit& unit, const LevelChoice& choice, const Place& place,
                   SampleTrace* trace) {
  const Filtered filtered = sample_level(*unit.texture, choice.first, place, choice.linear, trace);
  if (!choice.two_levels) return filtered;
  return mix(filtered, sample_level(*unit.texture, choice.second, place, choice.linear, trace),
             choice.fraction);
}

LevelChoice choose_levels(const TextureUnit& unit, float lod) {
  const float biased = lod + unit.lod_bias;
  const int last = unit.texture->level_count() - 1;
  LevelChoice choice;
  choice.magnified = biased <= magnification_limit(unit);
  choice.linear =
      choice.magnified ? unit.mag_filter == MagFilter::linear : is_linear_within_level(unit.min_filter);
  if (choice.magnified) return choice;
  switch (unit.min_filter) {
    case MinFilter::nearest:
    case MinFilter::linear:
    case MinFilter::footprint:
    case MinFilter::corners:
      break;
    case MinFilter::nearest_mipmap_nearest:
    case MinFilter::linear_mipmap_nearest:
      choice.first =
          static_cast<int>(minimum(maximum(std::ceil(biased + 0.5f) - 1.0f, 0.0f), static_cast<float>(last)));
      break;
    case MinFilter::nearest_mipmap_linear:
    case MinFilter::linear_mipmap_linear: {
      // Larger than 0, as it is not magnified, or NaN, which counts as 0 for the other filters, too.
      const float bounded = minimum(maximum(biased, 0.0f), static_cast<float>(last));
      choice.two_levels = true;
      choice.first = static_cast<int>(std::floor(bounded));
      choice.second = std::min(choice.first + 1, last);
      choice.fraction =
          static_cast<std::uint32_t>(std::floor((bounded - static_cast<float>(choice.first)) * 256.0f));
      break;
    }
  }
  return choice;
}

Color sample_texture(const TextureUnit& unit, TexcoordKind kind, const float (&coordinates)[3], float lod,
                     SampleTrace* trace) {
  const Place place = place_of(kind, coordinates);
  const LevelChoice choice = choose_levels(unit, lod);
  const Color color = color_of(*unit.texture, sample_at(unit, choice, place, trace));
  if (trace != nullptr) {
    trace->face = place.face;
    trace->u = place.u;
    trace->v = place.v;
    trace->lod = lod + unit.lod_bias;
    trace->magnified = choice.magnified;
    trace->far_weight = static_cast<float>(choice.fraction) * (1.0f / 256.0f);
    trace->color = color;
  }
  return color;
}

}  // namespace barrido::raster::reference
