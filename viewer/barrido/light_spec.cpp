// A light from its text and back.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "pipeline/scene/light_conversion.h"
#include "pipeline/scene/names.h"
#include "raster/base/portable_math.h"
#include "viewer/barrido/spec_keys.h"
#include "viewer/barrido/specs.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

using scene::UserLight;
using Kind = scene::Light::Kind;
using Text = std::string_view;

constexpr double kLargestIntensity = 1e6;
constexpr SpecWords kWords{"TYPE:KEY=VALUE:...", "this light"};

/// Kinds of light to which a key belongs.
constexpr unsigned bit(Kind kind) { return 1u << static_cast<unsigned>(kind); }
constexpr unsigned kAny = ~0u, kSpot = bit(Kind::spot), kPlaced = bit(Kind::point) | kSpot,
                   kAimed = bit(Kind::directional) | kSpot;

/// The three lights of the set-up that a scene without lights gets (V2), in its order.
constexpr std::array<Text, 3> kPresets{"key", "fill", "back"};

constexpr std::array<float, 3> kNoAttenuation{1.0f, 0.0f, 0.0f};

float radians_of(double degrees) { return static_cast<float>(radians(degrees)); }

/// Degrees in [0, 90] that become these radians.
float degrees_of(float radians_wanted) {
  float best = static_cast<float>(static_cast<double>(radians_wanted) * (180.0 / kPi));
  float below = best, above = best;
  for (int step = 0; step < 4 && radians_of(best) != radians_wanted; ++step) {
    below = std::nextafter(below, 0.0f);
    above = std::nextafter(above, 91.0f);
    if (radians_of(below) == radians_wanted) best = below;
    if (radians_of(above) == radians_wanted) best = above;
  }
  return std::clamp(best, 0.0f, 90.0f);
}

/// The shortest number of degrees that becomes these radians when it is read as a double.
std::string degrees_text(float radians_wanted) {
  const std::string text = shortest(degrees_of(radians_wanted));
  double degrees = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), degrees);
  if (radians_of(degrees) == radians_wanted) return text;
  return shortest_double(std::min(static_cast<double>(radians_wanted) * (180.0 / kPi), 90.0));
}

void read_attenuation(UserLight& user, Text text) {
  const auto attenuation = parse_tuple<3>(text, "KC,KL,KQ", 0.0, kAnyNumber);
  if (attenuation == std::array<float, 3>{}) throw ValueError("expected KC,KL,KQ, not all of them 0");
  user.light.attenuation = attenuation;
}

std::string attenuation_text(const UserLight& user) {
  const std::array<float, 3> k = user.light.attenuation.value_or(kNoAttenuation);
  return k == kNoAttenuation ? "" : shortest(glm::vec3(k[0], k[1], k[2]));
}

void read_cone(UserLight& user, Text text) {
  const auto [inner, outer] = parse_tuple<2>(text, "INNER,OUTER", 0.0, 90.0);
  if (inner > outer) throw ValueError("expected INNER,OUTER with INNER not above OUTER");
  user.light.inner_cone_rad = radians_of(inner);
  user.light.outer_cone_rad = radians_of(outer);
  user.light.spot_exponent.reset();
}

std::string cone_text(const UserLight& user) {
  if (user.light.spot_exponent) return "";
  const float outer = degrees_of(user.light.outer_cone_rad);
  return shortest(std::min(degrees_of(user.light.inner_cone_rad), outer)) + "," + shortest(outer);
}

void read_color(UserLight& user, Text text) {
  const auto [r, g, b] = parse_tuple<3>(text, "R,G,B", 0.0, kLargestIntensity);
  user.light.color = {r, g, b};
}

void read_intensity(UserLight& user, Text text) {
  user.light.exact_intensity = static_cast<float>(parse_number(text, -kLargestIntensity, kLargestIntensity));
}

std::string text_unless(float number, float standard) { return number == standard ? "" : shortest(number); }

