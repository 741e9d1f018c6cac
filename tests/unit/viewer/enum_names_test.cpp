// Names of enumerations: none is missing, and the check that says so finds one that is.
#include "raster/base/enum_names.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "pipeline/inspect/structure_view.h"
#include "pipeline/scene/names.h"

namespace barrido {
namespace {

enum class Hue { red, green_blue, grey };

constexpr auto kAll =
    std::to_array<Named<Hue>>({{Hue::red, "red"}, {Hue::green_blue, "green-blue"}, {Hue::grey, "grey"}});
constexpr auto kOneMissing = std::to_array<Named<Hue>>({{Hue::red, "red"}, {Hue::grey, "grey"}});
constexpr auto kOneTwice = std::to_array<Named<Hue>>(
    {{Hue::red, "red"}, {Hue::green_blue, "green-blue"}, {Hue::grey, "grey"}, {Hue::grey, "gray"}});
constexpr auto kOneEmpty =
    std::to_array<Named<Hue>>({{Hue::red, "red"}, {Hue::green_blue, ""}, {Hue::grey, "grey"}});

static_assert(enum_names::is_complete(kAll));
static_assert(!enum_names::is_complete(kOneMissing));
static_assert(!enum_names::is_complete(kOneTwice));
static_assert(!enum_names::is_complete(kOneEmpty));

/// The compiler has checked that there is a name for each value; here that no name stands for two.
template <class Value>
void expect_names() {
  std::set<std::string_view> names;
  for (const Named<Value>& row : names_of<Value>()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(name_of(row.value), row.name);
    EXPECT_EQ(value_named<Value>(row.name), row.value);
    EXPECT_EQ(row.name.find_first_of(" _"), std::string_view::npos) << row.name;
  }
  EXPECT_FALSE(value_named<Value>("no such name"));
}

TEST(EnumNames, ReadBackAsTheirValues) {
  expect_names<raster::Topology>();
  expect_names<raster::MinFilter>();
  expect_names<raster::MagFilter>();
  expect_names<raster::TextureEnvMode>();
  expect_names<raster::CombineFunction>();
  expect_names<raster::CombineSource>();
  expect_names<raster::CombineOperand>();
  expect_names<raster::FogMode>();
  expect_names<raster::BlendFactor>();
  expect_names<raster::BlendEquation>();
  expect_names<raster::ToneMap>();
  expect_names<raster::Compare>();
  expect_names<pipeline::ShadeModel>();
  expect_names<pipeline::FlatAt>();
  expect_names<pipeline::CheapPhongPower>();
  expect_names<pipeline::SpecularModel>();
  expect_names<pipeline::ColorInterpolation>();
  expect_names<pipeline::TextureInterpolation>();
  expect_names<pipeline::CullFace>();
  expect_names<scene::Light::Kind>();
  expect_names<scene::UserLight::Space>();
  expect_names<scene::Feature::Support>();
  expect_names<scene::ColorManagement>();
  expect_names<inspect::StructureView>();
}

TEST(EnumNames, TitlesAreTheNamesUnlessTheyAreGiven) {
  static_assert(kAll[1].title == "green-blue");
  EXPECT_EQ(names_of<pipeline::ShadeModel>()[2].title, "cheap Phong");
}

}  // namespace
}  // namespace barrido
