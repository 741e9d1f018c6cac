#include "test_stages.h"

#include <algorithm>
#include <cmath>

#include "raster/kernels/kernels.h"
#include "raster/reference/fragment.h"
#include "raster/reference/shading.h"
#include "raster/reference/trace.h"
#include "raster/tiles/tile.h"

namespace barrido::raster::testing {
namespace {

struct TestLight {
  float color[4], specular[3];
  TestLight(float x, float y, float z, bool back_facing) {
    const float side = back_facing ? -0.5f : 1.0f;
    const float length = std::sqrt((x * x + y * y) + z * z) + 1.0f;
    color[0] = side * x / length;
    color[1] = side * y / length + 0.25f;
    color[2] = z;
    color[3] = 1.0f / length;
    for (int c = 0; c < 3; ++c) specular[c] = color[c] * color[c];
  }
};

void light_batch(const FragmentStage&, TileWorkspace& workspace) {
  FragmentBatch& batch = workspace.batch;
  const float(*normal)[kBatchStride] = batch.varying + batch.state->varyings.at(Meaning::normal);
  for (int i = 0; i < batch.count; ++i) {
    const TestLight light(normal[0][i], normal[1][i], normal[2][i], batch.back_facing);
    for (int c = 0; c < 4; ++c) batch.color[c][i] = light.color[c];
    for (int c = 0; c < 3; ++c) batch.specular[c][i] = light.specular[c];
  }
}

void light_fragment(const FragmentStage&, reference::Fragment& fragment, reference::ShadingTrace*) {
  const float* n = fragment.varying + fragment.state->varyings.at(Meaning::normal);
  const TestLight light(n[0], n[1], n[2], fragment.back_facing);
  std::copy_n(light.color, 4, fragment.color.begin());
  std::copy_n(light.specular, 3, fragment.specular.begin());
}

void bend_batch(const FragmentStage&, TileWorkspace& workspace) {
  FragmentBatch& batch = workspace.batch;
  float* x = batch.varying[batch.state->varyings.at(Meaning::normal)];
  for (int i = 0; i < batch.count; ++i) x[i] = x[i] * 0.5f + 0.25f;
}

void bend_fragment(const FragmentStage&, reference::Fragment& fragment, reference::ShadingTrace* trace) {
  float& x = fragment.varying[fragment.state->varyings.at(Meaning::normal)];
  x = x * 0.5f + 0.25f;
  if (trace != nullptr) trace->notes.push_back({"bent normal x", {x}});
}

void bend_batch_by_texture(const FragmentStage& stage, TileWorkspace& workspace) {
  FragmentBatch& batch = workspace.batch;
  sample_unit(workspace, stage.unit);
  float(*normal)[kBatchStride] = batch.varying + batch.state->varyings.at(Meaning::normal);
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < batch.count; ++i) normal[c][i] = normal[c][i] * workspace.texel[c][i];
  }
}

void bend_fragment_by_texture(const FragmentStage& stage, reference::Fragment& fragment,
                              reference::ShadingTrace* trace) {
  const reference::Color texel =
      reference::unit_texel(fragment, stage.unit, trace != nullptr ? &trace->maps.emplace_back() : nullptr);
  float* normal = fragment.varying + fragment.state->varyings.at(Meaning::normal);
  for (std::size_t c = 0; c < 3; ++c) normal[c] = normal[c] * texel[c];
}

void invert_batch(const FragmentStage&, TileWorkspace& workspace) {
  for (int c = 0; c < 3; ++c) {
    float* color = workspace.batch.color[c];
    for (int i = 0; i < workspace.batch.count; ++i) color[i] = 1.0f - color[i];
  }
}

void invert_fragment(const FragmentStage&, reference::Fragment& fragment, reference::ShadingTrace*) {
  for (std::size_t c = 0; c < 3; ++c) fragment.color[c] = 1.0f - fragment.color[c];
}

std::array<float, 4> ring(float s, float t, float r) {
  const float d = std::sqrt((s * s + t * t) + r * r);
  const float light = d < 1e6f ? d - std::floor(d) : 0.5f;  // of hostile numbers, too
  return {light, 1.0f - light, 0.5f, 0.25f + 0.5f * light};
}

std::uint64_t rings_batch(const TextureUnit&, const ProcedurePoints& points, float (*texel)[kBatchStride]) {
  for (int i = 0; i < points.count; ++i) {
    const float r = points.at[2] != nullptr ? points.at[2][i] : 0.5f;
    const std::array<float, 4> color = ring(points.at[0][i], points.at[1][i], r + points.extent[0][i]);
    for (std::size_t c = 0; c < 4; ++c) texel[c][i] = color[c];
  }
  return 0;
}

std::array<float, 4> rings_fragment(const TextureUnit&, const float (&at)[3], const float (&extent)[3],
                                    reference::UnitTrace* trace) {
  const std::array<float, 4> color = ring(at[0], at[1], at[2] + extent[0]);
  if (trace != nullptr) trace->notes.push_back({"ring", {color[0]}});
  return color;
}

}  // namespace

constinit const StageKind kBendNormal{.name = "bend",
                                      .reads = set_of(Meaning::normal),
                                      .writes = set_of(Meaning::normal),
                                      .vector = bend_batch,
                                      .scalar = bend_fragment,
                                      .story = "bends the normal",
                                      .clock = Stage::illumination};

constinit const StageKind kBendByTexture{.name = "bend by texture",
                                         .reads = set_of(Meaning::normal, Meaning::texcoord),
                                         .writes = set_of(Meaning::normal),
                                         .vector = bend_batch_by_texture,
                                         .scalar = bend_fragment_by_texture,
                                         .story = "multiplies the normal by a texel"};

constinit const StageKind kTestLight{.name = "test light",
                                     .reads = set_of(Meaning::normal),
                                     .writes = set_of(Meaning::color, Meaning::specular),
                                     .vector = light_batch,
                                     .scalar = light_fragment,
                                     .story = "makes colours of the normal",
                                     .clock = Stage::illumination};

constinit const StageKind kInvert{.name = "invert",
                                  .reads = set_of(Meaning::color),
                                  .writes = set_of(Meaning::color),
                                  .vector = invert_batch,
                                  .scalar = invert_fragment,
                                  .story = "takes the colour from white",
                                  .clock = Stage::write};

constinit const TextureProcedure kRings2{"rings", 2, rings_batch, rings_fragment, "rings on a plane"};
constinit const TextureProcedure kRings3{"rings", 3, rings_batch, rings_fragment, "rings in space"};

}  // namespace barrido::raster::testing
