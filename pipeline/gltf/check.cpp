// The walk over a document along the schema's tables, with what in them ends a drawing. It goes only where
// the tables lead, so its depth is theirs, whatever the document holds.
#include "pipeline/gltf/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/files/error.h"
#include "pipeline/gltf/schema.h"
#include "pipeline/gltf/stand_ins.h"

namespace barrido::scene::gltf {
namespace {

using nlohmann::json;

constexpr double kMaxExact = 9007199254740992.0;  // 2^53: every integer up to it is exact in JSON.
constexpr double kMaxInt = 2147483647.0;

class Checker {
 public:
  Checker(Report& report, const json& document) : report_(report), document_(document) {
    for (std::size_t i = 0; i < kCollections; ++i) {
      const json::json_pointer array(pointer_to(static_cast<Collection>(i)));
      if (document.contains(array) && document[array].is_array()) sizes_[i] = document[array].size();
    }
  }

  void check_object(json& value, const Schema& schema, const Place& place) {
    if (!value.is_object()) fail(place, "must be an object");
    for (const Property& property : schema.properties) {
      if (property.drawing == Drawing::ignored) continue;
      const auto found = value.find(property.name);
      if (found != value.end()) {
        check_value(*found, property, Place(place, property.name));
      } else if (property.required) {
        fail(place, '"' + std::string(property.name) + "\" is missing");
      }
    }
    check_extensions(value, schema, place);
    check_extras(value, schema, place);
    if (schema.closed) warn_of_others(value, schema, place);
  }

 private:
  [[noreturn]] void fail(const Place& place, const std::string& reason) const {
    report_.fail(place.text(), reason);
  }

  void check_extensions(json& object, const Schema& schema, const Place& place) {
    const auto extensions = object.find("extensions");
    if (extensions == object.end()) return;
    const Place extensions_place(place, "extensions");
    for (const ExtensionObject& extension : extension_objects()) {
      if (extension.type != schema.type || extension.drawing == Drawing::ignored) continue;
      if (!extensions->is_object()) fail(extensions_place, "must be an object");
      const auto found = extensions->find(extension.name);
      if (found == extensions->end()) continue;
      check_object(*found, *extension.schema, Place(extensions_place, extension.name));
    }
  }

  /// extras.barrido only: extras may be anything to anybody else.
  void check_extras(json& object, const Schema& schema, const Place& place) {
    const auto extras = object.find("extras");
    if (schema.barrido == nullptr || extras == object.end() || !extras->is_object()) return;
    const auto barrido = extras->find("barrido");
    const Place extras_place(place, "extras");
    if (barrido != extras->end()) check_object(*barrido, *schema.barrido, Place(extras_place, "barrido"));
  }

  void warn_of_others(const json& value, const Schema& schema, const Place& place) const {
    for (const auto& [name, unused] : value.items()) {
      const bool known =
          std::any_of(schema.properties.begin(), schema.properties.end(),
                      [&name = name](const Property& property) { return property.name == name; });
      if (!known) report_.warn(Place(place, name).text() + ": there is no such property; it is ignored");
    }
  }

  void check_value(json& value, const Property& property, const Place& place) {
    switch (property.kind) {
      case Kind::any:
        break;
      case Kind::boolean:
        if (!value.is_boolean()) fail(place, "must be true or false");
        break;
      case Kind::integer:
        check_integer(value, range_of(property), place);
        if (value.get<std::int64_t>() % property.multiple_of != 0) {
          fail(place, "must be a multiple of " + std::to_string(property.multiple_of));
        }
        break;
      case Kind::number:
        check_number(value, property, place);
        break;
      case Kind::text:
        check_text(value, property, place);
        break;
      case Kind::index:
        check_index(value, property.target, place);
        break;
      case Kind::index_map:
        check_index_map(value, property.target, place);
        break;
      case Kind::object:
        check_object(value, *property.schema, place);
        break;
      case Kind::texts:
      case Kind::indices:
      case Kind::index_maps:
      case Kind::numbers:
      case Kind::objects:
      case Kind::collection:
        check_array(value, property, place);
        break;
    }
  }

