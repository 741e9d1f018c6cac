// A look at the headers of formats whose readers trust them too much, before those readers see the file.
// Enters: the bytes of a file. Must not know: pixels.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pipeline/pictures/format.h"
#include "pipeline/pictures/image_io.h"

namespace barrido::scene {

/// Refuses BMP, TGA, TIFF and EXR files with sizes outside the limits, too many tiles, and of BMP and TGA the
/// colour maps and compressions that nobody needs today; other formats pass. @throws InputError naming
/// `name`.
void check_header(std::span<const std::uint8_t> bytes, const FormatTraits& format, const std::string& name,
                  const ImageLimits& limits);

}  // namespace barrido::scene
