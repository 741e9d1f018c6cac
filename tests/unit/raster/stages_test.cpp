// Every stage has all of its facts, and what a draw's stages read is what they may read.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "raster/fragments/fragment_state.h"
#include "tests/kernels/compile_stages.h"

namespace barrido::raster {
namespace {

const StageKind* const kKinds[] = {&kTakeColors, &kApplyTexture, &kAddSecondary, &kApplyFog};

TEST(Stages, HaveAllTheirFacts) {
  for (const StageKind* kind : kKinds) {
    SCOPED_TRACE(kind->name);
    EXPECT_FALSE(kind->name.empty());
    EXPECT_NE(kind->reads, 0u);
    EXPECT_NE(kind->writes, 0u);
    EXPECT_NE(kind->vector, nullptr);
    EXPECT_NE(kind->scalar, nullptr);
    EXPECT_FALSE(kind->story.empty());
  }
}

TEST(Stages, StandInTheOrderOfOpenGL) {
  FragmentState state;
  state.separate_specular = true;
  state.fog.enabled = true;
  StageInputs inputs;
  inputs.color = inputs.specular = true;
  inputs.coordinates = {0, 2, 0, 3};
  static constexpr StageKind kLight{.name = "light", .writes = set_of(Meaning::color), .story = "lights"};
  const FragmentStage light{.kind = &kLight};
  const std::vector<FragmentStage> stages = make_stages(state, {&light, 1}, inputs);
  const std::vector<const StageKind*> expected{&kLight,        &kTakeColors,   &kApplyTexture,
                                               &kApplyTexture, &kAddSecondary, &kApplyFog};
  ASSERT_EQ(stages.size(), expected.size());
  for (std::size_t i = 0; i < stages.size(); ++i) EXPECT_EQ(stages[i].kind, expected[i]) << i;
  EXPECT_EQ(stages[2].unit, 1);
  EXPECT_EQ(stages[3].unit, 3);
  for (const FragmentStage& stage : stages) {
    for (const Varying& read : stage.reads) {
      if (read.floats == 0) continue;
      EXPECT_NE(stage.kind->reads & set_of(read.meaning), 0u) << stage.kind->name;
    }
  }
}

TEST(Stages, NothingIsLitWithoutAStageThatMakesColours) {
  FragmentState state;
  EXPECT_FALSE(is_lit(state));
  static constexpr StageKind kBend{.name = "bend", .writes = set_of(Meaning::normal), .story = "bends"};
  static constexpr StageKind kLight{.name = "light", .writes = set_of(Meaning::color), .story = "lights"};
  const FragmentStage stages[] = {{.kind = &kBend}, {.kind = &kLight}};
  testing::compile_stages(state, {stages, 1});
  EXPECT_FALSE(is_lit(state));
  testing::compile_stages(state, {stages, 2});
  EXPECT_TRUE(is_lit(state));
}

TEST(Varyings, AreFoundByMeaning) {
  VaryingList list;
  list.add({Meaning::texcoord, 3, 2});
  list.add({Meaning::color, 4});
  list.add({Meaning::texcoord, 2});
  list.add_computed({Meaning::visibility, 5});
  EXPECT_EQ(list.count, 9);
  EXPECT_EQ(list.at(Meaning::texcoord, 2), 0);
  EXPECT_EQ(list.at(Meaning::color), 3);
  EXPECT_EQ(list.at(Meaning::texcoord), 7);
  EXPECT_EQ(list.at(Meaning::visibility), 9);
  EXPECT_EQ(list.floats(Meaning::visibility), 5);
  EXPECT_FALSE(list.has(Meaning::texcoord, 1));
  EXPECT_FALSE(list.has(Meaning::normal));
}

}  // namespace
}  // namespace barrido::raster
