#include "viewer/osmesa/gl_procedures.h"

#include <iomanip>
#include <limits>
#include <sstream>

#include "raster/textures/perlin_noise.h"

namespace barrido::osmesa {
namespace {

using raster::MappingRay;
using raster::MappingSurface;
using raster::PatternKind;

/// A float that GLSL reads as the same.
std::string number(float value) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<float>::max_digits10) << std::showpoint << value;
  return text.str();
}

template <std::size_t count>
std::string vector(const std::array<float, count>& values) {
  std::string text = "vec" + std::to_string(count) + "(";
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + number(values[i]);
  return text + ")";
}

std::string permutation() {
  std::string text = "const float kPermutation[256] = float[256](";
  for (std::size_t i = 0; i < 256; ++i) {
    text += (i > 0 ? "," : "") + std::to_string(static_cast<int>(raster::kNoisePermutation[i])) + ".0";
  }
  return text + ");\n";
}

// Whole numbers as floats: GLSL 1.20 has no bits.
constexpr const char* kNoise = R"(
float hashed(float i) { return kPermutation[int(mod(i, 256.0))]; }
float slope(float hash, vec3 p) {
  float h = mod(hash, 16.0);
  float u = h < 8.0 ? p.x : p.y;
  float v = h < 4.0 ? p.y : (h == 12.0 || h == 14.0) ? p.x : p.z;
  return (mod(h, 2.0) == 0.0 ? u : -u) + (mod(floor(h / 2.0), 2.0) == 0.0 ? v : -v);
}
float noise_at(vec3 p) {
  vec3 cell = floor(p), f = p - cell;
  vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float a = hashed(cell.x) + cell.y, b = hashed(cell.x + 1.0) + cell.y;
  float aa = hashed(a) + cell.z, ab = hashed(a + 1.0) + cell.z;
  float ba = hashed(b) + cell.z, bb = hashed(b + 1.0) + cell.z;
  vec3 g = f - 1.0;
  float near = mix(mix(slope(hashed(aa), f), slope(hashed(ba), vec3(g.x, f.yz)), w.x),
                   mix(slope(hashed(ab), vec3(f.x, g.y, f.z)), slope(hashed(bb), vec3(g.xy, f.z)), w.x), w.y);
  float far = mix(mix(slope(hashed(aa + 1.0), vec3(f.xy, g.z)), slope(hashed(ba + 1.0), vec3(g.x, f.y, g.z)), w.x),
                  mix(slope(hashed(ab + 1.0), vec3(f.x, g.yz)), slope(hashed(bb + 1.0), g), w.x), w.y);
  return mix(near, far, w.z);
}
float octaves(vec3 p, float footprint, int count, float gain, bool magnitudes, float mean) {
  float finest = -1.0 - log2(max(footprint, 1e-37)), amplitude = 1.0, sum = 0.0;
  for (int i = 0; i < count; ++i) {
    float shown = smoothstep(0.3, 0.7, finest - float(i));
    if (shown > 0.0) {
      float n = noise_at(p);
      sum += amplitude * mix(mean, magnitudes ? abs(n) : n, shown);
    } else {
      sum += amplitude * mean;
    }
    p *= 2.0;
    amplitude *= gain;
  }
  return sum;
}
)";

constexpr const char* kWaves = R"(
float parity(float x, float w) {
  float at = mod(x, 2.0), edge = floor(at + 0.5);
  if (w <= 1.0) return (edge == 1.0 ? -1.0 : 1.0) * clamp(2.0 * (at - edge) / max(w, 1e-20), -1.0, 1.0);
  w = min(w, 4096.0);
  return 2.0 * (abs(fract((at - 0.5 * w) * 0.5) - 0.5) - abs(fract((at + 0.5 * w) * 0.5) - 0.5)) / w;
}
float risen(float x, float rise) {
  float f = fract(x);
  return 0.5 * floor(x) + (f < rise ? 0.5 * f * f / rise : 0.5 - 0.5 * (1.0 - f) * (1.0 - f) / (1.0 - rise));
}
float wave(float x, float w, float rise) {
  w = clamp(w, 1.0 / 64.0, 1024.0);
  x = fract(x);
  return (risen(x + 0.5 * w, rise) - risen(x - 0.5 * w, rise)) / w;
}
)";

std::string octave_sum(const raster::Pattern& pattern, bool magnitudes) {
  return "octaves(p, footprint, " + std::to_string(pattern.octaves) + ", " + number(pattern.gain) + ", " +
         (magnitudes ? "true, " + number(raster::kMeanAbsoluteNoise) : std::string("false, 0.0")) + ")";
}

std::string moved(const raster::Pattern& pattern, const std::string& place, const std::string& width,
                  float rise) {
  const std::string by = number(pattern.turbulence);
  const bool moves = pattern.turbulence != 0.0f;
  return "wave(" + place + (moves ? " + " + by + " * " + octave_sum(pattern, true) : "") + ", " + width +
         (moves ? " + abs(" + by + ") * footprint" : "") + ", " + number(rise) + ")";
}

