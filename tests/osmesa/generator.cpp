#include "tests/osmesa/generator.h"

#include <algorithm>

#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {

std::span<const Feature> features() {
  static const std::vector<Feature> all = [] {
    std::vector<Feature> list;
    for (const auto group : {geometry_features(), lighting_features(), texture_features(), map_features(),
                             procedure_features(), fragment_features()}) {
      list.insert(list.end(), group.begin(), group.end());
    }
    return list;
  }();
  return all;
}

std::vector<Feature> features_against(const std::string& renderer) {
  std::vector<Feature> list(features().begin(), features().end());
  if (renderer.find("softpipe") == std::string::npos) return list;
  for (Feature& feature : list) {
    feature.gate.edge_ppm = std::max(feature.gate.edge_ppm, 1000.0);  // positions have 4 sub-pixel bits there
    feature.gate.held = feature.gate.held_by_softpipe;
  }
  return list;
}

ScenePair make_pair(const Feature& feature, std::uint64_t seed) {
  RandomBits random(seed);
  ScenePair pair;
  pair.feature = feature.name;
  pair.seed = seed;
  feature.generate(random, pair);
  for (DrawCall& draw : pair.draws) avoid_zero_power(draw);
  return pair;
}

}  // namespace barrido::crosscheck
