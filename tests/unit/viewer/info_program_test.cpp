// `barrido info`: what a file holds, as text and as JSON.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/viewer/program.h"
#include "tests/unit/viewer/tiny_models.h"

namespace barrido::test {
namespace {

class Info : public ::testing::Test {
 protected:
  Info() {
    write_animated(folder_.path() / "animated.gltf");
    write_textured_glb(folder_.path() / "bumps.glb", 4);
  }

  Outcome info(std::vector<std::string> words) const {
    words.insert(words.begin(), "info");
    return run(words, {folder_.path(), "", false, 0});
  }

  TemporaryFolder folder_;
};

TEST_F(Info, TextNamesWhatTheFileHolds) {
  const Outcome outcome = info({"animated.gltf"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  const auto lines = lines_of(outcome.out);
  ASSERT_GT(lines.size(), 10u);
  EXPECT_EQ(lines[0], "animated.gltf");
  for (const char* line :
       {"  made by     tiny models", "  nodes       4",
        "  meshes      1 mesh of 1 primitive: 2 triangles, 4 vertices",
        "  drawn       4 triangles, 8 vertices", "  bounds      -1,-1,-2 to 1,1,0 (size 2,2,2)",
        "  cameras     2", "                0 \"front\" perspective, 45.8 degrees vertical",
        "                1 \"side\" perspective, 45.8 degrees vertical", "  animations  1",
        "                0 \"slide\" 1 s, 1 channel"}) {
    EXPECT_NE(std::find(lines.begin(), lines.end(), line), lines.end()) << line << "\nin\n" << outcome.out;
  }
}

TEST_F(Info, JsonHoldsTheSame) {
  const Outcome outcome = info({"--json", "animated.gltf"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["file"], "animated.gltf");
  EXPECT_EQ(json["nodes"], 4);
  EXPECT_EQ(json["stored"]["triangles"], 2);
  EXPECT_EQ(json["drawn"]["triangles"], 4);
  EXPECT_EQ(json["bounds"]["min"], (nlohmann::json{-1, -1, -2}));
  EXPECT_EQ(json["cameras"][1]["name"], "side");
  EXPECT_EQ(json["animations"][0]["duration_s"], 1.0);
  EXPECT_EQ(json["materials"], nlohmann::json::array({"red"}));
  EXPECT_TRUE(json["features"].is_array());
  EXPECT_TRUE(json["warnings"].is_array());
}

TEST_F(Info, TexturesHaveSizes) {
  const auto json = nlohmann::json::parse(info({"bumps.glb", "--json"}).out);
  ASSERT_EQ(json["images"].size(), 1u);
  EXPECT_EQ(json["images"][0]["width"], 16);
  EXPECT_EQ(json["images"][0]["height"], 16);
  EXPECT_EQ(json["stored"]["triangles"], 32);
  EXPECT_NE(info({"bumps.glb"}).out.find("16 x 16"), std::string::npos);
}

TEST_F(Info, FilesThatCannotBeReadAreOneLine) {
  write_text(folder_.path() / "broken.glb", "glTF");
  for (const char* file : {"missing.glb", "broken.glb"}) {
    const Outcome outcome = info({file});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.error).size(), 1u);
    EXPECT_EQ(outcome.error.find("barrido: " + std::string(file) + ": "), 0u) << outcome.error;
  }
}

TEST_F(Info, ValidateTellsFaultsPlacesAndWhetherItIsDrawn) {
  const Outcome sound = info({"--validate", "bumps.glb"});
  EXPECT_EQ(sound.status, 0) << sound.error;
  EXPECT_TRUE(sound.out.starts_with("bumps.glb: 0 errors, 0 warnings")) << sound.out;
  EXPECT_EQ(lines_of(sound.out).back(), "barrido render draws it");

  write_text(folder_.path() / "faulty.gltf",
             R"({"asset":{"version":"2.0"},"nodes":[{"mesh":7}],"scenes":[{"nodes":[0]}],"x":1})");
  const Outcome faulty = info({"faulty.gltf", "--validate"});
  EXPECT_EQ(faulty.status, 2);
  EXPECT_EQ(faulty.error, "");
  const auto lines = lines_of(faulty.out);
  ASSERT_EQ(lines.size(), 5u) << faulty.out;
  EXPECT_EQ(lines[0], "faulty.gltf: 1 error, 1 warning, 1 remark");
  EXPECT_EQ(lines[1], "  error        UNRESOLVED_REFERENCE /nodes/0/mesh: meshes[7] does not exist.");
  EXPECT_EQ(lines[2], "  warning      UNEXPECTED_PROPERTY /x: There is no such property.");
  EXPECT_EQ(lines[4],
            "barrido render refuses it: faulty.gltf: nodes[0].mesh: refers to meshes[7], but there are none");
}

TEST_F(Info, ValidateInJsonHasTheFormOfTheReferenceValidator) {
  write_text(folder_.path() / "faulty.gltf", R"({"asset":{"version":"2.0"},"nodes":[]})");
  const Outcome outcome = info({"faulty.gltf", "--validate", "--json"});
  EXPECT_EQ(outcome.status, 2);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["uri"], "faulty.gltf");
  EXPECT_EQ(json["mimeType"], "model/gltf+json");
  EXPECT_EQ(json["issues"]["numErrors"], 1);
  EXPECT_EQ(json["issues"]["numWarnings"], 0);
  EXPECT_EQ(json["issues"]["numInfos"], 0);
  EXPECT_EQ(json["issues"]["numHints"], 0);
  EXPECT_EQ(json["issues"]["truncated"], false);
  ASSERT_EQ(json["issues"]["messages"].size(), 1u);
  EXPECT_EQ(json["issues"]["messages"][0]["code"], "EMPTY_ENTITY");
  EXPECT_EQ(json["issues"]["messages"][0]["severity"], 0);
  EXPECT_EQ(json["issues"]["messages"][0]["pointer"], "/nodes");
  EXPECT_EQ(json["info"]["version"], "2.0");
  EXPECT_EQ(json["render"]["drawn"], true);
}

TEST_F(Info, ValidateOfAFileThatIsNotThereIsOneLine) {
  const Outcome outcome = info({"--validate", "missing.glb"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.error, "barrido: missing.glb: no such file\n");
}

}  // namespace
}  // namespace barrido::test
