// A look at the headers of formats whose readers trust them too much, before those readers see the file.
// Enters: the first bytes of a file. Must not know: pixels.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pipeline/scene/image_format.h"
#include "pipeline/scene/image_io.h"

namespace barrido::scene {

/// How many bytes of a file the check wants to see.
inline constexpr std::size_t kHeaderBytes = 64;

/// Refuses BMP and TGA files with sizes outside the limits, colour maps or compression that nobody needs
/// today; other formats pass. @throws InputError naming `name`.
void check_header(std::span<const std::uint8_t> bytes, const FormatTraits& format, const std::string& name,
                  const ImageLimits& limits);

}  // namespace barrido::scene
