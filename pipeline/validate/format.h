// What accessors hold, by name and number (glTF 2.0, section 3.6.2). Plain values.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace barrido::scene::validation {

enum ComponentType : int {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
};

/// Bytes of a component; 0 for what is none.
constexpr std::size_t component_bytes(int type) {
  switch (type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

struct TypeTraits {
  std::string_view name;
  std::size_t components;
  std::size_t columns;  ///< More than 1 for matrices, whose columns begin at multiples of 4 bytes.
};
inline constexpr std::array<TypeTraits, 7> kTypes = {{{"SCALAR", 1, 1},
                                                      {"VEC2", 2, 1},
                                                      {"VEC3", 3, 1},
                                                      {"VEC4", 4, 1},
                                                      {"MAT2", 4, 2},
                                                      {"MAT3", 9, 3},
                                                      {"MAT4", 16, 4}}};

/// Null where there is no such type.
constexpr const TypeTraits* find_type(std::string_view name) {
  for (const TypeTraits& type : kTypes) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

/// Least and greatest value of an integer component.
constexpr double least_of(int type) { return type == kByte ? -128.0 : type == kShort ? -32768.0 : 0.0; }
constexpr double greatest_of(int type) {
  switch (type) {
    case kByte:
      return 127.0;
    case kUnsignedByte:
      return 255.0;
    case kShort:
      return 32767.0;
    case kUnsignedShort:
      return 65535.0;
    default:
      return 4294967295.0;
  }
}

constexpr std::string_view name_of_component(int type) {
  constexpr std::array<std::string_view, 7> kNames = {"BYTE", "UNSIGNED_BYTE", "SHORT", "UNSIGNED_SHORT",
                                                      "INT",  "UNSIGNED_INT",  "FLOAT"};
  return type >= kByte && type <= kFloat ? kNames[static_cast<std::size_t>(type - kByte)] : "no type";
}

}  // namespace barrido::scene::validation
