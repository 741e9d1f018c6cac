#include "tests/unit/viewer/tiny_models.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "pipeline/pictures/image_io.h"
#include "tests/unit/viewer/program.h"

namespace barrido::test {
namespace {

using Json = nlohmann::json;

constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool padding = i + k > bytes.size();
      text += padding ? '=' : kDigits[group >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

/// Grows a buffer, with one view and one accessor for each array.
class Builder {
 public:
  Builder() {
    json["asset"] = {{"version", "2.0"}, {"generator", "tiny models"}};
    json["scene"] = 0;
  }

  int add_floats(const std::vector<float>& values, const std::string& type, int components) {
    const int view = add_view(values.data(), values.size() * sizeof(float));
    Json accessor{{"bufferView", view},
                  {"componentType", kFloat},
                  {"type", type},
                  {"count", values.size() / static_cast<std::size_t>(components)}};
    std::vector<float> least(values.begin(), values.begin() + components), most = least;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t c = i % static_cast<std::size_t>(components);
      least[c] = std::min(least[c], values[i]);
      most[c] = std::max(most[c], values[i]);
    }
    accessor["min"] = least;
    accessor["max"] = most;
    return add("accessors", accessor);
  }

  int add_indices(const std::vector<std::uint32_t>& indices) {
    const int view = add_view(indices.data(), indices.size() * sizeof(std::uint32_t));
    return add("accessors", {{"bufferView", view},
                             {"componentType", kUnsignedInt},
                             {"type", "SCALAR"},
                             {"count", indices.size()}});
  }

  int add_view(const void* data, std::size_t size) {
    const Json view{{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", size}};
    buffer.append(static_cast<const char*>(data), size);
    buffer.append((4 - buffer.size() % 4) % 4, '\0');
    return add("bufferViews", view);
  }

  int add(const char* list, const Json& entry) {
    json[list].push_back(entry);
    return static_cast<int>(json[list].size()) - 1;
  }

  void write_gltf(const std::filesystem::path& path) {
    json["buffers"] = {
        {{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    write_text(path, json.dump(1));
  }

  void write_glb(const std::filesystem::path& path) {
    json["buffers"] = {{{"byteLength", buffer.size()}}};
    std::string text = json.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    const std::size_t total = 12 + 8 + text.size() + 8 + buffer.size();
    write_text(path, word(0x46546c67) + word(2) + word(total) + word(text.size()) + word(0x4e4f534a) + text +
                         word(buffer.size()) + word(0x004e4942) + buffer);
  }

  Json json;
  std::string buffer;

 private:
  static std::string word(std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
    return bytes;
  }
};

int add_square(Builder& builder) {
  const int positions = builder.add_floats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3", 3);
  const int indices = builder.add_indices({0, 1, 2, 0, 2, 3});
  const int material = builder.add(
      "materials",
      {{"name", "red"},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {0.8, 0.1, 0.1, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.4}}}});
  return builder.add(
      "meshes",
      {{"name", "square"},
       {"primitives",
        {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}, {"material", material}}}}});
}

/// Noise that is the same everywhere.
std::vector<std::uint8_t> noise(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  std::uint32_t state = 12345;
  for (std::uint8_t& byte : bytes) {
    state = state * 1664525u + 1013904223u;
    byte = static_cast<std::uint8_t>(state >> 24);
  }
  return bytes;
}

int add_noisy_material(Builder& builder) {
  constexpr int kSide = 16;
  std::vector<std::uint8_t> pixels = noise(kSide * kSide * 4);
  for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
  const auto png = scene::encode_png({kSide, kSide, pixels, {}});
  const int view = builder.add_view(png.data(), png.size());
  const int image =
      builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}, {"name", "noise"}});
  const int texture = builder.add("textures", {{"source", image}});
  return builder.add(
      "materials",
      {{"pbrMetallicRoughness",
        {{"baseColorTexture", {{"index", texture}}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.5}}}});
}

}  // namespace

void write_square(const std::filesystem::path& path) {
  Builder builder;
  builder.json["nodes"] = {{{"mesh", add_square(builder)}}};
  builder.json["scenes"] = {{{"nodes", {0}}}};
  builder.write_gltf(path);
}

void write_animated(const std::filesystem::path& path) {
  Builder builder;
  const int mesh = add_square(builder);
  const Json lens{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}};
  Json front = lens, side = lens;
  front["name"] = "front";
  side["name"] = "side";
  builder.json["cameras"] = {front, side};
  builder.json["nodes"] = {{{"mesh", mesh}, {"name", "moving"}},
                           {{"mesh", mesh}, {"translation", {0, 0, -2}}},
                           {{"camera", 0}, {"translation", {0, 0, 6}}},
                           {{"camera", 1}, {"translation", {3, 0, 6}}}};
  builder.json["scenes"] = {{{"nodes", {0, 1, 2, 3}}}};
  const int times = builder.add_floats({0, 1}, "SCALAR", 1);
  const int moves = builder.add_floats({0, 0, 0, 1, 0, 0}, "VEC3", 3);
  builder.json["animations"] = {
      {{"name", "slide"},
       {"samplers", {{{"input", times}, {"output", moves}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  builder.write_gltf(path);
}

void write_textured_glb(const std::filesystem::path& path, int cells) {
  Builder builder;
  std::vector<float> positions, normals, texcoords;
  std::vector<std::uint32_t> indices;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const float u = static_cast<float>(i) / static_cast<float>(cells);
      const float v = static_cast<float>(j) / static_cast<float>(cells);
      const float bump = 0.2f * static_cast<float>((i * 7 + j * 13) % 5) / 5.0f;
      positions.insert(positions.end(), {2 * u - 1, 2 * v - 1, bump});
      const glm::vec3 normal =
          glm::normalize(glm::vec3(0.4f * std::sin(u * 9), 0.4f * std::sin(v * 7), 1.0f));
      normals.insert(normals.end(), {normal.x, normal.y, normal.z});
      texcoords.insert(texcoords.end(), {u, v});
    }
  }
  const auto at = [cells](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      indices.insert(indices.end(),
                     {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  const Json attributes{{"POSITION", builder.add_floats(positions, "VEC3", 3)},
                        {"NORMAL", builder.add_floats(normals, "VEC3", 3)},
                        {"TEXCOORD_0", builder.add_floats(texcoords, "VEC2", 2)}};
  const Json primitive{{"attributes", attributes},
                       {"indices", builder.add_indices(indices)},
                       {"material", add_noisy_material(builder)}};
  builder.json["meshes"] = {{{"primitives", {primitive}}}};
  builder.json["nodes"] = {{{"mesh", 0}}};
  builder.json["scenes"] = {{{"nodes", {0}}}};
  builder.write_glb(path);
}

}  // namespace barrido::test
