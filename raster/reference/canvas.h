// The frame while it is drawn: one colour, in the precision of the frame's format, and one depth a pixel.
// Leaves a Framebuffer. Knows nothing of primitives.
#pragma once

#include <map>
#include <vector>

#include "raster/fragments/fragment_state.h"
#include "raster/reference/arithmetic.h"
#include "raster/reference/trace.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::raster::reference {

class Canvas {
 public:
  Canvas(const FramebufferOptions& options, const ClearValues& clear);

  /// Alpha test, depth test, blending, masks and storing, at window coordinates (x, y) inside the frame. What
  /// happened is remembered in `trace` unless that is null.
  void apply(const FragmentState& state, int x, int y, const Color& color, float depth,
             FateTrace* trace = nullptr);

  /// Blends the fragments that wait to be sorted; their traces must still be there.
  void finish();
  /// FateTrace::turn of the last fragment that reached the frame.
  int turn() const { return turn_; }

  /// The pixel as it is now.
  const Color& color(int x, int y) const { return color_[index(x, y)]; }
  float depth(int x, int y) const { return depth_[index(x, y)]; }

  /// Writes the 8-bit picture, and float colours and depth where the framebuffer keeps them.
  void store(Framebuffer& framebuffer) const;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(options_.width) +
           static_cast<std::size_t>(x);
  }
  /// A fragment that waits for what else is in its pixel.
  struct Layer {
    const FragmentState* state;
    Color color;
    float depth;
    FateTrace* trace;
  };

  void add_layer(std::size_t pixel, const Layer& layer);
  void blend_layers(std::size_t pixel);
  void write(const FragmentState& state, std::size_t pixel, const Color& color, FateTrace& fate);
  Color stored_color(Color color) const;
  Color incoming_color(Color color) const;

  FramebufferOptions options_;
  std::vector<Color> color_;  ///< Bottom row first; rgba8: multiples of 1/255 as read back from bytes.
  std::vector<float> depth_;
  std::map<std::size_t, std::vector<Layer>> layers_;  ///< By pixel, in the order of drawing.
  int turn_ = 0;
};

}  // namespace barrido::raster::reference
