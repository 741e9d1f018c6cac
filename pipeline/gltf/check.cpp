// The walk over a document along the tables of gltf_rules.h. It goes only where the tables lead, so its depth
// is theirs, whatever the document holds.
#include "pipeline/gltf/check.h"

#include <array>
#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/gltf/rules.h"

namespace barrido::scene::gltf {
namespace {

using nlohmann::json;

/// Where the walk is, as a chain up to the root: made into text only when something is wrong.
struct Place {
  static constexpr std::size_t kNoIndex = SIZE_MAX;
  const Place* parent = nullptr;
  std::string_view name;
  std::size_t index = kNoIndex;

  std::string text() const {
    std::string above = parent != nullptr ? parent->text() : std::string();
    if (index != kNoIndex) return above + '[' + std::to_string(index) + ']';
    if (above.empty()) return one_line(name, 80);
    return above + '.' + one_line(name, 80);
  }
};

constexpr std::array<std::string_view, static_cast<std::size_t>(Target::count)> kTargetNames = {
    "accessors", "buffers", "bufferViews", "cameras", "images", "lights",  "materials",
    "meshes",    "nodes",   "samplers",    "scenes",  "skins",  "textures"};

std::string shown(double value) {
  const bool is_exact_integer = std::floor(value) == value && std::abs(value) <= 9007199254740992.0;
  return is_exact_integer ? std::to_string(static_cast<std::int64_t>(value)) : json(value).dump();
}

class Checker {
 public:
  Checker(Report& report, const json& document) : report_(report) {
    for (std::size_t target = 0; target < kTargetNames.size(); ++target) {
      const auto array = document.find(kTargetNames[target]);
      if (array != document.end() && array->is_array()) sizes_[target] = array->size();
    }
    static const json::json_pointer kLights("/extensions/KHR_lights_punctual/lights");
    if (document.contains(kLights) && document[kLights].is_array()) {
      sizes_[static_cast<std::size_t>(Target::lights)] = document[kLights].size();
    }
  }

  void check_object(json& value, const ObjectRule& rule, const Place& place) const {
    if (!value.is_object()) fail(place, "must be an object");
    for (const PropertyRule& property : rule.properties) {
      const auto found = value.find(property.name);
      if (found != value.end()) {
        check_value(*found, property, Place{&place, property.name});
      } else if (property.required) {
        fail(place, "\"" + std::string(property.name) + "\" is missing");
      }
    }
    if (rule.closed) warn_of_others(value, rule, place);
  }

 private:
  [[noreturn]] void fail(const Place& place, const std::string& reason) const {
    report_.fail(place.text(), reason);
  }

  void warn_of_others(const json& value, const ObjectRule& rule, const Place& place) const {
    for (const auto& [name, unused] : value.items()) {
      bool known = false;
      for (const PropertyRule& property : rule.properties) known = known || property.name == name;
      if (!known) report_.warn(Place{&place, name}.text() + ": there is no such property; it is ignored");
    }
  }

  void check_value(json& value, const PropertyRule& rule, const Place& place) const {
    switch (rule.kind) {
      case ValueKind::boolean:
        if (!value.is_boolean()) fail(place, "must be true or false");
        break;
      case ValueKind::integer:
        check_integer(value, rule.min, rule.max, place);
        if (value.get<std::int64_t>() % rule.multiple_of != 0) {
          fail(place, "must be a multiple of " + std::to_string(rule.multiple_of));
        }
        break;
      case ValueKind::number:
        check_number(value, rule, place);
        break;
      case ValueKind::text:
        check_text(value, rule, place);
        break;
      case ValueKind::index:
        check_index(value, rule.target, place);
        break;
      case ValueKind::index_map:
        check_index_map(value, rule.target, place);
        break;
      case ValueKind::object:
        check_object(value, *rule.object, place);
        break;
      case ValueKind::free_object:
        if (value.is_object()) check_object(value, *rule.object, place);
        break;
      case ValueKind::texts:
      case ValueKind::indices:
      case ValueKind::index_maps:
      case ValueKind::numbers:
      case ValueKind::objects:
        check_array(value, rule, place);
        break;
    }
  }

