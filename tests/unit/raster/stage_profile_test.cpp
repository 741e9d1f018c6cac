// The profile by stage: what is charged to whom, and that a frame charges the stages that it went through.
#include "raster/base/stage_profile.h"

#include <gtest/gtest.h>

#include <thread>

#include "raster/rasterizer.h"
#include "raster/tiles/binning.h"

namespace barrido::raster {
namespace {

void wait_a_moment() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

TEST(StageProfile, TheClockRunsForOneStageAtATime) {
  StageProfile profile;
  {
    StageClock clock(&profile, Stage::spans);
    wait_a_moment();
    EXPECT_EQ(clock.switch_to(Stage::texture), Stage::spans);
    const double spans_ms = profile.milliseconds(Stage::spans);
    EXPECT_GE(spans_ms, 2.0);
    wait_a_moment();
    EXPECT_EQ(profile.milliseconds(Stage::spans), spans_ms);
  }
  EXPECT_GE(profile.milliseconds(Stage::texture), 2.0);
  EXPECT_EQ(profile.milliseconds(Stage::write), 0.0);
}

TEST(StageProfile, AStoppedClockChargesNobody) {
  StageProfile profile;
  StageClock clock(&profile, Stage::spans);
  clock.stop();
  const double spans_ms = profile.milliseconds(Stage::spans);
  wait_a_moment();
  clock.switch_to(Stage::texture);
  clock.stop();
  EXPECT_EQ(profile.milliseconds(Stage::spans), spans_ms);
  EXPECT_EQ(profile.milliseconds(Stage::texture), 0.0);
}

TEST(StageProfile, AFrameChargesTheStagesThatItGoesThrough) {
  FramebufferOptions options;
  options.width = options.height = 64;
  Framebuffer frame(options);
  StageProfile profile;
  Rasterizer rasterizer(frame, {true, &profile});
  const FragmentState state;
  PrimitiveChunk chunk;
  chunk.state = &state;
  chunk.own_records.assign(static_cast<std::size_t>(3 * record_stride(0)), 1.0f);
  chunk.primitives.push_back({{0, 60 * 256, 0}, {0, 0, 60 * 256}, {0, 1, 2}, 0});
  rasterizer.clear({});
  rasterizer.submit(rasterizer.bin(std::move(chunk)));
  rasterizer.flush();
  for (const Stage stage : {Stage::binning, Stage::clear, Stage::spans, Stage::resolve}) {
    EXPECT_GT(profile.milliseconds(stage), 0.0) << kStageNames[static_cast<std::size_t>(stage)];
  }
  EXPECT_EQ(profile.milliseconds(Stage::vertices), 0.0);
  EXPECT_EQ(profile.milliseconds(Stage::texture), 0.0);
}

}  // namespace
}  // namespace barrido::raster
