#include "pipeline/reference/map_stages.h"

#include <algorithm>
#include <cmath>

#include "pipeline/draw_plan.h"
#include "pipeline/map_stages.h"
#include "raster/reference/shading.h"

namespace barrido::pipeline::reference {
namespace {

using raster::Meaning;
using raster::reference::Fragment;
using raster::reference::ShadingTrace;
using raster::reference::UnitTrace;

// Sums of products in the order that is written here; the C++ library and glm may choose another.
float dot(const glm::vec3& a, const glm::vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
glm::vec3 cross(const glm::vec3& a, const glm::vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr float kMinSquare = 1e-30f;
float inverse_length(float square) { return 1.0f / std::sqrt(std::max(square, kMinSquare)); }
glm::vec3 normalized(const glm::vec3& v) { return v * inverse_length(dot(v, v)); }
float positive(float value) { return value > 0.0f ? value : 0.0f; }

glm::vec3 vector_at(const Fragment& fragment, int at) {
  return {fragment.varying[at], fragment.varying[at + 1], fragment.varying[at + 2]};
}

MappedSurface surface_of(const Fragment& fragment) {
  const raster::VaryingList& varyings = fragment.state->varyings;
  MappedSurface surface;
  surface.normal = vector_at(fragment, varyings.at(Meaning::normal));
  if (!varyings.has(Meaning::tangents)) return surface;
  surface.tangent = vector_at(fragment, varyings.at(Meaning::tangents));
  surface.bitangent = vector_at(fragment, varyings.at(Meaning::tangents) + 3);
  return surface;
}

void note(UnitTrace* trace, const char* name, const glm::vec3& v) {
  if (trace != nullptr) trace->notes.push_back({name, {v.x, v.y, v.z}});
}

/// Puts the normal in place of the fragment's own.
void replace_normal(Fragment& fragment, const glm::vec3& normal, UnitTrace* trace) {
  const int at = fragment.state->varyings.at(Meaning::normal);
  note(trace, "interpolated normal", normalized(vector_at(fragment, at)));
  note(trace, "normal afterwards", normalized(normal));
  for (int axis = 0; axis < 3; ++axis) fragment.varying[at + axis] = normal[axis];
}

const raster::TextureUnit& unit_of(const raster::FragmentStage& stage, const Fragment& fragment) {
  return fragment.state->texture_units[static_cast<std::size_t>(stage.unit)];
}

/// The height beside the fragment, `step` along a coordinate.
float height_beside(const raster::FragmentStage& stage, const Fragment& fragment, int axis, float step) {
  const raster::FragmentState& state = *fragment.state;
  std::array<float, 3> shift{0, 0, 0};
  const bool divides = texcoord_kind(state, stage.unit) == raster::TexcoordKind::projective;
  const float q = fragment.varying[state.varyings.at(Meaning::texcoord, stage.unit) + 2];
  shift[static_cast<std::size_t>(axis)] = divides ? q * step : step;
  const raster::reference::Color texel = raster::reference::unit_texel(fragment, stage.unit, nullptr, shift);
  return ((texel[0] + texel[1]) + texel[2]) * (1.0f / 3.0f);
}

}  // namespace

glm::vec3 mapped_normal(const MappedSurface& surface, const glm::vec3& texel, float strength) {
  const float x = ((texel.x + texel.x) - 1.0f) * strength;
  const float y = ((texel.y + texel.y) - 1.0f) * strength;
  const float z = (texel.z + texel.z) - 1.0f;
  return (surface.tangent * x + surface.bitangent * y) + surface.normal * z;
}

glm::vec3 tilted_normal(const MappedSurface& surface, raster::BumpForm form, float slope_u, float slope_v) {
  const glm::vec3 n = normalized(surface.normal);
  const glm::vec3 &pu = surface.tangent, &pv = surface.bitangent;
  glm::vec3 d = cross(n, pv) * slope_u - cross(n, pu) * slope_v;
  float area = dot(cross(pu, pv), n);
  if (area < 0.0f) {  // the coordinates run the other way round: P_u × P_v points inwards
    d = -d;
    area = -area;
  }
  if (form == raster::BumpForm::blinn) return n * area + d;
  const float a = std::sqrt(slope_u * slope_u + slope_v * slope_v);
  return n + d * (a * inverse_length(dot(d, d)));
}

glm::vec3 tilted_normal(const glm::vec3& normal, raster::BumpForm form, const glm::mat3& eye_gradient,
                        const glm::vec3& slopes) {
  const glm::vec3 n = normalized(normal);
  const glm::vec3 g = (eye_gradient[0] * slopes.x + eye_gradient[1] * slopes.y) + eye_gradient[2] * slopes.z;
  const glm::vec3 along_surface = g - n * dot(n, g);
  if (form == raster::BumpForm::blinn) return n - along_surface;
  // The normal among the coordinates themselves, whatever the size of the object.
  const glm::vec3 own =
      normalized({dot(eye_gradient[0], n), dot(eye_gradient[1], n), dot(eye_gradient[2], n)});
  const float off = dot(slopes, own);
  const float a = std::sqrt(positive(dot(slopes, slopes) - off * off));
  return n - along_surface * (a * inverse_length(dot(along_surface, along_surface)));
}

void map_normal(const raster::FragmentStage& stage, Fragment& fragment, ShadingTrace* trace) {
  UnitTrace* remembered = trace != nullptr ? &trace->maps.emplace_back() : nullptr;
  const raster::reference::Color texel = raster::reference::unit_texel(fragment, stage.unit, remembered);
  const MappedSurface surface = surface_of(fragment);
  note(remembered, "tangent", surface.tangent);
  note(remembered, "bitangent", surface.bitangent);
  replace_normal(fragment,
                 mapped_normal(surface, {texel[0], texel[1], texel[2]}, unit_of(stage, fragment).strength),
                 remembered);
}

void bump_normal(const raster::FragmentStage& stage, Fragment& fragment, ShadingTrace* trace) {
  UnitTrace* remembered = trace != nullptr ? &trace->maps.emplace_back() : nullptr;
  if (remembered != nullptr) raster::reference::unit_texel(fragment, stage.unit, remembered);
  const raster::TextureUnit& unit = unit_of(stage, fragment);
  const raster::TexcoordKind kind = texcoord_kind(*fragment.state, stage.unit);
  const BumpSteps steps = bump_steps(unit, kind);
  glm::vec3 slopes(0.0f);
  for (int axis = 0; axis < steps.axes; ++axis) {
    const float above = height_beside(stage, fragment, axis, steps.step[axis]);
    const float below = height_beside(stage, fragment, axis, -steps.step[axis]);
    slopes[axis] = (above - below) * steps.scale[axis];
  }
  note(remembered, "slopes", slopes);
  const MappedSurface surface = surface_of(fragment);
  const auto& plan = *static_cast<const DrawPlan*>(stage.parameters);
  replace_normal(fragment,
                 is_flat(kind) ? tilted_normal(surface, unit.bump_form, slopes.x, slopes.y)
                               : tilted_normal(surface.normal, unit.bump_form, plan.eye_gradient, slopes),
                 remembered);
}

void map_occlusion(const raster::FragmentStage& stage, Fragment& fragment, ShadingTrace* trace) {
  UnitTrace* remembered = trace != nullptr ? &trace->maps.emplace_back() : nullptr;
  const float red = raster::reference::unit_texel(fragment, stage.unit, remembered)[0];
  const float share = (red - 1.0f) * unit_of(stage, fragment).strength + 1.0f;
  fragment.varying[fragment.state->varyings.at(Meaning::occlusion)] = share;
  if (remembered != nullptr) remembered->notes.push_back({"share of the ambient light", {share}});
}

}  // namespace barrido::pipeline::reference
