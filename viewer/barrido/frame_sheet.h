// All frames of a call in one labelled picture (--sheet): frames are kept as they are delivered and composed
// at the end.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "raster/tiles/framebuffer.h"

namespace barrido::cli {

class FrameSheet {
 public:
  /// Keeps a frame under its label. @throws scene::InputError when the sheet grows larger than a picture can
  /// be.
  void add(const std::string& label, raster::Framebuffer&& framebuffer);

  /// Composes and writes; `name` "-" is standard output. `columns` 0: chosen by the number of frames.
  /// @throws scene::InputError.
  void write(const std::string& name, int columns, int png_compression) const;

 private:
  struct Entry {
    std::string label;
    raster::Framebuffer framebuffer;
  };
  std::vector<Entry> entries_;
  std::size_t pixels_ = 0;
};

/// Columns that put what varies fastest (`inner` of `frames` frames) side by side, one row for each of the
/// rest; 0 when there would be one row only, or too many columns to be seen.
int sheet_columns(std::size_t frames, std::size_t inner);

}  // namespace barrido::cli
