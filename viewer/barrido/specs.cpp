#include "viewer/barrido/specs.h"

#include "raster/names.h"
#include "viewer/barrido/spec_keys.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

using Material = scene::MaterialOverride;

constexpr double kLargestCoefficient = 1e6;
constexpr double kLargestShininess = 1e5;

glm::vec3 parse_color(std::string_view text, double most) {
  const auto [r, g, b] = parse_tuple<3>(text, "R,G,B", 0.0, most);
  return {r, g, b};
}

glm::vec3 parse_coefficient(std::string_view text) { return parse_color(text, kLargestCoefficient); }

float parse_float(std::string_view text, double most) {
  return static_cast<float>(parse_number(text, 0.0, most));
}

template <class Value>
std::string text_of(const std::optional<Value>& value) {
  return value ? shortest(*value) : std::string();
}

using Text = std::string_view;

constexpr SpecKey<Material> kMaterialKeys[] = {
    {"color", ~0u, [](Material& m, Text text) { m.base_color = parse_color(text, 1.0); },
     [](const Material& m) { return text_of(m.base_color); }},
    {"metallic", ~0u, [](Material& m, Text text) { m.metallic = parse_float(text, 1.0); },
     [](const Material& m) { return text_of(m.metallic); }},
    {"roughness", ~0u, [](Material& m, Text text) { m.roughness = parse_float(text, 1.0); },
     [](const Material& m) { return text_of(m.roughness); }},
    {"ambient", ~0u, [](Material& m, Text text) { m.exact.ambient = parse_coefficient(text); },
     [](const Material& m) { return text_of(m.exact.ambient); }},
    {"diffuse", ~0u, [](Material& m, Text text) { m.exact.diffuse = parse_coefficient(text); },
     [](const Material& m) { return text_of(m.exact.diffuse); }},
    {"specular", ~0u, [](Material& m, Text text) { m.exact.specular = parse_coefficient(text); },
     [](const Material& m) { return text_of(m.exact.specular); }},
    {"emission", ~0u, [](Material& m, Text text) { m.exact.emission = parse_coefficient(text); },
     [](const Material& m) { return text_of(m.exact.emission); }},
    {"shininess", ~0u,
     [](Material& m, Text text) { m.exact.shininess = parse_float(text, kLargestShininess); },
     [](const Material& m) { return text_of(m.exact.shininess); }},
};

constexpr SpecWords kMaterialWords{"KEY=VALUE:...", "a material"};

}  // namespace

std::pair<std::string_view, std::string_view> split_pair(std::string_view pair, const SpecWords& words,
                                                         std::vector<std::string_view>& given) {
  const std::size_t equals = pair.find('=');
  if (equals == std::string_view::npos) {
    throw ValueError("expected " + std::string(words.form) + ", but '" + std::string(pair) + "' has no '='");
  }
  const std::string_view name = pair.substr(0, equals);
  if (std::find(given.begin(), given.end(), name) != given.end()) {
    throw ValueError(std::string(name) + " is given twice");
  }
  given.push_back(name);
  return {name, pair.substr(equals + 1)};
}

void complain_unknown_key(std::string_view key, const SpecWords& words,
                          std::span<const std::string_view> known) {
  throw ValueError("'" + std::string(key) + "' is no key of " + std::string(words.what) + ": expected " +
                   one_of(known) + did_you_mean(key, known));
}

Material parse_material(std::string_view spec) {
  Material material;
  read_keys<Material>(material, split(spec, ':'), kMaterialKeys, kMaterialWords);
  return material;
}

std::string material_text(const Material& material) {
  return write_keys<Material>("", material, kMaterialKeys);
}

raster::PixelFilter parse_pixel_filter(std::string_view spec) {
  using Filter = raster::PixelFilter;
  static constexpr SpecKey<Filter> kKeys[] = {{"radius", ~0u, [](Filter& f, std::string_view text) {
                                                 f.radius = static_cast<float>(parse_number(text, 0.01, 8.0));
                                               }}};
  const std::vector<std::string_view> pieces = split(spec, ':');
  Filter filter;
  filter.kind = parse_name<raster::PixelFilterKind>(pieces[0]);
  filter.radius = raster::default_radius(filter.kind);
  read_keys<Filter>(filter, std::span(pieces).subspan(1), kKeys, {"NAME:radius=R", "a pixel filter"});
  return filter;
}

std::string pixel_filter_text(const raster::PixelFilter& filter) {
  if (filter == raster::PixelFilter{}) return "";
  std::string text(name_of(filter.kind));
  if (filter.radius != raster::default_radius(filter.kind)) text += ":radius=" + shortest(filter.radius);
  return text;
}

// The two values of a fog are told apart by their places; keys would say no more.
FogChoice parse_fog(std::string_view spec) {
  const std::vector<std::string_view> pieces = split(spec, ':');
  FogChoice fog;
  fog.state.enabled = true;
  fog.state.mode = parse_name<raster::FogMode>(pieces[0]);
  const bool linear = fog.state.mode == raster::FogMode::linear;
  if (pieces.size() < 2 || pieces.size() > 3) {
    throw ValueError("expected " + std::string(pieces[0]) + (linear ? ":START,END" : ":DENSITY") +
                     "[:R,G,B]");
  }
  if (linear) {
    const auto [start, end] = parse_tuple<2>(pieces[1], "START,END", -kAnyNumber, kAnyNumber);
    if (start == end) throw ValueError("expected START and END to differ");
    fog.state.start = start;
    fog.state.end = end;
  } else {
    fog.state.density = static_cast<float>(parse_number(pieces[1], 0.0, kAnyNumber));
  }
  if (pieces.size() == 3) fog.color_shown = parse_tuple<3>(pieces[2], "R,G,B", 0.0, 1.0);
  return fog;
}

std::string fog_text(const FogChoice& fog) {
  const raster::FogState& state = fog.state;
  std::string text(name_of(state.mode));
  text += state.mode == raster::FogMode::linear ? ":" + shortest(state.start) + "," + shortest(state.end)
                                                : ":" + shortest(state.density);
  if (!fog.color_shown) return text;
  const auto [r, g, b] = *fog.color_shown;
  return text + ":" + shortest(glm::vec3(r, g, b));
}

}  // namespace barrido::cli
