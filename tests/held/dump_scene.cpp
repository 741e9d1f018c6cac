// What Barrido makes of scenes before it draws them, for the second implementation in Python to compare with
// its own.
//
// usage: dump_scene CALLS      a file; each line a JSON list of the words of a call of `barrido render`
//
// Prints a line of JSON a call: {"frames": [...]}, or {"error": "..."} where the call is refused. A frame is
// its name, its matrices and lights, and its draws in order, each with its state and its vertices, as the
// pipeline is given them. Matrices stand column by column.
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/gltf/import_gltf.h"
#include "pipeline/scene/frame_observer.h"
#include "pipeline/scene/scene_nodes.h"
#include "viewer/barrido/frame_plan.h"
#include "viewer/barrido/render_options.h"

namespace {

using namespace barrido;

/// A value of JSON that is written as it is given: floats in full, and fast.
class Writer {
 public:
  void key(const char* name) {
    separate();
    text_ += '"';
    text_ += name;
    text_ += "\":";
    first_ = true;
  }
  void open(char bracket) {
    separate();
    text_ += bracket;
    first_ = true;
  }
  void close(char bracket) {
    text_ += bracket;
    first_ = false;
  }
  void number(double value) {
    separate();
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", value);
    text_ += digits;
  }
  void string(const std::string& value) {
    separate();
    text_ += nlohmann::json(value).dump();
  }
  void list(std::span<const float> values) {
    open('[');
    for (const float value : values) number(value);
    close(']');
  }
  template <typename Value>
  void field(const char* name, const Value& value) {
    key(name);
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      number(static_cast<double>(value));
    } else {
      list(value);
    }
  }
  const std::string& text() const { return text_; }

 private:
  void separate() {
    if (!first_) text_ += ',';
    first_ = false;
  }

  std::string text_;
  bool first_ = true;
};

template <typename Vector>
std::span<const float> floats(const Vector& vector) {
  return {&vector[0], static_cast<std::size_t>(vector.length())};
}

std::span<const float> floats(const glm::mat4& matrix) { return {&matrix[0][0], 16}; }

void write_attribute(Writer& out, const char* name, const pipeline::Attribute& attribute,
                     std::uint32_t count) {
  if (attribute.data == nullptr) return;
  out.key(name);
  out.open('[');
  for (std::uint32_t i = 0; i < count; ++i) {
    const float* element = attribute.data + std::size_t{i} * static_cast<std::size_t>(attribute.stride);
    for (int c = 0; c < attribute.components; ++c) out.number(element[c]);
  }
  out.close(']');
}

void write_geometry(Writer& out, const pipeline::Geometry& geometry) {
  out.field("mode", geometry.mode);
  out.field("vertex_count", geometry.vertex_count);
  write_attribute(out, "position", geometry.position, geometry.vertex_count);
  write_attribute(out, "normal", geometry.normal, geometry.vertex_count);
  write_attribute(out, "color", geometry.color, geometry.vertex_count);
  out.field("constant_color", floats(geometry.constant_color));
  out.key("indices");
  out.open('[');
  for (const std::uint32_t index : geometry.indices) out.number(index);
  out.close(']');
}

void write_light(Writer& out, const pipeline::Light& light) {
  out.open('{');
  out.field("diffuse", floats(light.diffuse));
  out.field("specular", floats(light.specular));
  out.field("position", floats(light.position));
  out.field("spot_direction", floats(light.spot_direction));
  out.field("spot_exponent", light.spot_exponent);
  out.field("spot_cutoff_deg", light.spot_cutoff_deg);
  const float attenuation[] = {light.constant_attenuation, light.linear_attenuation,
                               light.quadratic_attenuation};
  out.field("attenuation", attenuation);
  out.field("spot_inner_cos", light.spot_inner_cos);
  out.field("spot_outer_cos", light.spot_outer_cos);
  out.field("range", light.range);
  out.close('}');
}

void write_lights(Writer& out, const std::vector<pipeline::Light>& lights) {
  out.key("lights");
  out.open('[');
  for (const pipeline::Light& light : lights) write_light(out, light);
  out.close(']');
}

void write_units(Writer& out, const pipeline::State& state, const pipeline::Geometry& geometry) {
  out.key("units");
  out.open('[');
  for (std::size_t i = 0; i < state.texture_units.size(); ++i) {
    const raster::TextureUnit& unit = state.texture_units[i];
    if (unit.texture == nullptr) continue;
    out.open('{');
    out.field("generated", state.texture_coordinates[i].generation[0].enabled);
    out.field("matrix", floats(state.texture_coordinates[i].matrix));
    out.field("env_mode", unit.env_mode);
    out.field("env_color", unit.env_color);
    out.field("min_filter", unit.min_filter);
    out.field("mag_filter", unit.mag_filter);
    const float wraps[] = {static_cast<float>(unit.texture->options().wrap_s),
                           static_cast<float>(unit.texture->options().wrap_t)};
    out.field("wraps", wraps);
    const std::array<float, 4> texel = unit.texture->texel(0, 0, 0, 0);
    out.field("texel", texel);
    write_attribute(out, "texcoord", geometry.texcoord[i], geometry.vertex_count);
    out.close('}');
  }
  out.close(']');
}

