// Meshes compressed by Draco's own encoder, by both of its methods and with all that glTF can ask for, are
// the meshes that went in; streams that lie, are cut off or changed are refused or drawn, and nothing else.
#include <dlfcn.h>

#include <algorithm>
#include <map>
#include <random>

#include "import_support.h"
#include "tests/unit/scene/draco_encoder/encoder.h"

namespace barrido::scene::test {
namespace {

DracoTestEncode encoder() {
  static const auto function = reinterpret_cast<DracoTestEncode>(
      dlsym(dlopen(BARRIDO_DRACO_ENCODER, RTLD_NOW | RTLD_LOCAL), "barrido_draco_test_encode"));
  return function;
}

struct Grid {
  static constexpr int kCells = 9;
  std::vector<float> positions, normals, texcoords, weights;
  std::vector<std::uint8_t> colors;
  std::vector<std::uint16_t> joints;
  std::vector<std::uint32_t> indices;

  std::uint32_t points() const { return static_cast<std::uint32_t>(positions.size() / 3); }

  Grid() {
    std::mt19937 bits(5);
    const auto share = [&] { return static_cast<float>(bits() % 4097) / 4096.0f; };
    for (int y = 0; y <= kCells; ++y) {
      for (int x = 0; x <= kCells; ++x) {
        positions.insert(positions.end(), {static_cast<float>(x), static_cast<float>(y), share()});
        normals.insert(normals.end(), {0.6f, 0.0f, 0.8f});
        texcoords.insert(texcoords.end(), {share(), share()});
        for (int c = 0; c < 4; ++c) colors.push_back(static_cast<std::uint8_t>(bits()));
        joints.insert(joints.end(),
                      {static_cast<std::uint16_t>(x % 2), static_cast<std::uint16_t>(y % 2), 0, 0});
        weights.insert(weights.end(), {0.75f, 0.25f, 0.0f, 0.0f});
      }
    }
    for (int y = 0; y < kCells; ++y) {
      for (int x = 0; x < kCells; ++x) {
        const auto a = static_cast<std::uint32_t>(y * (kCells + 1) + x), b = a + kCells + 1;
        indices.insert(indices.end(), {a, a + 1, b + 1, a, b + 1, b});
      }
    }
  }
};

struct Encoded {
  std::vector<std::uint8_t> stream;
  std::vector<std::uint32_t> ids;
};

struct Way {
  bool edgebreaker;
  int speed;
  int bits;
};

Encoded encode(const Grid& grid, const Way& way) {
  const DracoTestAttribute attributes[] = {
      {0, kF32, 3, 0, grid.positions.data()}, {1, kF32, 3, 0, grid.normals.data()},
      {2, kF32, 2, 0, grid.texcoords.data()}, {3, kU8, 4, 1, grid.colors.data()},
      {4, kU16, 4, 0, grid.joints.data()},    {4, kF32, 4, 0, grid.weights.data()}};
  Encoded encoded{std::vector<std::uint8_t>(1 << 20), std::vector<std::uint32_t>(std::size(attributes))};
  const DracoTestMesh mesh{grid.points(),
                           static_cast<std::uint32_t>(grid.indices.size() / 3),
                           grid.indices.data(),
                           attributes,
                           static_cast<std::int32_t>(std::size(attributes)),
                           way.edgebreaker ? 1 : 0,
                           way.speed,
                           way.bits};
  encoded.stream.resize(encoder()(&mesh, encoded.stream.data(), encoded.stream.size(), encoded.ids.data()));
  return encoded;
}

/// A model whose accessors have nothing but the stream.
Model model_of(const Encoded& encoded, std::size_t points, std::size_t indices) {
  Model model;
  const int view = model.add_view(encoded.stream);
  const struct {
    const char* name;
    int type;
    const char* shape;
    bool normalized;
  } kinds[] = {{"POSITION", kF32, "VEC3", false},   {"NORMAL", kF32, "VEC3", false},
               {"TEXCOORD_0", kF32, "VEC2", false}, {"COLOR_0", kU8, "VEC4", true},
               {"JOINTS_0", kU16, "VEC4", false},   {"WEIGHTS_0", kF32, "VEC4", false}};
  json attributes, ids;
  for (std::size_t i = 0; i < std::size(kinds); ++i) {
    attributes[kinds[i].name] =
        model.add_accessor(-1, kinds[i].type, kinds[i].shape, points, kinds[i].normalized);
    ids[kinds[i].name] = encoded.ids[i];
  }
  const int index_accessor = model.add_accessor(-1, 5125, "SCALAR", indices);
  model.document["meshes"] = {
      {{"primitives",
        {{{"attributes", attributes},
          {"indices", index_accessor},
          {"extensions", {{"KHR_draco_mesh_compression", {{"bufferView", view}, {"attributes", ids}}}}}}}}}};
  model.document["nodes"] = {{{"mesh", 0}}};
  model.document["scenes"] = {{{"nodes", {0}}}};
  model.document["scene"] = 0;
  model.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  model.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return model;
}

/// A point as text that knows no order of points, rounded to what so many bits can tell apart.
using Corner = std::vector<float>;

std::vector<std::vector<Corner>> triangles_of(const std::vector<std::uint32_t>& indices,
                                              const std::function<Corner(std::uint32_t)>& corner) {
  std::vector<std::vector<Corner>> triangles;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    std::vector<Corner> triangle{corner(indices[i]), corner(indices[i + 1]), corner(indices[i + 2])};
    // Turned so that the least corner is first: what stays is the way round.
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.push_back(std::move(triangle));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Corner corner_of(const Grid& grid, std::uint32_t p) {
  Corner corner(grid.positions.begin() + 3 * p, grid.positions.begin() + 3 * p + 3);
  corner.insert(corner.end(), grid.normals.begin() + 3 * p, grid.normals.begin() + 3 * p + 3);
  corner.insert(corner.end(), grid.texcoords.begin() + 2 * p, grid.texcoords.begin() + 2 * p + 2);
  for (std::uint32_t c = 0; c < 4; ++c) corner.push_back(static_cast<float>(grid.colors[4 * p + c]));
  for (std::uint32_t c = 0; c < 4; ++c) corner.push_back(static_cast<float>(grid.joints[4 * p + c]));
  return corner;
}

Corner corner_of(const Primitive& primitive, std::uint32_t p) {
  const auto some = [&](const FloatArray& array, std::uint32_t n, Corner& into, float scale = 1.0f) {
    for (std::uint32_t c = 0; c < n; ++c) into.push_back(array.data()[n * p + c] * scale);
  };
  Corner corner;
  some(primitive.positions, 3, corner);
  some(primitive.normals, 3, corner);
  some(primitive.texcoords[0], 2, corner);
  some(primitive.colors, 4, corner, 255.0f);
  for (const std::uint16_t joint : primitive.joints[p]) corner.push_back(joint);
  return corner;
}

TEST(Draco, BothMethodsGiveBackWhatWentIn) {
  ASSERT_NE(encoder(), nullptr);
  const Grid grid;
  const auto expected = triangles_of(grid.indices, [&](std::uint32_t p) { return corner_of(grid, p); });
  for (const Way& way :
       {Way{false, 5, 0}, Way{false, 10, 0}, Way{true, 0, 0}, Way{true, 5, 0}, Way{true, 10, 0}}) {
    SCOPED_TRACE(std::string(way.edgebreaker ? "edgebreaker " : "sequential ") + std::to_string(way.speed));
    const Encoded encoded = encode(grid, way);
    ASSERT_FALSE(encoded.stream.empty());
    const Scene scene = model_of(encoded, grid.points(), grid.indices.size()).import();
    const Primitive& primitive = scene.meshes[0].primitives[0];
    const auto triangles =
        triangles_of(values(primitive.indices), [&](std::uint32_t p) { return corner_of(primitive, p); });
    ASSERT_EQ(triangles.size(), expected.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < expected[t][k].size(); ++c) {
          ASSERT_NEAR(triangles[t][k][c], expected[t][k][c], 2e-4) << t << " " << k << " " << c;
        }
      }
    }
  }
}

/// n bits a coordinate of the range of the largest: nothing is farther off than half of a step.
TEST(Draco, QuantizedMeshesAreAsNearAsTheirBits) {
  const Grid grid;
  for (const bool edgebreaker : {false, true}) {
    for (const int bits : {8, 11, 14}) {
      const Scene scene =
          model_of(encode(grid, {edgebreaker, 5, bits}), grid.points(), grid.indices.size()).import();
      const Primitive& primitive = scene.meshes[0].primitives[0];
      const double step = static_cast<double>(Grid::kCells) / ((1 << bits) - 1);
      std::map<std::pair<int, int>, float> height;
      for (std::uint32_t p = 0; p < primitive.vertex_count; ++p) {
        const float* at = primitive.positions.data() + 3 * p;
        const int x = static_cast<int>(at[0] + 0.5f), y = static_cast<int>(at[1] + 0.5f);
        EXPECT_NEAR(at[0], x, 0.51 * step);
        EXPECT_NEAR(at[1], y, 0.51 * step);
        height[{x, y}] = at[2];
      }
      ASSERT_EQ(height.size(), grid.points());
      for (const auto& [place, z] : height) {
        const auto p = static_cast<std::size_t>(place.second * (Grid::kCells + 1) + place.first);
        EXPECT_NEAR(z, grid.positions[3 * p + 2], 0.51 * step) << bits;
      }
    }
  }
}

TEST(Draco, CountsThatLieAreRefused) {
  const Grid grid;
  const std::size_t points = grid.points(), indices = grid.indices.size();
  for (const bool edgebreaker : {false, true}) {
    const Encoded encoded = encode(grid, {edgebreaker, 5, 11});
    EXPECT_CONTAINS(import_error(model_of(encoded, points + 1, indices)), "points, but accessors");
    EXPECT_CONTAINS(import_error(model_of(encoded, points - 1, indices)), "points, but accessors");
    EXPECT_CONTAINS(import_error(model_of(encoded, points, indices + 3)), "indices, but accessors");
    EXPECT_CONTAINS(import_error(model_of(encoded, points, indices - 3)), "indices, but accessors");
    Encoded exchanged = encoded;
    std::swap(exchanged.ids[0], exchanged.ids[2]);
    EXPECT_CONTAINS(import_error(model_of(exchanged, points, indices)), "components, its accessor");
    exchanged.ids[0] = 77;
    EXPECT_CONTAINS(import_error(model_of(exchanged, points, indices)), "attribute 77 is not there");
  }
}

TEST(Draco, CutOffAnywhereIsRefused) {
  const Grid grid;
  for (const bool edgebreaker : {false, true}) {
    const Encoded whole = encode(grid, {edgebreaker, 5, 11});
    for (std::size_t size = 0; size < whole.stream.size(); size += 13) {
      Encoded cut = whole;
      cut.stream.resize(std::max<std::size_t>(size, 1));
      EXPECT_CONTAINS(import_error(model_of(cut, grid.points(), grid.indices.size())),
                      "meshes[0].primitives[0]");
    }
  }
}

/// Whatever comes out has been checked: every index is below the count, every number finite.
TEST(Draco, ChangedBytesAreRefusedOrDrawn) {
  const Grid grid;
  std::mt19937 bits(11);
  int refused = 0, drawn = 0;
  for (int round = 0; round < 400; ++round) {
    Encoded changed = encode(grid, {round % 2 == 0, 5, round % 4 < 2 ? 11 : 0});
    for (int n = 0; n < 1 + round % 3; ++n) {
      changed.stream[bits() % changed.stream.size()] = static_cast<std::uint8_t>(bits());
    }
    try {
      const Scene scene = model_of(changed, grid.points(), grid.indices.size()).import();
      const Primitive& primitive = scene.meshes[0].primitives[0];
      for (const std::uint32_t index : primitive.indices) ASSERT_LT(index, primitive.vertex_count);
      for (const float number : primitive.positions.values()) ASSERT_TRUE(std::isfinite(number));
      ++drawn;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 20);
  EXPECT_GT(drawn, 20);
}

}  // namespace
}  // namespace barrido::scene::test
