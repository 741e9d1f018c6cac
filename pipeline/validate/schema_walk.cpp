// Objects, their extensions, and the document as the first of them.
#include "pipeline/validate/schema_walk.h"

#include <algorithm>
#include <set>

#include "pipeline/validate/value_checks.h"

namespace barrido::scene::validation {
namespace {

bool holds(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> strings_of(const Json& document, const char* name) {
  std::vector<std::string> strings;
  const auto found = document.find(name);
  if (found == document.end()) return strings;
  for (const Json& item : *found) strings.push_back(item.get<std::string>());
  return strings;
}

bool is_extension_name(std::string_view name) {
  const auto is_upper = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  const auto is_word = [&](char c) { return is_upper(c) || (c >= 'a' && c <= 'z') || c == '_'; };
  const auto prefix_end = std::find_if_not(name.begin(), name.end(), is_upper);
  return prefix_end != name.begin() && prefix_end != name.end() && *prefix_end == '_' &&
         prefix_end + 1 != name.end() && std::all_of(prefix_end, name.end(), is_word);
}

bool is_list_of_extensions(const Property& property) { return property.kind == Kind::texts; }

}  // namespace

SchemaWalk::SchemaWalk(Issues& issues, Json& document)
    : issues_(issues),
      document_(document),
      references_(document),
      materials_(references_.size(Collection::materials)) {}

bool SchemaWalk::has_extension(std::string_view name) const { return holds(known_, name); }

bool SchemaWalk::run() {
  const Place root;
  const Schema& schema = gltf::document_schema();
  warn_of_unknown(document_, schema, root);
  if (document_.contains("extensionsRequired") && !document_.contains("extensionsUsed")) {
    issues_.add(kUnsatisfiedDependency, Place(root, "extensionsRequired"), {"extensionsUsed"});
  }
  for (const Property& property : schema.properties) {
    if (is_list_of_extensions(property)) check_property(document_, property, root);
  }
  init_extensions();
  for (const Property& property : schema.properties) {
    if (is_list_of_extensions(property)) continue;
    check_property(document_, property, root);
    if (property.name == "asset" && !check_version()) return false;
  }
  walk_extensions(document_, schema, root);
  return true;
}

bool SchemaWalk::check_version() {
  const auto asset = document_.find("asset");
  if (asset == document_.end() || !asset->contains("version")) return false;
  const Place root, place(root, "asset"), version_place(place, "version");
  const auto version = (*asset)["version"].get<std::string>();
  if (!version.starts_with("2.")) {
    issues_.add(kUnknownAssetMajorVersion, version_place, {in_quotes(version)});
    return false;
  }
  if (version != "2.0") issues_.add(kUnknownAssetMinorVersion, version_place, {in_quotes(version)});
  return true;
}

void SchemaWalk::init_extensions() {
  declared_ = strings_of(document_, "extensionsUsed");
  const std::vector<std::string> required = strings_of(document_, "extensionsRequired");
  const Place root, used_place(root, "extensionsUsed"), required_place(root, "extensionsRequired");
  for (std::size_t i = 0; i < declared_.size(); ++i) {
    const std::string& name = declared_[i];
    const Place place(used_place, i);
    if (!is_extension_name(name)) issues_.add(kInvalidExtensionNameFormat, place);
    const gltf::Extension* extension = gltf::find_extension(name);
    if (extension == nullptr) {
      issues_.add(kUnsupportedExtension, place, {in_quotes(name)});
      continue;
    }
    if (extension->must_be_required && !holds(required, name)) {
      issues_.add(kNonRequiredExtension, place, {name});
    }
    if (!holds(known_, name)) known_.push_back(name);
  }
  const std::set<std::string> declared(declared_.begin(), declared_.end());
  for (std::size_t i = 0; i < required.size(); ++i) {
    if (declared.contains(required[i])) continue;
    issues_.add(kUnusedExtensionRequired, Place(required_place, i), {in_quotes(required[i])});
  }
}

void SchemaWalk::warn_of_unknown(const Json& object, const Schema& schema, const Place& place) {
  for (const auto& [name, unused] : object.items()) {
    if (name == "extensions" || name == "extras") continue;
    const bool known =
        std::any_of(schema.properties.begin(), schema.properties.end(),
                    [&name = name](const Property& property) { return property.name == name; });
    if (!known) issues_.add(kUnexpectedProperty, Place(place, name));
  }
}

void SchemaWalk::check_property(Json& object, const Property& property, const Place& place) {
  const auto found = object.find(property.name);
  const bool is_null = found != object.end() && found->is_null();
  if (property.required && (found == object.end() || is_null)) {
    issues_.add(kUndefinedProperty, place, {in_quotes(property.name)});
  }
  if (found == object.end()) return;
  if (!check_value(*found, property, Place(place, property.name))) object.erase(found);
}

void SchemaWalk::walk_object(Json& object, const Schema& schema, const Place& place) {
  warn_of_unknown(object, schema, place);
  resolves_ = has_its_arrays(schema, place);
  for (const Property& property : schema.properties) {
    if (!property.of_type) check_property(object, property, place);
  }
  resolves_ = true;
  walk_extensions(object, schema, place);
  check_values(*this, schema.type, object, place);
  for (Property property : schema.properties) {
    if (!property.of_type || object.value("type", std::string()) != property.name) continue;
    property.required = true;
    check_property(object, property, place);
  }
}

void SchemaWalk::walk_extensions(Json& object, const Schema& schema, const Place& place) {
  const auto extras = object.find("extras");
  if (extras != object.end() && !extras->is_object() && !extras->is_null()) {
    issues_.add(kNonObjectExtras, Place(place, "extras"));
  }
  const auto extensions = object.find("extensions");
  if (extensions == object.end()) return;
  const Place extensions_place(place, "extensions");
  if (!has_type(extensions->is_object(), *extensions, "an object", extensions_place)) {
    object.erase(extensions);
    return;
  }
  std::vector<std::string> names;
  for (const auto& [name, unused] : extensions->items()) names.push_back(name);
  for (const std::string& name : names) walk_extension(*extensions, name, schema, extensions_place);
}

void SchemaWalk::walk_extension(Json& extensions, const std::string& name, const Schema& schema,
                                const Place& extensions_place) {
  const Place place(extensions_place, name);
  Json& value = extensions[name];
  const bool is_object = has_type(value.is_object(), value, "an object", place);
  if (!has_extension(name)) {
    if (!holds(declared_, name)) issues_.add(kUndeclaredExtension, place);
    if (!is_object) extensions.erase(name);
    return;
  }
  const gltf::ExtensionObject* extension = gltf::find_extension_object(name, schema.type);
  if (extension == nullptr) issues_.add(kUnexpectedExtensionObject, place);
  if (extension == nullptr || !is_object) {
    extensions.erase(name);
    return;
  }
  if (extension->alone && extensions.size() > 1) issues_.add(kMultipleExtensions, place);
  walk_object(value, *extension->schema, place);
}

bool SchemaWalk::check_objects(Json& value, const Property& property, const Place& place) {
  if (!has_type(value.is_array(), value, "an array", place)) return false;
  if (value.empty()) {
    issues_.add(kEmptyEntity, place);
    return false;
  }
  bool all_objects = true;
  for (const Json& item : value) {
    if (item.is_object()) continue;
    issues_.add(kArrayTypeMismatch, place, {shown(item), "an object"});
    all_objects = false;
  }
  if (!all_objects) return false;
  for (std::size_t i = 0; i < value.size(); ++i) walk_object(value[i], *property.schema, Place(place, i));
  return true;
}

bool SchemaWalk::check_collection(Json& value, const Property& property, const Place& place) {
  if (!has_type(value.is_array(), value, "an array", place)) return false;
  if (value.empty()) issues_.add(kEmptyEntity, place);
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Place item_place(place, i);
    if (property.schema->type == ObjectType::material) material_ = &materials_[i];
    if (has_type(value[i].is_object(), value[i], "an object", item_place)) {
      walk_object(value[i], *property.schema, item_place);
    }
    material_ = nullptr;
  }
  return true;
}

bool SchemaWalk::check_value(Json& value, const Property& property, const Place& place) {
  switch (property.kind) {
    case Kind::any:
      return true;
    case Kind::boolean:
      return has_type(value.is_boolean(), value, "true or false", place);
    case Kind::integer:
      return check_integer(value, property, place);
    case Kind::number:
      return check_number(value, property, place);
    case Kind::text:
      return check_text(value, property, place);
    case Kind::texts:
      return check_texts(value, place);
    case Kind::index:
      return check_index(value, property, place);
    case Kind::indices:
      return check_indices(value, property, place);
    case Kind::index_map:
      return check_index_map(value, property, place);
    case Kind::index_maps:
      return check_index_maps(value, property, place);
    case Kind::numbers:
      return check_numbers(value, property, place);
    case Kind::object:
      if (!has_type(value.is_object(), value, "an object", place)) return false;
      walk_object(value, *property.schema, place);
      return true;
    case Kind::objects:
      return check_objects(value, property, place);
    case Kind::collection:
      return check_collection(value, property, place);
  }
  return true;
}

}  // namespace barrido::scene::validation
