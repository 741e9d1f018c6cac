// The shape of a glTF document as tables: which properties an object has, of which type, in which range. One
// row serves whoever validates and whoever draws: it tells what the standard asks for, and in a column how
// much of that a drawing needs. Most of what the standard forbids is drawn all the same. Must not know how
// documents are stored.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace barrido::scene::gltf {

/// Objects that extensions may extend, or whose properties depend on each other.
enum class ObjectType : std::uint8_t {
  other,
  accessor,
  animation_pointer,
  asset,
  buffer_view,
  camera,
  channel_target,
  document,
  image,
  iridescence,
  light,
  material,
  mesh,
  node,
  normal_texture_info,
  occlusion_texture_info,
  orthographic,
  perspective,
  primitive,
  spot,
  texture,
  texture_info,
  texture_transform,
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
inline constexpr auto kCollections = static_cast<std::size_t>(Collection::count);

/// "accessors", "bufferViews" …
std::string_view name_of(Collection collection);
/// "/accessors", "/extensions/KHR_lights_punctual/lights" …
std::string pointer_to(Collection collection);

enum class Kind : std::uint8_t {
  any,  ///< Whatever it is, a check of its own sees to it.
  boolean,
  integer,     ///< In the range, or one of `integers`; a whole number written as 3.0 counts as one
  number,      ///< In the range
  text,        ///< One of `choices`, separated by '|', where there are any; others stay, with a warning
  texts,       ///< An array of different strings
  index,       ///< Into `target`; into an array that only the object itself knows where that is `count`
  indices,     ///< An array of different ones
  index_map,   ///< An object of them
  index_maps,  ///< An array of such objects
  numbers,     ///< An array of min_items to max_items numbers in the range
  object,      ///< As `schema` says
  objects,     ///< An array of them; one that is no object spoils all
  collection,  ///< An array of them; one that is no object is as if it were not there
};

/// What of a property ends a drawing when it is not as the standard says.
enum class Drawing : std::uint8_t {
  ignored,  ///< Nothing: drawing does not read it.
  form,     ///< Its type, the number of elements, its absence, indices of nothing
  value,    ///< Those, its range and the choices
};

struct Range {
  double min = std::numeric_limits<double>::lowest();
  double max = std::numeric_limits<double>::max();
};

struct Schema;

struct Property {
  std::string_view name;
  Kind kind = Kind::any;
  bool required = false;
  bool above_min = false;  ///< The range's minimum itself is out of it.
  bool below_max = false;  ///< So is its maximum.
  bool unused = false;     ///< To be referred to from here is not to be used.
  bool of_type = false;    ///< Belongs to objects whose "type" is its name, and is required there.
  Range range = {};
  double or_else = std::numeric_limits<double>::quiet_NaN();  ///< Allowed although out of the range.
  int multiple_of = 1;                                        ///< Integers only.
  std::size_t min_items = 0;
  std::size_t max_items = std::numeric_limits<std::size_t>::max();
  Collection target = Collection::count;
  std::span<const int> integers = {};
  std::string_view choices = {};
  const Schema* schema = nullptr;

  Drawing drawing = Drawing::form;
  Range drawn = {};  ///< Where only the form matters, numbers outside end a drawing all the same.
};

struct Schema {
  ObjectType type = ObjectType::other;
  std::span<const Property> properties = {};
  const Schema* barrido =
      nullptr;  ///< What the object's extras.barrido holds (docs/barrido-extras.schema.json).
  /// Drawing warns of a property that is not in the table: in extras.barrido it is a slip of the pen.
  bool closed = false;
};

const Schema& document_schema();

struct Extension {
  std::string_view name;
  bool must_be_required = false;
};

/// Where an extension has its properties, and which.
struct ExtensionObject {
  std::string_view name;
  ObjectType type = ObjectType::other;
  const Schema* schema = nullptr;
  Drawing drawing = Drawing::ignored;
  bool alone = false;  ///< May not go together with others.
};

std::span<const ExtensionObject> extension_objects();
/// Null where the extension is not known.
const Extension* find_extension(std::string_view name);
/// Null where the extension has no place in objects of that type.
const ExtensionObject* find_extension_object(std::string_view name, ObjectType type);

/// Of choices separated by '|'.
bool is_choice(std::string_view text, std::string_view choices);
/// The same separated by commas, for a message.
std::string list_of(std::string_view choices);

}  // namespace barrido::scene::gltf
