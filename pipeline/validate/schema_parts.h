// Short names for the lines of the schema's tables, and the tables that several files share.
#pragma once

#include "pipeline/validate/schema.h"
#include "pipeline/validate/value_checks.h"

namespace barrido::scene::validation {

constexpr Property any(std::string_view name) { return {.name = name}; }
constexpr Property boolean(std::string_view name) { return {.name = name, .kind = Kind::boolean}; }
constexpr Property integer(std::string_view name, double min,
                           double max = std::numeric_limits<double>::infinity()) {
  return {.name = name, .kind = Kind::integer, .min = min, .max = max};
}
constexpr Property integer_of(std::string_view name, std::span<const int> integers) {
  return {.name = name, .kind = Kind::integer, .integers = integers};
}
constexpr Property number(std::string_view name) { return {.name = name, .kind = Kind::number}; }
constexpr Property number(std::string_view name, double min,
                          double max = std::numeric_limits<double>::infinity()) {
  return {.name = name, .kind = Kind::number, .min = min, .max = max};
}
constexpr Property positive(std::string_view name) {
  return {.name = name, .kind = Kind::number, .above_min = true, .min = 0};
}
constexpr Property text(std::string_view name, std::string_view choices = {}) {
  return {.name = name, .kind = Kind::text, .choices = choices};
}
constexpr Property texts(std::string_view name) { return {.name = name, .kind = Kind::texts}; }
constexpr Property index(std::string_view name, Collection target) {
  return {.name = name, .kind = Kind::index, .target = target};
}
constexpr Property indices(std::string_view name, Collection target) {
  return {.name = name, .kind = Kind::indices, .target = target};
}
constexpr Property numbers(std::string_view name, std::size_t items) {
  return {.name = name, .kind = Kind::numbers, .items = items};
}
constexpr Property numbers(std::string_view name, std::size_t items, double min,
                           double max = std::numeric_limits<double>::infinity()) {
  return {.name = name, .kind = Kind::numbers, .min = min, .max = max, .items = items};
}
constexpr Property object(std::string_view name, const Schema& schema) {
  return {.name = name, .kind = Kind::object, .schema = &schema};
}
constexpr Property objects(std::string_view name, const Schema& schema) {
  return {.name = name, .kind = Kind::objects, .schema = &schema};
}
constexpr Property collection(std::string_view name, const Schema& schema) {
  return {.name = name, .kind = Kind::collection, .schema = &schema};
}
constexpr Property required(Property property) {
  property.required = true;
  return property;
}

// Textures of materials, in the core and in extensions.

inline constexpr Property kNormalTextureProperties[] = {required(index("index", Collection::textures)),
                                                        integer("texCoord", 0), number("scale")};
inline constexpr Schema kNormalTexture{ObjectType::normal_texture_info, kNormalTextureProperties,
                                       note_normal_texture_info};
inline constexpr Property kTextureInfoProperties[] = {required(index("index", Collection::textures)),
                                                      integer("texCoord", 0)};
inline constexpr Schema kTextureInfo{ObjectType::texture_info, kTextureInfoProperties, note_texture_info};

}  // namespace barrido::scene::validation
