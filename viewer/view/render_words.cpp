#include "viewer/view/render_words.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "viewer/barrido/text_format.h"

namespace barrido::view {
namespace {

using cli::RenderOptions;
using cli::shortest;

std::string triple(const glm::vec3& v) { return shortest(v.x) + "," + shortest(v.y) + "," + shortest(v.z); }

std::string shortest_double(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

/// The name at the value's place; names stand in the order of the enumeration.
template <class Value, std::size_t Count>
std::string name_at(Value value, const std::array<const char*, Count>& names) {
  return names.at(static_cast<std::size_t>(value));
}

class WordWriter {
 public:
  void flag(const char* name, bool on) {
    if (on) words_.emplace_back(name);
  }
  void value(const char* name, const std::string& text) {
    words_.emplace_back(name);
    words_.push_back(text);
  }
  /// The name of `chosen` when it is not the default.
  template <class Value, std::size_t Count>
  void choice(const char* name, Value chosen, Value standard, const std::array<const char*, Count>& names) {
    if (chosen != standard) value(name, name_at(chosen, names));
  }
  template <class Value, std::size_t Count>
  void choice(const char* name, const std::optional<Value>& chosen,
              const std::array<const char*, Count>& names) {
    if (chosen) value(name, name_at(*chosen, names));
  }
  std::vector<std::string> take() { return std::move(words_); }

 private:
  std::vector<std::string> words_;
};

std::string list_text(const std::vector<int>& numbers, int offset) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ",") + std::to_string(number + offset);
  return text;
}

void write_shading(WordWriter& out, const RenderOptions& o) {
  const scene::RenderSettings& s = o.settings;
  std::string shadings;
  for (const pipeline::ShadeModel shading : o.shadings) {
    shadings += (shadings.empty() ? "" : ",") + std::string(cli::name_of(shading));
  }
  if (shadings != "phong") out.value("--shading", shadings);
  const scene::RenderSettings d;
  out.choice("--flat-at", s.flat_at, d.flat_at, std::array{"provoking", "centroid"});
  out.choice("--cheap-phong-power", s.cheap_phong_power, d.cheap_phong_power, std::array{"pixel", "vertex"});
  out.choice("--lighting", s.lighting, d.lighting, std::array{"blinn", "phong"});
  out.choice("--color-interpolation", s.color_interpolation, d.color_interpolation,
             std::array{"perspective", "screen"});
  if (s.crease_angle_deg) out.value("--crease-angle", shortest(*s.crease_angle_deg));
  out.choice("--cull", s.cull, std::array{"none", "back", "front"});
  out.flag("--wireframe", s.wireframe);
  out.flag("--edges", s.overlays.edges);
  out.flag("--normals", s.overlays.normals);
  const std::string material = material_text(s.material);
  if (!material.empty()) out.value("--material", material);
  if (o.fog) out.value("--fog", fog_text(*o.fog));
}

void write_textures(WordWriter& out, const RenderOptions& o) {
  const scene::RenderSettings& s = o.settings;
  const scene::RenderSettings d;
  out.flag("--no-textures", !s.textures);
  out.choice("--texture-interpolation", s.texture_interpolation, d.texture_interpolation,
             std::array{"perspective", "affine"});
  out.choice("--min-filter", s.min_filter,
             std::array{"nearest", "linear", "nearest-mipmap-nearest", "linear-mipmap-nearest",
                        "nearest-mipmap-linear", "linear-mipmap-linear"});
  out.choice("--mag-filter", s.mag_filter, std::array{"nearest", "linear"});
  if (s.dynamic_environment) {
    out.value("--environment", "dynamic");
  } else if (!o.environment_path.empty()) {
    out.value("--environment", o.environment_path);
  }
}

void write_lights(WordWriter& out, const scene::RenderSettings& s) {
  for (const scene::UserLight& light : s.lights) out.value("--light", light_text(light));
  if (s.ambient) out.value("--ambient", triple(*s.ambient));
  if (!s.lights_off.empty()) out.value("--light-off", list_text(s.lights_off, 1));
  out.flag("--light-markers", s.overlays.light_markers);
  out.flag("--no-lights", s.no_lights && s.lights.empty());
}

void write_camera(WordWriter& out, const RenderOptions& o) {
  const scene::CameraChoice& c = o.settings.camera;
  if (o.all_cameras) {
    out.value("--camera-index", "all");
  } else if (!o.cameras.empty()) {
    out.value("--camera-index", list_text(o.cameras, 0));
  } else if (c.ignore_file_cameras && !c.position && !c.focal_point) {
    out.value("--camera-index", "none");
  }
  if (c.position) out.value("--camera-position", triple(*c.position));
  if (c.focal_point) out.value("--camera-focal-point", triple(*c.focal_point));
  if (c.view_angle_deg) out.value("--camera-view-angle", shortest(*c.view_angle_deg));
  if (c.view_up) out.value("--camera-up", triple(*c.view_up));
  if (c.orthographic_height) out.value("--orthographic-height", shortest(*c.orthographic_height));
  if (c.up != glm::vec3(0, 1, 0)) out.value("--up", triple(c.up));
  if (c.azimuth_deg != 0.0f) out.value("--azimuth", shortest(c.azimuth_deg));
  if (c.elevation_deg != 0.0f) out.value("--elevation", shortest(c.elevation_deg));
  if (o.settings.scene_index != scene::kNone) out.value("--scene", std::to_string(o.settings.scene_index));
}

void write_moment(WordWriter& out, const RenderOptions& o) {
  if (o.time_s) out.value("--time", shortest_double(*o.time_s));
  if (o.animation) out.value("--animation", std::to_string(*o.animation));
}

void write_colors(WordWriter& out, const RenderOptions& o) {
  const scene::RenderSettings& s = o.settings;
  const scene::RenderSettings d;
  if (s.background == scene::Background::environment) {
    out.value("--background", "environment");
  } else if (o.background_shown) {
    const auto& [r, g, b, a] = *o.background_shown;
    out.value("--background", triple({r, g, b}) + (a == 1.0f ? "" : "," + shortest(a)));
  }
  out.choice("--color-management", s.color_management, d.color_management, std::array{"srgb", "none"});
  if (s.exposure_ev != 0.0f) out.value("--exposure", shortest(s.exposure_ev));
  out.choice("--tone-map", s.tone_map, d.tone_map, std::array{"clamp", "reinhard"});
  if (!s.visibility_first) out.value("--visibility-first", "off");
}

bool is_harmless(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || std::string_view("-_./,:=+@%").find(letter) != std::string::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_harmless)) return word;
  std::string text = "'";
  for (const char letter : word) {
    if (letter == '\'') {
      text += "'\\''";
    } else {
      text += letter;
    }
  }
  return text + "'";
}

}  // namespace

std::vector<std::string> words_of(const RenderOptions& options) {
  WordWriter out;
  const std::optional<inspect::StructureView>& view = options.views.at(0);
  if (view) out.value("--view", std::string(inspect::name_of(*view)));
  out.value("--resolution",
            std::to_string(options.settings.width) + "," + std::to_string(options.settings.height));
  write_shading(out, options);
  write_textures(out, options);
  write_lights(out, options.settings);
  write_camera(out, options);
  write_moment(out, options);
  write_colors(out, options);
  return out.take();
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + quoted(word);
  return line;
}

}  // namespace barrido::view
