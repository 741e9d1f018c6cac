// Makers of option values for fields of the options: what a row of the table says about reading and writing,
// from the type of the field.
#pragma once

#include <algorithm>
#include <type_traits>

#include "pipeline/scene/names.h"
#include "viewer/barrido/render_option_table.h"
#include "viewer/barrido/text_format.h"

namespace barrido {

template <>
inline constexpr auto kNames<bool> = std::to_array<Named<bool>>({{true, "on"}, {false, "off"}});

}  // namespace barrido

namespace barrido::cli {

namespace fields {

template <class Owner, class Value>
Owner owner_of(Value Owner::*);
template <class Owner, class Value>
Value value_of(Value Owner::*);

template <class Value>
struct Unwrapped {
  using Type = Value;
  static constexpr bool is_optional = false;
};
template <class Value>
struct Unwrapped<std::optional<Value>> {
  using Type = Value;
  static constexpr bool is_optional = true;
};

/// What a field holds, without the std::optional around it.
template <auto member>
using Value = typename Unwrapped<decltype(value_of(member))>::Type;

template <auto member>
inline constexpr bool kIsOptional = Unwrapped<decltype(value_of(member))>::is_optional;

template <class Value, std::size_t count>
inline constexpr auto kWords = [] {
  std::array<std::string_view, count> words{};
  for (std::size_t i = 0; i < count; ++i) words[i] = kNames<Value>[i].name;
  return words;
}();

template <class Value, std::size_t count>
inline constexpr auto kTitles = [] {
  std::array<std::string_view, count> titles{};
  for (std::size_t i = 0; i < count; ++i) titles[i] = kNames<Value>[i].title;
  return titles;
}();

/// Where the field is, of options or of a part of them.
template <auto member>
auto& of(auto& options) {
  using Owner = decltype(owner_of(member));
  if constexpr (std::is_same_v<Owner, RenderOptions>) return options.*member;
  if constexpr (std::is_same_v<Owner, LimitOptions>) return options.limits.*member;
  if constexpr (std::is_same_v<Owner, scene::RenderSettings>) return options.settings.*member;
  if constexpr (std::is_same_v<Owner, scene::CameraChoice>) return options.settings.camera.*member;
  if constexpr (std::is_same_v<Owner, scene::TextureChoice>) return options.settings.texture.*member;
  if constexpr (std::is_same_v<Owner, scene::UserDisplacement>) return options.settings.displacement.*member;
  if constexpr (std::is_same_v<Owner, scene::SampleChoice>) return options.settings.samples.*member;
  if constexpr (std::is_same_v<Owner, scene::Overlays>) return options.settings.overlays.*member;
  if constexpr (std::is_same_v<Owner, scene::MapOverride>) return options.settings.maps.*member;
}

template <auto member>
void clear(RenderOptions& options) {
  static const RenderOptions kDefaults;
  of<member>(options) = of<member>(kDefaults);
}

template <class Number>
std::string number_text(Number number) {
  if constexpr (std::is_same_v<Number, float>) return shortest(number);
  if constexpr (std::is_same_v<Number, int>) return std::to_string(number);
  return shortest_double(number);
}

/// One text for a field that has a value, none for one that has not.
template <auto member, class Function>
std::vector<std::string> written(const RenderOptions& options, const Function& text) {
  const auto& field = of<member>(options);
  if constexpr (kIsOptional<member>) {
    return field ? std::vector<std::string>{text(*field)} : std::vector<std::string>{};
  } else {
    return {text(field)};
  }
}

}  // namespace fields

/// A switch: the flag sets the field to `on`.
template <auto member, bool on = true>
constexpr OptionValue flag() {
  OptionValue value;
  value.kind = OptionKind::flag;
  value.read = [](const RenderOption&, RenderOptions& o, std::string_view) { fields::of<member>(o) = on; };
  value.write = [](const RenderOptions& o) {
    return fields::of<member>(o) == on ? std::vector<std::string>{""} : std::vector<std::string>{};
  };
  value.clear = fields::clear<member>;
  return value;
}

/// A word: one of the first `count` names of the field's enumeration.
template <auto member, std::size_t count = kNames<fields::Value<member>>.size()>
constexpr OptionValue choice() {
  using Value = fields::Value<member>;
  OptionValue value;
  value.read = [](const RenderOption&, RenderOptions& o, std::string_view text) {
    fields::of<member>(o) = parse_choice(text, std::span<const Named<Value>>(kNames<Value>).first(count));
  };
  value.write = [](const RenderOptions& o) {
    return fields::written<member>(o, [](Value chosen) { return std::string(name_of(chosen)); });
  };
  value.clear = fields::clear<member>;
  value.names = fields::kWords<Value, count>;
  value.titles = fields::kTitles<Value, count>;
  value.is_optional = fields::kIsOptional<member>;
  return value;
}

/// Several words with commas between them, or "all" for those from number `first_of_all` on. The window
/// chooses one.
template <auto member, std::size_t first_of_all = 0>
constexpr OptionValue choices() {
  using Value = typename fields::Value<member>::value_type;
  OptionValue value;
  value.read = [](const RenderOption&, RenderOptions& o, std::string_view text) {
    fields::of<member>(o) = parse_choices<Value>(text, kNames<Value>, first_of_all);
  };
  value.write = [](const RenderOptions& o) {
    std::string text;
    for (const Value& chosen : fields::of<member>(o)) {
      text += (text.empty() ? "" : ",") + std::string(name_of(chosen));
    }
    return std::vector{text};
  };
  value.clear = fields::clear<member>;
  value.names = fields::kWords<Value, kNames<Value>.size()>;
  value.titles = fields::kTitles<Value, kNames<Value>.size()>;
  return value;
}

/// A number, whole where the field is.
template <auto member>
constexpr OptionValue number(double least, double most) {
  using Value = fields::Value<member>;
  OptionValue value;
  value.read = [](const RenderOption& row, RenderOptions& o, std::string_view text) {
    const auto [lowest, highest] = row.value.range;
    if constexpr (std::is_same_v<Value, int>) {
      fields::of<member>(o) = parse_whole(text, static_cast<int>(lowest), static_cast<int>(highest));
    } else {
      fields::of<member>(o) = static_cast<Value>(parse_number(text, lowest, highest));
    }
  };
  value.write = [](const RenderOptions& o) {
    return fields::written<member>(o, [](Value number) { return fields::number_text(number); });
  };
  value.clear = fields::clear<member>;
  value.range = {least, most};
  value.is_number = true;
  value.is_whole = std::is_same_v<Value, int>;
  value.is_optional = fields::kIsOptional<member>;
  return value;
}

/// Three numbers, which messages call by the option's form.
template <auto member>
constexpr OptionValue vector(Range range = {}) {
  OptionValue value;
  value.read = [](const RenderOption& row, RenderOptions& o, std::string_view text) {
    const auto [least, most] = row.value.range;
    const auto [x, y, z] = parse_tuple<3>(text, row.syntax.form, least, most);
    fields::of<member>(o) = glm::vec3(x, y, z);
  };
  value.write = [](const RenderOptions& o) {
    return fields::written<member>(o, [](const glm::vec3& v) { return shortest(v); });
  };
  value.range = range;
  return value;
}

/// A text of its own: `parse` makes the field of it, `text` the other way round; none where that is empty.
template <auto member, auto parse, std::string (*text)(const fields::Value<member>&)>
constexpr OptionValue parsed() {
  OptionValue value;
  value.read = [](const RenderOption&, RenderOptions& o, std::string_view given) {
    fields::of<member>(o) = parse(given);
  };
  value.write = [](const RenderOptions& o) {
    std::vector<std::string> texts = fields::written<member>(o, text);
    std::erase(texts, std::string());
    return texts;
  };
  return value;
}

/// What has functions of its own.
template <auto read, auto write>
constexpr OptionValue custom(OptionKind kind = OptionKind::value) {
  OptionValue value;
  value.kind = kind;
  value.read = [](const RenderOption&, RenderOptions& o, std::string_view given) { read(o, given); };
  value.write = [](const RenderOptions& o) -> std::vector<std::string> { return write(o); };
  return value;
}

}  // namespace barrido::cli
