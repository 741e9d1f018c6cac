// The stages that a draw's plan lists: light has its facts, what they read is laid out, and a stage that
// weakens lights is heard by either light.
#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "drawn.h"
#include "pipeline/fragment_shading.h"
#include "raster/reference/fragment.h"
#include "raster/tiles/tile.h"

namespace barrido::pipeline {
namespace {

using raster::Meaning;

const std::vector<float> kPositions{0, 0, 0, 1, 0, 0, 0, 1, 0};

State lit_state(ShadeModel model) {
  State state;
  state.shade_model = model;
  state.lighting.enabled = true;
  state.lighting.lights.resize(2);
  state.lighting.lights[1].position = {1, 2, 3, 1};
  state.lighting.front.specular = {1, 1, 1, 1};
  state.lighting.front.shininess = 3.0f;
  state.clamp_colors = false;
  return state;
}

TEST(PlanStages, LightsHaveAllTheirFacts) {
  for (const raster::StageKind* kind : {&kPhongLight, &kCheapPhongLight}) {
    EXPECT_FALSE(kind->name.empty());
    EXPECT_NE(kind->reads, 0u);
    EXPECT_NE(kind->writes & set_of(Meaning::color), 0u);
    EXPECT_NE(kind->vector, nullptr);
    EXPECT_NE(kind->scalar, nullptr);
    EXPECT_FALSE(kind->story.empty());
    EXPECT_EQ(kind->clock, raster::Stage::illumination);
  }
}

TEST(PlanStages, WhatTheyReadIsLaidOutAndNothingElse) {
  for (const ShadingMode& mode : kShadingModes) {
    SCOPED_TRACE(mode.name);
    State state = lit_state(mode.model);
    state.fog.enabled = true;
    const Drawn drawn(state, geometry_of(kPositions));
    int floats = 0;
    for (const raster::FragmentStage& stage : drawn.plan->fragment.stages) {
      for (const raster::Varying& read : stage.reads) {
        floats += read.floats;
        if (read.floats == 0) continue;
        EXPECT_NE(stage.kind->reads & set_of(read.meaning), 0u) << stage.kind->name;
        EXPECT_EQ(drawn.plan->fragment.varyings.floats(read.meaning, read.unit), read.floats);
      }
    }
    EXPECT_EQ(drawn.plan->fragment.varyings.count, floats);
    EXPECT_EQ(raster::is_lit(drawn.plan->fragment), mode.lit.at_fragments);
  }
}

/// The first fragment as the light stage makes it, by vectors and alone.
void expect_light(const DrawPlan& plan, raster::TileWorkspace& workspace, float (&color)[4]) {
  const raster::FragmentStage& light = plan.fragment.stages.front();
  light.kind->vector(light, workspace);
  raster::reference::Fragment one;
  one.state = &plan.fragment;
  for (int v = 0; v < raster::kMaxVaryings; ++v) one.varying[v] = workspace.batch.varying[v][0];
  light.kind->scalar(light, one, nullptr);
  for (std::size_t c = 0; c < 4; ++c) {
    color[c] = workspace.batch.color[c][0];
    EXPECT_EQ(color[c], one.color[c]) << c;
  }
}

TEST(PlanStages, LightIsWeakenedByWhatAStageBeforeItSaw) {
  for (const ShadeModel model : {ShadeModel::phong, ShadeModel::cheap_phong}) {
    Drawn drawn(lit_state(model), geometry_of(kPositions));
    raster::FragmentState& state = drawn.plan->fragment;
    auto workspace = std::make_unique<raster::TileWorkspace>();
    workspace->batch.state = &state;
    workspace->batch.count = 5;
    for (auto& column : workspace->batch.varying) std::fill_n(column, raster::kBatchStride, 0.5f);
    float whole[4], half[4], none[4];
    expect_light(*drawn.plan, *workspace, whole);
    state.varyings.add_computed({Meaning::visibility, 2});
    expect_light(*drawn.plan, *workspace, half);  // the columns hold 0.5
    for (int light = 0; light < 2; ++light) {
      std::fill_n(workspace->batch.varying[state.varyings.at(Meaning::visibility) + light],
                  raster::kBatchStride, 0.0f);
    }
    expect_light(*drawn.plan, *workspace, none);
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(whole[c], half[c]);
      EXPECT_NEAR(half[c] - none[c], 0.5f * (whole[c] - none[c]), 1e-6f);
    }
  }
}

}  // namespace
}  // namespace barrido::pipeline
