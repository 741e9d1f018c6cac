// Values of options from text: numbers, tuples of numbers, words out of a list. The whole text must be the
// value: nothing may be left over, and NaN and infinity are no numbers. Knows no option.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "raster/base/enum_names.h"
#include "viewer/barrido/spelling.h"

namespace barrido::cli {

/// Why a value is refused; who reads the command line puts the option and the value in front.
class ValueError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// " in 0..1", or nothing where the range is that of all finite floats.
std::string range_text(double least, double most);

/// Bounds for numbers that may be anything a float holds; beyond, products of them would overflow.
inline constexpr double kAnyNumber = 1e18;

/// A finite number in [least, most]. @throws ValueError "expected a number in 0..180".
double parse_number(std::string_view text, double least, double most);

/// A whole number in [least, most]. @throws ValueError.
int parse_whole(std::string_view text, int least, int most);

/// The pieces between `separator`; one more than there are separators.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Exactly as many numbers as `into` holds, comma between them, each in [least, most].
/// @return false when there are fewer, more, or other things.
bool parse_numbers(std::string_view text, std::span<float> into, double least, double most);
bool parse_numbers(std::string_view text, std::span<double> into, double least, double most);

/// parse_numbers or a complaint. `form` is what the help calls the value, as "R,G,B".
/// @throws ValueError "expected R,G,B, 3 numbers in 0..1".
template <std::size_t Count, class Number = float>
std::array<Number, Count> parse_tuple(std::string_view text, std::string_view form, double least,
                                      double most) {
  std::array<Number, Count> values{};
  if (!parse_numbers(text, values, least, most)) {
    throw ValueError("expected " + std::string(form) + ", " + std::to_string(Count) + " numbers" +
                     range_text(least, most));
  }
  return values;
}

/// X,Y,Z of any finite size. @throws ValueError.
glm::vec3 parse_point(std::string_view text);

/// X,Y,Z of any finite size, as scene::CameraChoice holds places. @throws ValueError.
glm::dvec3 parse_place(std::string_view text);

/// parse_point, but not 0,0,0. @throws ValueError.
glm::vec3 parse_direction(std::string_view text);

/// The value with this name. @throws ValueError "expected phong or blinn; did you mean 'phong'?".
template <class Value>
Value parse_choice(std::string_view text, std::span<const Named<Value>> choices) {
  std::vector<std::string_view> names;
  for (const Named<Value>& choice : choices) {
    if (choice.name == text) return choice.value;
    names.push_back(choice.name);
  }
  throw ValueError("expected " + one_of(names) + did_you_mean(text, names));
}

/// One of all names of the enumeration. @throws ValueError.
template <class Value>
Value parse_name(std::string_view text) {
  return parse_choice(text, names_of<Value>());
}

/// Different values with commas between; "all" for those from `first_of_all` on. @throws ValueError.
template <class Value>
std::vector<Value> parse_choices(std::string_view text, std::span<const Named<Value>> choices,
                                 std::size_t first_of_all) {
  std::vector<Value> values;
  if (text == "all") {
    for (const Named<Value>& choice : choices.subspan(first_of_all)) values.push_back(choice.value);
    return values;
  }
  for (const std::string_view name : split(text, ',')) {
    try {
      values.push_back(parse_choice(name, choices));
    } catch (const ValueError& error) {
      throw ValueError(std::string(error.what()) + " (or several with commas between, or all)");
    }
    if (std::find(values.begin(), values.end() - 1, values.back()) != values.end() - 1) {
      throw ValueError(std::string(name) + " is given twice");
    }
  }
  return values;
}

}  // namespace barrido::cli
