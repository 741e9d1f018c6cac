// Every shading mode has all of its facts, and docs/shading.md tells them.
#include "pipeline/shading_modes.h"

#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/layout.h"

namespace barrido::pipeline {
namespace {

std::string page() {
  std::ifstream file(BARRIDO_SOURCE_DIR "/docs/shading.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ShadingModes, StandInTheOrderOfTheEnumeration) {
  for (std::size_t i = 0; i < kShadingModes.size(); ++i) {
    EXPECT_EQ(kShadingModes[i].model, static_cast<ShadeModel>(i));
  }
}

TEST(ShadingModes, HaveAllTheirFacts) {
  std::set<std::string_view> names, words;
  for (const ShadingMode& mode : kShadingModes) {
    SCOPED_TRACE(mode.name);
    for (const std::string_view fact :
         {mode.name, std::string_view(mode.words), mode.lit.name, mode.unlit.name, mode.interpolated,
          mode.at_vertices, mode.at_polygon, mode.at_fragments, mode.cost, mode.formula}) {
      EXPECT_FALSE(fact.empty());
    }
    EXPECT_NE(mode.formula.find("{highlight}"), std::string_view::npos);
    EXPECT_TRUE(names.insert(mode.name).second);
    EXPECT_TRUE(words.insert(mode.words).second);
    EXPECT_TRUE(mode.lit.at_vertices || mode.lit.at_centroid || mode.lit.at_fragments);
    EXPECT_FALSE(mode.unlit.at_fragments);  // colours that are given need no model
    EXPECT_FALSE(mode.lit.flat && mode.lit.at_fragments);
  }
}

TEST(ShadingModes, AreToldByTheDocumentation) {
  const std::string text = page();
  for (const ShadingMode& mode : kShadingModes) {
    std::string row = "| `" + std::string(mode.name) + "` |";
    for (const std::string_view fact :
         {mode.interpolated, mode.at_vertices, mode.at_polygon, mode.at_fragments, mode.cost}) {
      row.append(" ").append(fact).append(" |");
    }
    EXPECT_NE(text.find(row), std::string::npos) << "docs/shading.md has no line\n" << row;
  }
}

TEST(ShadingModes, OneColorForAllWhereNeitherLightNorVerticesGiveAny) {
  State state;
  for (const ShadingMode& mode : kShadingModes) {
    state.shade_model = mode.model;
    EXPECT_EQ(color_origin(state, false, false).name, "constant");
    EXPECT_EQ(color_origin(state, true, false).name,
              mode.lit.flat ? "flat-provoking" : std::string(mode.lit.name));
  }
}

}  // namespace
}  // namespace barrido::pipeline
