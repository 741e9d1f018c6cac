// Any picture file to pixels, as its file holds them.
#pragma once

#include <filesystem>

#include "pipeline/pictures/image_io.h"
#include "pipeline/pictures/module.h"
#include "pipeline/pictures/stored_picture.h"

namespace barrido::scene {

/// Reads a regular file of any format that is read. Bytes are sRGB as a rule, floats linear.
/// @throws InputError.
Picture read_picture(const std::filesystem::path& path, const ImageLimits& limits = {});

/// Reads the same files for comparisons. @throws InputError.
StoredPicture read_stored_picture(const std::filesystem::path& path, const ImageLimits& limits = {});

}  // namespace barrido::scene
