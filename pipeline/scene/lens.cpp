#include "pipeline/scene/lens.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "pipeline/scene/view.h"

namespace barrido::scene {
namespace {

/// Half the height of a picture on 35 mm film, metres.
constexpr double kHalfFilmHeight = 0.012;

}  // namespace

Lens choose_lens(const Scene& scene, const PosedScene& posed, const RenderSettings& settings,
                 double focus_from_pixel, std::vector<std::string>& warnings) {
  const SampleChoice& choice = settings.samples;
  const Eye eye = choose_eye(scene, posed.nodes, posed.pose, posed.bounds, settings);
  Lens lens;
  lens.focus = glm::length(eye.focal_point - eye.position);
  if (choice.focus_distance) {
    lens.focus = static_cast<double>(*choice.focus_distance);
  } else if (focus_from_pixel > 0.0) {
    lens.focus = focus_from_pixel;
  } else if (choice.focus_pixel) {
    warnings.emplace_back("--focus-pixel: nothing is seen there: the focal point is in focus");
  }
  if (!(lens.focus > 0.0)) lens.focus = 1.0;
  if (choice.lens_radius) {
    lens.radius = static_cast<double>(*choice.lens_radius);
  } else if (eye.orthographic) {
    warnings.emplace_back("--f-stop: parallel rays have no focal length: all is in focus");
  } else {
    const View view = view_of(eye, posed.bounds.sphere, 1.0);
    const double focal_length = kHalfFilmHeight * static_cast<double>(view.clip_from_eye[1][1]);
    lens.radius = focal_length / (2.0 * static_cast<double>(*choice.f_stop));
  }
  return lens;
}

View through_lens(const View& view, const Lens& lens, double x, double y) {
  // x' = x − lens_x − z·lens_x/focus: 0 change where z = −focus.
  View seen = view;
  glm::dmat4 shear(1.0);
  shear[2][0] = -x / lens.focus;
  shear[2][1] = -y / lens.focus;
  seen.clip_from_eye = glm::mat4(glm::dmat4(view.clip_from_eye) * shear);
  seen.eye_from_world[3][0] -= static_cast<float>(x);
  seen.eye_from_world[3][1] -= static_cast<float>(y);
  return seen;
}

double distance_at(const View& view, float depth) {
  if (!(depth < 1.0f)) return 0.0;
  const glm::dmat4 eye_from_clip = glm::inverse(glm::dmat4(view.clip_from_eye));
  const glm::dvec4 eye = eye_from_clip * glm::dvec4(0.0, 0.0, 2.0 * static_cast<double>(depth) - 1.0, 1.0);
  return eye.w == 0.0 ? 0.0 : std::max(0.0, -eye.z / eye.w);
}

}  // namespace barrido::scene
