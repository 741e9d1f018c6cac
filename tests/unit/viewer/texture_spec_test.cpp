// Textures and mappings from text and back.
#include "viewer/barrido/texture_spec.h"

#include <gtest/gtest.h>

#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

TEST(TextureSpec, ProceduresWithAllTheirKeys) {
  const auto marble = parse_solid(
      "marble:scale=0.5:axis=1,0,0:space=world:dark=0.25,0,0:light=1,1,0.5,0.75:"
      "octaves=4:gain=0.25:turbulence=-2");
  ASSERT_TRUE(marble);
  EXPECT_EQ(marble->pattern.kind, raster::PatternKind::marble);
  EXPECT_EQ(marble->scale, 0.5f);
  EXPECT_EQ(marble->axis, glm::vec3(1, 0, 0));
  EXPECT_EQ(marble->space, scene::SolidTexture::Space::world);
  EXPECT_EQ(marble->pattern.colors[0], (std::array<float, 4>{0.25f, 0, 0, 1}));
  EXPECT_EQ(marble->pattern.colors[1], (std::array<float, 4>{1, 1, 0.5f, 0.75f}));
  EXPECT_EQ(marble->pattern.octaves, 4);
  EXPECT_EQ(marble->pattern.gain, 0.25f);
  EXPECT_EQ(marble->pattern.turbulence, -2.0f);
  const auto noise = parse_solid("noise:threshold=0");
  EXPECT_TRUE(noise->pattern.has_threshold);
  EXPECT_FALSE(parse_solid("noise")->pattern.has_threshold);
}

TEST(TextureSpec, OtherTextsArePictures) {
  for (const char* path : {"a.png", "./marble", "wood.jpg", "textures/marble", "/tmp/a:b=c"}) {
    EXPECT_FALSE(parse_solid(path)) << path;
  }
}

TEST(TextureSpec, MistakesAreRefused) {
  for (const char* text :
       {"", "marbel", "marble:", "marble:scale=0", "marble:scale=-1", "marble:scale", "marble:axis=0,0,0",
        "stripes:octaves=2", "checker:turbulence=1", "marble:threshold=0", "noise:threshold=2",
        "noise:octaves=0", "noise:octaves=17", "noise:gain=0", "wood:dark=2,0,0", "wood:space=camera",
        "wood:scale=1:scale=2", "wood:scale=nan"}) {
    EXPECT_THROW(parse_solid(text), ValueError) << text;
  }
  try {
    parse_solid("marbel");
  } catch (const ValueError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'marble'?"), std::string::npos) << error.what();
  }
}

TEST(MappingSpec, AllKeys) {
  const scene::MappingChoice m = parse_mapping(
      "cylinder:from=normal:at=vertices:axis=0,0,2:centre=1,2,3:size=4:repeats=3,-2:offset=0.5,0");
  EXPECT_EQ(m.surface, raster::MappingSurface::cylinder);
  EXPECT_EQ(m.ray, raster::MappingRay::normal);
  EXPECT_TRUE(m.at_vertices);
  EXPECT_EQ(m.axis, glm::vec3(0, 0, 2));
  EXPECT_EQ(m.centre, glm::vec3(1, 2, 3));
  EXPECT_EQ(m.size, 4.0f);
  EXPECT_EQ(m.repeats, glm::vec2(3, -2));
  EXPECT_EQ(m.offset, glm::vec2(0.5f, 0));
  EXPECT_EQ(mapping_text(m),
            "cylinder:from=normal:at=vertices:axis=0,0,2:centre=1,2,3:size=4:repeats=3,-2:offset=0.5,0");
  EXPECT_EQ(mapping_text(parse_mapping("box")), "box");
}

TEST(MappingSpec, MistakesAreRefused) {
  for (const char* text : {"", "none", "spere", "sphere:", "sphere:size=0", "sphere:axis=0,0,0",
                           "sphere:repeats=0,1", "sphere:repeats=1", "sphere:from=eye", "sphere:at=pixels",
                           "planar:centre=1,2", "box:offset=1,2,3", "box:color=1,1,1"}) {
    EXPECT_THROW(parse_mapping(text), ValueError) << text;
  }
}

TEST(TextureSpec, WhatIsWrittenReadsBackAsTheSameBits) {
  for (const char* text :
       {"stripes", "checker:scale=0.1:space=surface", "noise:octaves=3:gain=0.7:threshold=0",
        "wood:turbulence=0", "marble:dark=0.1,0.2,0.3:light=0.3,0.7,0.1,0.9"}) {
    const auto solid = parse_solid(text);
    ASSERT_TRUE(solid);
    EXPECT_EQ(solid_text(*solid), text);
    EXPECT_EQ(*parse_solid(solid_text(*solid)), *solid);
  }
}

}  // namespace
}  // namespace barrido::cli
