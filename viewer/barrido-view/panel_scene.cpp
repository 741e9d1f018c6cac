// Lights, material, environment, camera and the comparison in the panel.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "raster/base/portable_math.h"
#include "viewer/barrido-view/panel_parts.h"
#include "viewer/barrido/specs.h"
#include "viewer/view/commands.h"

namespace barrido::window {
namespace {

using Kind = scene::Light::Kind;

constexpr float kDegrees = static_cast<float>(180.0 / kPi);

bool drag3(const char* label, glm::vec3& value, float speed) {
  return ImGui::DragFloat3(label, &value.x, speed);
}

bool edit_cone(scene::Light& light) {
  bool soft = !light.spot_exponent;
  bool changed = ImGui::Checkbox("soft cone", &soft);
  if (changed) light.spot_exponent = soft ? std::nullopt : std::optional(0.0f);
  float outer = light.outer_cone_rad * kDegrees, inner = light.inner_cone_rad * kDegrees;
  const auto slide = [](const char* label, float& degrees) {
    return ImGui::SliderFloat(label, &degrees, 0.0f, 90.0f, "%.1f deg", ImGuiSliderFlags_AlwaysClamp);
  };
  bool turned = slide(soft ? "outer" : "cut-off", outer);
  if (soft) {
    turned |= slide("inner", inner);
  } else {
    changed |= ImGui::DragFloat("exponent", &*light.spot_exponent, 0.1f, 0.0f, 1e4f, "%.1f",
                                ImGuiSliderFlags_AlwaysClamp);
  }
  if (turned) {
    light.outer_cone_rad = static_cast<float>(radians(outer));
    light.inner_cone_rad = static_cast<float>(radians(std::min(inner, outer)));
  }
  return changed || turned;
}

/// A new kind keeps what both kinds have.
void change_kind(scene::UserLight& user, Kind kind) {
  user.light.kind = kind;
  if (kind != Kind::directional && !user.light.attenuation) user.light.attenuation = {1.0f, 0.0f, 0.0f};
  if (kind == Kind::spot) user.light.spot_exponent = 0.0f;
}

bool edit_light(scene::UserLight& user, float reach) {
  scene::Light& light = user.light;
  Kind kind = light.kind;
  bool changed = choose("type", kind);
  if (changed) change_kind(user, kind);
  changed |= choose("moves with", user.space);
  changed |= ImGui::ColorEdit3("colour", &light.color.x, ImGuiColorEditFlags_Float);
  changed |= ImGui::DragFloat("intensity", &*light.exact_intensity, 0.01f, -1e6f, 1e6f, "%.3f",
                              ImGuiSliderFlags_AlwaysClamp);
  if (light.kind != Kind::point) changed |= drag3("shines to", user.direction, 0.01f);
  if (light.kind == Kind::directional) return changed;
  changed |= drag3("position", user.position, reach * 0.01f);
  if (light.attenuation) {
    changed |= ImGui::DragFloat3("kc kl kq", light.attenuation->data(), 0.01f, 0.0f, 1e6f, "%.3f",
                                 ImGuiSliderFlags_AlwaysClamp);
  }
  changed |= ImGui::DragFloat("range (0: none)", &light.range, reach * 0.01f, 0.0f, 1e6f, "%.2f",
                              ImGuiSliderFlags_AlwaysClamp);
  if (light.kind == Kind::spot) changed |= edit_cone(light);
  return changed;
}

float reach_of(view::Viewer& viewer) {
  const std::optional<view::Look> look = viewer.look();
  return look ? static_cast<float>(look->bounds.radius) : 1.0f;
}

bool edit_own_lights(view::Viewer& viewer, float reach) {
  std::vector<scene::UserLight>& lights = viewer.active().settings.lights;
  std::vector<int>& off = viewer.active().settings.lights_off;
  bool changed = false;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    bool on = std::find(off.begin(), off.end(), static_cast<int>(i)) == off.end();
    if (ImGui::Checkbox("##on", &on)) {
      view::toggle_light(viewer.active(), static_cast<int>(i));
      changed = true;
    }
    ImGui::SameLine();
    bool removed = false;
    const char* const kind = name_of(lights[i].light.kind).data();
    if (ImGui::TreeNode("light", "light %d, %s", static_cast<int>(i) + 1, kind)) {
      if (edit_light(lights[i], reach)) {
        lights[i] = view::canonical(lights[i]);
        changed = true;
      }
      removed = ImGui::Button("remove");
      ImGui::TreePop();
    }
    ImGui::PopID();
    if (!removed) continue;
    view::remove_light(viewer.active(), static_cast<int>(i));
    return true;
  }
  return changed;
}

void add_light(view::Viewer& viewer, float reach) {
  scene::UserLight light = cli::parse_light("point");
  if (const std::optional<view::Look> look = viewer.look()) {
    light.position = glm::vec3(look->bounds.center) + glm::vec3(0.0f, reach, reach);
  }
  viewer.active().settings.no_lights = false;
  viewer.active().settings.lights.push_back(light);
}

bool edit_coefficient(const char* label, std::optional<glm::vec3>& value, const glm::vec3& standard) {
  return optional_value(label, value, standard, [label](glm::vec3& color) {
    return ImGui::ColorEdit3(label, &color.x, ImGuiColorEditFlags_Float);
  });
}

}  // namespace

