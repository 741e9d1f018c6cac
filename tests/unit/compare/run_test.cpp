// Totals and order of results.
#include "viewer/compare/run.h"

#include <gtest/gtest.h>

#include "tests/unit/compare/results.h"

namespace barrido::compare::test {
namespace {

TEST(Run, TotalsCountEachOutcome) {
  const Totals totals = totals_of(run_of_all_outcomes());
  EXPECT_EQ(totals.all(), 6u);
  EXPECT_EQ(totals.failed(), 4u);
  EXPECT_EQ(totals_text(totals), "6 pairs: 1 error, 1 different, 1 missing, 1 added, 1 warning, 1 same");
  EXPECT_EQ(totals_text(totals_of({"a", "b", {}, {result_of("x", Outcome::same)}})), "1 pair: 1 same");
}

TEST(Run, WorstFirst) {
  compare::Run run = run_of_all_outcomes();
  Result better = result_of("a.png", Outcome::different);
  better.flip->mean = 0.1;
  Result smaller = result_of("z.png", Outcome::different);
  smaller.flip->mean = 0.0;
  smaller.actual->width = 20;
  run.results.push_back(better);
  run.results.push_back(smaller);
  std::vector<std::string> names;
  for (const std::size_t index : worst_first(run)) names.push_back(run.results[index].pair.name);
  EXPECT_EQ(names, (std::vector<std::string>{"error.png", "z.png", "deep/different.png", "a.png",
                                             "missing.png", "added.png", "warning.png", "same.png"}));
}

TEST(Run, WithoutFlipTheRootMeanSquareDecides) {
  compare::Run run{
      "a", "b", {}, {result_of("small.png", Outcome::different), result_of("large.png", Outcome::different)}};
  for (Result& result : run.results) result.flip.reset();
  run.results[1].figures->rms = 0.3;
  EXPECT_EQ(worst_first(run), (std::vector<std::size_t>{1, 0}));
}

}  // namespace
}  // namespace barrido::compare::test
