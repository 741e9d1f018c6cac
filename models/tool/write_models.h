// Everything of models/ that the tool makes, into a folder.
#pragma once

#include <filesystem>

namespace barrido::models {

struct WriteOptions {
  std::filesystem::path folder;    ///< Where the GLB files, textures/ and sky/ go; made when missing.
  std::filesystem::path textures;  ///< Not empty: embed the PNG files found here, not the new ones.
  int teapot_cells = 10;           ///< Cells along each side of a teapot's patch.
};

/// Draws the pictures and builds the scenes. The same bytes every time and everywhere, but for the
/// compression of the pictures, which is zlib's and may change with its version; hence `textures`.
/// @throws std::runtime_error naming the file that cannot be read or written.
void write_models(const WriteOptions& options);

}  // namespace barrido::models
