#include "pipeline/inspect/illumination_story.h"

#include <cmath>
#include <functional>

#include <glm/geometric.hpp>

namespace barrido::inspect {
namespace {

using pipeline::IlluminatingLight;
using pipeline::Illumination;
using pipeline::LightProducts;

using pipeline::reference::LitColor;
using pipeline::reference::SurfacePoint;

constexpr LightProducts kNoProducts{};

LightProducts ones() {
  LightProducts products;
  products.fixed.fill(glm::vec3(1.0f));
  return products;
}

/// The model evaluated somewhere, with whatever lights and products the illumination is given. `only`: the
/// number that the illumination's single light has in the whole model, or −1 for all lights.
using Evaluation = std::function<LitColor(const Illumination& illumination, int only)>;

Rgb rgb(const Color& c) { return {c[0], c[1], c[2]}; }
Rgb rgb(const glm::vec3& c) { return {c.r, c.g, c.b}; }

/// The illumination with one of its lights, or none, and without its base.
Illumination isolated(const Illumination& whole, int light) {
  Illumination one = whole;
  one.separate_specular = true;
  one.base = one.emission = kNoProducts;
  one.lights.clear();
  if (light >= 0) one.lights.push_back(whole.lights[static_cast<std::size_t>(light)]);
  return one;
}

enum class Term { ambient, diffuse, specular };

/// One term of one light; `unit`: with products of 1 in place of the light's and material's colours.
Rgb share(const Illumination& whole, int light, Term term, bool unit, const Evaluation& evaluate) {
  Illumination one = isolated(whole, light);
  IlluminatingLight& l = one.lights[0];
  const auto products = [&](Term which, const LightProducts& own) {
    return which != term ? kNoProducts : unit ? ones() : own;
  };
  l.ambient = products(Term::ambient, l.ambient);
  l.diffuse = products(Term::diffuse, l.diffuse);
  l.specular = products(Term::specular, l.specular);
  if (term != Term::specular) l.shines = {false, false};
  const LitColor result = evaluate(one, light);
  return term == Term::specular ? result.secondary : rgb(result.primary);
}

/// N·L and N·H or R·V of one light, as they are before clamping and weakening.
void measure_products(const Illumination& whole, int light, const SurfacePoint& point, LightStory& story) {
  Illumination one = isolated(whole, light);
  one.cheap_phong_power = pipeline::CheapPhongPower::pixel;
  one.shininess.fill(1.0f);
  one.lights[0].weakens = false;
  float dots[2];
  pipeline::reference::cheap_phong_dots(one, point, dots);
  story.n_dot_l = dots[0];
  story.highlight = dots[1];
}

glm::vec3 unit(const glm::vec3& v) {
  const float length = std::sqrt(glm::dot(v, v));
  return length > 0.0f ? v / length : v;
}

/// L, H and R, for the reader.
void describe_vectors(const IlluminatingLight& light, const IlluminationStory& at, LightStory& story) {
  story.to_light = light.directional ? light.to_light : unit(light.position - at.position);
  story.half_vector = unit(story.to_light + at.to_viewer);
  story.reflection = 2.0f * glm::dot(at.normal, story.to_light) * at.normal - story.to_light;
}

/// Adds up the shares in the kernel's order and compares with its own result.
void add_up(const Illumination& whole, const LitColor& result, IlluminationStory& story) {
  const std::size_t side = story.back_side ? 1 : 0;
  Rgb primary = story.base;
  Rgb secondary{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (story.interpolated_products) primary[c] = primary[c] + story.interpolated_ambient[c];
    for (std::size_t i = 0; i < whole.lights.size(); ++i) {
      const LightStory& light = story.lights[i];
      const bool weakens = whole.lights[i].weakens && !story.interpolated_products;
      if (weakens) primary[c] = primary[c] + light.ambient[c];
      primary[c] = primary[c] + light.diffuse[c];
      if (whole.lights[i].shines[side]) secondary[c] = secondary[c] + light.specular[c];
    }
    if (!whole.separate_specular) primary[c] = primary[c] + secondary[c];
    story.exact = story.exact && primary[c] == result.primary[c] &&
                  (!whole.separate_specular || secondary[c] == result.secondary[c]);
  }
  story.primary = result.primary;
  story.secondary = whole.separate_specular ? result.secondary : Rgb{};
}

/// What does not depend on where the model is evaluated.
IlluminationStory begin_story(const Illumination& whole, const LightingNames& names, bool back,
                              const glm::vec4& color) {
  using pipeline::ColorMaterial;
  IlluminationStory story;
  const pipeline::Lighting& lighting = names.lighting;
  story.back_side = back && whole.two_sided;
  const std::size_t side = story.back_side ? 1 : 0;
  const pipeline::Material& m = story.back_side ? lighting.back : lighting.front;
  const ColorMaterial which = lighting.color_material;
  const auto property = [&](const glm::vec4& own, bool tracked) {
    return rgb(glm::vec3(tracked ? color : own));
  };
  const bool both = which == ColorMaterial::ambient_and_diffuse;
  story.k_ambient = property(m.ambient, both || which == ColorMaterial::ambient);
  story.k_diffuse = property(m.diffuse, both || which == ColorMaterial::diffuse);
  story.k_specular = property(m.specular, which == ColorMaterial::specular);
  story.emission = property(m.emission, which == ColorMaterial::emission);
  story.formula = whole.mode->formula;
  story.shininess = whole.shininess[side];
  story.ambient_light = rgb(glm::vec3(lighting.ambient));
  for (std::size_t i = 0; i < whole.lights.size(); ++i) {
    LightStory& light = story.lights.emplace_back();
    if (i < names.names.size()) light.name = names.names[i];
    light.intensity = rgb(glm::vec3(lighting.lights[i].diffuse));
  }
  return story;
}

void measure_shares(const Illumination& whole, const Evaluation& evaluate, IlluminationStory& story) {
  const std::size_t side = story.back_side ? 1 : 0;
  for (std::size_t i = 0; i < whole.lights.size(); ++i) {
    const int light = static_cast<int>(i);
    LightStory& l = story.lights[i];
    l.diffuse = share(whole, light, Term::diffuse, false, evaluate);
    if (!whole.lights[i].shines[side]) continue;
    l.specular = share(whole, light, Term::specular, false, evaluate);
    l.power = share(whole, light, Term::specular, true, evaluate)[0];
  }
}

}  // namespace

IlluminationStory explain_illumination(const Illumination& illumination, const SurfacePoint& point,
                                       const LightingNames& names) {
  const Evaluation evaluate = [&](const Illumination& model, int) {
    return pipeline::reference::illuminate(model, point);
  };
  IlluminationStory story = begin_story(illumination, names, point.back, point.color);
  story.position = point.position;
  story.normal = point.normalize ? unit(point.normal) : point.normal;
  if (story.back_side) story.normal = -story.normal;
  story.to_viewer = illumination.local_viewer ? unit(-point.position) : glm::vec3(0, 0, 1);
  measure_shares(illumination, evaluate, story);
  Illumination base = isolated(illumination, -1);
  base.base = illumination.base;
  base.emission = illumination.emission;
  story.base = rgb(evaluate(base, -1).primary);
  for (std::size_t i = 0; i < illumination.lights.size(); ++i) {
    const IlluminatingLight& light = illumination.lights[i];
    LightStory& l = story.lights[i];
    measure_products(illumination, static_cast<int>(i), point, l);
    describe_vectors(light, story, l);
    if (!light.weakens) continue;
    l.ambient = share(illumination, static_cast<int>(i), Term::ambient, false, evaluate);
    l.weakening = share(illumination, static_cast<int>(i), Term::ambient, true, evaluate)[0];
    Illumination steady = illumination;
    steady.lights[i].weakens = false;
    if (light.shines[story.back_side ? 1 : 0]) {
      l.power = share(steady, static_cast<int>(i), Term::specular, true, evaluate)[0];
    }
  }
  add_up(illumination, evaluate(illumination, -1), story);
  return story;
}

void add_products(const Illumination& illumination, const SurfacePoint& point, IlluminationStory& story) {
  std::vector<float> dots(static_cast<std::size_t>(pipeline::cheap_phong_varyings(illumination)));
  pipeline::reference::cheap_phong_dots(illumination, point, dots);
  for (std::size_t i = 0; i < story.lights.size(); ++i) {
    story.lights[i].products = {dots[2 * i], dots[2 * i + 1]};
  }
}

IlluminationStory explain_products(const Illumination& illumination, std::span<const float> dots,
                                   const SurfacePoint& point, const LightingNames& names) {
  const auto model = [&](const Illumination& of, std::span<const float> some) {
    return pipeline::reference::cheap_phong_color(of, some, point);
  };
  const Evaluation evaluate = [&](const Illumination& of, int only) {
    return model(of, only < 0 ? dots : dots.subspan(2 * static_cast<std::size_t>(only), 2));
  };
  IlluminationStory story = begin_story(illumination, names, point.back, point.color);
  story.place = "fragment";
  story.interpolated_products = true;
  story.highlights_are_powers = pipeline::power_at_vertices(illumination, story.back_side ? 1 : 0);
  measure_shares(illumination, evaluate, story);
  const std::size_t lights = illumination.lights.size();
  for (std::size_t i = 0; i < lights; ++i) {
    story.lights[i].n_dot_l = dots[2 * i];
    story.lights[i].highlight = dots[2 * i + 1];
  }
  Illumination base = isolated(illumination, -1);
  story.interpolated_ambient = rgb(model(base, dots.subspan(2 * lights)).primary);
  base.base = illumination.base;
  base.emission = illumination.emission;
  story.base = rgb(model(base, {}).primary);
  add_up(illumination, evaluate(illumination, -1), story);
  return story;
}

}  // namespace barrido::inspect
