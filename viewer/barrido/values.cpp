#include "viewer/barrido/values.h"

#include <charconv>
#include <cmath>

#include "pipeline/scene/view.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

/// All of `text` as a number; a plus in front is allowed, as in "--exposure +1".
template <class Number>
bool read_all(std::string_view text, Number& number) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

template <class Number>
bool read_numbers(std::string_view text, std::span<Number> into, double least, double most) {
  const std::vector<std::string_view> pieces = split(text, ',');
  if (pieces.size() != into.size()) return false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    double number = 0.0;
    if (!read_all(pieces[i], number) || !std::isfinite(number)) return false;
    if (number < least || number > most) return false;
    into[i] = static_cast<Number>(number);
  }
  return true;
}

}  // namespace

std::string range_text(double least, double most) {
  if (least <= -kAnyNumber && most >= kAnyNumber) return "";
  if (most >= kAnyNumber) return " of " + shortest_double(least) + " or more";
  return " in " + shortest_double(least) + ".." + shortest_double(most);
}

double parse_number(std::string_view text, double least, double most) {
  double number = 0.0;
  if (read_all(text, number) && std::isfinite(number) && number >= least && number <= most) return number;
  throw ValueError("expected a number" + range_text(least, most));
}

int parse_whole(std::string_view text, int least, int most) {
  int number = 0;
  if (read_all(text, number) && number >= least && number <= most) return number;
  throw ValueError("expected a whole number" + range_text(least, most));
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string_view::npos;
       end = text.find(separator, begin)) {
    pieces.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  pieces.push_back(text.substr(begin));
  return pieces;
}

bool parse_numbers(std::string_view text, std::span<float> into, double least, double most) {
  return read_numbers(text, into, least, most);
}

bool parse_numbers(std::string_view text, std::span<double> into, double least, double most) {
  return read_numbers(text, into, least, most);
}

glm::vec3 parse_point(std::string_view text) {
  const auto [x, y, z] = parse_tuple<3>(text, "X,Y,Z", -kAnyNumber, kAnyNumber);
  return {x, y, z};
}

glm::dvec3 parse_place(std::string_view text) {
  const auto [x, y, z] = parse_tuple<3, double>(text, "X,Y,Z", -kAnyNumber, kAnyNumber);
  return scene::kept_place({x, y, z});
}

glm::vec3 parse_direction(std::string_view text) {
  const glm::vec3 direction = parse_point(text);
  if (direction == glm::vec3(0.0f)) throw ValueError("expected a direction, not 0,0,0");
  return direction;
}

}  // namespace barrido::cli
