// Names of pictures from templates.
#include "viewer/barrido/output_template.h"

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

const FrameName kName{"teapot", "cheap-phong", "2", 7, "overdraw"};

TEST(OutputTemplate, PlaceholdersAreReplaced) {
  EXPECT_EQ(OutputTemplate("a/{model}-{shading}_{camera}.{frame}.png").expand(kName),
            "a/teapot-cheap-phong_2.7.png");
  EXPECT_EQ(OutputTemplate("{frame:04}{frame:01}{frame:09}").expand(kName), "00077000000007");
  EXPECT_EQ(OutputTemplate("{frame:02}").expand({"", "", "", 12345, ""}), "12345");
  EXPECT_EQ(OutputTemplate("{view}.png").expand(kName), "overdraw.png");
  EXPECT_EQ(OutputTemplate("plain.png").expand(kName), "plain.png");
}

TEST(OutputTemplate, DoubledBracesAreBraces) {
  EXPECT_EQ(OutputTemplate("{{{model}}}.png").expand(kName), "{teapot}.png");
  EXPECT_EQ(OutputTemplate("{{model}}").expand(kName), "{model}");
}

TEST(OutputTemplate, TellsWhatItHolds) {
  const OutputTemplate output("{model}{frame:04}");
  EXPECT_TRUE(output.has("model"));
  EXPECT_TRUE(output.has("frame"));
  EXPECT_FALSE(output.has("shading"));
  EXPECT_TRUE(OutputTemplate("-").is_standard_output());
  EXPECT_FALSE(OutputTemplate("./-").is_standard_output());
  EXPECT_FALSE(OutputTemplate("{model}").is_standard_output());
}

TEST(OutputTemplate, MistakesAreRefused) {
  for (const char* text : {"", "{", "}", "{model", "model}", "{Model}", "{}", "{frame:4}", "{frame:00}",
                           "{frame:010}", "{frame:0x}", "{shading:04}", "{ model }", "{model}}"}) {
    EXPECT_THROW(OutputTemplate{text}, ValueError) << text;
  }
  try {
    OutputTemplate("{name}.png");
    FAIL();
  } catch (const ValueError& error) {
    EXPECT_STREQ(error.what(),
                 "unknown placeholder {name}: expected {model}, {folder}, {shading}, {camera}, {frame}, "
                 "{frame:04} or {view}");
  }
}

}  // namespace
}  // namespace barrido::cli
