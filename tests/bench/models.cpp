// The draws of a frame are taken with a scene::FrameObserver, just before Barrido would rasterize them.
// OpenGL 1.x has no float frames and decodes no sRGB, so colours are as stored, with 8 bits
// (--color-management none); flat polygons are lit at the provoking vertex, and there are at most 8 lights.
#include "tests/bench/models.h"

#include <cstdio>
#include <filesystem>
#include <map>

#include "pipeline/gltf/import_gltf.h"
#include "pipeline/scene/frame_observer.h"
#include "pipeline/scene/render_scene.h"

namespace barrido::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kPeerLights = 8;

template <class Vector>
std::vector<Vector> copy(const pipeline::Attribute& from, std::uint32_t count, Vector fallback) {
  std::vector<Vector> to;
  if (from.data == nullptr) return to;
  to.assign(count, fallback);
  for (std::uint32_t i = 0; i < count; ++i) {
    const float* element = from.data + static_cast<std::ptrdiff_t>(i) * from.stride;
    for (int c = 0; c < from.components && c < Vector::length(); ++c) to[i][c] = element[c];
  }
  return to;
}

Mesh copy(const pipeline::Geometry& from) {
  Mesh mesh;
  mesh.mode = from.mode;
  mesh.position = copy(from.position, from.vertex_count, glm::vec4(0, 0, 0, 1));
  mesh.position_components = from.position.components;
  mesh.normal = copy(from.normal, from.vertex_count, glm::vec3(0, 0, 1));
  mesh.color = copy(from.color, from.vertex_count, glm::vec4(0, 0, 0, 1));
  if (mesh.color.empty() && from.constant_color != glm::vec4(1.0f)) {
    mesh.color.assign(from.vertex_count, from.constant_color);
  }
  for (std::size_t unit = 0; unit < mesh.texcoord.size(); ++unit) {
    mesh.texcoord[unit] = copy(from.texcoord[unit], from.vertex_count, glm::vec4(0, 0, 0, 1));
    mesh.texcoord_components[unit] = from.texcoord[unit].components;
  }
  mesh.indices.assign(from.indices.begin(), from.indices.end());
  return mesh;
}

/// Copies the draws of the frame, with their textures; the frame itself is not drawn.
class DrawTaker final : public scene::FrameObserver {
 public:
  explicit DrawTaker(ScenePair& pair) : pair_(pair) {}

  bool observe(const scene::ObservedFrame& frame) override {
    pair_.width = frame.options.width;
    pair_.height = frame.options.height;
    pair_.clear = frame.assembled.clear;
    for (const pipeline::AssembledDraw& draw : frame.assembled.draws) {
      DrawCall& call = pair_.draws.emplace_back();
      call.state = draw.state;
      call.mesh = copy(draw.geometry);
      for (raster::TextureUnit& unit : call.state.texture_units) {
        if (unit.texture != nullptr) unit.texture = own(*unit.texture);
      }
    }
    return false;
  }

 private:
  const raster::Texture* own(const raster::Texture& texture) {
    const raster::Texture*& copied = copies_[&texture];
    if (copied == nullptr) {
      pair_.textures.push_back(std::make_unique<raster::Texture>(texture));
      copied = pair_.textures.back().get();
    }
    return copied;
  }

  ScenePair& pair_;
  std::map<const raster::Texture*, const raster::Texture*> copies_;
};

bool peer_can(const ScenePair& pair) {
  for (const DrawCall& draw : pair.draws) {
    if (draw.state.lighting.lights.size() > kPeerLights) return false;
  }
  return true;
}

std::vector<fs::path> model_files(const Options& options) {
  const fs::path own = BARRIDO_SOURCE_DIR "/models";
  std::vector<fs::path> files{own / "suzanne.glb", own / "teapot.glb", own / "showcase.glb"};
  const char* const others[] = {
      "MetalRoughSpheresNoTextures/glTF-Binary/MetalRoughSpheresNoTextures.glb",
      "TextureCoordinateTest/glTF-Binary/TextureCoordinateTest.glb",
  };
  for (const char* const other : others) {
    const fs::path file = fs::path(options.models) / other;
    if (fs::exists(file)) {
      files.push_back(file);
    } else {
      std::printf("left out, as it is not there: %s\n", file.c_str());
    }
  }
  return files;
}

constexpr std::pair<pipeline::ShadeModel, const char*> kShadings[] = {
    {pipeline::ShadeModel::flat, "flat"},
    {pipeline::ShadeModel::gouraud, "Gouraud"},
    {pipeline::ShadeModel::cheap_phong, "cheap Phong"},
    {pipeline::ShadeModel::phong, "Phong"},
};

}  // namespace

Table run_models(const Options& options) {
  Table table{"models", "Models, 1280x720, whole frames (colours as stored, 8 bits)", {}};
  const std::vector<fs::path> files = model_files(options);
  print_header(table);
  for (const fs::path& file : files) {
    const scene::Scene scene = scene::import_gltf(file);
    scene::SceneRenderer renderer(scene);
    for (const auto& [shading, name] : kShadings) {
      scene::RenderSettings settings;
      settings.color_management = scene::ColorManagement::none;
      settings.flat_at = pipeline::FlatAt::provoking_vertex;
      settings.shading = shading;
      ScenePair pair;
      DrawTaker taker(pair);
      renderer.render(settings, nullptr, &taker);
      Measurement row = measure(pair, options, {peer_can(pair), PeerStates::of_each_draw});
      row.id = name;
      row.title = file.stem().string();
      print_row(row);
      table.rows.push_back(std::move(row));
    }
  }
  print_total(table);
  return table;
}

}  // namespace barrido::bench
