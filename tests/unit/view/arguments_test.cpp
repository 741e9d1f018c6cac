// The command line of barrido-view.
#include "viewer/view/arguments.h"

#include <gtest/gtest.h>

#include "viewer/view/key_table.h"

namespace barrido::view {
namespace {

std::string complaint(const std::vector<std::string>& words) {
  try {
    parse_view_arguments(words);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(ViewArguments, OptionsOfBothKinds) {
  const ViewArguments arguments = parse_view_arguments(
      {"a.glb", "--report", "--shading", "flat", "--no-panel", "b.glb", "--scale", "1.5"});
  EXPECT_EQ(arguments.files, (std::vector<std::string>{"a.glb", "b.glb"}));
  EXPECT_TRUE(arguments.report);
  EXPECT_FALSE(arguments.panel);
  EXPECT_EQ(arguments.scale, 1.5f);
  EXPECT_EQ(arguments.options.shadings, std::vector{pipeline::ShadeModel::flat});
  EXPECT_EQ(arguments.settings_path, "barrido-view.json");
}

TEST(ViewArguments, AFileMayBeCalledAsAnOption) {
  const ViewArguments arguments = parse_view_arguments({"--", "--report"});
  EXPECT_EQ(arguments.files, std::vector<std::string>{"--report"});
  EXPECT_FALSE(arguments.report);
}

TEST(ViewArguments, NoFileIsNeeded) { EXPECT_EQ(complaint({}), ""); }

TEST(ViewArguments, WhatAWindowCannotDoIsRefused) {
  EXPECT_EQ(complaint({"a.glb", "-o", "a.png"}), "--output: only for barrido render");
  EXPECT_EQ(complaint({"a.glb", "--hash"}), "--hash: only for barrido render");
  EXPECT_EQ(complaint({"a.glb", "--frames", "0:3"}), "--frames: only for barrido render");
  EXPECT_EQ(complaint({"--scale", "9"}), "--scale: '9': expected a number in 0.5..4");
  EXPECT_EQ(complaint({"--scale"}), "--scale: needs a value");
  EXPECT_EQ(complaint({"--shading", "flt"}).substr(0, 16), "--shading: 'flt'");
}

TEST(ViewArguments, HelpTellsOptionsAndKeys) {
  const std::string help = view_help();
  for (const char* const text : {"--report", "--settings", "Shift+S", "Ctrl+1"}) {
    EXPECT_NE(help.find(text), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace barrido::view
