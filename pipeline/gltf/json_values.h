// Reading of extensions as JSON, whatever they hold: what is not there, or of another type, is no value.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace barrido::scene::gltf {

/// A whole number from 0 to 2^53, up to which all are exact; 3.0 counts as one.
inline std::optional<std::uint64_t> whole_number(const nlohmann::json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  if (found == object.end() || !found->is_number()) return std::nullopt;
  const double given = found->get<double>();
  if (!(given >= 0.0 && given <= 9007199254740992.0) || std::floor(given) != given) return std::nullopt;
  return static_cast<std::uint64_t>(given);
}

inline std::string text_of(const nlohmann::json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace barrido::scene::gltf
