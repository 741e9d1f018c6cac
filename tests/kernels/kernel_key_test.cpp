// The kernel key: every field has its facts and is moved by the states that ought to move it, what is not in
// it moves nothing, and the loops that draw random scenes are those that the key names.
#include "raster/tiles/kernel_key.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "random_scene.h"
#include "raster/tiles/binning.h"

namespace barrido::raster::testing {
namespace {

const TexturePool& texture_pool() {
  static const TexturePool pool(2026);
  return pool;
}

struct AnyField {
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor): stands for any initialiser
};

/// Fields of a plain struct.
template <class T, class... Fields>
constexpr std::size_t field_count() {
  if constexpr (requires { T{Fields{}..., AnyField{}}; }) return field_count<T, Fields..., AnyField>();
  return sizeof...(Fields);
}

template <auto kField>
int value_of(const KernelKey& key) {
  return static_cast<int>(key.*kField);
}

struct Axis {
  std::string_view name;
  int (*value)(const KernelKey&);
  std::size_t values;  ///< That random states must lead to, at least.
};
constexpr Axis kAxes[] = {
    {"surface", value_of<&KernelKey::surface>, 2},
    {"colors", value_of<&KernelKey::colors>, 3},
    {"blending", value_of<&KernelKey::blending>, 4},
    {"sorted", value_of<&KernelKey::sorted>, 2},
    {"depth", value_of<&KernelKey::depth>, 4},
    {"late_depth", value_of<&KernelKey::late_depth>, 2},
    {"hides", value_of<&KernelKey::hides>, 2},
    {"small", value_of<&KernelKey::small>, 3},
    {"divides_color", value_of<&KernelKey::divides_color>, 2},
    {"takes_primary", value_of<&KernelKey::takes_primary>, 2},
    {"fills_primary", value_of<&KernelKey::fills_primary>, 2},
    {"fills_secondary", value_of<&KernelKey::fills_secondary>, 2},
    {"unit_colors", value_of<&KernelKey::unit_colors>, 2},
    {"lod_units", value_of<&KernelKey::lod_units>, 64},  // of 256
};
static_assert(std::size(kAxes) == field_count<KernelKey>(), "a field of the key is missing above");

const KernelKeyFact* find_fact(std::string_view name) {
  const auto* fact = std::find_if(std::begin(kKernelKeyFacts), std::end(kKernelKeyFacts),
                                  [&](const KernelKeyFact& f) { return f.name == name; });
  return fact == std::end(kKernelKeyFacts) ? nullptr : fact;
}

/// Calls visit(state, format) for random states of every kind.
void for_random_states(int count, const std::function<void(FragmentState&, ColorFormat)>& visit) {
  RandomBits random(14);
  for (int k = 0; k < count; ++k) {
    FragmentState state = k % 3 == 0 ? random_simple_state(random, 200, 100)
                                     : random_state(random, texture_pool(), k % 3 == 1, 200, 100);
    visit(state, k % 4 == 0 ? ColorFormat::rgba32f : ColorFormat::rgba8);
  }
}

TEST(KernelKey, EveryFieldHasItsFacts) {
  std::size_t in_key = 0;
  std::set<std::string_view> names, reasons;
  for (const KernelKeyFact& fact : kKernelKeyFacts) {
    EXPECT_TRUE(names.insert(fact.name).second) << fact.name << " stands twice";
    EXPECT_TRUE(fact.why.size() > 20 && reasons.insert(fact.why).second) << fact.name << " has no reason";
    if (!fact.in_key) continue;
    ASSERT_LT(in_key, std::size(kAxes)) << fact.name;
    EXPECT_EQ(fact.name, kAxes[in_key].name) << "not in the order of the fields";
    ++in_key;
  }
  EXPECT_EQ(in_key, std::size(kAxes));
}

TEST(KernelKey, EveryFieldIsMovedByStates) {
  std::set<int> values[std::size(kAxes)];
  for_random_states(20000, [&](FragmentState& state, ColorFormat format) {
    const KernelKey key = make_kernel_key(state, format);
    for (std::size_t i = 0; i < std::size(kAxes); ++i) values[i].insert(kAxes[i].value(key));
  });
  for (std::size_t i = 0; i < std::size(kAxes); ++i) {
    EXPECT_GE(values[i].size(), kAxes[i].values) << kAxes[i].name;
  }
}

/// What each field of FragmentState is to the key: the facts that tell of it, and a change that must not move
/// the key, or null where every change may.
struct StateField {
  std::string_view name;
  std::vector<std::string_view> facts;
  void (*change)(FragmentState&);
};
const std::vector<StateField>& state_fields() {
  static const std::vector<StateField> fields{
      {"varyings", {"colors", "divides_color", "fills_primary", "fills_secondary"}, nullptr},
      {"stages", {"stages", "colors"}, [](FragmentState& s) { s.stages.front().parameters = &s; }},
      {"texture_units",
       {"texture_units", "colors", "takes_primary", "lod_units"},
       [](FragmentState& s) {
         for (TextureUnit& unit : s.texture_units) {
           unit.lod_bias += 1.0f;
           unit.env_color[1] = 0.5f;
         }
       }},
      {"separate_specular", {"colors", "fills_secondary"}, nullptr},
      {"clamp_colors", {"unit_colors"}, nullptr},
      {"fog",
       {"stages"},
       [](FragmentState& s) {
         s.fog.mode = FogMode::linear;
         s.fog.color[0] = 0.25f;
       }},
      {"alpha_test",
       {"comparison", "late_depth"},
       [](FragmentState& s) {
         s.alpha_test.compare = Compare::greater;
         s.alpha_test.reference = 0.125f;
       }},
      {"depth",
       {"depth", "comparison"},
       [](FragmentState& s) {
         if (s.depth.compare > Compare::less_equal) s.depth.compare = Compare::greater;
       }},
      {"polygon_offset",
       {"polygon_offset", "small"},
       [](FragmentState& s) { s.polygon_offset.factor += 2.0f; }},
      {"blend", {"blending", "factors"}, [](FragmentState& s) { s.blend.constant[2] += 0.25f; }},
      {"sorted", {"sorted", "colors", "hides"}, nullptr},
      {"color_mask",
       {"color_mask", "hides"},
       [](FragmentState& s) { std::reverse(s.color_mask.begin(), s.color_mask.end()); }},
      {"scissor",
       {"scissor"},
       [](FragmentState& s) {
         s.scissor = {!s.scissor.enabled, 3, 5, 7, 11};
       }},
  };
  return fields;
}

TEST(KernelKey, EveryFieldOfTheStateIsAccountedFor) {
  EXPECT_EQ(state_fields().size(), field_count<FragmentState>()) << "tell what the new field is to the key";
  for (const StateField& field : state_fields()) {
    for (const std::string_view fact : field.facts) EXPECT_NE(find_fact(fact), nullptr) << fact;
  }
  for_random_states(2000, [](FragmentState& state, ColorFormat format) {
    const KernelKey key = make_kernel_key(state, format);
    for (const StateField& field : state_fields()) {
      if (field.change == nullptr) continue;
      FragmentState changed = state;
      field.change(changed);
      EXPECT_EQ(make_kernel_key(changed, format), key) << field.name << " in " << describe(state);
    }
  });
}

RasterStatistics draw_alone(const RandomScene& scene, const PrimitiveChunk& chunk, bool visibility_first) {
  Framebuffer frame(scene.frame);
  Rasterizer rasterizer(frame, {visibility_first});
  rasterizer.clear(scene.clear);
  rasterizer.submit(rasterizer.bin(PrimitiveChunk(chunk)));
  rasterizer.flush();
  return rasterizer.statistics();
}

TEST(KernelKey, LoopsThatDrawAreThoseItNames) {
  std::array<std::uint64_t, kLoopCount> all{};
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const RandomScene scene = make_random_scene(seed, texture_pool(), {.simple = seed % 2 == 0});
    for (std::size_t k = 0; k < scene.chunks.size(); ++k) {
      const PrimitiveChunk& chunk = scene.chunks[k];
      const KernelKey key = make_kernel_key(*chunk.state, scene.frame.format);
      const bool is_small = chunk.topology == Topology::triangles && key.small != SmallTriangles::spans;
      for (const bool visibility_first : {false, true}) {
        const auto& shaded = draw_alone(scene, chunk, visibility_first).shaded_in;
        const auto by = [&](Loop loop) { return shaded[static_cast<std::size_t>(loop)]; };
        const std::string where = std::to_string(seed) + ": " + scene.descriptions[k];
        if (key.colors == ColorWay::batch) {
          EXPECT_EQ(by(Loop::spans) + by(Loop::blocks) + by(Loop::lists), 0u) << where;
        } else {
          EXPECT_EQ(by(Loop::batch), 0u) << where;
        }
        if (!is_small) {
          EXPECT_EQ(by(Loop::blocks) + by(Loop::lists), 0u) << where;
        }
        if (key.small != SmallTriangles::lists) {
          EXPECT_EQ(by(Loop::lists), 0u) << where;
        }
        for (std::size_t loop = 0; loop < kLoopCount; ++loop) all[loop] += shaded[loop];
      }
    }
  }
  for (const std::uint64_t fragments : all) EXPECT_GT(fragments, 1000u);
}

}  // namespace
}  // namespace barrido::raster::testing
