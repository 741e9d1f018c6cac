#include "pipeline/scene/why_empty.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace barrido::scene {
namespace {

/// Whether the sphere around the scene lies beyond one side of the view.
std::string where_it_is(const View& view, const Sphere& sphere, const glm::dvec3& origin) {
  const glm::dmat4 clip_from_world = glm::dmat4(view.clip_from_eye) * glm::dmat4(view.eye_from_world);
  const auto row = [&](int i) {
    return glm::dvec4(clip_from_world[0][i], clip_from_world[1][i], clip_from_world[2][i],
                      clip_from_world[3][i]);
  };
  const glm::dvec4 center(sphere.center - origin, 1.0);
  const auto is_beyond = [&](const glm::dvec4& plane) {
    const double length = std::sqrt(glm::dot(glm::dvec3(plane), glm::dvec3(plane)));
    return glm::dot(plane, center) < -sphere.radius * length;
  };
  const glm::dvec4 w = row(3);
  if (is_beyond(w + row(2))) return "all of it is behind the eye, or before the near plane";
  if (is_beyond(w - row(2))) return "all of it is beyond the far plane";
  for (int axis = 0; axis < 2; ++axis) {
    if (is_beyond(w + row(axis)) || is_beyond(w - row(axis))) return "the eye looks past all of it";
  }
  return {};
}

}  // namespace

std::string why_empty(const SceneFrame& frame, const RenderSettings& settings,
                      const pipeline::Statistics& drawn) {
  const std::string empty = "the picture is empty: ";
  if (frame.list.draws.empty()) return empty + "the scene has nothing to draw";
  if (frame.backdrop_in_view || drawn.raster.fragments_covered > 0) return {};
  if (drawn.primitives_in == 0) return empty + "the scene's meshes have no whole point, line or triangle";
  const std::string place = where_it_is(frame.view, frame.posed.bounds.sphere, frame.posed.pose.origin);
  if (!place.empty()) return empty + place;
  if (settings.cull == pipeline::CullFace::front_and_back) return empty + "both sides are culled";
  return empty + "what is in view faces away, or is smaller than a pixel";
}

}  // namespace barrido::scene
