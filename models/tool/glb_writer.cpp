#include "models/tool/glb_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace barrido::models {
namespace {

constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kNoTarget = 0;

/// Little endian, as glTF stores numbers.
void append_word(std::vector<std::uint8_t>& bytes, std::uint32_t value, int byte_count = 4) {
  for (int i = 0; i < byte_count; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void pad_to_four(std::vector<std::uint8_t>& bytes, std::uint8_t filler) {
  while (bytes.size() % 4 != 0) bytes.push_back(filler);
}

void append_chunk(std::vector<std::uint8_t>& file, const char (&type)[5],
                  const std::vector<std::uint8_t>& data) {
  append_word(file, static_cast<std::uint32_t>(data.size()));
  for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::uint8_t>(type[i]));
  file.insert(file.end(), data.begin(), data.end());
}

template <typename Vector>
std::vector<double> flatten(const std::vector<Vector>& vectors) {
  std::vector<double> values;
  for (const Vector& v : vectors) {
    for (int i = 0; i < Vector::length(); ++i) values.push_back(v[i]);
  }
  return values;
}

}  // namespace

GlbWriter::GlbWriter(const std::string& title) {
  root_["asset"] = {{"version", "2.0"}, {"generator", "barrido-models"}};
  root_["scene"] = 0;
  root_["scenes"] = Json::array({Json{{"name", title}, {"nodes", Json::array()}}});
}

int GlbWriter::append_to(const char* array, Json element) {
  root_[array].push_back(std::move(element));
  return static_cast<int>(root_[array].size()) - 1;
}

int GlbWriter::add_buffer_view(std::span<const std::uint8_t> bytes, int target) {
  pad_to_four(binary_, 0);
  Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
  if (target != kNoTarget) view["target"] = target;
  binary_.insert(binary_.end(), bytes.begin(), bytes.end());
  return append_to("bufferViews", std::move(view));
}

int GlbWriter::add_vectors(std::span<const double> values, int components, bool with_bounds) {
  const auto width = static_cast<std::size_t>(components);
  std::vector<std::uint8_t> bytes;
  std::vector<float> lowest(width, 3.4e38f);
  std::vector<float> highest(width, -3.4e38f);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = static_cast<float>(values[i]);
    append_word(bytes, std::bit_cast<std::uint32_t>(value));
    lowest[i % width] = std::min(lowest[i % width], value);
    highest[i % width] = std::max(highest[i % width], value);
  }
  Json accessor{{"bufferView", add_buffer_view(bytes, kArrayBuffer)},
                {"componentType", kFloat},
                {"count", values.size() / width},
                {"type", "VEC" + std::to_string(components)}};
  if (with_bounds) {
    accessor["min"] = lowest;
    accessor["max"] = highest;
  }
  return append_to("accessors", std::move(accessor));
}

int GlbWriter::add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertex_count) {
  const bool is_short = vertex_count < 65536;
  std::vector<std::uint8_t> bytes;
  for (const std::uint32_t index : indices) append_word(bytes, index, is_short ? 2 : 4);
  return append_to("accessors", Json{{"bufferView", add_buffer_view(bytes, kElementArrayBuffer)},
                                     {"componentType", is_short ? kUnsignedShort : kUnsignedInt},
                                     {"count", indices.size()},
                                     {"type", "SCALAR"}});
}

int GlbWriter::add_texture(const std::string& name, std::span<const std::uint8_t> png) {
  constexpr int kLinear = 9729;
  constexpr int kLinearMipmapLinear = 9987;
  constexpr int kRepeat = 10497;
  if (!root_.contains("samplers")) {
    append_to("samplers", Json{{"magFilter", kLinear},
                               {"minFilter", kLinearMipmapLinear},
                               {"wrapS", kRepeat},
                               {"wrapT", kRepeat}});
  }
  const int image = append_to(
      "images",
      Json{{"name", name}, {"mimeType", "image/png"}, {"bufferView", add_buffer_view(png, kNoTarget)}});
  return append_to("textures", Json{{"sampler", 0}, {"source", image}});
}

int GlbWriter::add_material(Json material) { return append_to("materials", std::move(material)); }