std::string value_of(const raster::Pattern& pattern) {
  switch (pattern.kind) {
    case PatternKind::stripes:
      return "0.5 - 0.5 * parity(p.y, w.y)";
    case PatternKind::checker:
      return "0.5 - 0.5 * parity(p.x, w.x) * parity(p.y, w.y) * parity(p.z, w.z)";
    case PatternKind::noise:
      if (!pattern.has_threshold) return "0.5 + 0.5 * " + octave_sum(pattern, false);
      return "0.5 + (" + octave_sum(pattern, false) + " - " + number(pattern.threshold) +
             ") / (2.0 * max(footprint, 1e-6))";
    case PatternKind::wood:
      return moved(pattern, "length(p.xz)", "max(w.x, w.z)", raster::kWoodRise);
    case PatternKind::marble:
      break;
  }
  return moved(pattern, "p.y", "w.y", raster::kMarbleRise);
}

std::string pattern_function(const raster::TextureUnit& unit, const std::string& index) {
  const raster::Pattern& pattern = unit.pattern;
  return "vec4 pattern" + index + "(vec3 p) {\n  vec3 w = max(abs(dFdx(p)), abs(dFdy(p)));\n" +
         "  float footprint = max(max(w.x, w.y), w.z);\n" + "  return mix(" + vector(pattern.colors[0]) +
         ", " + vector(pattern.colors[1]) + ", clamp(" + value_of(pattern) + ", 0.0, 1.0));\n}\n";
}

/// Where the ray from `a` along `d` leaves the intermediate surface, and its coordinates.
constexpr const char* kSurfaces = R"(
const float kTurn = 6.28318530718;
vec2 on_plane(vec3 a, vec3 d) { vec3 q = a + d * ((sign(d.y) - a.y) / d.y); return vec2(q.x, -q.z) * 0.5 + 0.5; }
vec2 on_cylinder(vec3 a, vec3 d) {
  float l = length(d.xz), b = dot(a.xz, d.xz) / l;
  vec3 q = a + d * ((sqrt(b * b - dot(a.xz, a.xz) + 2.0) - b) / l);
  return vec2(0.5 - atan(q.x, q.z) / kTurn, q.y * 0.5 + 0.5);
}
vec2 on_sphere(vec3 a, vec3 d) {
  float l = length(d), b = dot(a, d) / l;
  vec3 q = a + d * ((sqrt(b * b - dot(a, a) + 3.0) - b) / l);
  return vec2(0.5 - atan(q.x, q.z) / kTurn, 1.0 - 2.0 * atan(length(q.xz), q.y) / kTurn);
}
vec2 on_box(vec3 a, vec3 d, bool across) {
  vec3 t = (sign(d) - a) / d, s = sign(d);
  float least = min(min(t.x, t.y), t.z);
  vec3 q = across ? d : a + d * least;
  if (t.x == least) return vec2(-s.x * q.z, q.y) * 0.5 + 0.5;
  if (t.y == least) return vec2(q.x, -s.y * q.z) * 0.5 + 0.5;
  return vec2(s.z * q.x, q.y) * 0.5 + 0.5;
}
)";

template <std::size_t count>
std::string matrix_times(const std::array<std::array<float, count>, 3>& rows,
                         const std::string& vector_text) {
  std::string text = "vec3(";
  for (std::size_t r = 0; r < 3; ++r) {
    text += std::string(r > 0 ? ", " : "") + "dot(" + vector(rows[r]) + ", " + vector_text + ")";
  }
  return text + ")";
}

std::string ray_along(const raster::Mapping& mapping) {
  if (mapping.ray == MappingRay::normal) return matrix_times(mapping.mapping_from_eye, "normal");
  return matrix_times(mapping.mapping_from_eye, "reflect(position, normalize(normal))");
}

std::string uv_of(const raster::Mapping& mapping) {
  const bool from_point = raster::needs_normal(mapping);
  const bool across = mapping.ray == MappingRay::surface;
  const std::string ray = from_point ? "p, " + ray_along(mapping) : "vec3(0.0), p";
  switch (mapping.surface) {
    case MappingSurface::planar:
      return across ? "vec2(p.x, -p.z) * 0.5 + 0.5" : "on_plane(" + ray + ")";
    case MappingSurface::cylinder:
      return across ? "on_cylinder(vec3(0.0, p.y, 0.0), vec3(p.x, 0.0, p.z))" : "on_cylinder(" + ray + ")";
    case MappingSurface::sphere:
      return "on_sphere(" + ray + ")";
    default:
      return "on_box(" + ray + (across ? ", true)" : ", false)");
  }
}

}  // namespace

std::string procedure_functions(const raster::TextureUnit& unit, const std::string& index) {
  std::string text;
  if (unit.procedure != nullptr) text += permutation() + kNoise + kWaves + pattern_function(unit, index);
  const raster::Mapping& mapping = unit.mapping;
  if (mapping.surface == MappingSurface::none) return text;
  return text + kSurfaces + "vec2 mapped" + index + "(vec3 p) {\n  vec2 uv = " + uv_of(mapping) +
         ";\n  return vec2(uv.x, 1.0 - uv.y) * " + vector(mapping.repeats) + " + " + vector(mapping.offset) +
         ";\n}\n";
}

std::string procedure_texel(const raster::TextureUnit& unit, const std::string& index,
                            const std::string& at) {
  if (unit.mapping.surface != MappingSurface::none) {
    return "pattern" + index + "(vec3(" + mapped_place(index, at) + ", 0.5))";
  }
  return "pattern" + index + "(" + at + ")";
}

std::string mapped_place(const std::string& index, const std::string& at) {
  return "mapped" + index + "(" + at + ")";
}

}  // namespace barrido::osmesa
