#include "viewer/barrido/text_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace barrido::cli {

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ',');
  return digits;
}

std::string fixed(double number, int digits) {
  std::array<char, 400> text{};  // The largest double has 309 digits before the point.
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, digits).ptr;
  return {text.data(), end};
}

std::string shortest(float number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

std::string shortest_double(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

std::string shortest(const glm::vec3& v) { return shortest(v.x) + "," + shortest(v.y) + "," + shortest(v.z); }

std::string shortest(const glm::dvec3& v) {
  const auto text = [](double c) {
    const auto rounded = static_cast<float>(c);
    return double{rounded} == c ? shortest(rounded) : shortest_double(c);
  };
  return text(v.x) + "," + text(v.y) + "," + text(v.z);
}

std::size_t character_count(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }));
}

std::string left(std::string text, std::size_t width) {
  const std::size_t count = character_count(text);
  if (count < width) text.append(width - count, ' ');
  return text;
}

std::string right(std::string text, std::size_t width) {
  const std::size_t count = character_count(text);
  if (count < width) text.insert(0, width - count, ' ');
  return text;
}

std::string counted(std::uint64_t number, const char* one, const char* several) {
  return grouped(number) + " " + (number == 1 ? one : several);
}

}  // namespace barrido::cli
