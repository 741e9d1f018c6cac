#include "viewer/barrido/light_spec.h"

#include <algorithm>
#include <array>

#include "pipeline/scene/light_conversion.h"
#include "raster/base/portable_math.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

using scene::UserLight;
using Kind = scene::Light::Kind;

constexpr double kLargestIntensity = 1e6;

enum class Type { key, fill, back, directional, point, spot };

constexpr std::array<Choice<Type>, 6> kTypes{{{"key", Type::key},
                                              {"fill", Type::fill},
                                              {"back", Type::back},
                                              {"directional", Type::directional},
                                              {"point", Type::point},
                                              {"spot", Type::spot}}};

constexpr std::array<Choice<UserLight::Space>, 2> kSpaces{
    {{"world", UserLight::Space::world}, {"camera", UserLight::Space::camera}}};

/// Kinds of light to which a key belongs, as bits.
enum KindBits : unsigned { kDirectional = 1, kPoint = 2, kSpot = 4, kPlaced = kPoint | kSpot, kAny = 7 };

unsigned bits_of(Kind kind) {
  return kind == Kind::directional ? kDirectional : kind == Kind::point ? kPoint : kSpot;
}

glm::vec3 vector_of(const std::array<float, 3>& values) { return {values[0], values[1], values[2]}; }

glm::vec3 parse_direction(std::string_view text) {
  const glm::vec3 direction = vector_of(parse_tuple<3>(text, "X,Y,Z", -kAnyNumber, kAnyNumber));
  if (direction == glm::vec3(0.0f)) throw ValueError("expected a direction, not 0,0,0");
  return direction;
}

void set_attenuation(UserLight& user, std::string_view text) {
  const auto attenuation = parse_tuple<3>(text, "KC,KL,KQ", 0.0, kAnyNumber);
  if (attenuation == std::array<float, 3>{}) throw ValueError("expected KC,KL,KQ, not all of them 0");
  user.light.attenuation = attenuation;
}

void set_cone(UserLight& user, std::string_view text) {
  const auto angles = parse_tuple<2>(text, "INNER,OUTER", 0.0, 90.0);
  if (angles[0] > angles[1]) throw ValueError("expected INNER,OUTER with INNER not above OUTER");
  user.light.inner_cone_rad = static_cast<float>(radians(angles[0]));
  user.light.outer_cone_rad = static_cast<float>(radians(angles[1]));
  user.light.spot_exponent.reset();
}

void set_cutoff(UserLight& user, std::string_view text) {
  user.light.outer_cone_rad = static_cast<float>(radians(parse_number(text, 0.0, 90.0)));
}

struct Key {
  std::string_view name;
  unsigned kinds;
  void (*apply)(UserLight& user, std::string_view text);
};

constexpr std::array<Key, 10> kKeys{{
    {"color", kAny,
     [](UserLight& user, std::string_view text) {
       user.light.color = vector_of(parse_tuple<3>(text, "R,G,B", 0.0, kLargestIntensity));
     }},
    {"intensity", kAny,
     [](UserLight& user, std::string_view text) {
       user.light.exact_intensity =
           static_cast<float>(parse_number(text, -kLargestIntensity, kLargestIntensity));
     }},
    {"dir", kDirectional | kSpot,
     [](UserLight& user, std::string_view text) { user.direction = parse_direction(text); }},
    {"pos", kPlaced,
     [](UserLight& user, std::string_view text) {
       user.position = vector_of(parse_tuple<3>(text, "X,Y,Z", -kAnyNumber, kAnyNumber));
     }},
    {"attenuation", kPlaced, set_attenuation},
    {"range", kPlaced,
     [](UserLight& user, std::string_view text) {
       user.light.range = static_cast<float>(parse_number(text, 0.0, kAnyNumber));
     }},
    {"cone", kSpot, set_cone},
    {"cutoff", kSpot, set_cutoff},
    {"exponent", kSpot,
     [](UserLight& user, std::string_view text) {
       user.light.spot_exponent = static_cast<float>(parse_number(text, 0.0, 1e6));
     }},
    {"space", kAny, [](UserLight& user, std::string_view text) { user.space = parse_choice(text, kSpaces); }},
}};

/// One of the three lights that a scene without lights gets (V2); it moves with the camera.
UserLight preset(Type type) {
  const pipeline::Light light = scene::three_light_setup()[static_cast<std::size_t>(type)];
  UserLight user;
  user.space = UserLight::Space::camera;
  user.light.kind = Kind::directional;
  user.light.exact_intensity = light.diffuse.x;
  user.direction = -glm::vec3(light.position);
  return user;
}

UserLight start(Type type) {
  UserLight user;
  switch (type) {
    case Type::key:
    case Type::fill:
    case Type::back:
      return preset(type);
    case Type::directional:
      user.light.kind = Kind::directional;
      break;
    case Type::point:
      user.light.kind = Kind::point;
      break;
    case Type::spot:
      user.light.kind = Kind::spot;
      break;
  }
  user.light.exact_intensity = 1.0f;
  if (type != Type::directional) user.light.attenuation = std::array<float, 3>{1.0f, 0.0f, 0.0f};
  // Without a soft cone a spot is OpenGL's: a hard edge at the cut-off, cosθ^exponent inside.
  if (type == Type::spot) user.light.spot_exponent = 0.0f;
  return user;
}

/// The keys of this kind of light.
std::vector<std::string_view> keys_for(unsigned kind) {
  std::vector<std::string_view> names;
  for (const Key& key : kKeys) {
    if ((key.kinds & kind) != 0) names.push_back(key.name);
  }
  return names;
}

const Key& find_key(std::string_view name, unsigned kind) {
  for (const Key& key : kKeys) {
    if (key.name == name && (key.kinds & kind) != 0) return key;
  }
  const auto names = keys_for(kind);
  throw ValueError("'" + std::string(name) + "' is no key of this light: expected " + one_of(names) +
                   did_you_mean(name, names));
}

void apply_pair(UserLight& user, std::string_view pair, std::vector<std::string_view>& given) {
  const std::size_t equals = pair.find('=');
  if (equals == std::string_view::npos) {
    throw ValueError("expected TYPE:KEY=VALUE:..., but '" + std::string(pair) + "' has no '='");
  }
  const std::string_view name = pair.substr(0, equals);
  const Key& key = find_key(name, bits_of(user.light.kind));
  if (std::find(given.begin(), given.end(), name) != given.end()) {
    throw ValueError(std::string(name) + " is given twice");
  }
  given.push_back(name);
  try {
    key.apply(user, pair.substr(equals + 1));
  } catch (const ValueError& error) {
    throw ValueError(std::string(name) + ": " + error.what());
  }
}

bool holds(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

scene::UserLight parse_light(std::string_view spec) {
  const std::vector<std::string_view> pieces = split(spec, ':');
  UserLight user = start(parse_choice(pieces[0], kTypes));
  std::vector<std::string_view> given;
  for (std::size_t i = 1; i < pieces.size(); ++i) apply_pair(user, pieces[i], given);
  if (holds(given, "cone") && (holds(given, "cutoff") || holds(given, "exponent"))) {
    throw ValueError("cone (soft) and cutoff or exponent (hard) exclude each other");
  }
  return user;
}

}  // namespace barrido::cli
