// Values that are no objects: numbers, texts, indices, and arrays of them.
#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/gltf/report.h"
#include "pipeline/validate/schema_walk.h"

namespace barrido::scene::validation {
namespace {

constexpr std::size_t kNoIndex = SIZE_MAX;

/// 3 and 3.0 are whole; the value is an integer afterwards.
bool make_whole(Json& value) {
  if (value.is_number_integer()) return true;
  if (!value.is_number_float()) return false;
  const double number = value.get<double>();
  constexpr double kLargestExact = 9007199254740992.0;
  if (std::floor(number) != number || std::abs(number) > kLargestExact) return false;
  value = static_cast<std::int64_t>(number);
  return true;
}

/// A whole number from 0 on, or kNoIndex.
std::size_t index_in(Json& value) {
  if (!make_whole(value) || (!value.is_number_unsigned() && value.get<std::int64_t>() < 0)) return kNoIndex;
  return value.get<std::size_t>();
}

bool is_in_range(double value, const Property& property) {
  if (value == property.or_else) return true;
  if (is_infinite(value)) return false;
  return value >= property.range.min && value <= property.range.max &&
         !(property.above_min && value == property.range.min) &&
         !(property.below_max && value == property.range.max);
}

std::string list_of(std::span<const int> integers) {
  std::string text;
  for (const int value : integers) text += (text.empty() ? "" : ", ") + std::to_string(value);
  return text;
}

}  // namespace

std::string shown(const Json& value) {
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  if (value.is_number()) return shown(value.get<double>());
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array";
  return value.is_null() ? "null" : value.get<bool>() ? "true" : "false";
}

bool SchemaWalk::has_type(bool right, const Json& value, const char* wanted, const Place& place) {
  if (!right) issues_.add(kTypeMismatch, place, {shown(value), wanted});
  return right;
}

bool SchemaWalk::check_integer(Json& value, const Property& property, const Place& place) {
  if (!has_type(make_whole(value), value, "a whole number", place)) return false;
  const double number = value.get<double>();
  if (!property.integers.empty()) {
    if (std::find(property.integers.begin(), property.integers.end(), number) != property.integers.end()) {
      return true;
    }
    issues_.add(kValueNotInList, place, {shown(value), list_of(property.integers)});
    return false;
  }
  if (!is_in_range(number, property)) {
    issues_.add(kValueNotInRange, place, {shown(value)});
    return false;
  }
  if (value.get<std::int64_t>() % property.multiple_of != 0) {
    issues_.add(kValueMultipleOf, place, {shown(value), std::to_string(property.multiple_of)});
  }
  return true;
}

bool SchemaWalk::check_number(const Json& value, const Property& property, const Place& place) {
  if (!has_type(value.is_number(), value, "a number", place)) return false;
  if (is_in_range(value.get<double>(), property)) return true;
  issues_.add(kValueNotInRange, place, {shown(value)});
  return false;
}

bool SchemaWalk::check_text(const Json& value, const Property& property, const Place& place) {
  if (!has_type(value.is_string(), value, "a string", place)) return false;
  if (!property.choices.empty() && !gltf::is_choice(value.get_ref<const std::string&>(), property.choices)) {
    issues_.add(kValueNotInList, place, {shown(value), gltf::list_of(property.choices)});
  }
  return true;  // A word that is not known is still a word, and perhaps one of a later version.
}

bool SchemaWalk::check_texts(const Json& value, const Place& place) {
  if (!has_type(value.is_array(), value, "an array", place)) return false;
  if (value.empty()) {
    issues_.add(kEmptyEntity, place);
    return false;
  }
  bool all_texts = true;
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_string()) {
      issues_.add(kArrayTypeMismatch, Place(place, i), {shown(value[i]), "a string"});
      all_texts = false;
    } else if (!seen.insert(value[i].get_ref<const std::string&>()).second) {
      issues_.add(kDuplicateElements, Place(place, i), {shown(value[i])});
    }
  }
  return all_texts;
}

