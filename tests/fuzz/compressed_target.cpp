// Streams for the libraries in modules: Draco, meshoptimizer, libwebp. The first bytes say what the model
// promises of the stream behind them. Whatever comes, it is refused with InputError or gives as many numbers
// as were promised.
#include <algorithm>
#include <string>

#include "model_file.h"
#include "pipeline/gltf/import_gltf.h"
#include "pipeline/pictures/image_io.h"
#include "targets.h"

namespace barrido::fuzz {
namespace {

/// A GLB of this JSON with `stream` as its binary chunk.
std::vector<std::uint8_t> glb(std::string json, Bytes stream) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t padded = (stream.size() + 3) / 4 * 4;
  std::vector<std::uint8_t> file;
  const auto put = [&](std::size_t value) {
    for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  };
  put(0x46546c67);
  put(2);
  put(28 + json.size() + padded);
  put(json.size());
  put(0x4e4f534a);
  file.insert(file.end(), json.begin(), json.end());
  put(padded);
  put(0x004e4942);
  file.insert(file.end(), stream.begin(), stream.end());
  file.resize(file.size() + padded - stream.size());
  return file;
}

std::string text(std::size_t number) { return std::to_string(number); }

constexpr const char* kHead = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)";

void import(const std::string& json, Bytes stream) {
  static const ModelFile file;
  try {
    const scene::Scene scene = scene::import_gltf(file.write("model.glb", glb(json, stream)), small_limits());
    for (const scene::Mesh& mesh : scene.meshes) {
      for (const scene::Primitive& primitive : mesh.primitives) {
        require(primitive.positions.size() == std::size_t{3} * primitive.vertex_count,
                "positions are missing");
        for (const std::uint32_t index : primitive.indices) {
          require(index < primitive.vertex_count, "an index is too large");
        }
      }
    }
  } catch (const scene::InputError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos, error.what());
  }
}

}  // namespace

void run_draco(Bytes bytes) {
  if (bytes.size() < 6) return;
  const std::size_t points = std::max(bytes[0] + 256 * (bytes[1] % 4), 1);
  const std::size_t faces = std::max(bytes[2] + 256 * (bytes[3] % 8), 1);
  constexpr const char* kTypes[] = {"5120", "5121", "5122", "5123", "5126", "5126", "5126", "5126"};
  const Bytes stream = bytes.subspan(5);
  import(kHead +
             (R"("buffers":[{"byteLength":)" + text(stream.size()) +
              R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + text(stream.size()) +
              R"(}],"accessors":[{"componentType":5126,"type":"VEC3","count":)" + text(points) +
              R"(},{"componentType":)" + kTypes[bytes[4] % 8] + R"(,"normalized":)" +
              (bytes[4] % 8 < 4 ? "true" : "false") + R"(,"type":"VEC4","count":)" + text(points) +
              R"(},{"componentType":5125,"type":"SCALAR","count":)" + text(3 * faces) +
              R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0)" +
              (bytes[4] < 128 ? R"(,"COLOR_0":1)" : "") +
              R"(},"indices":2,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0,)" +
              R"("attributes":{"POSITION":0,"COLOR_0":1}}}}]}]})"),
         stream);
}

void run_meshopt(Bytes bytes) {
  if (bytes.size() < 4) return;
  constexpr const char* kModes[] = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
  constexpr const char* kFilters[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
  const std::size_t mode = bytes[0] % 3, filter = bytes[0] / 3 % 4;
  const std::size_t stride =
      mode == 0 ? std::max(bytes[1] % 65, 1) * std::size_t{4} : (bytes[1] % 2 + 1) * 2u;
  const std::size_t count = std::max(bytes[2] + 256 * (bytes[3] % 4), 3);
  const Bytes stream = bytes.subspan(3);
  // Attributes are read as positions of the same stride, indices as what they are.
  const std::string accessors =
      mode == 0 && stride >= 12
          ? R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":)" + text(count) + "}"
          : R"({"componentType":5126,"type":"VEC3","count":1000},{"bufferView":0,"componentType":)" +
                std::string(stride == 2 ? "5123" : "5125") + R"(,"type":"SCALAR","count":)" + text(count) +
                "}";
  import(kHead +
             (R"("buffers":[{"byteLength":)" + text(stream.size()) +
              R"(},{"byteLength":1000000}],"bufferViews":[{"buffer":1,"byteLength":)" + text(count * stride) +
              (mode == 0 && stride <= 252 ? R"(,"byteStride":)" + text(stride) : std::string()) +
              R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteLength":)" + text(stream.size()) +
              R"(,"byteStride":)" + text(stride) + R"(,"count":)" + text(count) + R"(,"mode":")" +
              kModes[mode] + R"(","filter":")" + kFilters[filter] + R"("}}}],"accessors":[)" + accessors +
              R"(],"meshes":[{"primitives":[{"mode":0,"attributes":{"POSITION":0})" +
              (accessors.find("SCALAR") != std::string::npos ? R"(,"indices":1)" : "") + "}]}]}"),
         stream);
}

void run_webp(Bytes bytes) {
  std::vector<std::uint8_t> file(bytes.begin(), bytes.end());
  if (file.size() < 16) return;
  constexpr std::string_view kRiff = "RIFF", kWebp = "WEBP";
  std::copy(kRiff.begin(), kRiff.end(), file.begin());
  std::copy(kWebp.begin(), kWebp.end(), file.begin() + 8);
  try {
    const scene::Image image = scene::decode_image(file, "picture", {4096, 1 << 18});
    require(image.rgba.size() ==
                static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4,
            "pixels are missing");
  } catch (const scene::InputError& error) {
    require(std::string_view(error.what()).starts_with("picture: "), error.what());
  }
}

}  // namespace barrido::fuzz
