#include "viewer/barrido/fog_spec.h"

#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

constexpr std::array<Choice<raster::FogMode>, 3> kModes{
    {{"linear", raster::FogMode::linear}, {"exp", raster::FogMode::exp}, {"exp2", raster::FogMode::exp2}}};

}  // namespace

FogChoice parse_fog(std::string_view spec) {
  const std::vector<std::string_view> pieces = split(spec, ':');
  FogChoice fog;
  fog.state.enabled = true;
  fog.state.mode = parse_choice(pieces[0], kModes);
  const bool linear = fog.state.mode == raster::FogMode::linear;
  if (pieces.size() < 2 || pieces.size() > 3) {
    throw ValueError(linear ? "expected linear:START,END[:R,G,B]"
                            : "expected " + std::string(pieces[0]) + ":DENSITY[:R,G,B]");
  }
  if (linear) {
    const auto range = parse_tuple<2>(pieces[1], "START,END", -kAnyNumber, kAnyNumber);
    if (range[0] == range[1]) throw ValueError("expected START and END to differ");
    fog.state.start = range[0];
    fog.state.end = range[1];
  } else {
    fog.state.density = static_cast<float>(parse_number(pieces[1], 0.0, kAnyNumber));
  }
  if (pieces.size() == 3) fog.color_shown = parse_tuple<3>(pieces[2], "R,G,B", 0.0, 1.0);
  return fog;
}

}  // namespace barrido::cli
