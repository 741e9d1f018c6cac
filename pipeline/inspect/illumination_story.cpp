#include "pipeline/inspect/illumination_story.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "pipeline/vertex_batch.h"

namespace barrido::inspect {
namespace {

using pipeline::IlluminatingLight;
using pipeline::Illumination;
using pipeline::LightProducts;

constexpr LightProducts kNoProducts{};
constexpr std::size_t kLanes = pipeline::kVertexPadding;

/// One number in an array as the kernels read and write them.
struct alignas(64) Column {
  float lane[kLanes] = {};
};

LightProducts ones() {
  LightProducts products;
  products.fixed.fill(glm::vec3(1.0f));
  return products;
}

struct Result {
  Color primary{};
  Rgb secondary{};
};

/// A surface point as the kernels take it.
struct PointColumns {
  Column normal[3], position[3], color[4];
  pipeline::SurfacePoints points;

  explicit PointColumns(const LitPoint& at) {
    for (int axis = 0; axis < 3; ++axis) {
      normal[axis].lane[0] = at.normal[axis];
      position[axis].lane[0] = at.position[axis];
    }
    for (int c = 0; c < 4; ++c) color[c].lane[0] = at.color[c];
    points.count = 1;
    points.normal = {normal[0].lane, normal[1].lane, normal[2].lane};
    points.position = {position[0].lane, position[1].lane, position[2].lane};
    points.color = {color[0].lane, color[1].lane, color[2].lane, color[3].lane};
    points.normalize = at.normalize;
    points.back = at.back;
  }
  PointColumns(const PointColumns&) = delete;
  PointColumns& operator=(const PointColumns&) = delete;
};

struct ResultColumns {
  Column primary[4], secondary[3];

  pipeline::LitColors out() {
    return {{primary[0].lane, primary[1].lane, primary[2].lane, primary[3].lane},
            {secondary[0].lane, secondary[1].lane, secondary[2].lane}};
  }
  Result result() const {
    Result r;
    for (std::size_t c = 0; c < 4; ++c) r.primary[c] = primary[c].lane[0];
    for (std::size_t c = 0; c < 3; ++c) r.secondary[c] = secondary[c].lane[0];
    return r;
  }
};

/// The model evaluated somewhere, with whatever lights and products the illumination is given.
class Evaluation {
 public:
  virtual ~Evaluation() = default;
  /// `only`: the number that the illumination's single light has in the whole model, or −1 for all lights.
  virtual Result operator()(const Illumination& illumination, int only) const = 0;
};

class AtPoint final : public Evaluation {
 public:
  explicit AtPoint(const PointColumns& point) : point_(point) {}
  Result operator()(const Illumination& illumination, int) const override {
    ResultColumns columns;
    pipeline::illuminate(illumination, point_.points, columns.out());
    return columns.result();
  }

 private:
  const PointColumns& point_;
};

class FromProducts final : public Evaluation {
 public:
  FromProducts(std::span<const float> dots, const glm::vec4& color, bool back)
      : back_(back), dots_(dots.size()) {
    for (std::size_t i = 0; i < dots.size(); ++i) dots_[i].lane[0] = dots[i];
    for (int c = 0; c < 4; ++c) color_[c].lane[0] = color[c];
  }
  Result operator()(const Illumination& illumination, int only) const override {
    std::vector<const float*> columns;
    const std::size_t first = only < 0 ? 0 : 2 * static_cast<std::size_t>(only);
    const std::size_t end = only < 0 ? dots_.size() : first + 2;
    for (std::size_t i = first; i < end; ++i) columns.push_back(dots_[i].lane);
    return evaluate(illumination, columns);
  }
  /// The columns behind those of the lights: interpolated ambient light.
  Result ambient(const Illumination& illumination, std::size_t lights) const {
    std::vector<const float*> columns;
    for (std::size_t i = 2 * lights; i < dots_.size(); ++i) columns.push_back(dots_[i].lane);
    return evaluate(illumination, columns);
  }
  Result without_products(const Illumination& illumination) const { return evaluate(illumination, {}); }

