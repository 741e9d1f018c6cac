// The shape of a glTF document as tables: which properties its objects have, of which type, in which range,
// and which of them are indices into which array. Covers what the importer reads; other properties may hold
// anything. Must not know how documents are stored.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace barrido::scene::gltf {

/// The arrays that indices refer to.
enum class Target : std::uint8_t {
  accessors,
  buffers,
  buffer_views,
  cameras,
  images,
  lights,
  materials,
  meshes,
  nodes,
  samplers,
  scenes,
  skins,
  textures,
  count
};

enum class ValueKind : std::uint8_t {
  boolean,
  integer,     ///< min ≤ value ≤ max; a whole number written as 3.0 counts as one
  number,      ///< min ≤ value ≤ max
  text,        ///< A string; one of `choices` (separated by '|') where these are given
  texts,       ///< An array of strings
  index,       ///< Into `target`
  indices,     ///< An array of them
  index_map,   ///< An object whose values are indices
  index_maps,  ///< An array of such objects
  numbers,     ///< An array of min_items to max_items numbers in [min, max]
  object,      ///< As `object` says
  objects,     ///< An array of them
  free_object  ///< As `object` says where it is an object; any other value is left alone (extras)
};

struct ObjectRule;

struct PropertyRule {
  std::string_view name;
  ValueKind kind = ValueKind::boolean;
  bool required = false;
  bool positive = false;  ///< min is 0 and itself not allowed
  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();
  std::uint32_t multiple_of = 1;  ///< Integers only.
  std::size_t min_items = 0;
  std::size_t max_items = std::numeric_limits<std::size_t>::max();
  Target target = Target::count;
  std::string_view choices = {};
  const ObjectRule* object = nullptr;
};

struct ObjectRule {
  std::span<const PropertyRule> properties;
  /// A property that is not in the table is worth a warning: in extras.barrido it is a slip of the pen.
  bool closed = false;
};

/// The whole document.
const ObjectRule& document_rule();

}  // namespace barrido::scene::gltf
