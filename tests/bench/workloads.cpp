#include "tests/bench/workloads.h"

namespace barrido::bench {
namespace {

using raster::MagFilter;
using raster::MinFilter;

constexpr double kMain = 8.0;
constexpr double kOther = 4.0;

GroundOptions ground(MinFilter min_filter, MagFilter mag_filter = MagFilter::linear) {
  GroundOptions options;
  options.min_filter = min_filter;
  options.mag_filter = mag_filter;
  return options;
}

GroundOptions blended(GroundOptions options) {
  options.blended = true;
  return options;
}

GroundOptions front_to_back(GroundOptions options) {
  options.front_to_back = true;
  return options;
}

GroundOptions anisotropic(GroundOptions options) {
  options.max_anisotropy = 8;
  return options;
}

constexpr EllipsoidOptions kMillion{1000, 501, 0.98};
constexpr EllipsoidOptions kBunny{265, 133, 0.874};
constexpr EllipsoidOptions kBunnyPhong{265, 133, 0.874, pipeline::ShadeModel::phong};
constexpr EllipsoidOptions kBunnyBumps{265, 133, 0.874, pipeline::ShadeModel::phong, 1, 1024};
constexpr EllipsoidOptions kBunnyMarble{265, 133, 0.874, pipeline::ShadeModel::phong, 1, 0, true};

}  // namespace

const std::vector<Workload>& workloads() {
  using S = const Scale&;
  constexpr auto kTrilinear = MinFilter::linear_mipmap_linear;
  static const std::vector<Workload> all = {
      {"W1", "8 layers, flat", kMain, [](S s) { return screen_layers(s, 8, Coloring::flat, false); }},
      {"W2", "8 layers, smooth", kMain, [](S s) { return screen_layers(s, 8, Coloring::smooth, false); }},
      {"W3", "8 grounds, nearest", kMain,
       [](S s) { return ground_layers(s, ground(MinFilter::nearest, MagFilter::nearest)); }},
      {"W4", "8 grounds, bilinear", kMain, [](S s) { return ground_layers(s, ground(MinFilter::linear)); }},
      {"W5", "8 grounds, trilinear", kMain, [](S s) { return ground_layers(s, ground(kTrilinear)); }},
      {"W6", "reflections, bilinear", kOther, [](S s) { return reflecting_grid(s, MinFilter::linear); }},
      {"W7", "1,000,000 triangles, Gouraud", kOther, [](S s) { return ellipsoid(s, kMillion); },
       Unit::triangles},
      {"W8", "69,960 triangles, Gouraud", kOther, [](S s) { return ellipsoid(s, kBunny); }, Unit::triangles},
      {"W9", "69,960 triangles, Phong", kOther, [](S s) { return ellipsoid(s, kBunnyPhong); },
       Unit::triangles},
      {"W10", "clear", kOther, [](S s) { return screen_layers(s, 0, Coloring::flat, false); }},
      {"W12", "8 grounds, nearest level", kMain,
       [](S s) { return ground_layers(s, ground(MinFilter::linear_mipmap_nearest)); }},
      {"W13", "reflections, trilinear", kOther, [](S s) { return reflecting_grid(s, kTrilinear); }},
      {"W14", "8 grounds, trilinear, blended", kOther,
       [](S s) { return ground_layers(s, blended(ground(kTrilinear))); }},
      {"W15", "8 layers, smooth, blended", kOther,
       [](S s) { return screen_layers(s, 8, Coloring::smooth, true); }},
      {"W16", "8 grounds, trilinear, front first", kOther,
       [](S s) { return ground_layers(s, front_to_back(ground(kTrilinear))); }},
      {"W17", "69,960 triangles, normal map", kOther, [](S s) { return ellipsoid(s, kBunnyBumps); },
       Unit::triangles},
      {"W18", "W9 in marble of six octaves", kOther, [](S s) { return ellipsoid(s, kBunnyMarble); }},
      {"W19", "8 grounds, trilinear, anisotropy 8", kOther,
       [](S s) { return ground_layers(s, anisotropic(ground(kTrilinear))); }},
  };
  return all;
}

}  // namespace barrido::bench
