// Frames through three stages: in order where it matters, beside each other where it helps, and with errors
// that stop at the same frame every time.
#include "viewer/barrido/frame_pipeline.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

struct Trace {
  std::vector<int> drawn, delivered;
};

/// Stages that only note the frame's number, kept in cost.width.
FrameStages tracing(Trace& trace) {
  FrameStages stages;
  stages.draw = [&trace](std::size_t index, FrameInFlight& frame) {
    frame.cost.width = static_cast<int>(index);
    trace.drawn.push_back(frame.cost.width);
  };
  stages.encode = [](FrameInFlight&) {};
  stages.deliver = [&trace](FrameInFlight& frame) { trace.delivered.push_back(frame.cost.width); };
  return stages;
}

std::vector<int> first(int count) {
  std::vector<int> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(i);
  return numbers;
}

TEST(FramePipeline, FramesAreDrawnAndDeliveredInOrder) {
  for (const std::size_t in_flight : {1u, 2u, 4u}) {
    Trace trace;
    FrameStages stages = tracing(trace);
    stages.encode = [](FrameInFlight& frame) {
      if (frame.cost.width % 3 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    };
    run_frames(20, in_flight, stages);
    EXPECT_EQ(trace.drawn, first(20));
    EXPECT_EQ(trace.delivered, first(20));
  }
}

TEST(FramePipeline, NoFramesAreFine) {
  Trace trace;
  run_frames(0, 2, tracing(trace));
  EXPECT_TRUE(trace.drawn.empty());
}

TEST(FramePipeline, NoMoreFramesAreAliveThanAllowed) {
  Trace trace;
  FrameStages stages = tracing(trace);
  std::atomic<int> alive = 0;
  std::atomic<int> most = 0;
  const auto draw = stages.draw;
  stages.draw = [&](std::size_t index, FrameInFlight& frame) {
    draw(index, frame);
    most = std::max<int>(most, ++alive);
  };
  stages.encode = [](FrameInFlight&) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  stages.deliver = [&](FrameInFlight&) { --alive; };
  run_frames(16, 2, stages);
  EXPECT_LE(most, 2);
}

TEST(FramePipeline, TheFirstFrameThatFailsEndsIt) {
  for (int stage = 0; stage < 3; ++stage) {
    Trace trace;
    FrameStages stages = tracing(trace);
    const auto fail = [](const FrameInFlight& frame) {
      if (frame.cost.width == 5) throw std::runtime_error("frame 5");
    };
    const auto draw = stages.draw;
    const auto deliver = stages.deliver;
    stages.draw = [&](std::size_t index, FrameInFlight& frame) {
      draw(index, frame);
      if (stage == 0) fail(frame);
    };
    stages.encode = [&](FrameInFlight& frame) {
      if (stage == 1) fail(frame);
    };
    stages.deliver = [&](FrameInFlight& frame) {
      if (stage == 2) fail(frame);
      deliver(frame);
    };
    try {
      run_frames(20, 3, stages);
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "frame 5");
    }
    EXPECT_EQ(trace.delivered, first(5)) << "stage " << stage;
    if (stage == 0) {
      EXPECT_EQ(trace.drawn, first(6));
    }
  }
}

TEST(FramePipeline, BigFramesAreFewerAtATime) {
  EXPECT_EQ(frames_in_flight(640 * 480 * 4, 4), 6u);
  EXPECT_EQ(frames_in_flight(std::size_t{16384} * 16384 * 4, 4), 1u);
}

}  // namespace
}  // namespace barrido::cli
