// Options of `barrido render` whose value is one word out of a list.
#include "viewer/barrido/render_values.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {

void set_flat_at(RenderOptions& options, std::string_view text) {
  using pipeline::FlatAt;
  constexpr std::array<Choice<FlatAt>, 2> kPlaces{
      {{"centroid", FlatAt::centroid}, {"provoking", FlatAt::provoking_vertex}}};
  options.settings.flat_at = parse_choice(text, kPlaces);
}

void set_cheap_phong_power(RenderOptions& options, std::string_view text) {
  using pipeline::CheapPhongPower;
  constexpr std::array<Choice<CheapPhongPower>, 2> kPlaces{
      {{"pixel", CheapPhongPower::pixel}, {"vertex", CheapPhongPower::vertex}}};
  options.settings.cheap_phong_power = parse_choice(text, kPlaces);
}

void set_lighting(RenderOptions& options, std::string_view text) {
  using pipeline::SpecularModel;
  constexpr std::array<Choice<SpecularModel>, 2> kModels{
      {{"phong", SpecularModel::phong}, {"blinn", SpecularModel::blinn}}};
  options.settings.lighting = parse_choice(text, kModels);
}

void set_color_interpolation(RenderOptions& options, std::string_view text) {
  using pipeline::ColorInterpolation;
  constexpr std::array<Choice<ColorInterpolation>, 2> kWays{
      {{"perspective", ColorInterpolation::perspective}, {"screen", ColorInterpolation::screen}}};
  options.settings.color_interpolation = parse_choice(text, kWays);
}

void set_texture_interpolation(RenderOptions& options, std::string_view text) {
  using pipeline::TextureInterpolation;
  constexpr std::array<Choice<TextureInterpolation>, 2> kWays{
      {{"perspective", TextureInterpolation::perspective}, {"affine", TextureInterpolation::affine}}};
  options.settings.texture_interpolation = parse_choice(text, kWays);
}

void set_min_filter(RenderOptions& options, std::string_view text) {
  using raster::MinFilter;
  constexpr std::array<Choice<MinFilter>, 6> kFilters{
      {{"nearest", MinFilter::nearest},
       {"linear", MinFilter::linear},
       {"nearest-mipmap-nearest", MinFilter::nearest_mipmap_nearest},
       {"linear-mipmap-nearest", MinFilter::linear_mipmap_nearest},
       {"nearest-mipmap-linear", MinFilter::nearest_mipmap_linear},
       {"linear-mipmap-linear", MinFilter::linear_mipmap_linear}}};
  options.settings.min_filter = parse_choice(text, kFilters);
}

void set_mag_filter(RenderOptions& options, std::string_view text) {
  using raster::MagFilter;
  constexpr std::array<Choice<MagFilter>, 2> kFilters{
      {{"nearest", MagFilter::nearest}, {"linear", MagFilter::linear}}};
  options.settings.mag_filter = parse_choice(text, kFilters);
}

void set_cull(RenderOptions& options, std::string_view text) {
  using pipeline::CullFace;
  constexpr std::array<Choice<CullFace>, 3> kFaces{
      {{"none", CullFace::none}, {"back", CullFace::back}, {"front", CullFace::front}}};
  options.settings.cull = parse_choice(text, kFaces);
}

void set_color_management(RenderOptions& options, std::string_view text) {
  using scene::ColorManagement;
  constexpr std::array<Choice<ColorManagement>, 2> kWays{
      {{"srgb", ColorManagement::srgb}, {"none", ColorManagement::none}}};
  options.settings.color_management = parse_choice(text, kWays);
}

void set_tone_map(RenderOptions& options, std::string_view text) {
  using raster::ToneMap;
  constexpr std::array<Choice<ToneMap>, 2> kMaps{
      {{"clamp", ToneMap::clamp}, {"reinhard", ToneMap::reinhard}}};
  options.settings.tone_map = parse_choice(text, kMaps);
}

void set_visibility_first(RenderOptions& options, std::string_view text) {
  constexpr std::array<Choice<bool>, 2> kSwitch{{{"on", true}, {"off", false}}};
  options.settings.visibility_first = parse_choice(text, kSwitch);
}

}  // namespace barrido::cli
