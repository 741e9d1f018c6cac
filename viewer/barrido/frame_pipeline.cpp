#include "viewer/barrido/frame_pipeline.h"

#include <algorithm>
#include <memory>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "viewer/sheet/sha256.h"

namespace barrido::cli {
namespace {

using Token = std::shared_ptr<FrameInFlight>;

template <class Stage>
void guarded(FrameInFlight& frame, const Stage& stage) {
  if (frame.error) return;
  try {
    stage();
  } catch (...) {
    frame.error = std::current_exception();
  }
}

/// The pixels as bytes; their order in memory is R, G, B, A on every machine.
std::span<const std::uint8_t> bytes_of_colors(const raster::Framebuffer& framebuffer) {
  const auto& colors = framebuffer.color8();
  return {reinterpret_cast<const std::uint8_t*>(colors.data()), colors.size() * 4};
}

}  // namespace

scene::ImageView view_of(const raster::Framebuffer& framebuffer) {
  return {framebuffer.width(), framebuffer.height(), bytes_of_colors(framebuffer), framebuffer.color_float()};
}

std::string pixel_hash(const raster::Framebuffer& framebuffer) {
  return sheet::sha256_hex(bytes_of_colors(framebuffer));
}

void run_frames(std::size_t count, std::size_t in_flight, const FrameStages& stages) {
  std::size_t next = 0;
  const auto draw = [&](tbb::flow_control& control) -> Token {
    if (next == count) {
      control.stop();
      return nullptr;
    }
    auto frame = std::make_shared<FrameInFlight>();
    const std::size_t index = next++;
    // Isolated: while this thread waits for the frame's tiles it must not begin to encode another frame.
    tbb::this_task_arena::isolate([&] { guarded(*frame, [&] { stages.draw(index, *frame); }); });
    if (frame->error) next = count;
    return frame;
  };
  const auto encode = [&](const Token& frame) {
    guarded(*frame, [&] { stages.encode(*frame); });
    return frame;
  };
  const auto deliver = [&](const Token& frame) {
    if (frame->error) std::rethrow_exception(frame->error);
    stages.deliver(*frame);
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(in_flight, tbb::make_filter<void, Token>(filter_mode::serial_in_order, draw) &
                                        tbb::make_filter<Token, Token>(filter_mode::parallel, encode) &
                                        tbb::make_filter<Token, void>(filter_mode::serial_in_order, deliver));
}

std::size_t frames_in_flight(std::size_t frame_bytes, int threads) {
  constexpr std::size_t kBudgetBytes = std::size_t{1} << 30;
  return std::clamp<std::size_t>(kBudgetBytes / frame_bytes, 1, static_cast<std::size_t>(threads) + 2);
}

}  // namespace barrido::cli
