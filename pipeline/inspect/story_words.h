// Words and numbers for telling a story: names of enumerations and short forms of numbers. Knows no story.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "pipeline/inspect/pixel_story.h"

namespace barrido::inspect {

/// Six significant digits: "0.714286", "1e-07".
std::string number(double value);

/// "(0.1, 0.2, 0.3)"
std::string tuple(std::span<const float> values);
std::string tuple(const glm::vec3& v);

std::string_view name_of(Fate fate);
std::string_view name_of(pipeline::ShadeModel model);
std::string_view name_of(pipeline::Shading shading);
std::string_view name_of(pipeline::SpecularModel model);
std::string_view name_of(raster::Topology topology);
std::string_view name_of(raster::MinFilter filter);
std::string_view name_of(raster::MagFilter filter);
std::string_view name_of(raster::TextureEnvMode mode);
std::string_view name_of(raster::CombineFunction function);
std::string_view name_of(raster::CombineSource source);
std::string_view name_of(raster::CombineOperand operand);
std::string_view name_of(raster::FogMode mode);
std::string_view name_of(raster::BlendFactor factor);
std::string_view name_of(raster::BlendEquation equation);
std::string_view name_of(raster::ToneMap map);
/// "<", "<=" …; "never" and "always" for those.
std::string_view sign_of(raster::Compare compare);
/// "+X" … of a cube map's face.
std::string_view name_of_face(int face);

}  // namespace barrido::inspect
