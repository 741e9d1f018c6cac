// Reading of extensions as tinygltf keeps them, whatever they hold: what is not there, or of another type, is
// a null value. tinygltf's own functions assert that types fit.
#pragma once

#include <cmath>
#include <cstddef>

#include <tiny_gltf.h>

namespace barrido::scene::gltf {

inline const tinygltf::Value& null_value() {
  static const tinygltf::Value value;
  return value;
}

inline const tinygltf::Value& member(const tinygltf::Value& object, const char* name) {
  return object.IsObject() ? object.Get(name) : null_value();
}

inline const tinygltf::Value& member(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? null_value() : found->second;
}

inline const tinygltf::Value& item(const tinygltf::Value& array, std::size_t index) {
  return array.IsArray() && index < array.ArrayLen() ? array.Get(static_cast<int>(index)) : null_value();
}

/// 0 for what is no number.
inline double number(const tinygltf::Value& value) {
  return value.IsNumber() ? value.GetNumberAsDouble() : 0.0;
}

/// −1 for what is no whole number in [0, 2^31).
inline int whole_number(const tinygltf::Value& value) {
  const double given = value.IsNumber() ? value.GetNumberAsDouble() : -1.0;
  return given >= 0.0 && given < 2147483648.0 && std::floor(given) == given ? static_cast<int>(given) : -1;
}

}  // namespace barrido::scene::gltf
