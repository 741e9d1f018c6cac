// What bless copies and what it leaves alone.
#include "viewer/compare/bless.h"

#include <gtest/gtest.h>

#include "tests/unit/compare/pictures.h"

namespace barrido::compare::test {
namespace {

namespace fs = std::filesystem;

class Bless : public testing::Test {
 protected:
  compare::Run compared(const Settings& settings = {}) const {
    compare::Run run{"a", "b", settings, {}};
    for (const Pair& pair : find_pairs(folder_ / "a", folder_ / "b", MissingExpected::is_empty)) {
      run.results.push_back(compare_pair(pair, settings).result);
    }
    return run;
  }
  TemporaryFolder folder_;
};

TEST_F(Bless, ReplacesWhatDiffersAddsWhatIsNewAndDeletesNothing) {
  write_png(folder_ / "a/same.png", flat(4, 4, 1));
  write_png(folder_ / "b/same.png", flat(4, 4, 1));
  write_png(folder_ / "a/changed.png", flat(4, 4, 1));
  write_png(folder_ / "b/changed.png", flat(4, 4, 2));
  write_png(folder_ / "b/deep/new.png", flat(4, 4, 3));
  write_png(folder_ / "a/gone.png", flat(4, 4, 4));
  write_text(folder_ / "a/damaged.png", "x");
  write_png(folder_ / "b/damaged.png", flat(4, 4, 5));
  write_png(folder_ / "a/unreadable.png", flat(4, 4, 6));
  write_text(folder_ / "b/unreadable.png", "x");
  const std::string gone = read_text(folder_ / "a/gone.png"),
                    unreadable = read_text(folder_ / "a/unreadable.png");

  const Blessed blessed = bless(compared());
  EXPECT_EQ(blessed.replaced, (std::vector<fs::path>{folder_ / "a/changed.png", folder_ / "a/damaged.png"}));
  EXPECT_EQ(blessed.added, (std::vector<fs::path>{folder_ / "a/deep/new.png"}));
  EXPECT_EQ(blessed.kept, (std::vector<fs::path>{folder_ / "a/gone.png"}));
  for (const char* name : {"changed.png", "deep/new.png", "damaged.png"}) {
    EXPECT_EQ(read_text(folder_ / "a" / name), read_text(folder_ / "b" / name)) << name;
  }
  EXPECT_EQ(read_text(folder_ / "a/gone.png"), gone);
  EXPECT_EQ(read_text(folder_ / "a/unreadable.png"), unreadable);
}

TEST_F(Bless, LeavesWhatIsWithinTheThresholds) {
  write_png(folder_ / "a/x.png", flat(4, 4, 100));
  write_png(folder_ / "b/x.png", flat(4, 4, 101));
  const std::string before = read_text(folder_ / "a/x.png");
  Settings settings;
  settings.thresholds.fail = 0.01;
  EXPECT_TRUE(bless(compared(settings)).replaced.empty());
  EXPECT_EQ(read_text(folder_ / "a/x.png"), before);
}

TEST_F(Bless, MakesTheExpectedFolder) {
  write_png(folder_ / "b/x.png", flat(4, 4, 1));
  EXPECT_EQ(bless(compared()).added.size(), 1u);
  EXPECT_EQ(compared().results[0].outcome, Outcome::same);
}

TEST_F(Bless, RefusesAnotherFormat) {
  write_png(folder_ / "a.png", flat(4, 4, 1));
  const Bytes rgba(64, 255);
  scene::write_image(folder_ / "b.jpg", {4, 4, rgba, {}});
  compare::Run run{"a.png", "b.jpg", {}, {}};
  run.results.push_back(compare_pair(find_pairs(folder_ / "a.png", folder_ / "b.jpg")[0], {}).result);
  EXPECT_EQ(scene::test::message_of([&] { bless(run); }),
            (folder_ / "a.png").string() + ": cannot become a copy of " + (folder_ / "b.jpg").string() +
                ": another format");
}

}  // namespace
}  // namespace barrido::compare::test
