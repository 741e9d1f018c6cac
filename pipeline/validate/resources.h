// The bytes that a document refers to: buffers, which are kept, and images, of which only the headers matter.
// Files are read under the importer's rules: below the model's folder, regular, of limited size.
#pragma once

#include <filesystem>
#include <map>

#include "pipeline/files/bytes.h"
#include "pipeline/validate/glb.h"
#include "pipeline/validate/image_probe.h"
#include "pipeline/validate/link.h"

namespace barrido::scene::validation {

class Resources {
 public:
  /// `chunks`: null for a file that is no GLB. `max_bytes`: of all files together, each counted once.
  Resources(std::filesystem::path folder, const Chunks* chunks, std::shared_ptr<const void> chunks_owner,
            std::uint64_t max_bytes);

  void load_buffers(Link& link);
  void check_images(Link& link);
  /// Textures against what their images turned out to be.
  void check_textures(Link& link);

 private:
  void load_buffer(Link& link, const Json& source, std::size_t index, const Place& place);
  void check_image(Link& link, const Json& source, std::size_t index, const Place& place);
  void check_probe(Link& link, const Json& source, const ImageProbe& probe, const Place& place);
  gltf::Content read_data_uri(Link& link, const std::string& uri, const Place& place) const;
  /// Nothing where the file is not to be read or cannot be.
  gltf::Content read_file(Link& link, const std::string& uri, const Place& place);

  std::filesystem::path folder_;
  const Chunks* chunks_;
  std::shared_ptr<const void> chunks_owner_;
  std::uint64_t bytes_left_;
  std::map<std::filesystem::path, gltf::ByteBlock> buffer_files_;
  std::map<std::filesystem::path, ImageProbe> image_files_;
  std::vector<std::string_view> image_types_;  ///< As recognized, by image; empty where it was not.
};

}  // namespace barrido::scene::validation
