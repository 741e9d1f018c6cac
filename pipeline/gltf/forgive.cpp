#include "pipeline/gltf/forgive.h"

#include <cmath>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace barrido::scene::gltf {
namespace {

using nlohmann::json;

enum class Kind : std::uint8_t { text, boolean, number, whole, numbers, interpolation };

/// A property of the objects in a nested array: "animations/samplers" are the samplers of all animations, a
/// part with a dot in front is an object instead.
struct Forgivable {
  std::string_view path, name;
  Kind kind;
};

constexpr Forgivable kForgivable[] = {
    {".asset", "generator", Kind::text},
    {".asset", "copyright", Kind::text},
    {"animations", "name", Kind::text},
    {"animations/samplers", "interpolation", Kind::interpolation},
    {"cameras", "name", Kind::text},
    {"images", "name", Kind::text},
    {"images", "mimeType", Kind::text},
    {"materials", "name", Kind::text},
    {"materials", "doubleSided", Kind::boolean},
    {"materials", "alphaMode", Kind::text},
    {"materials", "alphaCutoff", Kind::number},
    {"materials", "emissiveFactor", Kind::numbers},
    {"materials/.pbrMetallicRoughness", "baseColorFactor", Kind::numbers},
    {"materials/.pbrMetallicRoughness", "metallicFactor", Kind::number},
    {"materials/.pbrMetallicRoughness", "roughnessFactor", Kind::number},
    {"meshes", "name", Kind::text},
    {"nodes", "name", Kind::text},
    {"samplers", "minFilter", Kind::whole},
    {"samplers", "magFilter", Kind::whole},
    {"samplers", "wrapS", Kind::whole},
    {"samplers", "wrapT", Kind::whole},
    {"scenes", "name", Kind::text},
    {"skins", "name", Kind::text},
    {"textures", "name", Kind::text},
};

bool is_whole(const json& value) {
  return value.is_number_integer() ||
         (value.is_number_float() && std::floor(value.get<double>()) == value.get<double>());
}

bool are_numbers(const json& value) {
  if (!value.is_array()) return false;
  for (const json& item : value) {
    if (!item.is_number()) return false;
  }
  return true;
}

/// What is wrong; empty where nothing is.
const char* sin_of(const json& value, Kind kind) {
  switch (kind) {
    case Kind::text:
      return value.is_string() ? "" : "must be a string";
    case Kind::boolean:
      return value.is_boolean() ? "" : "must be true or false";
    case Kind::number:
      return value.is_number() ? "" : "must be a number";
    case Kind::whole:
      return is_whole(value) ? "" : "must be a whole number";
    case Kind::numbers:
      return are_numbers(value) ? "" : "must be an array of numbers";
    case Kind::interpolation:
      break;
  }
  const bool known = value == "LINEAR" || value == "STEP" || value == "CUBICSPLINE";
  return known ? "" : "must be LINEAR, STEP or CUBICSPLINE";
}

class Forgiver {
 public:
  Forgiver(Report& report, json& document) : report_(report), document_(document) {}

  void forgive(const Forgivable& rule) { walk(document_, rule.path, "", rule); }

 private:
  void walk(json& object, std::string_view path, const std::string& place, const Forgivable& rule) {
    if (!object.is_object()) return;
    if (path.empty()) return judge(object, place, rule);
    std::string_view part = path.substr(0, path.find('/'));
    path.remove_prefix(std::min(path.size(), part.size() + 1));
    const bool is_array = part[0] != '.';
    if (!is_array) part.remove_prefix(1);
    const auto found = object.find(part);
    if (found == object.end()) return;
    const std::string here = (place.empty() ? "" : place + '.') + std::string(part);
    if (!is_array) return walk(*found, path, here, rule);
    if (!found->is_array()) return;
    for (std::size_t i = 0; i < found->size(); ++i) walk((*found)[i], path, element(here, i), rule);
  }

  void judge(json& object, const std::string& place, const Forgivable& rule) {
    const auto found = object.find(rule.name);
    if (found == object.end()) return;
    const std::string sin = sin_of(*found, rule.kind);
    if (sin.empty()) return;
    report_.warn((place.empty() ? "" : place + '.') + std::string(rule.name) + ": " + sin +
                 "; it is ignored");
    object.erase(found);
  }

  Report& report_;
  json& document_;
};

}  // namespace

void forgive_small_sins(Report& report, json& document) {
  Forgiver forgiver(report, document);
  for (const Forgivable& rule : kForgivable) forgiver.forgive(rule);
}

}  // namespace barrido::scene::gltf
