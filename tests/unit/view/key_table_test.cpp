// One table for keys and help: nothing is bound twice, everything is told.
#include "viewer/view/key_table.h"

#include <gtest/gtest.h>

#include <set>

#include "viewer/barrido/render_option_table.h"

namespace barrido::view {
namespace {

TEST(KeyTable, NoKeyIsBoundTwice) {
  std::set<std::pair<int, unsigned>> bound;
  for (const KeyBinding& binding : key_table()) {
    if (!binding.action) continue;
    EXPECT_TRUE(bound.emplace(static_cast<int>(binding.key), binding.modifiers).second) << binding.name;
  }
}

TEST(KeyTable, StepsAreOfOptionsWithAWidget) {
  int steps = 0;
  for (const KeyBinding& binding : key_table()) {
    if (binding.action.option.empty()) continue;
    const cli::RenderOption& row = cli::render_option(binding.action.option);
    EXPECT_EQ(row.editor.kind, cli::Editor::Kind::widget) << binding.name;
    EXPECT_NE(binding.action.step, 0.0f);
    ++steps;
  }
  EXPECT_GE(steps, 19);
}

TEST(KeyTable, HelpNamesEveryKeyThatIsBound) {
  const std::string help = keys_help();
  for (const KeyBinding& binding : key_table()) {
    if (binding.name.empty()) {
      EXPECT_EQ(binding.modifiers, static_cast<unsigned>(kControl));  // Ctrl+2 … 8 stand with Ctrl+1
      continue;
    }
    EXPECT_NE(help.find("  " + std::string(binding.name) + " "), std::string::npos) << binding.name;
    EXPECT_FALSE(binding.help.empty());
  }
}

/// Whatever is pressed, in whatever order: what results is something that the command line takes.
TEST(KeyTable, EveryKeyLeavesOptionsThatCanBeRead) {
  Viewer viewer({});
  viewer.open({BARRIDO_SOURCE_DIR "/models/checker_square.glb"});
  ASSERT_EQ(viewer.message, "");
  std::uint32_t state = 12345;
  for (int i = 0; i < 2000; ++i) {
    state = state * 1664525u + 1013904223u;
    const KeyBinding& binding = key_table()[(state >> 8) % key_table().size()];
    if (!binding.action || binding.key == Key::up) continue;
    press(viewer, binding.key, binding.modifiers);
    viewer.requests.clear();
    viewer.message.clear();
    EXPECT_NO_THROW(cli::parse_view_options(viewer.words()))
        << binding.name << ": " << viewer.command_line(viewer.active_side());
  }
}

TEST(KeyTable, KeysOfTheWindowDoNotChangeThePicture) {
  Viewer viewer({});
  for (const Key key : {key_of('H'), key_of('Z'), Key::tab, Key::escape, Key::f12, key_of('C')}) {
    viewer.changed = false;
    EXPECT_TRUE(press(viewer, key, kPlain));
    EXPECT_FALSE(viewer.changed);
  }
  EXPECT_TRUE(press(viewer, key_of('S'), kShift));
  EXPECT_TRUE(viewer.changed);
  EXPECT_FALSE(press(viewer, key_of('S'), kShift | kControl));
}

TEST(KeyTable, EscapeClosesTheHelpFirst) {
  Viewer viewer({});
  press(viewer, key_of('H'), kPlain);
  press(viewer, Key::escape, kPlain);
  EXPECT_FALSE(viewer.display.help);
  EXPECT_TRUE(viewer.requests.empty());
  press(viewer, Key::escape, kPlain);
  EXPECT_EQ(viewer.requests, std::vector{Request::quit});
}

}  // namespace
}  // namespace barrido::view
