// Data, pictures, cameras and the asset's version.
#include "pipeline/validate/value_checks.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "pipeline/validate/format.h"

namespace barrido::scene::validation {
namespace {

/// Major and minor number of "2.0".
std::optional<std::pair<unsigned long, unsigned long>> parse_version(const std::string& version) {
  constexpr std::size_t kMaxDigits = 6;
  const auto is_digits = [](std::string_view part) {
    return !part.empty() && part.size() <= kMaxDigits &&
           std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  const std::size_t dot = version.find('.');
  if (dot == std::string::npos) return {};
  const std::string major = version.substr(0, dot), minor = version.substr(dot + 1);
  if (!is_digits(major) || !is_digits(minor)) return {};
  return std::pair(std::stoul(major), std::stoul(minor));
}

void check_version_form(SchemaWalk& walk, Json& asset, const char* name, const Place& place) {
  const auto found = asset.find(name);
  if (found == asset.end() || parse_version(found->get<std::string>())) return;
  walk.issues().add(kPatternMismatch, Place(place, name), {shown(*found), "2.0"});
  asset.erase(found);
}

/// min or max of an accessor of integers.
void check_integer_bounds(SchemaWalk& walk, Json& accessor, const char* name, std::size_t items, int type,
                          const Place& place) {
  const auto found = accessor.find(name);
  if (found == accessor.end()) return;
  const Place bounds_place(place, name);
  Issues& issues = walk.issues();
  bool right = found->is_array();
  if (!right) {
    issues.add(kTypeMismatch, bounds_place, {shown(*found), "an array"});
  } else if (found->size() != items) {
    issues.add(kArrayLengthNotInList, bounds_place, {std::to_string(found->size()), std::to_string(items)});
    right = false;
  } else {
    for (const Json& item : *found) {
      const double value = item.is_number() ? item.get<double>() : 0.5;
      const bool whole =
          value == static_cast<double>(static_cast<std::int64_t>(std::clamp(value, -1e18, 1e18)));
      if (!whole) {
        issues.add(kArrayTypeMismatch, bounds_place, {shown(item), "a whole number"});
      } else if (value < least_of(type) || value > greatest_of(type)) {
        issues.add(kInvalidGlValue, bounds_place, {shown(item), std::string(name_of_component(type))});
      } else {
        continue;
      }
      right = false;
    }
  }
  if (!right) accessor.erase(found);
}

void check_bounds(SchemaWalk& walk, Json& accessor, const char* name, const Place& place) {
  const auto component = accessor.find("componentType");
  const auto type_name = accessor.find("type");
  const TypeTraits* type =
      type_name == accessor.end() ? nullptr : find_type(type_name->get_ref<const std::string&>());
  if (component == accessor.end() || type == nullptr) {
    accessor.erase(name);
  } else if (*component == kFloat) {
    walk.check_property(
        accessor,
        {.name = name, .kind = Kind::numbers, .min_items = type->components, .max_items = type->components},
        place);
  } else {
    check_integer_bounds(walk, accessor, name, type->components, component->get<int>(), place);
  }
}

void check_asset_values(SchemaWalk& walk, Json& asset, const Place& place) {
  check_version_form(walk, asset, "version", place);
  check_version_form(walk, asset, "minVersion", place);
  if (!asset.contains("version") || !asset.contains("minVersion")) return;
  const auto version = asset["version"].get<std::string>();
  const auto least = asset["minVersion"].get<std::string>();
  if (parse_version(least) > parse_version(version)) {
    walk.issues().add(kAssetMinVersionGreaterThanVersion, Place(place, "minVersion"), {least, version});
  }
}

void check_accessor_values(SchemaWalk& walk, Json& accessor, const Place& place) {
  Issues& issues = walk.issues();
  if (accessor.contains("byteOffset") && !accessor.contains("bufferView")) {
    issues.add(kUnsatisfiedDependency, Place(place, "byteOffset"), {"bufferView"});
  }
  check_bounds(walk, accessor, "min", place);
  check_bounds(walk, accessor, "max", place);
  const int component = accessor.value("componentType", 0);
  if (accessor.value("normalized", false) && (component == kFloat || component == kUnsignedInt)) {
    issues.add(kAccessorNormalizedInvalid, Place(place, "normalized"));
  }
  const bool is_matrix = accessor.value("type", std::string()).starts_with("MAT");
  if (is_matrix && accessor.value("byteOffset", std::uint64_t{0}) % 4 != 0) {
    issues.add(kAccessorMatrixAlignment, Place(place, "byteOffset"));
  }
}

void check_buffer_view_values(SchemaWalk& walk, Json& view, const Place& place) {
  if (!view.contains("byteStride")) return;
  constexpr int kElementArrayBuffer = 34963;
  const Place stride_place(place, "byteStride");
  const auto stride = view["byteStride"].get<std::uint64_t>();
  Issues& issues = walk.issues();
  if (view.contains("byteLength") && stride > view["byteLength"].get<std::uint64_t>()) {
    issues.add(kBufferViewTooBigByteStride, stride_place,
               {std::to_string(stride), shown(view["byteLength"])});
  }
  if (view.value("target", 0) == kElementArrayBuffer) issues.add(kBufferViewInvalidByteStride, stride_place);
}

void check_image_values(SchemaWalk& walk, Json& image, const Place& place) {
  const bool has_webp = walk.has_extension("EXT_texture_webp");
  const std::string_view types = has_webp ? "image/jpeg|image/png|image/webp" : "image/jpeg|image/png";
  walk.check_property(image, {.name = "mimeType", .kind = Kind::text, .choices = types}, place);
  const bool has_view = image.contains("bufferView");
  if (has_view && !image.contains("mimeType")) {
    walk.issues().add(kUnsatisfiedDependency, Place(place, "bufferView"), {"mimeType"});
  }
  if (has_view == image.contains("uri")) walk.issues().add(kOneOfMismatch, place, {"bufferView, uri"});
}

void check_camera_values(SchemaWalk& walk, Json& camera, const Place& place) {
  if (camera.contains("orthographic") && camera.contains("perspective")) {
    walk.issues().add(kOneOfMismatch, place, {"orthographic, perspective"});
  }
}

void check_perspective_values(SchemaWalk& walk, Json& perspective, const Place& place) {
  constexpr double kPi = 3.141592653589793;
  if (perspective.value("yfov", 0.0) >= kPi) walk.issues().add(kCameraYfovGequalPi, place);
  if (perspective.contains("zfar") && perspective.contains("znear") &&
      perspective["zfar"].get<double>() <= perspective["znear"].get<double>()) {
    walk.issues().add(kCameraZfarLequalZnear, place);
  }
}

void check_orthographic_values(SchemaWalk& walk, Json& orthographic, const Place& place) {
  if (orthographic.contains("zfar") && orthographic.contains("znear") &&
      orthographic["zfar"].get<double>() <= orthographic["znear"].get<double>()) {
    walk.issues().add(kCameraZfarLequalZnear, place);
  }
  for (const char* name : {"xmag", "ymag"}) {
    const double size = orthographic.value(name, 1.0);
    if (size == 0.0) walk.issues().add(kCameraXmagYmagZero, Place(place, name));
    if (size < 0.0) walk.issues().add(kCameraXmagYmagNegative, Place(place, name));
  }
}

void check_channel_target_values(SchemaWalk& walk, Json& target, const Place& place) {
  const bool has_pointers = walk.has_extension("KHR_animation_pointer");
  const std::string_view paths =
      has_pointers ? "translation|rotation|scale|weights|pointer" : "translation|rotation|scale|weights";
  walk.check_property(target, {.name = "path", .kind = Kind::text, .choices = paths}, place);
  const auto extensions = target.find("extensions");
  if (extensions == target.end() || !extensions->contains("KHR_animation_pointer")) return;
  const Place extensions_place(place, "extensions"), pointer_place(extensions_place, "KHR_animation_pointer");
  walk.issues().add(kIncompleteExtensionSupport, pointer_place);
  const auto node = target.find("node");
  if (node != target.end() && walk.references().exists(Collection::nodes, node->get<std::size_t>())) {
    walk.issues().add(kAnimationPointerTargetNode, pointer_place);
  }
  const std::string path = target.value("path", std::string());
  if (path != "pointer") walk.issues().add(kAnimationPointerTargetPath, pointer_place, {in_quotes(path)});
}

void check_animation_pointer_values(SchemaWalk& walk, Json& object, const Place& place) {
  const std::string pointer = object.value("pointer", std::string());
  bool right = pointer.empty() || pointer[0] == '/';
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    if (pointer[i] == '~')
      right = right && i + 1 < pointer.size() && (pointer[i + 1] == '0' || pointer[i + 1] == '1');
  }
  if (!right)
    walk.issues().add(kPatternMismatch, Place(place, "pointer"), {in_quotes(pointer), "a JSON pointer"});
}

}  // namespace

void check_values(SchemaWalk& walk, ObjectType type, Json& object, const Place& place) {
  switch (type) {
    case ObjectType::accessor:
      return check_accessor_values(walk, object, place);
    case ObjectType::animation_pointer:
      return check_animation_pointer_values(walk, object, place);
    case ObjectType::asset:
      return check_asset_values(walk, object, place);
    case ObjectType::buffer_view:
      return check_buffer_view_values(walk, object, place);
    case ObjectType::camera:
      return check_camera_values(walk, object, place);
    case ObjectType::channel_target:
      return check_channel_target_values(walk, object, place);
    case ObjectType::image:
      return check_image_values(walk, object, place);
    case ObjectType::iridescence:
      return check_iridescence_values(walk, object, place);
    case ObjectType::light:
      return check_light_values(walk, object, place);
    case ObjectType::material:
      return check_material_values(walk, object, place);
    case ObjectType::mesh:
      return check_mesh_values(walk, object, place);
    case ObjectType::node:
      return check_node_values(walk, object, place);
    case ObjectType::normal_texture_info:
      return note_normal_texture_info(walk, object, place);
    case ObjectType::occlusion_texture_info:
    case ObjectType::texture_info:
      return note_texture_info(walk, object, place);
    case ObjectType::orthographic:
      return check_orthographic_values(walk, object, place);
    case ObjectType::perspective:
      return check_perspective_values(walk, object, place);
    case ObjectType::primitive:
      return check_primitive_values(walk, object, place);
    case ObjectType::spot:
      return check_spot_values(walk, object, place);
    case ObjectType::texture_transform:
      return note_texture_transform(walk, object, place);
    case ObjectType::document:
    case ObjectType::other:
    case ObjectType::texture:
      return;
  }
}

}  // namespace barrido::scene::validation
