#include "tests/osmesa/generator.h"

#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {

std::span<const Feature> features() {
  static const std::vector<Feature> all = [] {
    std::vector<Feature> list;
    for (const auto group :
         {geometry_features(), lighting_features(), texture_features(), fragment_features()}) {
      list.insert(list.end(), group.begin(), group.end());
    }
    return list;
  }();
  return all;
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
