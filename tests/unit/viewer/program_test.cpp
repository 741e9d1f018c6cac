// The program as such: commands, help, version, exit status, and messages of one line.
#include <gtest/gtest.h>

#include "tests/unit/viewer/program.h"
#include "viewer/barrido/help.h"

namespace barrido::test {
namespace {

/// Expects exit status 2, nothing on standard output, and exactly this line on standard error.
void expect_error(const std::vector<std::string>& words, const std::string& message) {
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.error, "barrido: " + message + "\n");
}

TEST(Program, HelpAndVersionGoToStandardOutput) {
  const std::pair<std::vector<std::string>, std::string> cases[] = {
      {{"--help"}, cli::general_help()},
      {{"-h"}, cli::general_help()},
      {{"help"}, cli::general_help()},
      {{"--version"}, cli::version_text()},
      {{"-V"}, cli::version_text()},
      {{"render", "--help"}, cli::render_help()},
      {{"info", "-h"}, cli::info_help()},
      {{"inspect", "--help"}, cli::inspect_help()},
      {{"diff", "-h"}, cli::diff_help()},
      {{"render", "x.glb", "--resolution", "0,0", "--help"}, cli::render_help()},
  };
  for (const auto& [words, text] : cases) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 0) << words[0];
    EXPECT_EQ(outcome.out, text) << words[0];
    EXPECT_EQ(outcome.error, "") << words[0];
  }
}

TEST(Program, CommandsThatAreNoneAreNamed) {
  expect_error({}, "no command given; see barrido --help");
  expect_error({"rendr", "a.glb"}, "unknown command 'rendr'; did you mean 'render'? (see barrido --help)");
  expect_error({"--verson"}, "unknown option '--verson'; did you mean '--version'? (see barrido --help)");
  expect_error({"teapot.glb"}, "unknown command 'teapot.glb' (see barrido --help)");
}

TEST(Program, MistakesInOptionsAreOneLine) {
  expect_error({"render", "a.glb", "-o", "a.png", "--resolution", "0,5"},
               "--resolution: '0,5': expected W,H, two whole numbers in 1..16384");
  expect_error({"render", "a.glb", "-o", "a.png", "--shadng", "flat"},
               "unknown option '--shadng'; did you mean '--shading'?");
  expect_error({"render", "a.glb", "-o", "a.png", "--exposure", "1\n2"},
               "--exposure: '1\\n2': expected a number in -32..32");
  expect_error({"info"}, "info: no FILE given; see barrido info --help");
  expect_error({"info", "a", "b"}, "info: one FILE at a time");
  expect_error({"info", "--jsno", "a"}, "unknown option '--jsno'; did you mean '--json'?");
}

TEST(Program, AFullDiskIsAnError) {
  const Outcome outcome = run({"--help"}, {{}, "/dev/full", false, 0});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.error, "barrido: standard output: No space left on device\n");
}

TEST(Program, AClosedStandardOutputIsAnError) {
  const Outcome outcome = run({"--help"}, {{}, "", true, 0});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.error, "barrido: standard output: Bad file descriptor\n");
}

}  // namespace
}  // namespace barrido::test
