// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

namespace barrido::cli {

/// "1,234,567"
std::string grouped(std::uint64_t number);

/// With so many digits after the point: "12.50".
std::string fixed(double number, int digits);

/// The shortest text that reads back as this float: "0.1", "1e+20".
std::string shortest(float number);
/// The same of a double.
std::string shortest_double(double number);
/// "0.1,2,3"
std::string shortest(const glm::vec3& v);
std::string shortest(const glm::dvec3& v);

/// `text` with blanks before or after it to `width` characters (of UTF-8).
std::string left(std::string text, std::size_t width);
std::string right(std::string text, std::size_t width);

/// "1 mesh", "2 meshes": the number with the word for one or for several.
std::string counted(std::uint64_t number, const char* one, const char* several);

/// Characters of a UTF-8 text.
std::size_t character_count(const std::string& text);

}  // namespace barrido::cli