bool SchemaWalk::has_its_arrays(const Schema& schema, const Place& place) {
  for (const Property& property : schema.properties) {
    if (property.target != Collection::lights && property.target != Collection::variants) continue;
    const auto extension = Json::json_pointer(gltf::pointer_to(property.target)).parent_pointer();
    if (document_.contains(extension) && document_[extension].is_object()) continue;
    issues_.add(kUnsatisfiedDependency, place, {extension.to_string()});
    return false;
  }
  return true;
}

void SchemaWalk::resolve(std::size_t index, const Property& property, const Place& place) {
  const Collection target = property.target;
  if (!resolves_ || target == Collection::count)
    return;  // The array is known only to the object that holds both.
  if (!references_.exists(target, index)) {
    issues_.add(kUnresolvedReference, place, {gltf::element(gltf::name_of(target), index)});
  } else if (!property.unused) {
    references_.use(target, index);
  }
}

bool SchemaWalk::check_index(Json& value, const Property& property, const Place& place) {
  if (!has_type(make_whole(value), value, "a whole number", place)) return false;
  const std::size_t index = index_in(value);
  if (index == kNoIndex) {
    issues_.add(kInvalidIndex, place);
    return false;
  }
  resolve(index, property, place);
  return true;
}

bool SchemaWalk::check_indices(Json& value, const Property& property, const Place& place) {
  if (!has_type(value.is_array(), value, "an array", place)) return false;
  if (value.empty()) {
    issues_.add(kEmptyEntity, place);
    return false;
  }
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Place item_place(place, i);
    const std::size_t index = index_in(value[i]);
    if (index == kNoIndex) {
      issues_.add(kInvalidIndex, item_place);
      value[i] = -1;
      continue;
    }
    if (!seen.insert(index).second) issues_.add(kDuplicateElements, item_place, {std::to_string(index)});
    resolve(index, property, item_place);
  }
  return true;
}

bool SchemaWalk::check_index_map(Json& value, const Property& property, const Place& place) {
  if (!has_type(value.is_object(), value, "an object", place)) return false;
  if (value.empty()) {
    issues_.add(kEmptyEntity, place);
    return false;
  }
  for (auto item = value.begin(); item != value.end(); ++item) {
    const Place item_place(place, item.key());
    const std::size_t index = index_in(*item);
    if (index == kNoIndex) {
      issues_.add(kInvalidIndex, item_place);
      *item = -1;
    } else {
      resolve(index, property, item_place);
    }
  }
  return true;
}

bool SchemaWalk::check_index_maps(Json& value, const Property& property, const Place& place) {
  if (!has_type(value.is_array(), value, "an array", place)) return false;
  if (value.empty()) {
    issues_.add(kEmptyEntity, place);
    return false;
  }
  bool all_right = true;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_object()) {
      issues_.add(kArrayTypeMismatch, place, {shown(value[i]), "an object"});
      all_right = false;
    } else {
      all_right = check_index_map(value[i], property, Place(place, i)) && all_right;
    }
  }
  return all_right;
}

bool SchemaWalk::check_numbers(const Json& value, const Property& property, const Place& place) {
  if (!has_type(value.is_array(), value, "an array", place)) return false;
  if (value.empty()) {
    issues_.add(kEmptyEntity, place);
    return false;
  }
  if (value.size() < property.min_items || value.size() > property.max_items) {
    issues_.add(kArrayLengthNotInList, place,
                {std::to_string(value.size()), std::to_string(property.min_items)});
    return false;
  }
  bool all_right = true;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_number()) {
      issues_.add(kArrayTypeMismatch, place, {shown(value[i]), "a number"});
      all_right = false;
    } else if (!is_in_range(value[i].get<double>(), property)) {
      issues_.add(kValueNotInRange, Place(place, i), {shown(value[i])});
      all_right = false;
    }
  }
  return all_right;
}

}  // namespace barrido::scene::validation
