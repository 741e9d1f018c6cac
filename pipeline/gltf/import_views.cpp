// Cameras and lights (KHR_lights_punctual): values that no camera or light can have are errors or are brought
// into range with a warning, so that projections and attenuations are always defined.
#include <algorithm>

#include "pipeline/gltf/import_parts.h"
#include "pipeline/scene/names.h"
#include "raster/base/portable_math.h"

namespace barrido::scene::gltf {
namespace {

void read_perspective(Import& import, const tinygltf::PerspectiveCamera& source, const std::string& place,
                      Camera& camera) {
  constexpr double kLargestAngle = 0.99 * kPi;
  camera.kind = Camera::Kind::perspective;
  if (source.yfov > kLargestAngle)
    import.report.warn("a camera's yfov is not below 180 degrees: it was reduced");
  camera.vertical_fov_rad = to_float(std::min(source.yfov, kLargestAngle));
  camera.aspect = to_float(source.aspectRatio);
  camera.near_plane = to_float(source.znear);
  camera.far_plane = to_float(source.zfar);
  if (source.zfar != 0.0 && camera.far_plane <= camera.near_plane) {
    import.report.fail(place + ".perspective", "zfar must be greater than znear");
  }
}

void read_orthographic(Import& import, const tinygltf::OrthographicCamera& source, const std::string& place,
                       Camera& camera) {
  camera.kind = Camera::Kind::orthographic;
  if (source.xmag < 0.0 || source.ymag < 0.0) {
    import.report.warn("a camera's xmag and ymag must not be negative: their absolute values are used");
  }
  camera.half_width = std::abs(to_float(source.xmag));
  camera.half_height = std::abs(to_float(source.ymag));
  camera.near_plane = to_float(source.znear);
  camera.far_plane = to_float(source.zfar);
  if (camera.half_width == 0.0f || camera.half_height == 0.0f) {
    import.report.fail(place + ".orthographic", "xmag and ymag must not be 0");
  }
  if (camera.far_plane <= camera.near_plane) {
    import.report.fail(place + ".orthographic", "zfar must be greater than znear");
  }
}

Light::Kind light_kind(const std::string& type) {
  return value_named<Light::Kind>(type).value_or(Light::Kind::directional);
}

void read_cone(Import& import, const tinygltf::SpotLight& source, Light& light) {
  const double outer = std::clamp(source.outerConeAngle, 0.0, 0.5 * kPi);
  const double inner = std::clamp(source.innerConeAngle, 0.0, outer);
  // Half a millionth of tolerance: 90 degrees are written with few digits.
  if (std::abs(outer - source.outerConeAngle) > 5e-7 || std::abs(inner - source.innerConeAngle) > 5e-7) {
    import.report.warn("a spot light's cone angles were brought into 0 <= inner <= outer <= 90 degrees");
  }
  light.outer_cone_rad = to_float(outer);
  light.inner_cone_rad = to_float(inner);
}

Light light_of(Import& import, const tinygltf::Light& source) {
  Light light;
  light.name = source.name;
  light.kind = light_kind(source.type);
  for (int c = 0; c < 3 && source.color.size() == 3; ++c) {
    light.color[c] = std::max(to_float(source.color[static_cast<std::size_t>(c)]), 0.0f);
  }
  if (source.intensity < 0.0) {
    import.report.warn("a light's intensity must not be negative: 0 is used (extras.barrido allows it)");
  }
  light.intensity = std::max(to_float(source.intensity), 0.0f);
  if (source.range < 0.0) import.report.warn("a light's range must be greater than 0: it is endless");
  light.range = std::max(to_float(source.range), 0.0f);
  if (light.kind == Light::Kind::spot) read_cone(import, source.spot, light);
  return light;
}

}  // namespace

void import_cameras(Import& import) {
  const auto& cameras = import.document.model().cameras;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    Camera camera;
    camera.name = cameras[i].name;
    if (cameras[i].type == "perspective") {
      read_perspective(import, cameras[i].perspective, element("cameras", i), camera);
    } else {
      read_orthographic(import, cameras[i].orthographic, element("cameras", i), camera);
    }
    import.scene.cameras.push_back(std::move(camera));
  }
}

void import_lights(Import& import) {
  for (const tinygltf::Light& source : import.document.model().lights) {
    import.scene.lights.push_back(light_of(import, source));
  }
}

}  // namespace barrido::scene::gltf
