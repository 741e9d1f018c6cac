#include <nlohmann/json.hpp>

#include "pipeline/inspect/pixel_story.h"
#include "pipeline/inspect/story_words.h"

namespace barrido::inspect {
namespace {

using Json = nlohmann::ordered_json;
using raster::reference::FragmentTrace;
using raster::reference::UnitTrace;

Json vector(const glm::vec3& v) { return {v.x, v.y, v.z}; }

template <std::size_t Count>
Json list(const std::array<float, Count>& values) {
  return Json(values);
}

Json index(int i) { return i == scene::kNone ? Json(nullptr) : Json(i); }

Json corner_json(const CornerStory& c) {
  Json json{{"vertex", c.vertex},
            {"object", vector(c.object)},
            {"eye", vector(c.eye)},
            {"normal", vector(c.normal)},
            {"window", {c.window_x, c.window_y, c.depth}},
            {"w", c.w},
            {"weight", c.weight},
            {"screen_weight", c.screen_weight}};
  if (c.displaced) json["displaced"] = *c.displaced;
  if (c.lit) json["lit"] = list(*c.lit);
  if (c.lit_secondary) json["lit_secondary"] = list(*c.lit_secondary);
  return json;
}

Json light_json(const LightStory& light, bool has_vectors) {
  Json json{{"name", light.name}, {"intensity", list(light.intensity)}};
  if (has_vectors) {
    json["l"] = vector(light.to_light);
    json["h"] = vector(light.half_vector);
    json["r"] = vector(light.reflection);
    json["weakening"] = light.weakening;
  }
  json["n_dot_l"] = light.n_dot_l;
  json["highlight"] = light.highlight;
  json["power"] = light.power;
  json["ambient"] = list(light.ambient);
  json["diffuse"] = list(light.diffuse);
  json["specular"] = list(light.specular);
  if (light.products) json["products"] = *light.products;
  return json;
}

Json illumination_json(const IlluminationStory& story) {
  Json json{{"place", story.place}};
  if (!story.interpolated_products) {
    json["position"] = vector(story.position);
    json["n"] = vector(story.normal);
    json["v"] = vector(story.to_viewer);
  }
  json["back_side"] = story.back_side;
  json["k_ambient"] = list(story.k_ambient);
  json["k_diffuse"] = list(story.k_diffuse);
  json["k_specular"] = list(story.k_specular);
  json["emission"] = list(story.emission);
  json["shininess"] = story.shininess;
  json["ambient_light"] = list(story.ambient_light);
  json["base"] = list(story.base);
  if (story.interpolated_products) {
    json["interpolated_ambient"] = list(story.interpolated_ambient);
    json["highlights_are_powers"] = story.highlights_are_powers;
  }
  json["lights"] = Json::array();
  for (const LightStory& light : story.lights) {
    json["lights"].push_back(light_json(light, !story.interpolated_products));
  }
  json["primary"] = list(story.primary);
  json["secondary"] = list(story.secondary);
  return json;
}

Json span_json(const FragmentTrace& trace) {
  const raster::reference::SpanQuantity& z = trace.along.quantities[raster::kRecordDepth];
  const raster::reference::SpanQuantity& q = trace.along.quantities[raster::kRecordQ];
  const auto end = [&](int x) {
    const auto distance = static_cast<float>(x - trace.along.anchor);
    return Json{{"x", x}, {"z", z.at(distance)}, {"inverse_w", q.at(distance)}};
  };
  return {{"y", trace.span.y},
          {"first", end(trace.span.first)},
          {"last", end(trace.span.end - 1)},
          {"z_per_pixel", z.ddx},
          {"inverse_w_per_pixel", q.ddx}};
}

Json level_json(const raster::reference::LevelTrace& level) {
  Json json{{"probe", level.probe},
            {"level", level.level},
            {"size", {level.width, level.height}},
            {"texels", Json::array()}};
  for (const raster::reference::TexelTrace& texel : level.texels) {
    json["texels"].push_back(
        {{"i", texel.i}, {"j", texel.j}, {"color", list(texel.color)}, {"weight", texel.weight}});
  }
  json["color"] = list(level.color);
  return json;
}

Json unit_json(const UnitTrace& unit, const TextureStory& texture, const raster::TextureUnit& state) {
  Json json{{"unit", unit.unit},
            {"role", texture.role},
            {"image", texture.image},
            {"size", {texture.width, texture.height}},
            {"mip_levels", texture.levels},
            {"min_filter", name_of(state.min_filter)},
            {"mag_filter", name_of(state.mag_filter)},
            {"coordinates", unit.coordinates},
            {"mapping", name_of(state.mapping.surface)},
            {"mapped_from", name_of(state.mapping.ray)},
            {"tiles", name_of(state.tiles)},
            {"u", unit.sample.u},
            {"v", unit.sample.v},
            {"lod", unit.sample.lod},
            {"magnified", unit.sample.magnified}};
  for (const auto& note : unit.notes) json["notes"][std::string(note.name)] = note.values;
  if (unit.sample.footprint) {
    const auto& footprint = *unit.sample.footprint;
    json["footprint"] = {
        {"along_x", footprint.along_x}, {"along_y", footprint.along_y}, {"samples", footprint.probes}};
  }
  if (texture.cube) json["face"] = name_of_face(unit.sample.face);
  json["levels"] = Json::array();
  for (const auto& level : unit.sample.levels) json["levels"].push_back(level_json(level));
  json["second_level_weight"] = unit.sample.far_weight;
  json["texel"] = list(unit.sample.color);
  json["environment"] = name_of(state.env_mode);
  json["constant"] = list(state.env_color);
  json["previous"] = list(unit.previous);
  json["result"] = list(unit.color);
  return json;
}

Json fate_json(const FragmentStory& f) {
  const raster::reference::FateTrace& fate = f.trace.fate;
  Json json;
  json["alpha_test"] = f.state.alpha_test.enabled ? Json{{"compare", name_of(f.state.alpha_test.compare)},
                                                         {"reference", f.state.alpha_test.reference},
                                                         {"passed", fate.alpha_passed}}
                                                  : Json(nullptr);
  json["depth_test"] = f.state.depth.test ? Json{{"z", f.trace.depth},
                                                 {"compare", name_of(f.state.depth.compare)},
                                                 {"stored", fate.depth_before},
                                                 {"passed", fate.depth_passed},
                                                 {"stored_after", fate.depth_after}}
                                          : Json(nullptr);
  if (!fate.alpha_passed || !fate.depth_passed) return json;
  json["blend"] =
      f.state.blend.enabled
          ? Json{{"equation", name_of(f.state.blend.equation)},         {"source", list(fate.incoming)},
                 {"source_factor", list(fate.source_factor)},           {"destination", list(fate.before)},
                 {"destination_factor", list(fate.destination_factor)}, {"result", list(fate.blended)}}
          : Json(nullptr);
  if (fate.layer > 0) json["layer"] = fate.layer;
  json["before"] = list(fate.before);
  json["after"] = list(fate.after);
  return json;
}

Json source_json(const FragmentStory& f) {
  if (f.backdrop) return {{"backdrop", true}};
  return {{"backdrop", false},
          {"node", {{"index", index(f.node)}, {"name", f.node_name}}},
          {"mesh", {{"index", index(f.mesh)}, {"name", f.mesh_name}}},
          {"material", {{"index", index(f.material)}, {"name", f.material_name}}},
          {"primitive", f.primitive},
          {"triangle", f.triangle}};
}

Json fragment_json(const FragmentStory& f) {
  Json json{{"fate", name_of(f.fate)}, {"source", source_json(f)},     {"drawn_as", name_of(f.topology)},
            {"clipped", f.clipped},    {"back_facing", f.back_facing}, {"shading", f.shading},
            {"z", f.trace.depth}};
  json["corners"] = Json::array();
  for (const CornerStory& corner : f.corners) json["corners"].push_back(corner_json(corner));
  json["span"] = span_json(f.trace);
  if (f.trace.outside_scissor) return json;
  json["inverse_w"] = f.trace.q;
  json["illuminations"] = Json::array();
  for (const auto& story : f.illuminations) json["illuminations"].push_back(illumination_json(story));
  if (f.from_products) json["illumination_from_products"] = illumination_json(*f.from_products);
  const raster::reference::ShadingTrace& shading = f.trace.shading;
  json["primary"] = list(shading.lit_primary);
  json["secondary"] = list(shading.lit_secondary);
  for (std::size_t i = 0; i < f.maps.size(); ++i) {
    const UnitTrace& map = shading.maps[i];
    const raster::TextureUnit& state = f.state.texture_units[static_cast<std::size_t>(map.unit)];
    Json entry{{"unit", map.unit},
               {"role", name_of(state.role)},
               {"image", f.maps[i].image},
               {"size", {f.maps[i].width, f.maps[i].height}},
               {"strength", state.strength},
               {"coordinates", map.coordinates},
               {"texel", list(map.sample.color)}};
    for (const auto& note : map.notes) entry["notes"][std::string(note.name)] = note.values;
    json["maps"].push_back(std::move(entry));
  }
  json["textures"] = Json::array();
  for (std::size_t i = 0; i < shading.units.size(); ++i) {
    const auto unit = static_cast<std::size_t>(shading.units[i].unit);
    json["textures"].push_back(unit_json(shading.units[i], f.textures[i], f.state.texture_units[unit]));
  }
  json["with_secondary"] = shading.sum ? list(*shading.sum) : Json(nullptr);
  json["fog"] = shading.fog ? Json{{"mode", name_of(f.state.fog.mode)},
                                   {"distance", shading.fog->distance},
                                   {"fraction", shading.fog->fraction},
                                   {"fog_color", list(f.state.fog.color)},
                                   {"result", list(shading.fog->color)}}
                            : Json(nullptr);
  for (const auto& note : shading.notes) json["notes"][std::string(note.name)] = note.values;
  json["color"] = list(shading.color);
  json["frame"] = fate_json(f);
  return json;
}

}  // namespace

std::string story_json(const PixelStory& story) {
  Json json{{"schema", "barrido-inspect-1"},
            {"source", story.source},
            {"frame", {{"width", story.width}, {"height", story.height}}},
            {"pixel", {{"x", story.x}, {"y", story.y}, {"window_y", story.window_y}}},
            {"shading", pipeline::shading_mode(story.shading).name},
            {"lighting", name_of(story.lighting)},
            {"format", story.format == raster::ColorFormat::rgba8 ? "rgba8" : "rgba32f"},
            {"clear", {{"color", list(story.clear)}, {"z", story.clear_depth}}}};
  json["fragments"] = Json::array();
  for (const FragmentStory& fragment : story.fragments) json["fragments"].push_back(fragment_json(fragment));
  json["front"] = story.front < 0 ? Json(nullptr) : Json(story.front);
  if (story.blended) json["blended"] = list(*story.blended);
  json["color"] = list(story.color);
  json["z"] = story.depth;
  json["display"] = story.format == raster::ColorFormat::rgba8
                        ? Json(nullptr)
                        : Json{{"exposure_scale", story.display.exposure_scale},
                               {"tone_map", name_of(story.display.tone_map)},
                               {"srgb_encode", story.display.srgb_encode},
                               {"result", list(story.displayed)}};
  json["rgba8"] = story.rgba8;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace barrido::inspect
