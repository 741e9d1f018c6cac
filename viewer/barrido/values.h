// Values of options from text: numbers, tuples of numbers, words out of a list. The whole text must be the
// value: nothing may be left over, and NaN and infinity are no numbers. Knows no option.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/barrido/spelling.h"
#include "viewer/barrido/usage_error.h"

namespace barrido::cli {

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

/// parse_numbers or a complaint. `form` is what the help calls the value, as "R,G,B".
/// @throws ValueError "expected R,G,B, 3 numbers in 0..1".
template <std::size_t Count>
std::array<float, Count> parse_tuple(std::string_view text, std::string_view form, double least,
                                     double most) {
  std::array<float, Count> values{};
  if (!parse_numbers(text, values, least, most)) {
    throw ValueError("expected " + std::string(form) + ", " + std::to_string(Count) + " numbers" +
                     range_text(least, most));
  }
  return values;
}

template <class Value>
struct Choice {
  std::string_view name;
  Value value;
};

/// The value with this name. @throws ValueError "expected one of phong, blinn; did you mean 'phong'?".
template <class Value, std::size_t Count>
Value parse_choice(std::string_view text, const std::array<Choice<Value>, Count>& choices) {
  std::vector<std::string_view> names;
  for (const Choice<Value>& choice : choices) {
    if (choice.name == text) return choice.value;
    names.push_back(choice.name);
  }
  throw ValueError("expected " + one_of(names) + did_you_mean(text, names));
}

}  // namespace barrido::cli