 private:
  Result evaluate(const Illumination& illumination, const std::vector<const float*>& columns) const {
    pipeline::InterpolatedDots dots;
    dots.count = 1;
    dots.back = back_;
    dots.columns = columns;
    dots.color = {color_[0].lane, color_[1].lane, color_[2].lane, color_[3].lane};
    ResultColumns result;
    pipeline::cheap_phong_colors(illumination, dots, result.out());
    return result.result();
  }

  bool back_;
  std::vector<Column> dots_;
  Column color_[4];
};

Rgb rgb(const Color& c) { return {c[0], c[1], c[2]}; }
Rgb rgb(const glm::vec3& c) { return {c.r, c.g, c.b}; }

/// The illumination with one of its lights, or none, and without its base.
Illumination isolated(const Illumination& whole, int light) {
  Illumination one = whole;
  one.separate_specular = true;
  one.base = kNoProducts;
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
  const Result result = evaluate(one, light);
  return term == Term::specular ? result.secondary : rgb(result.primary);
}

/// N·L and N·H or R·V of one light, as they are before clamping and weakening.
void measure_products(const Illumination& whole, int light, const PointColumns& point, LightStory& story) {
  Illumination one = isolated(whole, light);
  one.cheap_phong_power = pipeline::CheapPhongPower::pixel;
  one.shininess.fill(1.0f);
  one.lights[0].weakens = false;
  Column columns[2];
  float* const pointers[2] = {columns[0].lane, columns[1].lane};
  pipeline::cheap_phong_dots(one, point.points, pointers);
  story.n_dot_l = columns[0].lane[0];
  story.highlight = columns[1].lane[0];
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
void add_up(const Illumination& whole, const Result& result, IlluminationStory& story) {
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

IlluminationStory explain_illumination(const Illumination& illumination, const LitPoint& point,
                                       const LightingNames& names) {
  const PointColumns columns(point);
  const AtPoint evaluate(columns);
  IlluminationStory story = begin_story(illumination, names, point.back, point.color);
  story.position = point.position;
  story.normal = point.normalize ? unit(point.normal) : point.normal;
  if (story.back_side) story.normal = -story.normal;
  story.to_viewer = illumination.local_viewer ? unit(-point.position) : glm::vec3(0, 0, 1);
  measure_shares(illumination, evaluate, story);
  Illumination base = isolated(illumination, -1);
  base.base = illumination.base;
  story.base = rgb(evaluate(base, -1).primary);
  for (std::size_t i = 0; i < illumination.lights.size(); ++i) {
    const IlluminatingLight& light = illumination.lights[i];
    LightStory& l = story.lights[i];
    measure_products(illumination, static_cast<int>(i), columns, l);
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

void add_products(const Illumination& illumination, const LitPoint& point, IlluminationStory& story) {
  const PointColumns columns(point);
  std::vector<Column> dots(static_cast<std::size_t>(pipeline::cheap_phong_varyings(illumination)));
  std::vector<float*> pointers;
  for (Column& column : dots) pointers.push_back(column.lane);
  pipeline::cheap_phong_dots(illumination, columns.points, pointers);
  for (std::size_t i = 0; i < story.lights.size(); ++i) {
    story.lights[i].products = {dots[2 * i].lane[0], dots[2 * i + 1].lane[0]};
  }
}

IlluminationStory explain_products(const Illumination& illumination, std::span<const float> dots,
                                   const glm::vec4& color, bool back, const LightingNames& names) {
  const FromProducts evaluate(dots, color, back);
  IlluminationStory story = begin_story(illumination, names, back, color);
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
  story.interpolated_ambient = rgb(evaluate.ambient(base, lights).primary);
  base.base = illumination.base;
  story.base = rgb(evaluate.without_products(base).primary);
  add_up(illumination, evaluate(illumination, -1), story);
  return story;
}

}  // namespace barrido::inspect
