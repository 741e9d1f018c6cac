// Words of the command line become files and options, whatever way they are written.
#include "viewer/barrido/arguments.h"

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

constexpr OptionSyntax kSyntax[] = {
    {"", "--output", "-o", OptionKind::value, "OUT", ""},
    {"", "--resolution", "", OptionKind::value, "W,H", ""},
    {"", "--quiet", "", OptionKind::flag, "", ""},
    {"", "--stats", "", OptionKind::optional_value, "text|json", ""},
    {"", "--light", "", OptionKind::repeatable, "SPEC", ""},
};

using Words = std::vector<std::string>;

/// "file" for each file, "--name=value" for each option.
Words parsed(const Words& words) {
  const Arguments arguments = parse_arguments(kSyntax, words);
  Words all = arguments.files;
  for (const GivenOption& given : arguments.options) {
    all.push_back(std::string(kSyntax[given.index].name) + "=" + given.value);
  }
  return all;
}

std::string complaint(const Words& words) {
  try {
    parse_arguments(kSyntax, words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Arguments, ValuesStandApartOrBehindAnEqualsSign) {
  const Words expected{"a.glb", "--output=x.png", "--resolution=1,2"};
  EXPECT_EQ(parsed({"a.glb", "-o", "x.png", "--resolution", "1,2"}), expected);
  EXPECT_EQ(parsed({"--resolution=1,2", "--output=x.png", "a.glb"}), expected);
  EXPECT_EQ(parsed({"-ox.png", "a.glb", "--resolution=1,2"}), expected);
  EXPECT_EQ(parsed({"-o=x.png", "a.glb", "--resolution=1,2"}), expected);
}

TEST(Arguments, ValuesMayLookLikeOptions) {
  EXPECT_EQ(parsed({"--resolution", "-1,2"}), (Words{"--resolution=-1,2"}));
  EXPECT_EQ(parsed({"-o", "-"}), (Words{"--output=-"}));
  EXPECT_EQ(parsed({"--light", "[a,b]"}), (Words{"--light=[a,b]"}));
  EXPECT_EQ(parsed({"-o", ""}), (Words{"--output="}));
}

TEST(Arguments, FlagsAndOptionalValuesTakeNoFile) {
  EXPECT_EQ(parsed({"--quiet", "a"}), (Words{"a", "--quiet="}));
  EXPECT_EQ(parsed({"--stats", "a"}), (Words{"a", "--stats="}));
  EXPECT_EQ(parsed({"--stats=json", "a"}), (Words{"a", "--stats=json"}));
}

TEST(Arguments, RepeatableOptionsKeepTheirOrder) {
  EXPECT_EQ(parsed({"--light", "key", "--light=fill"}), (Words{"--light=key", "--light=fill"}));
}

TEST(Arguments, FilesMayHaveAnyName) {
  EXPECT_EQ(parsed({"[a,b]", "-", "{c}", "/d", ""}), (Words{"[a,b]", "-", "{c}", "/d", ""}));
  EXPECT_EQ(parsed({"a", "--", "--quiet", "-b"}), (Words{"a", "--quiet", "-b"}));
}

TEST(Arguments, MistakesAreNamed) {
  EXPECT_EQ(complaint({"--resolutoin", "1,2"}),
            "unknown option '--resolutoin'; did you mean '--resolution'?");
  EXPECT_EQ(complaint({"--lihgt=key"}), "unknown option '--lihgt'; did you mean '--light'?");
  EXPECT_EQ(complaint({"-x"}), "unknown option '-x'");
  EXPECT_EQ(complaint({"--something-else"}), "unknown option '--something-else'");
  EXPECT_EQ(complaint({"a", "--resolution"}), "--resolution: needs a value");
  EXPECT_EQ(complaint({"a", "-o"}), "--output: needs a value");
  EXPECT_EQ(complaint({"--resolution=", "a"}), "--resolution: needs a value");
  EXPECT_EQ(complaint({"--quiet=no"}), "--quiet: 'no': takes no value");
  EXPECT_EQ(complaint({"--quiet", "--quiet"}), "--quiet: given more than once");
  EXPECT_EQ(complaint({"-o", "a", "--output=b"}), "--output: given more than once");
}

}  // namespace
}  // namespace barrido::cli
