// The GLB container (glTF 2.0, section 4.4): a 12-byte header, a JSON chunk, at most one binary chunk, and
// chunks of unknown type, which are skipped. All numbers are little-endian and checked against the file's
// true size.
#include "pipeline/gltf/container.h"

#include <algorithm>
#include <string>

#include "pipeline/gltf/glb_format.h"

namespace barrido::scene::gltf {
namespace {

std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// "OBJ" for model.obj, where the name is that of another kind of model.
std::string other_kind(const std::string& file) {
  std::string extension = file.substr(std::min(file.size(), file.find_last_of("./") + 1));
  for (char& c : extension) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  for (const char* kind : {"OBJ",  "FBX",  "STL",  "PLY", "DAE", "3DS", "3MF", "BLEND", "X3D",  "WRL", "USD",
                           "USDZ", "USDC", "USDA", "ABC", "LWO", "OFF", "VTK", "VTP",   "STEP", "STP"}) {
    if (extension == kind) return extension;
  }
  return {};
}

/// Returns the length that the header gives.
std::size_t check_header(Report& report, std::span<const std::uint8_t> file) {
  if (file.size() < glb::kHeaderBytes + glb::kChunkHeaderBytes)
    report.fail("GLB header", "the file is cut off");
  const std::uint32_t version = glb::read_u32(file, 4);
  if (version != 2) {
    report.fail("GLB header", "container version " + std::to_string(version) +
                                  (version == 1 ? ", of glTF 1.0," : "") + " is not supported; only 2 is");
  }
  const std::uint32_t length = glb::read_u32(file, 8);
  if (length > file.size() || length < glb::kHeaderBytes) {
    report.fail("GLB header", "gives a length of " + std::to_string(length) + " bytes, but the file has " +
                                  std::to_string(file.size()));
  }
  if (length < file.size()) {
    report.warn("the file is " + std::to_string(file.size() - length) +
                " bytes longer than its GLB header says; these are ignored");
  }
  return length;
}

Container split_glb(Report& report, std::span<const std::uint8_t> file) {
  file = file.first(check_header(report, file));
  Container container;
  std::size_t offset = glb::kHeaderBytes;
  for (std::size_t chunk = 0; offset < file.size(); ++chunk) {
    const std::string place = "GLB chunk " + std::to_string(chunk);
    if (file.size() - offset < glb::kChunkHeaderBytes) report.fail(place, "its header is cut off");
    const std::uint32_t length = glb::read_u32(file, offset);
    const std::uint32_t type = glb::read_u32(file, offset + 4);
    offset += glb::kChunkHeaderBytes;
    if (length > file.size() - offset) report.fail(place, "reaches past the end of the file");
    if (length % 4 != 0) report.fail(place, "its length is not a multiple of 4");
    if ((chunk == 0) != (type == glb::kJsonChunk)) {
      report.fail(place, chunk == 0 ? "is not JSON, as the first must be" : "is a second JSON chunk");
    }
    if (type == glb::kJsonChunk) container.json = as_text(file.subspan(offset, length));
    if (type == glb::kBinaryChunk) {
      if (chunk != 1) report.fail(place, "a binary chunk must be the second");
      container.binary_chunk = file.subspan(offset, length);
    }
    offset += length;
  }
  if (container.json.empty()) report.fail("GLB chunk 0", "is empty");
  return container;
}

}  // namespace

Container split_container(Report& report, std::span<const std::uint8_t> file) {
  if (file.empty()) report.fail("", "the file is empty");
  if (file.size() >= 4 && glb::read_u32(file, 0) == glb::kMagic) return split_glb(report, file);
  const std::string_view text = as_text(file);
  const std::size_t first =
      text.find_first_not_of(" \t\r\n\xef\xbb\xbf");  // A byte order mark may be ignored.
  if (first == std::string_view::npos || text[first] != '{') {
    const std::string other = other_kind(report.file());
    report.fail("",
                "is neither GLB (it does not begin with \"glTF\") nor JSON" +
                    (other.empty() ? "" : "; of " + other + " nothing is read, only of glTF: convert it"));
  }
  return {text, std::nullopt};
}

JsonShape check_json_depth(const Report& report, std::string_view json, int max_depth) {
  JsonShape shape;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\') ++i;  // Whatever is escaped, it does not end the string.
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == ',') {
      ++shape.values;
    } else if (c == '{' || c == '[') {
      ++shape.values;
      if (c == '{') ++shape.objects;
      if (++depth > max_depth) {
        report.fail("JSON", "arrays and objects nest deeper than " + std::to_string(max_depth) + " levels");
      }
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return shape;
}

}  // namespace barrido::scene::gltf