bool draw_lights(view::Viewer& viewer) {
  scene::RenderSettings& s = viewer.active().settings;
  const float reach = reach_of(viewer);
  bool changed = false;
  if (s.lights.empty()) {
    ImGui::SameLine();
    changed |= ImGui::Checkbox("only ambient", &s.no_lights);
  }
  changed |= edit_coefficient("ambient", s.ambient, glm::vec3(0.05f));
  if (s.lights.empty() && viewer.model() != nullptr) {
    ImGui::TextDisabled(viewer.model()->scene().lights.empty() ? "key, fill and back light"
                                                               : "the file's lights");
    ImGui::SameLine();
    if (ImGui::Button("edit")) view::take_over_lights(viewer), changed = true;
  }
  changed |= edit_own_lights(viewer, reach);
  if (ImGui::Button("add a light") && s.lights.size() < raster::kMaxLights) {
    if (s.lights.empty() && !s.no_lights) view::take_over_lights(viewer);
    add_light(viewer, reach);
    changed = true;
  }
  if (!s.lights.empty()) {
    ImGui::SameLine();
    if (ImGui::Button("the file's again")) s.lights.clear(), s.lights_off.clear(), changed = true;
  }
  return changed;
}

bool draw_material(view::Viewer& viewer) {
  scene::MaterialOverride& m = viewer.active().settings.material;
  const auto slide = [](const char* label) {
    return [label](float& value) {
      return ImGui::SliderFloat(label, &value, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    };
  };
  ImGui::TextDisabled("in place of every material's:");
  bool changed = optional_value("colour", m.base_color, glm::vec3(0.8f),
                                [](glm::vec3& color) { return ImGui::ColorEdit3("colour", &color.x); });
  changed |= optional_value("metallic", m.metallic, 0.0f, slide("metallic"));
  changed |= optional_value("roughness", m.roughness, 0.4f, slide("roughness"));
  ImGui::TextDisabled("the formula's own:");
  changed |= edit_coefficient("ambient", m.exact.ambient, glm::vec3(0.8f));
  changed |= edit_coefficient("diffuse", m.exact.diffuse, glm::vec3(0.8f));
  changed |= edit_coefficient("specular", m.exact.specular, glm::vec3(0.5f));
  changed |= edit_coefficient("emission", m.exact.emission, glm::vec3(0.0f));
  changed |= optional_value("shininess", m.exact.shininess, 30.0f, [](float& n) {
    return ImGui::SliderFloat("shininess", &n, 0.0f, 1000.0f, "%.1f",
                              ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  });
  return changed;
}

bool draw_environment(view::Viewer& viewer) {
  cli::RenderOptions& options = viewer.active();
  int choice = options.settings.dynamic_environment ? 1 : options.environment_path.empty() ? 0 : 2;
  bool changed = ImGui::RadioButton("none", &choice, 0);
  ImGui::SameLine();
  changed |= ImGui::RadioButton("of the scene", &choice, 1);
  ImGui::SameLine();
  changed |= ImGui::RadioButton("picture", &choice, 2);
  static std::string path;
  if (path.empty()) path = viewer.environment_given();
  const bool entered = ImGui::InputText("picture or folder", &path, ImGuiInputTextFlags_EnterReturnsTrue);
  if (entered) choice = 2;
  if (changed || entered) {
    options.settings.background = scene::Background::color;
    options.settings.dynamic_environment = choice == 1;
    options.environment_path.clear();
    if (choice == 2 && !path.empty()) viewer.set_environment(path);
  }
  bool behind = options.settings.background == scene::Background::environment;
  if (ImGui::Checkbox("as background", &behind)) {
    view::toggle_environment_background(viewer);
    changed = true;
  }
  return changed || entered;
}

bool draw_camera(view::Viewer& viewer) {
  cli::RenderOptions& options = viewer.active();
  const std::optional<view::Look> look = viewer.look();
  if (!look) return false;
  scene::Eye eye = look->eye;
  const auto speed = static_cast<float>(look->bounds.radius * 0.01);
  glm::vec3 position(eye.position), focal_point(eye.focal_point);
  bool moved = false;
  if (drag3("position", position, speed)) eye.position = position, moved = true;
  if (drag3("looks at", focal_point, speed)) eye.focal_point = focal_point, moved = true;
  auto angle_deg = static_cast<float>(eye.vertical_fov_rad * kDegrees);
  if (!look->eye.orthographic &&
      ImGui::SliderFloat("view angle", &angle_deg, 1.0f, 170.0f, "%.1f deg", ImGuiSliderFlags_AlwaysClamp)) {
    eye.vertical_fov_rad = static_cast<double>(angle_deg / kDegrees);
    moved = true;
  }
  if (moved) viewer.look_through(eye);
  if (ImGui::Button(look->eye.orthographic ? "perspective" : "orthographic")) viewer.toggle_orthographic();
  ImGui::SameLine();
  if (ImGui::Button("reset")) viewer.reset_camera();
  const int cameras = viewer.model() != nullptr ? viewer.model()->camera_count(options) : 0;
  for (int i = 0; i < cameras; ++i) {
    const std::string label = "camera " + std::to_string(i);
    if (i % 3 != 0) ImGui::SameLine();
    if (!ImGui::Button(label.c_str())) continue;
    for (const int side : {view::kLeft, view::kRight}) {
      viewer.side(side).settings.camera = {};
      viewer.side(side).cameras = {i};
    }
    moved = true;
  }
  return moved;
}

bool draw_compare(view::Viewer& viewer) {
  bool changed = false;
  bool split = viewer.display.split;
  if (ImGui::Checkbox("split", &split)) viewer.set_split(split), changed = true;
  ImGui::SameLine();
  bool osmesa = viewer.display.osmesa;
  if (ImGui::Checkbox("Barrido | OSMesa", &osmesa)) viewer.set_osmesa(osmesa), changed = true;
  if (!viewer.display.split) return changed;
  changed |= ImGui::Checkbox("difference", &viewer.display.difference);
  if (const auto& difference = viewer.difference()) {
    ImGui::Text("largest %d of 255, mean %.4f", difference->largest, difference->mean);
  }
  if (viewer.display.osmesa) return changed;
  cli::RenderOptions& a = viewer.side(view::kLeft);
  cli::RenderOptions& b = viewer.side(view::kRight);
  if (ImGui::Button("Gouraud | Phong")) {
    a.shadings = {pipeline::ShadeModel::gouraud};
    b.shadings = {pipeline::ShadeModel::phong};
    changed = true;
  }
  ImGui::SameLine();
  if (ImGui::Button("nearest | mipmap")) {
    a.settings.min_filter = raster::MinFilter::nearest;
    b.settings.min_filter = raster::MinFilter::linear_mipmap_linear;
    changed = true;
  }
  if (ImGui::Button("affine | perspective")) {
    a.settings.texture_interpolation = pipeline::TextureInterpolation::affine;
    b.settings.texture_interpolation = pipeline::TextureInterpolation::perspective;
    changed = true;
  }
  ImGui::SameLine();
  if (ImGui::Button("A = B")) a = b, changed = true;
  return changed;
}

}  // namespace barrido::window