int GlbWriter::add_mesh(const std::string& name, std::span<const Part> parts) {
  Json primitives = Json::array();
  for (const Part& part : parts) {
    const Mesh& mesh = *part.mesh;
    Json attributes{{"POSITION", add_vectors(flatten(mesh.positions), 3, true)}};
    if (!mesh.normals.empty()) attributes["NORMAL"] = add_vectors(flatten(mesh.normals), 3, false);
    if (!mesh.texcoords.empty()) attributes["TEXCOORD_0"] = add_vectors(flatten(mesh.texcoords), 2, false);
    if (!mesh.colors.empty()) attributes["COLOR_0"] = add_vectors(flatten(mesh.colors), 4, false);
    Json primitive{{"attributes", std::move(attributes)}};
    if (!mesh.indices.empty()) primitive["indices"] = add_indices(mesh.indices, mesh.positions.size());
    primitive["mode"] = static_cast<int>(mesh.mode);
    primitive["material"] = part.material;
    primitives.push_back(std::move(primitive));
  }
  return append_to("meshes", Json{{"name", name}, {"primitives", std::move(primitives)}});
}

int GlbWriter::add_mesh(const std::string& name, const Mesh& mesh, int material) {
  return add_mesh(name, std::array{Part{&mesh, material}});
}

int GlbWriter::add_light(Json light) {
  constexpr const char* kExtension = "KHR_lights_punctual";
  Json& lights = root_["extensions"][kExtension]["lights"];
  if (lights.empty()) declare_extension(kExtension);
  lights.push_back(std::move(light));
  return static_cast<int>(lights.size()) - 1;
}

int GlbWriter::add_camera(Json camera) { return append_to("cameras", std::move(camera)); }

int GlbWriter::add_node(Json node) {
  const int index = append_to("nodes", std::move(node));
  root_["scenes"][0]["nodes"].push_back(index);
  return index;
}

void GlbWriter::add_turning(int node, double seconds) {
  const double root_half = std::sqrt(0.5);
  // Quarter turns: the sines and cosines of half their angles.
  const double sine[5] = {0, root_half, 1, root_half, 0};
  const double cosine[5] = {1, root_half, 0, -root_half, -1};
  std::vector<double> times, turns;
  for (int key = 0; key < 5; ++key) {
    times.push_back(seconds * key / 4);
    turns.insert(turns.end(), {0, 0, sine[key], cosine[key]});
  }
  const auto add_values = [&](const std::vector<double>& values, int components, const char* type) {
    const int accessor = add_vectors(values, components, components == 1);
    Json& added = root_["accessors"][static_cast<std::size_t>(accessor)];
    added["type"] = type;
    root_["bufferViews"][added["bufferView"].get<std::size_t>()].erase("target");
    return accessor;
  };
  const int input = add_values(times, 1, "SCALAR");
  const int output = add_values(turns, 4, "VEC4");
  append_to("animations",
            Json{{"name", "turning"},
                 {"samplers", Json::array({Json{{"input", input}, {"output", output}}})},
                 {"channels",
                  Json::array({Json{{"sampler", 0}, {"target", {{"node", node}, {"path", "rotation"}}}}})}});
}

void GlbWriter::declare_extension(const std::string& name) { root_["extensionsUsed"].push_back(name); }

void GlbWriter::set_scene_extras(Json extras) { root_["scenes"][0]["extras"]["barrido"] = std::move(extras); }

std::vector<std::uint8_t> GlbWriter::bytes() const {
  Json root = root_;
  root["buffers"] = Json::array({Json{{"byteLength", binary_.size()}}});
  const std::string text = root.dump();
  std::vector<std::uint8_t> json(text.begin(), text.end());
  pad_to_four(json, ' ');
  std::vector<std::uint8_t> binary = binary_;
  pad_to_four(binary, 0);

  std::vector<std::uint8_t> file{'g', 'l', 'T', 'F'};
  constexpr std::uint32_t kVersion = 2;
  constexpr std::size_t kHeaderBytes = 12;
  constexpr std::size_t kChunkHeaderBytes = 8;
  append_word(file, kVersion);
  append_word(file,
              static_cast<std::uint32_t>(kHeaderBytes + 2 * kChunkHeaderBytes + json.size() + binary.size()));
  append_chunk(file, "JSON", json);
  append_chunk(file, "BIN\0", binary);
  return file;
}

Json looking_node(const std::string& name, const Vec3& position, const Vec3& target) {
  const Vec3 back = unit(position - target);
  const bool is_vertical = std::fabs(back.y) > 0.999;
  const Vec3 right = unit(glm::cross(is_vertical ? Vec3(0, 0, -1) : Vec3(0, 1, 0), back));
  const Vec3 up = glm::cross(back, right);
  Json matrix = Json::array();
  for (const Vec4& column : {Vec4(right, 0), Vec4(up, 0), Vec4(back, 0), Vec4(position, 1)}) {
    for (int i = 0; i < 4; ++i) matrix.push_back(column[i] + 0.0);  // + 0: no negative zeros in the file.
  }
  return {{"name", name}, {"matrix", std::move(matrix)}};
}

}  // namespace barrido::models
