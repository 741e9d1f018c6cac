// Lights from text.
#include <gtest/gtest.h>

#include "pipeline/scene/light_conversion.h"
#include "raster/base/portable_math.h"
#include "viewer/barrido/specs.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

using scene::Light;
using scene::UserLight;

std::string complaint(const char* text) {
  try {
    parse_light(text);
  } catch (const ValueError& error) {
    return error.what();
  }
  return "";
}

TEST(LightSpec, Directional) {
  const UserLight user = parse_light("directional:dir=0,-1,-2:color=1,0.5,0:intensity=-2");
  EXPECT_EQ(user.light.kind, Light::Kind::directional);
  EXPECT_EQ(user.space, UserLight::Space::world);
  EXPECT_EQ(user.direction, glm::vec3(0, -1, -2));
  EXPECT_EQ(user.light.color, glm::vec3(1, 0.5f, 0));
  EXPECT_EQ(user.light.exact_intensity, -2.0f);
}

TEST(LightSpec, DefaultsAreAWhiteLightOfIntensityOneThatDoesNotFade) {
  const UserLight point = parse_light("point");
  EXPECT_EQ(point.light.kind, Light::Kind::point);
  EXPECT_EQ(point.light.color, glm::vec3(1.0f));
  EXPECT_EQ(point.light.exact_intensity, 1.0f);
  EXPECT_EQ(point.light.attenuation, (std::array<float, 3>{1, 0, 0}));
  EXPECT_EQ(point.light.range, 0.0f);
  EXPECT_EQ(point.position, glm::vec3(0.0f));
}

TEST(LightSpec, PointsFade) {
  const UserLight point = parse_light("point:pos=1,2,3:attenuation=1,0,0.1:range=20");
  EXPECT_EQ(point.position, glm::vec3(1, 2, 3));
  EXPECT_EQ(point.light.attenuation, (std::array<float, 3>{1, 0, 0.1f}));
  EXPECT_EQ(point.light.range, 20.0f);
}

TEST(LightSpec, SpotsAreSoftOrHard) {
  const UserLight soft = parse_light("spot:pos=0,2,0:dir=0,-1,0:cone=10,30");
  EXPECT_FLOAT_EQ(soft.light.inner_cone_rad, static_cast<float>(radians(10)));
  EXPECT_FLOAT_EQ(soft.light.outer_cone_rad, static_cast<float>(radians(30)));
  EXPECT_FALSE(soft.light.spot_exponent.has_value());
  const UserLight hard = parse_light("spot:exponent=8:cutoff=20");
  EXPECT_FLOAT_EQ(hard.light.outer_cone_rad, static_cast<float>(radians(20)));
  EXPECT_EQ(hard.light.spot_exponent, 8.0f);
  EXPECT_EQ(parse_light("spot").light.spot_exponent, 0.0f);
}

TEST(LightSpec, PresetsAreTheThreeLightSetUp) {
  const auto setup = scene::three_light_setup();
  const char* names[] = {"key", "fill", "back"};
  for (std::size_t i = 0; i < 3; ++i) {
    const UserLight user = parse_light(names[i]);
    EXPECT_EQ(user.space, UserLight::Space::camera);
    const pipeline::Light made = scene::convert_light(user.light, {user.position, user.direction});
    EXPECT_EQ(made.diffuse, setup[i].diffuse) << names[i];
    for (int axis = 0; axis < 4; ++axis) EXPECT_FLOAT_EQ(made.position[axis], setup[i].position[axis]);
  }
  const UserLight brighter = parse_light("fill:intensity=2:space=world:color=0,0,1");
  EXPECT_EQ(brighter.light.exact_intensity, 2.0f);
  EXPECT_EQ(brighter.space, UserLight::Space::world);
}

TEST(LightSpec, MistakesAreNamed) {
  EXPECT_EQ(complaint("pont"),
            "expected one of key, fill, back, directional, point, spot; did you mean 'point'?");
  EXPECT_EQ(
      complaint("point:position=1,2,3"),
      "'position' is no key of this light: expected one of color, intensity, pos, attenuation, range, space");
  EXPECT_EQ(
      complaint("point:dri=1,2,3"),
      "'dri' is no key of this light: expected one of color, intensity, pos, attenuation, range, space");
  EXPECT_EQ(complaint("spot:dri=1,2,3").substr(0, 30), "'dri' is no key of this light:");
  EXPECT_EQ(complaint("spot:pos=1,2"), "pos: expected X,Y,Z, 3 numbers");
  EXPECT_EQ(complaint("spot:intensity"), "expected TYPE:KEY=VALUE:..., but 'intensity' has no '='");
  EXPECT_EQ(complaint("spot:pos=1,2,3:pos=1,2,3"), "pos is given twice");
  EXPECT_EQ(complaint("spot:cone=30,10"), "cone: expected INNER,OUTER with INNER not above OUTER");
  EXPECT_EQ(complaint("spot:cone=10,20:exponent=2"),
            "cone (soft) and cutoff or exponent (hard) exclude each other");
}

TEST(MaterialSpec, MistakesAreNamedAsThoseOfLights) {
  const auto of = [](const char* text) -> std::string {
    try {
      parse_material(text);
    } catch (const ValueError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(
      of("rougness=1"),
      "'rougness' is no key of a material: expected one of color, metallic, roughness, ambient, diffuse, "
      "specular, emission, shininess; did you mean 'roughness'?");
  EXPECT_EQ(of("roughness"), "expected KEY=VALUE:..., but 'roughness' has no '='");
  EXPECT_EQ(of("roughness=1:roughness=0"), "roughness is given twice");
  EXPECT_EQ(of("roughness=2"), "roughness: expected a number in 0..1");
  EXPECT_EQ(of("color=1,1,1:shininess=20:diffuse=9,0,0"), "");
}

TEST(LightSpec, ImpossibleValuesAreRefused) {
  for (const char* text : {"", ":", "point:", "directional:dir=0,0,0", "directional:pos=1,2,3",
                           "point:cone=1,2", "spot:cutoff=91", "spot:cutoff=-1", "point:attenuation=0,0,0",
                           "point:attenuation=-1,0,0", "point:color=-1,0,0", "point:intensity=nan",
                           "point:intensity=1x", "point:range=-1", "point:space=here", "key:pos=1,2,3"}) {
    EXPECT_THROW(parse_light(text), ValueError) << text;
  }
}

}  // namespace
}  // namespace barrido::cli
