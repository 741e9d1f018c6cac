// What may be said to `barrido diff`, and what is refused.
#include "viewer/barrido/diff_options.h"

#include <gtest/gtest.h>

#include "viewer/barrido/help.h"

namespace barrido::cli {
namespace {

DiffOptions parse(std::vector<std::string> words) { return parse_diff_options(words); }

std::string refusal(std::vector<std::string> words) {
  try {
    parse_diff_options(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  ADD_FAILURE() << "accepted";
  return {};
}

TEST(DiffOptions, DefaultsAreThoseOfIdiff) {
  const DiffOptions options = parse({"a.png", "b.png"});
  EXPECT_EQ(options.expected, "a.png");
  EXPECT_EQ(options.actual, "b.png");
  const compare::Thresholds& thresholds = options.settings.thresholds;
  EXPECT_EQ(thresholds.fail, 1e-6);
  EXPECT_EQ(thresholds.warn, 1e-6);
  EXPECT_EQ(thresholds.fail_percent, 0.0);
  EXPECT_EQ(thresholds.warn_percent, 0.0);
  EXPECT_EQ(thresholds.hard_fail, compare::kUnlimited);
  EXPECT_EQ(thresholds.hard_warn, compare::kUnlimited);
  EXPECT_EQ(thresholds.fail_flip, compare::kUnlimited);
  EXPECT_TRUE(options.settings.flip);
  EXPECT_FALSE(options.difference.absolute);
  EXPECT_EQ(options.difference.scale, 1.0f);
}

TEST(DiffOptions, SpellingsOfIdiffMeanTheSame) {
  for (const std::string dash : {"-", "--"}) {
    const DiffOptions options = parse({"a",
                                       dash + "fail",
                                       "0.1",
                                       dash + "failpercent=2",
                                       dash + "hardfail",
                                       "0.3",
                                       dash + "warn",
                                       "0.4",
                                       dash + "warnpercent",
                                       "5",
                                       dash + "hardwarn",
                                       "0.6",
                                       dash + "allowfailures",
                                       "7",
                                       dash + "scale",
                                       "8",
                                       dash + "abs",
                                       "-o",
                                       "x.png",
                                       "b"});
    const compare::Thresholds& thresholds = options.settings.thresholds;
    EXPECT_EQ(thresholds.fail, 0.1);
    EXPECT_EQ(thresholds.fail_percent, 2.0);
    EXPECT_EQ(thresholds.hard_fail, 0.3);
    EXPECT_EQ(thresholds.warn, 0.4);
    EXPECT_EQ(thresholds.warn_percent, 5.0);
    EXPECT_EQ(thresholds.hard_warn, 0.6);
    EXPECT_EQ(thresholds.allow_failures, 7u);
    EXPECT_EQ(options.difference.scale, 8.0f);
    EXPECT_TRUE(options.difference.absolute);
    EXPECT_EQ(options.output, "x.png");
    EXPECT_EQ(options.actual, "b");
  }
}

TEST(DiffOptions, NamesThatBeginWithADashComeAfterTwoDashes) {
  EXPECT_EQ(parse({"--", "-fail", "-q"}).expected, "-fail");
}

TEST(DiffOptions, MistakesAreNamed) {
  EXPECT_EQ(refusal({"a"}),
            "diff: needs two pictures or two folders, A (expected) and B (actual); see barrido diff --help");
  EXPECT_EQ(refusal({"a", "b", "c"}), refusal({}));
  EXPECT_EQ(refusal({"a", ""}), "diff: a file with an empty name");
  EXPECT_EQ(refusal({"a", "b", "-fial", "1"}), "unknown option '--fial'; did you mean '--fail'?");
  EXPECT_EQ(refusal({"a", "b", "--hmtl", "x"}), "unknown option '--hmtl'; did you mean '--html'?");
  EXPECT_EQ(refusal({"a", "b", "-x"}), "unknown option '-x'");
  EXPECT_EQ(refusal({"a", "b", "-fail", "lots"}), "--fail: 'lots': expected a number of 0 or more");
  EXPECT_EQ(refusal({"a", "b", "--failpercent", "101"}), "--failpercent: '101': expected a number in 0..100");
  EXPECT_EQ(refusal({"a", "b", "--html", "-"}), "--html: '-': expected a folder");
  EXPECT_EQ(refusal({"a", "b", "--json", "-", "--junit", "-"}),
            "--junit: '-': standard output cannot hold JSON as well");
  EXPECT_EQ(refusal({"a", "b", "--failflip", "0.1", "--no-flip"}),
            "--failflip: cannot be used together with --no-flip");
  EXPECT_EQ(refusal({"a", "b", "--scale", "2"}), "--scale: only with --output");
  EXPECT_EQ(refusal({"a", "b", "--abs"}), "--abs: only with --output");
}

TEST(DiffOptions, HelpNamesEachAndGivesExamples) {
  const std::string help = diff_help();
  for (const OptionSyntax& option : diff_syntax()) {
    EXPECT_NE(help.find(std::string(option.name)), std::string::npos) << option.name;
  }
  EXPECT_NE(help.find("\nExamples:\n"), std::string::npos);
}

}  // namespace
}  // namespace barrido::cli
