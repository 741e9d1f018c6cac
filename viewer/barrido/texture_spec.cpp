#include "viewer/barrido/texture_spec.h"

#include "pipeline/scene/names.h"
#include "viewer/barrido/spec_keys.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

using scene::MappingChoice;
using scene::SolidTexture;
using Kind = raster::PatternKind;
using Text = std::string_view;
using Color = std::array<float, 4>;

constexpr double kSmallest = 1e-18;
constexpr SpecWords kSolidWords{"NAME:KEY=VALUE:...", "this texture"};
constexpr SpecWords kMappingWords{"SURFACE:KEY=VALUE:...", "a mapping"};

constexpr unsigned bit(Kind kind) { return 1u << static_cast<unsigned>(kind); }
constexpr unsigned kAny = ~0u, kNoise = bit(Kind::noise), kMoved = bit(Kind::wood) | bit(Kind::marble);

Color parse_alpha_color(Text text) {
  if (std::count(text.begin(), text.end(), ',') == 3) return parse_tuple<4>(text, "R,G,B[,A]", 0.0, 1.0);
  const auto [r, g, b] = parse_tuple<3>(text, "R,G,B[,A]", 0.0, 1.0);
  return {r, g, b, 1.0f};
}

/// Nothing where the color is the standard one.
std::string color_text(const SolidTexture& solid, std::size_t which) {
  const Color& color = solid.pattern.colors[which];
  if (color == scene::standard_solid(solid.pattern.kind).pattern.colors[which]) return "";
  const std::string rgb = shortest(glm::vec3(color[0], color[1], color[2]));
  return color[3] == 1.0f ? rgb : rgb + "," + shortest(color[3]);
}

float parse_float(Text text, double least, double most) {
  return static_cast<float>(parse_number(text, least, most));
}

/// Nothing where the number is as in the standard pattern.
template <class Number>
std::string number_text(const SolidTexture& solid, Number raster::Pattern::*member) {
  const Number number = solid.pattern.*member;
  if (number == scene::standard_solid(solid.pattern.kind).pattern.*member) return "";
  if constexpr (std::is_same_v<Number, int>) return std::to_string(number);
  return shortest(static_cast<float>(number));
}

std::string axis_text(const glm::vec3& axis) { return axis == glm::vec3(0, 1, 0) ? "" : shortest(axis); }

constexpr SpecKey<SolidTexture> kSolidKeys[] = {
    {"scale", kAny, [](SolidTexture& s, Text text) { s.scale = parse_float(text, kSmallest, kAnyNumber); },
     [](const SolidTexture& s) { return s.scale == 0.0f ? std::string() : shortest(s.scale); }},
    {"axis", kAny, [](SolidTexture& s, Text text) { s.axis = parse_direction(text); },
     [](const SolidTexture& s) { return axis_text(s.axis); }},
    {"space", kAny, [](SolidTexture& s, Text text) { s.space = parse_name<SolidTexture::Space>(text); },
     [](const SolidTexture& s) {
       return s.space == SolidTexture::Space::object ? std::string() : std::string(name_of(s.space));
     }},
    {"dark", kAny, [](SolidTexture& s, Text text) { s.pattern.colors[0] = parse_alpha_color(text); },
     [](const SolidTexture& s) { return color_text(s, 0); }},
    {"light", kAny, [](SolidTexture& s, Text text) { s.pattern.colors[1] = parse_alpha_color(text); },
     [](const SolidTexture& s) { return color_text(s, 1); }},
    {"octaves", kNoise | kMoved,
     [](SolidTexture& s, Text text) { s.pattern.octaves = parse_whole(text, 1, raster::kMaxOctaves); },
     [](const SolidTexture& s) { return number_text(s, &raster::Pattern::octaves); }},
    {"gain", kNoise | kMoved,
     [](SolidTexture& s, Text text) { s.pattern.gain = parse_float(text, 0.01, 1.0); },
     [](const SolidTexture& s) { return number_text(s, &raster::Pattern::gain); }},
    {"turbulence", kMoved,
     [](SolidTexture& s, Text text) { s.pattern.turbulence = parse_float(text, -100.0, 100.0); },
     [](const SolidTexture& s) { return number_text(s, &raster::Pattern::turbulence); }},
    {"threshold", kNoise,
     [](SolidTexture& s, Text text) {
       s.pattern.threshold = parse_float(text, -1.0, 1.0);
       s.pattern.has_threshold = true;
     },
     [](const SolidTexture& s) {
       return s.pattern.has_threshold ? shortest(s.pattern.threshold) : std::string();
     }},
};

