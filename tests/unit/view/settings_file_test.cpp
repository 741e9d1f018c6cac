// Settings files: what is written is read again, what is wrong is told with its place.
#include "viewer/barrido/settings_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/unit/view/random_options.h"
#include "viewer/barrido/render_options.h"
#include "viewer/view/render_words.h"

namespace barrido::view {
namespace {

class SettingsFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ =
        (std::filesystem::temp_directory_path() / (std::string("barrido_settings_") + info->name())).string();
  }
  void TearDown() override { std::filesystem::remove(path_); }

  void write(const std::string& text) const { std::ofstream(path_) << text; }

  cli::RenderOptions read(std::vector<std::string> words = {}) const {
    words.insert(words.end(), {"--settings", path_});
    return cli::parse_view_options(words);
  }

  /// What is said of a file with this text, without the file's name.
  std::string complaint(const std::string& text) const {
    write(text);
    try {
      read();
    } catch (const std::exception& error) {
      const std::string message = error.what();
      return message.substr(0, path_.size() + 2) == path_ + ": " ? message.substr(path_.size() + 2) : message;
    }
    return "";
  }

  std::string path_;
};

TEST_F(SettingsFile, HoldsOptionsByName) {
  write(
      R"({"shading": "flat", "exposure": 1.5, "camera-position": [1, -2.5, 1e1], "edges": true, "wireframe": false,
            "light": ["key", "point:pos=1,2,3"], "resolution": [320, 200], "light-off": 2})");
  const cli::RenderOptions options = read();
  EXPECT_EQ(options.shadings, std::vector{pipeline::ShadeModel::flat});
  EXPECT_EQ(options.settings.exposure_ev, 1.5f);
  EXPECT_EQ(options.settings.camera.position, glm::dvec3(1, -2.5f, 10));
  EXPECT_TRUE(options.settings.overlays.edges);
  EXPECT_FALSE(options.settings.wireframe);
  EXPECT_EQ(options.settings.lights.size(), 2u);
  EXPECT_EQ(options.settings.width, 320);
  EXPECT_EQ(options.settings.lights_off, std::vector{1});
}

TEST_F(SettingsFile, TheCommandLineWins) {
  write(R"({"shading": "flat", "light": ["key", "fill"], "exposure": 2})");
  const cli::RenderOptions options = read({"--shading", "gouraud", "--light", "back"});
  EXPECT_EQ(options.shadings, std::vector{pipeline::ShadeModel::gouraud});
  EXPECT_EQ(options.settings.lights.size(), 1u);
  EXPECT_EQ(options.settings.exposure_ev, 2.0f);
}

TEST_F(SettingsFile, WhatIsWrittenIsReadAgain) {
  testing::RandomOptions random(3);
  for (int i = 0; i < 300 && !HasFailure(); ++i) {
    const cli::RenderOptions options = random.next();
    const std::vector<std::string> words = words_of(options);
    cli::write_settings(path_, cli::render_syntax(), words);
    SCOPED_TRACE(cli::settings_json(cli::render_syntax(), words));
    testing::expect_same(read(), options);
  }
}

TEST_F(SettingsFile, NumbersAreNumbers) {
  const std::vector<std::string> words{"a.glb",        "-o",      "a.png",     "--camera-position",
                                       "0.1,-2,3e-05", "--edges", "--light",   "key",
                                       "--exposure",   "-0.5",    "--threads", "2"};
  EXPECT_EQ(cli::settings_json(cli::render_syntax(), words), R"({
  "edges": true,
  "light": [
    "key"
  ],
  "camera-position": [
    0.1,
    -2,
    3e-05
  ],
  "exposure": -0.5
}
)");
}

TEST_F(SettingsFile, MistakesAreToldWithTheirPlace) {
  EXPECT_EQ(complaint("{"), "line 1, column 2: is not JSON");
  EXPECT_EQ(complaint("{\"edges\": true,\n x}"), "line 2, column 2: is not JSON");
  EXPECT_EQ(complaint("[]"), "expected a JSON object, {\"option\": value, …}");
  EXPECT_EQ(complaint(R"({"shadng": "flat"})"), "shadng: is no setting; did you mean 'shading'?");
  EXPECT_EQ(complaint(R"({"output": "a.png"})"), "output: is no setting");
  EXPECT_EQ(complaint(R"({"edges": 1})"), "edges: expected true or false");
  EXPECT_EQ(complaint(R"({"edges": true, "edges": false})"), "edges: is given twice");
  EXPECT_EQ(complaint(R"({"exposure": true})"), "exposure: expected a string, a number or an array of them");
  EXPECT_EQ(complaint(R"({"exposure": []})"), "exposure: expected a string, a number or an array of them");
  EXPECT_EQ(complaint(R"({"exposure": {"a": 1}})"),
            "exposure: expected a string, a number or an array of them");
  EXPECT_EQ(complaint(R"({"light": [1]})"), "light: expected a string or an array of strings");
  EXPECT_EQ(complaint(R"({"exposure": 99})"), "exposure: '99': expected a number in -32..32");
  EXPECT_EQ(complaint(R"({"exposure": [[[1]]]})"), "is no settings file: values within values");
  EXPECT_EQ(complaint(R"({"no-lights": true, "light": "key"})"),
            "--no-lights: cannot be used together with --light");
  EXPECT_EQ(complaint(std::string(2 << 20, ' ')), "is no settings file: larger than 1 MiB");
}

TEST_F(SettingsFile, AMissingFileIsTold) {
  EXPECT_THROW(read(), scene::InputError);
  path_ = std::filesystem::temp_directory_path().string();
  EXPECT_THROW(read(), scene::InputError);
  path_ = "none";
}

TEST_F(SettingsFile, NothingIsLeftWhereWritingFails) {
  EXPECT_THROW(cli::write_settings("/no such folder/a.json", cli::render_syntax(), {}), scene::InputError);
}

}  // namespace
}  // namespace barrido::view
