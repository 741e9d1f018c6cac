// The account of what files may take, and its words.
#include "pipeline/files/budget.h"

#include <gtest/gtest.h>

#include "pipeline/files/error.h"
#include "tests/unit/scene/import_support.h"

namespace barrido::scene::test {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

TEST(Budget, SmallFilesMayTakeSoMuch) {
  Budget budget;
  budget.take(351 * kMiB, "a", "b");
  EXPECT_EQ(input_error([&] { budget.take(2 * kMiB, "model.glb", "accessors[3]"); }),
            "model.glb: accessors[3]: needs more than the 352 MiB of memory that it may take "
            "(--max-memory allows more)");
  budget.take(kMiB, "a", "b");
}

TEST(Budget, RefusesSumsThatWouldWrap) {
  Budget budget({UINT64_MAX, std::nullopt});
  budget.take(UINT64_MAX - 5, "a", "");
  EXPECT_THROW(budget.take(6, "a", ""), InputError);
  EXPECT_THROW(budget.take(UINT64_MAX, "a", ""), InputError);
}

TEST(Budget, LargeFilesMayTakeMore) {
  Budget budget;
  budget.add_file(10 * kMiB, Budget::Kind::model, "a");
  EXPECT_EQ(budget.allowed_memory(), 640 * kMiB);
  budget.add_file(10 * kMiB, Budget::Kind::picture, "b");
  EXPECT_EQ(budget.allowed_memory(), 2240 * kMiB);
  EXPECT_NEAR(budget.allowed_seconds(), 4.0 + 20.97, 0.01);
  budget.take(2220 * kMiB, "c", "");
  EXPECT_THROW(budget.take(1, "c", ""), InputError);
}

TEST(Budget, WhatTheUserSaysStands) {
  Budget budget({5 * kMiB, 100.0});
  EXPECT_EQ(budget.allowed_seconds(), 100.0);
  EXPECT_THROW(budget.add_file(6 * kMiB, Budget::Kind::model, "a"), InputError);
  EXPECT_EQ(budget.allowed_memory(), 5 * kMiB);
}

TEST(Budget, TellsOfGrowth) {
  Budget budget;
  std::uint64_t earned = 0;
  budget.on_growth([&](const Budget& grown) { earned = grown.earned_memory(); });
  budget.add_file(100, Budget::Kind::model, "a");
  EXPECT_EQ(earned, 6400u);
}

TEST(Budget, TimeIsUp) {
  Budget budget({std::nullopt, -1.0});
  EXPECT_TRUE(budget.is_late());
  EXPECT_EQ(input_error([&] { budget.take(0, "a", "b"); }),
            "a: b: takes too long to read (--max-seconds allows more)");
  EXPECT_FALSE(Budget().is_late());
}

TEST(Budget, LoaderEndsWhenTimeIsUp) {
  ImportOptions options;
  options.budget = std::make_shared<Budget>(BudgetLimits{std::nullopt, -1.0});
  EXPECT_CONTAINS(input_error([&] { triangle().import(options); }), "takes too long to read");
}

TEST(Budget, EmptyObjectsCost) {
  Model model = triangle();
  ImportOptions options;
  options.budget = std::make_shared<Budget>(BudgetLimits{std::uint64_t{20} * kMiB, std::nullopt});
  model.import(options);
  model.document["materials"] = std::vector<json>(20'000, json::object());
  EXPECT_CONTAINS(input_error([&] { model.import(options); }), "needs more than the 20 MiB");
}

TEST(Budget, ManyWarningsAreCut) {
  Model model = triangle();
  model.document["samplers"] = json::array();
  model.document["textures"] = json::array();
  for (int i = 0; i < 200; ++i) {
    model.append("samplers", {{"wrapS", 2 + i}});
    model.append("textures", {{"sampler", i}});
  }
  const Scene scene = model.import();
  ASSERT_EQ(scene.warnings.size(), 65u);
  EXPECT_EQ(scene.warnings.back(), "there are more warnings; these are the first");
}

TEST(Budget, BytesInWords) {
  EXPECT_EQ(shown_bytes(0), "0 bytes");
  EXPECT_EQ(shown_bytes(1023), "1023 bytes");
  EXPECT_EQ(shown_bytes(1024), "1 KiB");
  EXPECT_EQ(shown_bytes(1536), "1.5 KiB");
  EXPECT_EQ(shown_bytes(288 * kMiB), "288 MiB");
  EXPECT_EQ(shown_bytes(std::uint64_t{4} << 30), "4 GiB");
}

}  // namespace
}  // namespace barrido::scene::test
