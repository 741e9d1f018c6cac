// Names of enumerations. Each enumeration has one table, which options, settings files, reports, stories and
// the window read: raster/names.h, pipeline/names.h, pipeline/scene/names.h. A table that forgets an
// enumerator does not compile.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

namespace barrido {

template <class Value>
struct Named {
  Value value;
  std::string_view name;          ///< In options, files and reports: "cheap-phong".
  std::string_view title = name;  ///< Where people read it: "cheap Phong".
};

/// The table of an enumeration, in the order in which messages and lists tell it: an array of Named<Value>.
/// Specialised for every enumeration that has names.
template <class Value>
inline constexpr std::nullptr_t kNames = nullptr;

namespace enum_names {

/// Compilers spell a number that has no enumerator as a cast, "(Color)7".
template <auto value>
constexpr bool is_enumerator() {
  return std::string_view(__PRETTY_FUNCTION__).find("value = (") == std::string_view::npos;
}

template <auto value, std::size_t count>
constexpr bool is_named(const std::array<Named<decltype(value)>, count>& table) {
  for (const Named<decltype(value)>& row : table) {
    if (row.value == value) return !row.name.empty() && !row.title.empty();
  }
  return false;
}

inline constexpr std::size_t kMostEnumerators = 32;

/// Whether each enumerator in 0..31 has a name, given once.
template <class Value, std::size_t count>
constexpr bool is_complete(const std::array<Named<Value>, count>& table) {
  return [&]<std::size_t... numbers>(std::index_sequence<numbers...>) {
    std::size_t enumerators = 0;
    const auto check = [&]<std::size_t number>() {
      constexpr auto value = static_cast<Value>(number);
      if constexpr (!is_enumerator<value>()) return true;
      ++enumerators;
      return is_named<value>(table);
    };
    return (check.template operator()<numbers>() && ...) && enumerators == count;
  }
  (std::make_index_sequence<kMostEnumerators>());
}

}  // namespace enum_names

template <class Value>
constexpr std::span<const Named<Value>> names_of() {
  if constexpr (std::is_enum_v<Value>) {
    static_assert(enum_names::is_complete<Value>(kNames<Value>), "an enumerator has no name, or two");
  }
  return kNames<Value>;
}

template <class Value>
constexpr std::string_view name_of(Value value) {
  for (const Named<Value>& row : names_of<Value>()) {
    if (row.value == value) return row.name;
  }
  return {};
}

template <class Value>
constexpr std::optional<Value> value_named(std::string_view name) {
  for (const Named<Value>& row : names_of<Value>()) {
    if (row.name == name) return row.value;
  }
  return std::nullopt;
}

}  // namespace barrido
