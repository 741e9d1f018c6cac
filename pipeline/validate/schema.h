// The shape of a glTF document as glTF 2.0 and its extensions define it: which properties an object has, of
// which type, in which range. The importer has a table of its own (gltf_rules.h), which holds what drawing
// needs and no more: most of what is wrong by this table is drawn all the same.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "pipeline/validate/json_text.h"

namespace barrido::scene::validation {

class SchemaWalk;

/// Objects that extensions may extend.
enum class ObjectType : std::uint8_t {
  other,
  document,
  camera,
  channel_target,
  image,
  material,
  node,
  primitive,
  texture,
  texture_info,
  normal_texture_info,
  occlusion_texture_info,
};

/// The arrays that indices refer to.
enum class Collection : std::uint8_t {
  accessors,
  buffers,
  buffer_views,
  cameras,
  images,
  materials,
  meshes,
  nodes,
  samplers,
  scenes,
  skins,
  textures,
  lights,    ///< Of KHR_lights_punctual.
  variants,  ///< Of KHR_materials_variants.
  count
};

enum class Kind : std::uint8_t {
  any,  ///< Whatever it is, a check of its own sees to it.
  boolean,
  integer,     ///< From `min` to `max`, or one of `integers`; a whole number written as 3.0 counts as one
  number,      ///< In the range
  text,        ///< One of `choices`, separated by '|', where there are any; others stay, with a warning
  texts,       ///< An array of different strings
  index,       ///< Into `target`
  indices,     ///< An array of different ones
  index_map,   ///< An object of them
  index_maps,  ///< An array of such objects
  numbers,     ///< An array of `items` numbers in the range, any number of them where `items` is 0
  object,      ///< As `schema` says
  objects,     ///< An array of them; one that is no object spoils all
  collection,  ///< An array of them; one that is no object is as if it were not there
};

struct Schema;

struct Property {
  std::string_view name;
  Kind kind = Kind::any;
  bool required = false;
  bool above_min = false;  ///< `min` itself is out of range.
  bool below_max = false;  ///< So is `max`.
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  double or_else = std::numeric_limits<double>::quiet_NaN();  ///< Allowed although out of the range.
  std::size_t items = 0;
  Collection target = Collection::count;
  bool unused = false;  ///< To be referred to from here is not to be used.
  std::span<const int> integers = {};
  std::string_view choices = {};
  const Schema* schema = nullptr;
};

struct Schema {
  ObjectType type = ObjectType::other;
  std::span<const Property> properties = {};
  /// Rules between the properties, applied after each was checked; null where there are none.
  void (*check)(SchemaWalk& walk, Json& object, const Place& place) = nullptr;
};

const Schema& document_schema();

// What is walked into only where the object that holds it says so.
const Schema& perspective_schema();
const Schema& orthographic_schema();
const Schema& spot_schema();

struct Extension {
  std::string_view name;
  bool must_be_required = false;
};

/// Where an extension has its properties, and which.
struct ExtensionObject {
  std::string_view name;
  ObjectType type = ObjectType::other;
  const Schema* schema = nullptr;
  bool alone = false;  ///< May not go together with others.
};

/// Null where the extension is not known.
const Extension* find_extension(std::string_view name);
/// Null where the extension has no place in objects of that type.
const ExtensionObject* find_extension_object(std::string_view name, ObjectType type);

}  // namespace barrido::scene::validation
