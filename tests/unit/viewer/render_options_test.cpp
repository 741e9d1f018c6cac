// The command line of `barrido render` as a whole: which options exclude or need each other.
#include "viewer/barrido/render_options.h"

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

using Words = std::vector<std::string>;

/// "a.glb -o a.png" and these words.
RenderOptions parse(Words words) {
  words.insert(words.begin(), {"a.glb", "-o", "a.png"});
  return parse_render_options(words);
}

std::string complaint(const Words& words) {
  try {
    parse_render_options(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

std::string complaint_after_file(Words words) {
  words.insert(words.begin(), {"a.glb", "-o", "a.png"});
  return complaint(words);
}

TEST(RenderOptions, DefaultsAreTheRenderers) {
  const RenderOptions options = parse({});
  EXPECT_EQ(options.files, Words{"a.glb"});
  EXPECT_EQ(options.output, "a.png");
  EXPECT_EQ(options.shadings, std::vector{pipeline::ShadeModel::phong});
  EXPECT_EQ(options.settings.width, 1280);
  EXPECT_EQ(options.settings.height, 720);
  EXPECT_TRUE(options.settings.visibility_first);
  EXPECT_FALSE(options.settings.camera.ignore_file_cameras);
  EXPECT_EQ(options.stats, StatsFormat::none);
  EXPECT_EQ(options.threads, 0);
}

TEST(RenderOptions, HelpStandsBeforeAllElse) {
  EXPECT_TRUE(parse_render_options(Words{"--help"}).help);
  EXPECT_TRUE(parse_render_options(Words{"--resolution", "0,5", "-h"}).help);
}

TEST(RenderOptions, FilesAndAnOutputAreNeeded) {
  EXPECT_EQ(complaint({"-o", "a.png"}), "render: no FILE given; see barrido render --help");
  EXPECT_EQ(complaint({"a.glb"}), "render: no output given; say -o OUT (or only --hash or --stats)");
  EXPECT_EQ(complaint({"", "-o", "a.png"}), "render: a FILE with an empty name");
  EXPECT_EQ(complaint({"a.glb", "-o", ""}), "--output: '': expected a file name, or - for standard output");
  EXPECT_EQ(complaint({"a.glb", "--hash"}), "");
  EXPECT_EQ(complaint({"a.glb", "--stats"}), "");
}

TEST(RenderOptions, ValuesAreNamedWithTheirOption) {
  EXPECT_EQ(complaint_after_file({"--resolution", "0,5"}),
            "--resolution: '0,5': expected W,H, two whole numbers in 1..16384");
  EXPECT_EQ(complaint_after_file({"--tone-map", "clmap"}),
            "--tone-map: 'clmap': expected clamp or reinhard; did you mean 'clamp'?");
  EXPECT_EQ(complaint_after_file({"--light", "point:pos=1"}),
            "--light: 'point:pos=1': pos: expected X,Y,Z, 3 numbers");
}

TEST(RenderOptions, ContradictionsAreRefused) {
  EXPECT_EQ(complaint_after_file({"--no-lights", "--light", "key"}),
            "--no-lights: cannot be used together with --light");
  EXPECT_EQ(complaint_after_file({"--turntable", "4", "--frames", "0:3"}),
            "--turntable: cannot be used together with --frames");
  EXPECT_EQ(complaint_after_file({"--time", "1", "--frames", "0:3"}),
            "--time: cannot be used together with --frames");
  EXPECT_EQ(complaint_after_file({"--camera-index", "0,1", "--camera-position", "1,2,3"}),
            "--camera-index: several cannot be used together with --camera-position");
  EXPECT_EQ(complaint_after_file({"--camera-index", "all", "--camera-focal-point", "1,2,3"}),
            "--camera-index: several cannot be used together with --camera-focal-point");
  EXPECT_EQ(complaint_after_file({"--camera-position", "1,2,3", "--camera-focal-point", "1,2,3"}),
            "--camera-focal-point: is the same point as --camera-position");
}

TEST(RenderOptions, NeedsAreNamed) {
  EXPECT_EQ(complaint_after_file({"--fps", "25"}), "--fps: only with --frames, --turntable or --shutter");
  EXPECT_EQ(complaint({"a.glb", "--hash", "--sheet"}), "--sheet: only with --output");
  EXPECT_EQ(complaint_after_file({"--background", "environment"}),
            "--background: 'environment': needs a picture, --environment PATH");
  EXPECT_EQ(complaint_after_file({"--background", "environment", "--environment", "dynamic"}),
            "--background: 'environment': needs a picture, --environment PATH");
  EXPECT_EQ(complaint_after_file({"--background", "environment", "--environment", "sky.hdr"}), "");
}

TEST(RenderOptions, AnEyeOfTheUserReplacesTheFilesCameras) {
  EXPECT_TRUE(parse({"--camera-position", "1,2,3"}).settings.camera.ignore_file_cameras);
  EXPECT_EQ(parse({"--camera-position", "1,2,3", "--camera-index", "4"}).cameras, std::vector{4});
  EXPECT_TRUE(parse({"--camera-focal-point", "1,2,3"}).settings.camera.ignore_file_cameras);
  EXPECT_FALSE(parse({"--camera-view-angle", "40"}).settings.camera.ignore_file_cameras);
}

TEST(RenderOptions, LightsKeepTheirOrder) {
  const RenderOptions options = parse({"--light", "point", "--light", "spot", "--light", "key"});
  ASSERT_EQ(options.settings.lights.size(), 3u);
  EXPECT_EQ(options.settings.lights[0].light.kind, scene::Light::Kind::point);
  EXPECT_EQ(options.settings.lights[1].light.kind, scene::Light::Kind::spot);
  EXPECT_EQ(options.settings.lights[2].light.kind, scene::Light::Kind::directional);
}

TEST(RenderOptions, EveryOptionHasASectionAHelpTextAndAnOwnName) {
  std::vector<std::string_view> names;
  for (const OptionSyntax& option : render_syntax()) {
    EXPECT_FALSE(option.section.empty()) << option.name;
    EXPECT_FALSE(option.help.empty()) << option.name;
    EXPECT_EQ(option.name.substr(0, 2), "--");
    EXPECT_EQ(option.form.empty(), option.kind == OptionKind::flag) << option.name;
    EXPECT_EQ(std::count(names.begin(), names.end(), option.name), 0) << option.name;
    names.push_back(option.name);
  }
}

}  // namespace
}  // namespace barrido::cli
