// Contact sheets: pictures in a grid, each with its label, under a title. Enters: straight RGBA8 pictures and
// text. Leaves: one opaque RGBA8 picture. Must not know: scenes, files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pipeline/pictures/image_io.h"

namespace barrido::sheet {

/// One picture of a sheet. Pictures of a sheet may differ in size: each stands in the middle of its cell.
struct SheetPicture {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgba8;  ///< Straight RGBA, top row first.
  std::string label;                    ///< UTF-8; lines after the first ("\n") are set dimmer.
};

struct SheetOptions {
  std::string title;   ///< Above the pictures; empty: none.
  int columns = 0;     ///< 0: chosen so that the sheet is a little wider than high.
  int text_scale = 0;  ///< 1, 2, 4 …: height of text in units of 16 pixels; 0: from the pictures' width.
};

/// Composes a sheet on neutral dark grey; transparent pixels let the grey through.
/// @throws std::invalid_argument for no picture, or one whose bytes do not fit its size.
/// @throws InputError when the sheet would have a side over 65535 or more than 2^28 pixels.
scene::Image compose_sheet(std::span<const SheetPicture> pictures, const SheetOptions& options = {});

}  // namespace barrido::sheet
