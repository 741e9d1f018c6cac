// Frames through three stages: drawn one after another in order, encoded beside that on other threads, and
// delivered in order. At most a given number is under way, so memory is bounded however many there are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/pictures/image_io.h"
#include "raster/tiles/framebuffer.h"
#include "viewer/barrido/cost_report.h"
#include "viewer/barrido/frame_plan.h"

namespace barrido::cli {

/// A frame on its way from the renderer to its file.
struct FrameInFlight {
  const PlannedFrame* plan = nullptr;
  std::optional<raster::Framebuffer> framebuffer;
  std::vector<std::uint8_t> encoded;  ///< PNG or bare pixels, where it goes to standard output.
  std::optional<scene::AnimationFrame> of_animation;  ///< Where it goes into one.
  FrameCost cost;
  std::exception_ptr error;  ///< Set when a stage failed; later stages pass the frame on.
};

/// The frame's colours as a picture to be written; the framebuffer must outlive it.
scene::ImageView view_of(const raster::Framebuffer& framebuffer);

/// SHA-256 of the 8-bit RGBA pixels, top row first, as 64 lower-case hexadecimal digits.
std::string pixel_hash(const raster::Framebuffer& framebuffer);

struct FrameStages {
  std::function<void(std::size_t index, FrameInFlight&)> draw;  ///< In order, one at a time.
  std::function<void(FrameInFlight&)> encode;                   ///< On any thread, several at a time.
  std::function<void(FrameInFlight&)> deliver;                  ///< In order, one at a time.
};

/// Runs frames 0 … count − 1 with at most `in_flight` (≥ 1) at once.
/// @throws what the first frame, in order, that failed threw; the frames before it have been delivered.
void run_frames(std::size_t count, std::size_t in_flight, const FrameStages& stages);

/// How many frames of so many bytes may be in flight: enough for the threads, few enough for memory.
std::size_t frames_in_flight(std::size_t frame_bytes, int threads);

}  // namespace barrido::cli
