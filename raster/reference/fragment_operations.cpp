#include "raster/reference/fragment_operations.h"

#include <bit>
#include <cmath>

namespace barrido::raster::reference {
namespace {

constexpr std::size_t kAlpha = 3;

/// Channel `c` (3: alpha) of one factor; s source, d destination, k constant colour.
float factor_of(BlendFactor factor, std::size_t c, const Color& s, const Color& d, const Color& k) {
  switch (factor) {
    case BlendFactor::zero:
      return 0.0f;
    case BlendFactor::one:
      return 1.0f;
    case BlendFactor::src_color:
      return s[c];
    case BlendFactor::one_minus_src_color:
      return 1.0f - s[c];
    case BlendFactor::dst_color:
      return d[c];
    case BlendFactor::one_minus_dst_color:
      return 1.0f - d[c];
    case BlendFactor::src_alpha:
      return s[kAlpha];
    case BlendFactor::one_minus_src_alpha:
      return 1.0f - s[kAlpha];
    case BlendFactor::dst_alpha:
      return d[kAlpha];
    case BlendFactor::one_minus_dst_alpha:
      return 1.0f - d[kAlpha];
    case BlendFactor::constant_color:
      return k[c];
    case BlendFactor::one_minus_constant_color:
      return 1.0f - k[c];
    case BlendFactor::constant_alpha:
      return k[kAlpha];
    case BlendFactor::one_minus_constant_alpha:
      return 1.0f - k[kAlpha];
    case BlendFactor::src_alpha_saturate:
      break;
  }
  return c == kAlpha ? 1.0f : minimum(s[kAlpha], 1.0f - d[kAlpha]);
}

float blend_channel(BlendEquation equation, float s, float fs, float d, float fd) {
  switch (equation) {
    case BlendEquation::add:
      return s * fs + d * fd;
    case BlendEquation::subtract:
      return s * fs - d * fd;
    case BlendEquation::reverse_subtract:
      return d * fd - s * fs;
    case BlendEquation::min:
      return minimum(s, d);
    case BlendEquation::max:
      break;
  }
  return maximum(s, d);
}

}  // namespace

bool compare(Compare how, float incoming, float stored) {
  switch (how) {
    case Compare::never:
      return false;
    case Compare::less:
      return incoming < stored;
    case Compare::equal:
      return incoming == stored;
    case Compare::less_equal:
      return incoming <= stored;
    case Compare::greater:
      return incoming > stored;
    case Compare::not_equal:
      return incoming != stored;
    case Compare::greater_equal:
      return incoming >= stored;
    case Compare::always:
      break;
  }
  return true;
}

bool is_inside_scissor(const Scissor& scissor, int x, int y) {
  if (!scissor.enabled) return true;
  const std::int64_t right = std::int64_t{scissor.x} + scissor.width;
  const std::int64_t top = std::int64_t{scissor.y} + scissor.height;
  return x >= scissor.x && x < right && y >= scissor.y && y < top;
}

Color blend_factor(BlendFactor rgb, BlendFactor alpha, const Color& source, const Color& destination,
                   const Color& constant) {
  Color factors{};
  for (std::size_t c = 0; c < 4; ++c) {
    factors[c] = factor_of(c == kAlpha ? alpha : rgb, c, source, destination, constant);
  }
  return factors;
}

Color blend(const BlendState& state, const Color& source, const Color& destination) {
  if (!state.enabled) return source;
  const Color fs = blend_factor(state.src_rgb, state.src_alpha, source, destination, state.constant);
  const Color fd = blend_factor(state.dst_rgb, state.dst_alpha, source, destination, state.constant);
  Color result{};
  for (std::size_t c = 0; c < 4; ++c) {
    result[c] = blend_channel(state.equation, source[c], fs[c], destination[c], fd[c]);
  }
  return result;
}

std::uint32_t pack_rgba8(const Color& color) {
  std::array<std::uint8_t, 4> bytes{};
  for (std::size_t c = 0; c < 4; ++c) {
    bytes[c] = static_cast<std::uint8_t>(std::nearbyint(clamp_to_unit(color[c]) * 255.0f));
  }
  return std::bit_cast<std::uint32_t>(bytes);
}

Color unpack_rgba8(std::uint32_t packed) {
  const auto bytes = std::bit_cast<std::array<std::uint8_t, 4>>(packed);
  Color color{};
  for (std::size_t c = 0; c < 4; ++c) color[c] = static_cast<float>(bytes[c]) * (1.0f / 255.0f);
  return color;
}

}  // namespace barrido::raster::reference