constexpr SpecKey<UserLight> kKeys[] = {
    {"color", kAny, read_color,
     [](const UserLight& user) {
       return user.light.color == glm::vec3(1.0f) ? std::string() : shortest(user.light.color);
     }},
    {"intensity", kAny, read_intensity,
     [](const UserLight& user) { return text_unless(user.light.exact_intensity.value_or(1.0f), 1.0f); }},
    {"dir", kAimed, [](UserLight& user, Text text) { user.direction = parse_direction(text); },
     [](const UserLight& user) { return shortest(user.direction); }},
    {"pos", kPlaced, [](UserLight& user, Text text) { user.position = parse_point(text); },
     [](const UserLight& user) { return shortest(user.position); }},
    {"attenuation", kPlaced, read_attenuation, attenuation_text},
    {"range", kPlaced,
     [](UserLight& user, Text text) {
       user.light.range = static_cast<float>(parse_number(text, 0.0, kAnyNumber));
     },
     [](const UserLight& user) { return text_unless(user.light.range, 0.0f); }},
    {"cone", kSpot, read_cone, cone_text},
    {"cutoff", kSpot,
     [](UserLight& user, Text text) {
       user.light.outer_cone_rad = radians_of(parse_number(text, 0.0, 90.0));
     },
     [](const UserLight& user) {
       return user.light.spot_exponent ? degrees_text(user.light.outer_cone_rad) : std::string();
     }},
    {"exponent", kSpot,
     [](UserLight& user, Text text) {
       user.light.spot_exponent = static_cast<float>(parse_number(text, 0.0, 1e6));
     },
     [](const UserLight& user) { return text_unless(user.light.spot_exponent.value_or(0.0f), 0.0f); }},
    {"space", kAny, [](UserLight& user, Text text) { user.space = parse_name<UserLight::Space>(text); },
     [](const UserLight& user) {
       return user.space == UserLight::Space::world ? std::string() : std::string(name_of(user.space));
     }},
};

/// A light with nothing but its type. @throws ValueError.
UserLight start(Text type) {
  std::vector<Text> types(kPresets.begin(), kPresets.end());
  for (const Named<Kind>& kind : names_of<Kind>()) types.push_back(kind.name);
  UserLight user;
  const auto preset = std::find(kPresets.begin(), kPresets.end(), type);
  if (preset != kPresets.end()) {
    const pipeline::Light light =
        scene::three_light_setup()[static_cast<std::size_t>(preset - kPresets.begin())];
    user.space = UserLight::Space::camera;
    user.light.kind = Kind::directional;
    user.light.exact_intensity = light.diffuse.x;
    user.direction = -glm::vec3(light.position);
    return user;
  }
  const std::optional<Kind> kind = value_named<Kind>(type);
  if (!kind) throw ValueError("expected " + one_of(types) + did_you_mean(type, types));
  user.light.kind = *kind;
  user.light.exact_intensity = 1.0f;
  if (*kind != Kind::directional) user.light.attenuation = kNoAttenuation;
  // Without a soft cone a spot is OpenGL's: a hard edge at the cut-off, cosθ^exponent inside.
  if (*kind == Kind::spot) user.light.spot_exponent = 0.0f;
  return user;
}

bool holds(const std::vector<Text>& names, Text name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

scene::UserLight parse_light(std::string_view spec) {
  const std::vector<Text> pieces = split(spec, ':');
  UserLight user = start(pieces[0]);
  const std::span<const Text> pairs(pieces.begin() + 1, pieces.end());
  const std::vector<Text> given = read_keys<UserLight>(user, pairs, kKeys, kWords, bit(user.light.kind));
  if (holds(given, "cone") && (holds(given, "cutoff") || holds(given, "exponent"))) {
    throw ValueError("cone (soft) and cutoff or exponent (hard) exclude each other");
  }
  return user;
}

std::string light_text(const UserLight& user) {
  return write_keys<UserLight>(name_of(user.light.kind), user, kKeys, bit(user.light.kind));
}

}  // namespace barrido::cli
