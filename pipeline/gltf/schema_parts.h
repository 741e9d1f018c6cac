// Short names for the rows of the schema's tables, and the tables that several files share.
#pragma once

#include "pipeline/gltf/schema.h"

namespace barrido::scene::gltf {

inline constexpr double kMaxInt = 2147483647.0;

constexpr Property boolean(std::string_view name) { return {.name = name, .kind = Kind::boolean}; }
constexpr Property integer(std::string_view name, double min, double max = Range{}.max) {
  return {.name = name, .kind = Kind::integer, .range = {min, max}, .drawing = Drawing::value};
}
/// In drawing, all from the first to the last.
constexpr Property integer_of(std::string_view name, std::span<const int> integers) {
  Property property = integer(name, integers.front(), integers.back());
  property.integers = integers;
  return property;
}
constexpr Property number(std::string_view name, Range range = {}) {
  return {.name = name, .kind = Kind::number, .range = range};
}
constexpr Property number(std::string_view name, double min) { return number(name, Range{.min = min}); }
constexpr Property number(std::string_view name, double min, double max) {
  return number(name, Range{min, max});
}
constexpr Property positive(std::string_view name) {
  return {.name = name, .kind = Kind::number, .above_min = true, .range = {.min = 0}};
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
constexpr Property numbers(std::string_view name, std::size_t items, Range range = {}) {
  return {.name = name, .kind = Kind::numbers, .range = range, .min_items = items, .max_items = items};
}
constexpr Property any_numbers(std::string_view name) { return {.name = name, .kind = Kind::numbers}; }
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
constexpr Property of_type(Property property) {
  property.of_type = true;
  return property;
}

constexpr Property ignored(Property property) {
  property.drawing = Drawing::ignored;
  return property;
}
/// A value that the standard forbids ends a drawing.
constexpr Property fatal(Property property) {
  property.drawing = Drawing::value;
  return property;
}
/// What drawing takes instead of what the standard allows.
constexpr Property drawn_from(double min, double max, Property property) {
  property.drawing = Drawing::form;
  property.drawn = {min, max};
  return property;
}

// Textures of materials, in the core and in extensions.

inline constexpr Property kNormalTextureProperties[] = {required(index("index", Collection::textures)),
                                                        drawn_from(0, kMaxInt, integer("texCoord", 0)),
                                                        number("scale")};
inline constexpr Schema kNormalTexture{ObjectType::normal_texture_info, kNormalTextureProperties};
inline constexpr Property kTextureInfoProperties[] = {required(index("index", Collection::textures)),
                                                      drawn_from(0, kMaxInt, integer("texCoord", 0))};
inline constexpr Schema kTextureInfo{ObjectType::texture_info, kTextureInfoProperties};

}  // namespace barrido::scene::gltf