glm::vec2 parse_pair(Text text) {
  const auto [u, v] = parse_tuple<2>(text, "U,V", -kAnyNumber, kAnyNumber);
  return {u, v};
}

glm::vec2 parse_repeats(Text text) {
  const glm::vec2 repeats = parse_pair(text);
  if (repeats.x == 0.0f || repeats.y == 0.0f) throw ValueError("expected U,V, neither of them 0");
  return repeats;
}

std::string pair_text(const glm::vec2& pair, const glm::vec2& standard) {
  return pair == standard ? "" : shortest(pair.x) + "," + shortest(pair.y);
}

bool parse_at(Text text) {
  constexpr auto kPlaces = std::to_array<Named<bool>>({{false, "fragments"}, {true, "vertices"}});
  return parse_choice(text, std::span<const Named<bool>>(kPlaces));
}

constexpr SpecKey<MappingChoice> kMappingKeys[] = {
    {"from", kAny, [](MappingChoice& m, Text text) { m.ray = parse_name<raster::MappingRay>(text); },
     [](const MappingChoice& m) {
       return m.ray == raster::MappingRay::surface ? std::string() : std::string(name_of(m.ray));
     }},
    {"at", kAny, [](MappingChoice& m, Text text) { m.at_vertices = parse_at(text); },
     [](const MappingChoice& m) { return std::string(m.at_vertices ? "vertices" : ""); }},
    {"axis", kAny, [](MappingChoice& m, Text text) { m.axis = parse_direction(text); },
     [](const MappingChoice& m) { return axis_text(m.axis); }},
    {"centre", kAny, [](MappingChoice& m, Text text) { m.centre = parse_point(text); },
     [](const MappingChoice& m) { return m.centre ? shortest(*m.centre) : std::string(); }},
    {"size", kAny, [](MappingChoice& m, Text text) { m.size = parse_float(text, kSmallest, kAnyNumber); },
     [](const MappingChoice& m) { return m.size == 0.0f ? std::string() : shortest(m.size); }},
    {"repeats", kAny, [](MappingChoice& m, Text text) { m.repeats = parse_repeats(text); },
     [](const MappingChoice& m) {
       return pair_text(m.repeats, {1, 1});
     }},
    {"offset", kAny, [](MappingChoice& m, Text text) { m.offset = parse_pair(text); },
     [](const MappingChoice& m) {
       return pair_text(m.offset, {0, 0});
     }},
};

std::span<const Text> without_first(const std::vector<Text>& pieces) {
  return std::span<const Text>(pieces).subspan(1);
}

}  // namespace

std::optional<SolidTexture> parse_solid(std::string_view spec) {
  const std::vector<Text> pieces = split(spec, ':');
  const std::optional<Kind> kind = value_named<Kind>(pieces[0]);
  if (!kind) {
    if (!spec.empty() && pieces[0].find_first_of("./\\") != Text::npos) return std::nullopt;
    std::vector<Text> names;
    for (const Named<Kind>& named : names_of<Kind>()) names.push_back(named.name);
    throw ValueError("expected the path of a picture, or " + one_of(names) + did_you_mean(pieces[0], names));
  }
  SolidTexture solid = scene::standard_solid(*kind);
  read_keys<SolidTexture>(solid, without_first(pieces), kSolidKeys, kSolidWords, bit(*kind));
  return solid;
}

std::string solid_text(const SolidTexture& solid) {
  const Kind kind = solid.pattern.kind;
  return write_keys<SolidTexture>(name_of(kind), solid, kSolidKeys, bit(kind));
}

MappingChoice parse_mapping(std::string_view spec) {
  const std::vector<Text> pieces = split(spec, ':');
  MappingChoice mapping;
  // All but `none`, the last.
  const std::span<const Named<raster::MappingSurface>> surfaces = names_of<raster::MappingSurface>();
  mapping.surface = parse_choice(pieces[0], surfaces.first(surfaces.size() - 1));
  read_keys<MappingChoice>(mapping, without_first(pieces), kMappingKeys, kMappingWords);
  return mapping;
}

std::string mapping_text(const MappingChoice& mapping) {
  return write_keys<MappingChoice>(name_of(mapping.surface), mapping, kMappingKeys);
}

}  // namespace barrido::cli
