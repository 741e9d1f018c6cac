// Options written as a command line and read again are the same options, bit for bit.
#include "viewer/view/render_words.h"

#include <gtest/gtest.h>

#include <set>

#include "raster/base/portable_math.h"
#include "tests/unit/view/random_options.h"
#include "viewer/barrido/render_option_table.h"
#include "viewer/barrido/settings_file.h"
#include "viewer/barrido/specs.h"

namespace barrido::view {
namespace {

cli::RenderOptions parsed(const std::vector<std::string>& words) { return cli::parse_view_options(words); }

TEST(RenderWords, OfDefaultsAreTheSizeOnly) {
  EXPECT_EQ(words_of({}), (std::vector<std::string>{"--resolution", "1280,720"}));
}

TEST(RenderWords, GiveTheSameOptionsAgain) {
  testing::RandomOptions random(1);
  for (int i = 0; i < 2000 && !::testing::Test::HasFailure(); ++i) {
    const cli::RenderOptions options = random.next();
    SCOPED_TRACE(shell_line(words_of(options)));
    testing::expect_same(parsed(words_of(options)), options);
  }
}

/// A new option that is forgotten here could be set in the window and would be lost on the command line.
TEST(RenderWords, KnowEveryOptionOfAPicture) {
  std::set<std::string> written;
  testing::RandomOptions random(2);
  for (int i = 0; i < 300; ++i) {
    for (const std::string& word : words_of(random.next())) written.insert(word);
  }
  cli::RenderOptions rare;
  rare.settings.visibility_first = false;
  rare.settings.scene_index = 1;
  scene::UserMap map;
  map.path = "map.png";
  rare.settings.maps.bump = rare.settings.maps.transparency = rare.settings.maps.specularity = map;
  for (const std::string& word : words_of(rare)) written.insert(word);
  for (const cli::RenderOption& option : cli::render_option_table()) {
    if (!option.syntax.is_setting()) continue;
    EXPECT_TRUE(written.contains(std::string(option.syntax.name))) << option.syntax.name;
  }
}

TEST(RenderWords, PresetLightsKeepTheirNumbers) {
  for (const char* preset : {"key", "fill", "back"}) {
    const scene::UserLight light = cli::parse_light(preset);
    const scene::UserLight again = cli::parse_light(cli::light_text(light));
    EXPECT_EQ(again.direction, light.direction) << preset;
    EXPECT_EQ(again.light.exact_intensity, light.light.exact_intensity) << preset;
    EXPECT_EQ(again.space, light.space) << preset;
  }
}

TEST(RenderWords, AnglesOfConesAreReadBackAsTheSameRadians) {
  for (int tenths = 0; tenths <= 900; ++tenths) {
    const std::string cone = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
    const scene::UserLight light = cli::parse_light("spot:cutoff=" + cone);
    EXPECT_EQ(cli::parse_light(cli::light_text(light)).light.outer_cone_rad, light.light.outer_cone_rad)
        << cone;
  }
}

TEST(ShellLine, QuotesWhatAShellWouldRead) {
  EXPECT_EQ(shell_line({"barrido", "a b", "it's", "", "x=1,2:3/4.png", "$HOME", "é"}),
            "barrido 'a b' 'it'\\''s' '' x=1,2:3/4.png '$HOME' 'é'");
}

}  // namespace
}  // namespace barrido::view