  void check_array(json& value, const Property& property, const Place& place) {
    if (!value.is_array()) fail(place, "must be an array");
    if (value.size() < property.min_items || value.size() > property.max_items) {
      std::string count = std::to_string(property.min_items);
      if (property.max_items != property.min_items) count += " to " + std::to_string(property.max_items);
      fail(place, "must have " + count + " elements, not " + std::to_string(value.size()));
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      json& item = value[i];
      const Place item_place(place, i);
      switch (property.kind) {
        case Kind::texts:
          if (!item.is_string()) fail(item_place, "must be a string");
          break;
        case Kind::indices:
          check_index(item, property.target, item_place);
          break;
        case Kind::index_maps:
          check_index_map(item, property.target, item_place);
          break;
        case Kind::numbers:
          check_number(item, property, item_place);
          break;
        case Kind::collection:
          check_element(item, property, i, item_place);
          break;
        default:
          check_object(item, *property.schema, item_place);
          break;
      }
    }
  }

  /// What is wrong with an element that nothing drawn uses is a warning.
  void check_element(json& item, const Property& property, std::size_t index, const Place& place) {
    try {
      check_object(item, *property.schema, place);
    } catch (const InputError& error) {
      if (!stand_ins_) stand_ins_.emplace(document_);
      std::optional<json> stand_in = stand_ins_->find(property.name, index);
      if (!stand_in) throw;
      report_.warn(std::string(error.what()).substr(report_.file().size() + 2) +
                   "; nothing that is drawn uses it");
      item = std::move(*stand_in);
    }
  }

  static Range range_of(const Property& property) {
    return property.drawing == Drawing::value ? property.range : property.drawn;
  }

  void check_integer(json& value, const Range& range, const Place& place) const {
    const double number = value.is_number() ? value.get<double>() : 0.5;
    if (std::floor(number) != number) fail(place, "must be a whole number");
    check_range(number, {range.min, std::min(range.max, kMaxExact)}, place);
    if (!value.is_number_float()) return;
    if (number < 0) {
      value = static_cast<std::int64_t>(number);
    } else {
      value = static_cast<std::uint64_t>(number);
    }
  }

  void check_number(const json& value, const Property& property, const Place& place) const {
    if (!value.is_number()) fail(place, "must be a number");
    const double number = value.get<double>();
    const Range range = range_of(property);
    if (property.above_min && number <= range.min) {
      fail(place, "is " + shown(number) + ", but must be greater than " + shown(range.min));
    }
    check_range(number, range, place);
  }

  void check_range(double number, const Range& range, const Place& place) const {
    if (number < range.min) fail(place, "is " + shown(number) + ", but must be at least " + shown(range.min));
    if (number > range.max) fail(place, "is " + shown(number) + ", but must be at most " + shown(range.max));
  }

  void check_text(const json& value, const Property& property, const Place& place) const {
    if (!value.is_string()) fail(place, "must be a string");
    if (property.drawing != Drawing::value) return;
    const auto& text = value.get_ref<const std::string&>();
    if (is_choice(text, property.choices)) return;
    fail(place, "is \"" + one_line(text, 40) + "\"; known are " + list_of(property.choices));
  }

  void check_index(json& value, Collection target, const Place& place) const {
    if (target == Collection::count) return check_integer(value, {0, kMaxInt}, place);
    check_integer(value, {-kMaxInt - 1, kMaxExact}, place);
    const std::size_t size = sizes_[static_cast<std::size_t>(target)];
    const double number = value.get<double>();
    if (number >= 0 && number < static_cast<double>(size)) return;
    const std::string count = size == 0 ? "none" : std::to_string(size);
    fail(place, "refers to " + std::string(name_of(target)) + "[" + shown(number) + "], but there " +
                    (size == 1 ? "is " : "are ") + count);
  }

  void check_index_map(json& value, Collection target, const Place& place) const {
    if (!value.is_object()) fail(place, "must be an object");
    for (auto item = value.begin(); item != value.end(); ++item) {
      check_index(*item, target, Place(place, item.key()));
    }
  }

  Report& report_;
  const json& document_;
  std::optional<StandIns> stand_ins_;  ///< As the document was when first asked.
  std::array<std::size_t, kCollections> sizes_{};
};

}  // namespace

void check_document(Report& report, json& document) {
  if (!document.is_object()) report.fail("JSON", "must be an object");
  Checker checker(report, document);
  checker.check_object(document, document_schema(), Place());
}

}  // namespace barrido::scene::gltf
