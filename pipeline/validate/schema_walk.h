// The walk over a document along the schema's tables. What does not pass is reported and taken out of the
// document, so that whoever looks at it afterwards finds only values of the right type in the right range.
// The walk goes only where the tables lead, so its depth is theirs, whatever the document holds.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/validate/references.h"

namespace barrido::scene::validation {

/// What a material asks of the meshes it is on.
struct MaterialNeeds {
  /// Where a set of texture coordinates is needed, as a JSON pointer, and which set.
  std::vector<std::pair<std::string, std::size_t>> texcoords;
  bool tangents = false;
};

class SchemaWalk {
 public:
  SchemaWalk(Issues& issues, Json& document);

  /// Returns false when the document is of a version that cannot be checked.
  bool run();

  Issues& issues() { return issues_; }
  References& references() { return references_; }
  std::vector<MaterialNeeds>& materials() { return materials_; }
  /// Of the material that is being walked; null outside of materials.
  MaterialNeeds* material() { return material_; }
  /// Whether the file declares the extension, and its rules are known.
  bool has_extension(std::string_view name) const;

  /// Checks the property as the others of the tables are; it is gone afterwards unless it passes.
  void check_property(Json& object, const Property& property, const Place& place);

 private:
  void walk_object(Json& object, const Schema& schema, const Place& place);
  void warn_of_unknown(const Json& object, const Schema& schema, const Place& place);
  void init_extensions();
  bool check_version();
  void walk_extensions(Json& object, const Schema& schema, const Place& place);
  void walk_extension(Json& extensions, const std::string& name, const Schema& schema, const Place& place);

  bool check_value(Json& value, const Property& property, const Place& place);
  bool check_integer(Json& value, const Property& property, const Place& place);
  bool check_number(const Json& value, const Property& property, const Place& place);
  bool check_text(const Json& value, const Property& property, const Place& place);
  bool check_texts(const Json& value, const Place& place);
  bool check_index(Json& value, const Property& property, const Place& place);
  bool check_indices(Json& value, const Property& property, const Place& place);
  bool check_index_map(Json& value, const Property& property, const Place& place);
  bool check_index_maps(Json& value, const Property& property, const Place& place);
  bool check_numbers(const Json& value, const Property& property, const Place& place);
  bool check_objects(Json& value, const Property& property, const Place& place);
  bool check_collection(Json& value, const Property& property, const Place& place);
  /// Reports the type when it is not the one wanted.
  bool has_type(bool right, const Json& value, const char* wanted, const Place& place);
  void resolve(std::size_t index, const Property& property, const Place& place);
  /// Reports an object that refers to an extension's array where the document has no such extension.
  bool has_its_arrays(const Schema& schema, const Place& place);

  Issues& issues_;
  Json& document_;
  References references_;
  std::vector<std::string> declared_, known_;
  bool resolves_ = true;  ///< Whether indices of the object that is being walked mean something.
  std::vector<MaterialNeeds> materials_;
  MaterialNeeds* material_ = nullptr;
};

/// A JSON value for a message, on one line and not too long.
std::string shown(const Json& value);
using gltf::shown;

}  // namespace barrido::scene::validation
