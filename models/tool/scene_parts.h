// Pieces that several scenes use: materials, cameras and lights as glTF's JSON.
#pragma once

#include <string>

#include "models/tool/glb_writer.h"

namespace barrido::models {

Json json_of(const Vec3& v);

/// A glTF material (metallic-roughness); base colour in linear RGB.
Json make_material(const std::string& name, const Vec3& base_color, double metallic, double roughness);
/// The same with a base colour texture.
Json make_textured_material(const std::string& name, int texture, double metallic, double roughness);

/// Fixed-function values of the course, exact: extras.barrido of a material.
struct ExactMaterial {
  Vec3 ambient, diffuse, specular;
  double shininess;
};
Json make_exact_material(const std::string& name, const ExactMaterial& exact);

/// Adds a perspective camera at `position` that looks at `target`; the vertical field of view is
/// 2·atan(half_height), near and far are distances.
struct CameraSpec {
  Vec3 position, target;
  double half_height;
  double near_plane, far_plane;
};
void add_camera(GlbWriter& writer, const CameraSpec& spec);

/// Adds a directional light that shines from `from` towards the origin with `lux`.
void add_sun(GlbWriter& writer, const std::string& name, const Vec3& from, const Vec3& color, double lux);

/// Adds a point light with the course's intensity I_p and attenuation 1/(kc + kl·d + kq·d²) (L4).
void add_exact_point_light(GlbWriter& writer, const std::string& name, const Vec3& position,
                           const Vec3& color, double intensity, const Vec3& attenuation);

}  // namespace barrido::models