  void check_array(json& value, const PropertyRule& rule, const Place& place) const {
    if (!value.is_array()) fail(place, "must be an array");
    if (value.size() < rule.min_items || value.size() > rule.max_items) {
      std::string count = std::to_string(rule.min_items);
      if (rule.max_items != rule.min_items) count += " to " + std::to_string(rule.max_items);
      fail(place, "must have " + count + " elements, not " + std::to_string(value.size()));
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      json& item = value[i];
      const Place item_place{&place, {}, i};
      switch (rule.kind) {
        case ValueKind::texts:
          if (!item.is_string()) fail(item_place, "must be a string");
          break;
        case ValueKind::indices:
          check_index(item, rule.target, item_place);
          break;
        case ValueKind::index_maps:
          check_index_map(item, rule.target, item_place);
          break;
        case ValueKind::numbers:
          check_number(item, rule, item_place);
          break;
        default:
          check_object(item, *rule.object, item_place);
          break;
      }
    }
  }

  void check_integer(json& value, double min, double max, const Place& place) const {
    if (!value.is_number()) fail(place, "must be a whole number");
    const double number = value.get<double>();
    if (std::floor(number) != number) fail(place, "must be a whole number");
    check_range(number, min, max, place);
    if (!value.is_number_float()) return;
    if (number < 0) {
      value = static_cast<std::int64_t>(number);
    } else {
      value = static_cast<std::uint64_t>(number);
    }
  }

  void check_number(const json& value, const PropertyRule& rule, const Place& place) const {
    if (!value.is_number()) fail(place, "must be a number");
    const double number = value.get<double>();
    if (rule.positive && number <= 0) fail(place, "is " + shown(number) + ", but must be greater than 0");
    check_range(number, rule.min, rule.max, place);
  }

  void check_range(double number, double min, double max, const Place& place) const {
    if (number < min) fail(place, "is " + shown(number) + ", but must be at least " + shown(min));
    if (number > max) fail(place, "is " + shown(number) + ", but must be at most " + shown(max));
  }

  void check_text(const json& value, const PropertyRule& rule, const Place& place) const {
    if (!value.is_string()) fail(place, "must be a string");
    if (rule.choices.empty()) return;
    const auto& text = value.get_ref<const std::string&>();
    std::string_view rest = rule.choices;
    while (!rest.empty()) {
      const std::string_view choice = rest.substr(0, rest.find('|'));
      if (choice == text) return;
      rest.remove_prefix(std::min(choice.size() + 1, rest.size()));
    }
    std::string choices(rule.choices);
    for (std::size_t at = 0; (at = choices.find('|', at)) != std::string::npos; at += 2) {
      choices.replace(at, 1, ", ");
    }
    fail(place, "is \"" + one_line(text, 40) + "\"; known are " + choices);
  }

  void check_index(json& value, Target target, const Place& place) const {
    const auto which = static_cast<std::size_t>(target);
    check_integer(value, -2147483648.0, 9007199254740992.0, place);
    const double number = value.get<double>();
    if (number >= 0 && number < static_cast<double>(sizes_[which])) return;
    const std::string size = sizes_[which] == 0 ? "none" : std::to_string(sizes_[which]);
    fail(place, "refers to " + std::string(kTargetNames[which]) + "[" + shown(number) + "], but there " +
                    (sizes_[which] == 1 ? "is " : "are ") + size);
  }

  void check_index_map(json& value, Target target, const Place& place) const {
    if (!value.is_object()) fail(place, "must be an object");
    for (auto item = value.begin(); item != value.end(); ++item) {
      check_index(*item, target, Place{&place, item.key()});
    }
  }

  Report& report_;
  std::array<std::size_t, static_cast<std::size_t>(Target::count)> sizes_{};
};

}  // namespace

void check_document(Report& report, json& document) {
  if (!document.is_object()) report.fail("JSON", "must be an object");
  const Checker checker(report, document);
  checker.check_object(document, document_rule(), Place{});
}

}  // namespace barrido::scene::gltf
