// Words and numbers for telling a story: names and short forms of numbers. Knows no story.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "pipeline/inspect/pixel_story.h"
#include "pipeline/scene/names.h"

namespace barrido {

template <>
inline constexpr auto kNames<inspect::Fate> =
    std::to_array<Named<inspect::Fate>>({{inspect::Fate::visible, "visible"},
                                         {inspect::Fate::covered, "covered"},
                                         {inspect::Fate::hidden, "hidden"},
                                         {inspect::Fate::cut_out, "cut-out"},
                                         {inspect::Fate::scissored, "scissored"}});

}  // namespace barrido

namespace barrido::inspect {

/// Six significant digits: "0.714286", "1e-07".
std::string number(double value);

/// "(0.1, 0.2, 0.3)"
std::string tuple(std::span<const float> values);
std::string tuple(const glm::vec3& v);

/// "+X" … of a cube map's face.
std::string_view name_of_face(int face);

}  // namespace barrido::inspect
