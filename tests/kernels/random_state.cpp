#include "random_state.h"

#include <utility>

#include "compile_stages.h"
#include "test_stages.h"

namespace barrido::raster::testing {
namespace {

void random_pattern(RandomBits& random, TexcoordKind kind, TextureUnit& unit) {
  unit.procedure = kind == TexcoordKind::plain ? &kSurfacePattern : &kSolidPattern;
  Pattern& pattern = unit.pattern;
  pattern.kind = random.one_of_first<PatternKind>(5);
  pattern.octaves = random.between(1, random.chance(20) ? kMaxOctaves : 4);
  pattern.gain = random.pick({0.5f, 0.7f, 1.0f});
  pattern.turbulence = random.chance(80) ? random.number(-2.0f, 2.0f) : 0.0f;
  pattern.has_threshold = random.chance(50);
  pattern.threshold = random.number(-0.5f, 0.5f);
  pattern.colors = {random.color(0.0f, 1.0f), random.color(0.0f, 1.0f)};
}

/// Of a point in space: three coordinates that are no longer divided.
void random_mapping(RandomBits& random, TextureUnit& unit) {
  Mapping& mapping = unit.mapping;
  mapping.surface = random.pick(
      {MappingSurface::planar, MappingSurface::cylinder, MappingSurface::sphere, MappingSurface::box});
  mapping.ray = random.one_of_first<MappingRay>(4);
  mapping.repeats = {random.number(-4.0f, 4.0f), random.number(-4.0f, 4.0f)};
  mapping.offset = {random.number(-1.0f, 1.0f), random.number(-1.0f, 1.0f)};
  for (std::size_t r = 0; r < 3; ++r) {
    for (float& element : mapping.eye_from_mapping[r]) element = random.number(-2.0f, 2.0f);
    for (float& element : mapping.mapping_from_eye[r]) element = random.number(-2.0f, 2.0f);
  }
  if (unit.procedure == &kSolidPattern && random.chance(60)) unit.procedure = &kSurfacePattern;
}

/// @return the kind of the unit's coordinates.
TexcoordKind random_unit(RandomBits& random, const TexturePool& textures, int index, FragmentState& state) {
  const auto slot = static_cast<std::size_t>(index);
  TextureUnit& unit = state.texture_units[slot];
  const auto kind =
      random.pick({TexcoordKind::plain, TexcoordKind::plain, TexcoordKind::projective, TexcoordKind::direct});
  unit.texture = kind == TexcoordKind::direct ? &textures.cube(random) : &textures.flat(random);
  unit.min_filter = random.one_of_first<MinFilter>(8);
  unit.max_anisotropy = random.chance(25) ? random.between(2, kMaxAnisotropy) : 1;
  unit.mag_filter = random.one_of_first<MagFilter>(2);
  unit.lod_bias = random.chance(40) ? random.number(-3.0f, 3.0f) : 0.0f;
  unit.env_mode = random.one_of_first<TextureEnvMode>(6);
  unit.env_color = random.color(0.0f, 1.0f);
  for (CombineChannel* channel : {&unit.combine.rgb, &unit.combine.alpha}) {
    channel->function = random.one_of_first<CombineFunction>(channel == &unit.combine.rgb ? 8 : 6);
    for (std::size_t k = 0; k < 3; ++k) {
      channel->source[k] = random.one_of_first<CombineSource>(4);
      channel->operand[k] = random.one_of_first<CombineOperand>(4);
    }
    channel->scale = random.pick({1.0f, 1.0f, 2.0f, 4.0f});
  }
  if (random.chance(10)) unit.role = TextureRole::shine;
  if (random.chance(10)) unit.procedure = kind == TexcoordKind::plain ? &kRings2 : &kRings3;
  if (random.chance(25)) random_pattern(random, kind, unit);
  const bool colors = unit.role == TextureRole::environment;
  if (colors && kind == TexcoordKind::projective && random.chance(40)) random_mapping(random, unit);
  unit.tiles = random.chance(20) ? random.one_of_first<TileChange>(4) : TileChange::none;
  return kind;
}

/// Colours, coordinates and fog in any order, any number of the first ones linear on the screen.
/// @return whether fragments are lit.
bool random_varyings(RandomBits& random, const std::array<TexcoordKind, kMaxTextureUnits>& kinds,
                     FragmentState& state) {
  const bool lit = random.chance(20);
  std::vector<Varying> groups;
  bool maps_by_normal = false;
  for (const TextureUnit& unit : state.texture_units) maps_by_normal |= needs_normal(unit.mapping);
  if (lit || maps_by_normal) groups.push_back({Meaning::normal, 3});
  if (!lit && random.chance(60)) {
    groups.push_back({Meaning::color, 4});
    if (random.chance(60)) groups.push_back({Meaning::specular, 3});
  }
  if (state.fog.enabled) groups.push_back({Meaning::fog, 1});
  for (std::size_t unit = 0; unit < kMaxTextureUnits; ++unit) {
    if (state.texture_units[unit].texture == nullptr) continue;
    groups.push_back({Meaning::texcoord, floats_of(kinds[unit]), static_cast<int>(unit)});
  }
  for (std::size_t k = groups.size(); k > 1; --k) {
    std::swap(groups[k - 1], groups[static_cast<std::size_t>(random.between(0, static_cast<int>(k) - 1))]);
  }
  const int affine_groups = random.chance(50) ? 0 : random.between(0, static_cast<int>(groups.size()));
  int placed = 0;
  for (const Varying& group : groups) {
    state.varyings.add(group);
    if (++placed == affine_groups) state.varyings.affine_count = state.varyings.count;
  }
  return lit;
}

void random_tests(RandomBits& random, int frame_width, int frame_height, FragmentState& state) {
  state.depth.test = random.chance(75);
  state.depth.write = random.chance(80);
  state.depth.compare =
      random.chance(50) ? random.pick({Compare::less, Compare::less_equal}) : random.one_of_first<Compare>(8);
  state.polygon_offset = {random.chance(25), random.number(-2.0f, 2.0f), random.number(-1e6f, 1e6f)};
  state.scissor.enabled = random.chance(20);
  state.scissor.x = random.between(-20, frame_width);
  state.scissor.y = random.between(-20, frame_height);
  state.scissor.width = random.between(0, frame_width + 40);
  state.scissor.height = random.between(0, frame_height + 40);
}

void random_output(RandomBits& random, FragmentState& state) {
  state.alpha_test.enabled = random.chance(30);
  state.alpha_test.compare = random.one_of_first<Compare>(8);
  state.alpha_test.reference = random.number(0.0f, 1.0f);
  BlendState& blend = state.blend;
  blend.enabled = random.chance(60);
  blend.src_rgb = random.one_of_first<BlendFactor>(15);
  blend.dst_rgb = random.one_of_first<BlendFactor>(15);
  blend.src_alpha = random.one_of_first<BlendFactor>(15);
  blend.dst_alpha = random.one_of_first<BlendFactor>(15);
  blend.equation = random.one_of_first<BlendEquation>(5);
  blend.constant = random.color(0.0f, 1.0f);
  state.sorted = random.chance(25);
  if (random.chance(30)) {
    for (bool& channel : state.color_mask) channel = random.chance(50);
  }
}

template <class Enumeration>
std::string number_of(Enumeration value) {
  return std::to_string(static_cast<int>(value));
}

std::string describe_unit(const FragmentState& state, std::size_t index) {
  const TextureUnit& unit = state.texture_units[index];
  const Texture& t = *unit.texture;
  return " unit" + std::to_string(index) + "{" + std::to_string(t.width()) + "x" +
         std::to_string(t.height()) + " kind=" + number_of(texcoord_kind(state, static_cast<int>(index))) +
         " format=" + number_of(t.format()) + " levels=" + std::to_string(t.level_count()) +
         " wrap=" + number_of(t.options().wrap_s) + "," + number_of(t.options().wrap_t) +
         " min=" + number_of(unit.min_filter) + " mag=" + number_of(unit.mag_filter) +
         " procedure=" + std::string(unit.procedure != nullptr ? unit.procedure->name : "") +
         " pattern=" + number_of(unit.pattern.kind) + " mapping=" + number_of(unit.mapping.surface) + "," +
         number_of(unit.mapping.ray) + " tiles=" + number_of(unit.tiles) +
         " anisotropy=" + std::to_string(unit.max_anisotropy) + " bias=" + std::to_string(unit.lod_bias) +
         " env=" + number_of(unit.env_mode) + " role=" + number_of(unit.role) +
         " combine=" + number_of(unit.combine.rgb.function) + "," + number_of(unit.combine.alpha.function) +
         "}";
}

/// Light, and what may come before it: a normal that is bent, or multiplied by the texels of a unit which is
/// then that stage's own.
std::vector<FragmentStage> random_light(RandomBits& random, FragmentState& state) {
  std::vector<FragmentStage> stages;
  if (random.chance(50)) stages.push_back({.kind = &kBendNormal});
  const int unit = random.between(0, kMaxTextureUnits - 1);
  TextureUnit& texture = state.texture_units[static_cast<std::size_t>(unit)];
  const bool is_mapped = texture.mapping.surface != MappingSurface::none;
  if (texture.texture != nullptr && !is_mapped && random.chance(70)) {
    texture.role = TextureRole::normal;
    const int floats = state.varyings.floats(Meaning::texcoord, unit);
    stages.push_back({.kind = &kBendByTexture, .unit = unit, .reads = {{{Meaning::texcoord, floats, unit}}}});
  }
  stages.push_back({.kind = &kTestLight});
  return stages;
}

}  // namespace

FragmentState random_state(RandomBits& random, const TexturePool& textures, bool opaque, int frame_width,
                           int frame_height) {
  FragmentState state;
  std::array<TexcoordKind, kMaxTextureUnits> kinds{};
  const int units = random.chance(35) ? 0 : random.between(1, kMaxTextureUnits);
  for (int unit = 0; unit < units; ++unit) {
    if (random.chance(85)) kinds[static_cast<std::size_t>(unit)] = random_unit(random, textures, unit, state);
  }
  state.fog = {random.chance(35),         random.one_of_first<FogMode>(3), random.number(0.0f, 2.0f),
               random.number(0.0f, 1.0f), random.number(1.0f, 4.0f),       random.color(0.0f, 1.0f)};
  const bool lit = random_varyings(random, kinds, state);
  state.separate_specular = random.chance(30);
  state.clamp_colors = random.chance(60);
  random_tests(random, frame_width, frame_height, state);
  if (!opaque) random_output(random, state);
  compile_stages(state, lit ? random_light(random, state) : std::vector<FragmentStage>{});
  if (random.chance(10)) state.stages.push_back({.kind = &kInvert});
  return state;
}

FragmentState random_simple_state(RandomBits& random, int frame_width, int frame_height) {
  FragmentState state;
  if (random.chance(65)) {
    state.varyings.add({Meaning::color, 4});
    state.varyings.affine_count = random.chance(30) ? 4 : 0;
  }
  random_tests(random, frame_width, frame_height, state);
  if (random.chance(70)) state.depth = {true, true, Compare::less};
  if (random.chance(70)) state.polygon_offset.enabled = false;
  state.clamp_colors = random.chance(80);
  state.separate_specular = !state.varyings.has(Meaning::color) && random.chance(50);
  compile_stages(state);
  if (random.chance(70)) return state;
  state.blend.enabled = true;
  state.blend.constant = random.color(0.0f, 1.0f);
  const bool constant = random.chance(50);
  state.blend.src_rgb = state.blend.src_alpha =
      constant ? BlendFactor::constant_alpha : BlendFactor::src_alpha;
  state.blend.dst_rgb = state.blend.dst_alpha =
      constant ? BlendFactor::one_minus_constant_alpha : BlendFactor::one_minus_src_alpha;
  return state;
}

std::string describe(const FragmentState& s) {
  std::string text =
      "varyings=" + std::to_string(s.varyings.count) + " affine=" + std::to_string(s.varyings.affine_count) +
      " color=" + std::to_string(s.varyings.at(Meaning::color)) + " lit=" + std::to_string(is_lit(s)) +
      " separate=" + std::to_string(s.separate_specular) + " clamp=" + std::to_string(s.clamp_colors);
  text += s.depth.test ? " depth{" + number_of(s.depth.compare) + (s.depth.write ? " write}" : "}") : "";
  text += s.alpha_test.enabled ? " alpha{" + number_of(s.alpha_test.compare) + "}" : "";
  if (s.blend.enabled) {
    text += " blend{" + number_of(s.blend.src_rgb) + "," + number_of(s.blend.dst_rgb) + "," +
            number_of(s.blend.src_alpha) + "," + number_of(s.blend.dst_alpha) + " " +
            number_of(s.blend.equation) + "}";
  }
  text += s.sorted ? " sorted" : "";
  text += " mask=";
  for (const bool channel : s.color_mask) text += channel ? '1' : '0';
  if (s.scissor.enabled) {
    text += " scissor{" + std::to_string(s.scissor.x) + "," + std::to_string(s.scissor.y) + " " +
            std::to_string(s.scissor.width) + "x" + std::to_string(s.scissor.height) + "}";
  }
  text += s.polygon_offset.enabled ? " offset" : "";
  text += s.fog.enabled ? " fog{" + number_of(s.fog.mode) + "}" : "";
  for (std::size_t unit = 0; unit < kMaxTextureUnits; ++unit) {
    if (s.texture_units[unit].texture != nullptr) text += describe_unit(s, unit);
  }
  return text;
}

}  // namespace barrido::raster::testing