void write_state(Writer& out, const pipeline::State& state) {
  out.field("eye_from_object", floats(state.eye_from_object));
  out.field("clip_from_eye", floats(state.clip_from_eye));
  out.field("normalize", state.normalize);
  out.field("shade_model", state.shade_model);
  out.field("cull_face", state.cull_face);
  out.field("front_face", state.front_face);
  out.field("lit", state.lighting.enabled);
  out.field("local_viewer", state.lighting.local_viewer);
  out.field("two_sided", state.lighting.two_sided);
  out.field("color_material", state.lighting.color_material);
  out.field("scene_ambient", floats(state.lighting.ambient));
  out.field("ambient", floats(state.lighting.front.ambient));
  out.field("diffuse", floats(state.lighting.front.diffuse));
  out.field("specular", floats(state.lighting.front.specular));
  out.field("emission", floats(state.lighting.front.emission));
  out.field("shininess", state.lighting.front.shininess);
  out.field("alpha_test", state.alpha_test.enabled);
  out.field("alpha_reference", state.alpha_test.reference);
  out.field("blend", state.blend.enabled);
  out.field("sorted", state.sorted);
  out.field("depth_write", state.depth.write);
  out.field("fog", state.fog.enabled);
  out.field("fog_color", state.fog.color);
  out.field("line_width", state.line_width);
  out.field("point_size", state.point_size);
  write_lights(out, state.lighting.lights);
}

/// Writes the frame, which is not drawn then.
class DumpFrame : public scene::FrameObserver {
 public:
  explicit DumpFrame(Writer& out) : out_(out) {}

  bool observe(const scene::ObservedFrame& frame) override {
    out_.field("eye_from_world", floats(frame.view.eye_from_world));
    out_.field("clip_from_eye", floats(frame.view.clip_from_eye));
    out_.field("clear_color", frame.assembled.clear.color);
    out_.field("exposure_scale", frame.options.display.exposure_scale);
    out_.field("tone_map", frame.options.display.tone_map);
    out_.field("ambient", floats(frame.lights.ambient));
    write_lights(out_, frame.lights.lights);
    out_.key("draws");
    out_.open('[');
    for (std::size_t i = 0; i < frame.origins.size(); ++i)
      write_draw(frame.origins[i], frame.assembled.draws[i]);
    out_.close(']');
    return false;
  }

 private:
  void write_draw(const scene::DrawOrigin& origin, const pipeline::AssembledDraw& draw) {
    out_.open('{');
    out_.field("backdrop", origin.backdrop);
    out_.field("node", origin.node);
    out_.field("mesh", origin.mesh);
    out_.field("primitive", origin.primitive);
    out_.field("material", origin.material);
    write_state(out_, draw.state);
    write_geometry(out_, draw.geometry);
    write_units(out_, draw.state, draw.geometry);
    out_.close('}');
  }

  Writer& out_;
};

void write_frames(Writer& out, const cli::RenderOptions& options, const std::string& path) {
  scene::ImportOptions import;
  import.image_roles = cli::kDrawnImages;
  const scene::Scene scene = scene::import_gltf(path, import);
  scene::SceneRenderer renderer(scene);
  const scene::RenderSettings settings = cli::resolved_settings(options);
  const int root = scene::resolve_scene_index(scene, settings.scene_index);
  const auto cameras = scene::camera_nodes(scene, scene::nodes_of_scene(scene, root));
  const cli::FileFacts facts{path, static_cast<int>(cameras.size()),
                             static_cast<int>(scene.animations.size())};
  for (const cli::PlannedFrame& frame : cli::plan_frames(options, facts)) {
    out.open('{');
    out.key("name");
    out.string(frame.output);
    out.key("label");
    out.string(frame.label);
    DumpFrame dump(out);
    renderer.render(cli::settings_of(settings, frame), nullptr, &dump);
    out.close('}');
  }
}

std::string dumped(const std::vector<std::string>& words) {
  Writer out;
  out.open('{');
  try {
    Writer frames;
    const cli::RenderOptions options = cli::parse_render_options(words);
    frames.key("frames");
    frames.open('[');
    for (const std::string& path : options.files) write_frames(frames, options, path);
    frames.close(']');
    return "{" + frames.text() + "}";
  } catch (const std::exception& error) {
    out.key("error");
    out.string(error.what());
  }
  out.close('}');
  return out.text();
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 2;
  std::ifstream calls(words[1]);
  if (!calls) return 2;
  for (std::string line; std::getline(calls, line);) {
    std::cout << dumped(nlohmann::json::parse(line).get<std::vector<std::string>>()) << '\n';
  }
  return 0;
}
