#include "pipeline/inspect/story_words.h"

#include <cstdio>

namespace barrido::inspect {
std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.6g", value);
  return text;
}

std::string tuple(std::span<const float> values) {
  std::string text = "(";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? ", " : "") + number(values[i]);
  return text + ")";
}

std::string tuple(const glm::vec3& v) {
  const float values[3] = {v.x, v.y, v.z};
  return tuple(values);
}

std::string_view name_of_face(int face) {
  constexpr std::array<std::string_view, 6> kFaces{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  return kFaces.at(static_cast<std::size_t>(face));
}

}  // namespace barrido::inspect
