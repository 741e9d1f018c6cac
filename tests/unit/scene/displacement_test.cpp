// Displacement: moved surfaces stay whole, whatever their seams and creases; a sphere stays a sphere; normals
// and counts.
#include "pipeline/scene/displacement.h"

#include <array>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "pipeline/files/error.h"
#include "pipeline/scene/displacer.h"
#include "scene_fixture.h"

namespace barrido::scene {
namespace {

using testing::SceneBuilder;
using testing::triangles;

glm::vec3 at(const std::vector<float>& values, std::uint32_t vertex) {
  return glm::make_vec3(values.data() + std::size_t{3} * vertex);
}

/// A sphere of radius 1 with a seam (two vertices a place where u is 0 and 1) and poles (one a slice).
Primitive sphere(int slices, int stacks) {
  std::vector<float> positions, texcoords;
  std::vector<std::uint32_t> indices;
  for (int j = 0; j <= stacks; ++j) {
    for (int i = 0; i <= slices; ++i) {
      const double theta = 2 * M_PI * (i % slices) / slices, phi = M_PI * j / stacks;
      const double r = j == 0 || j == stacks ? 0.0 : std::sin(phi);
      for (const double p : {r * std::cos(theta), j == stacks ? -1.0 : std::cos(phi), r * std::sin(theta)})
        positions.push_back(static_cast<float>(p));
      texcoords.push_back(static_cast<float>(i) / static_cast<float>(slices));
      texcoords.push_back(static_cast<float>(j) / static_cast<float>(stacks));
    }
  }
  for (int j = 0; j < stacks; ++j) {
    for (int i = 0; i < slices; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (slices + 1) + i),
                 b = a + static_cast<std::uint32_t>(slices) + 1;
      if (j > 0) indices.insert(indices.end(), {a, a + 1, b});
      if (j + 1 < stacks) indices.insert(indices.end(), {a + 1, b + 1, b});
    }
  }
  Primitive primitive = triangles(positions, indices);
  primitive.normals = FloatArray(positions);
  primitive.texcoords[0] = FloatArray(texcoords);
  return primitive;
}

/// A box of half side 1 whose faces share no vertex: a normal a face, and a chart of the picture a face.
Primitive box() {
  std::vector<float> positions, normals, texcoords;
  std::vector<std::uint32_t> indices;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto first = static_cast<std::uint32_t>(positions.size() / 3);
      for (int corner = 0; corner < 4; ++corner) {
        glm::vec3 p(0), n(0);
        p[axis] = n[axis] = side;
        p[(axis + 1) % 3] = (corner & 1) != 0 ? 1.0f : -1.0f;
        p[(axis + 2) % 3] = (corner & 2) != 0 ? 1.0f : -1.0f;
        for (int c = 0; c < 3; ++c) positions.push_back(p[c]);
        for (int c = 0; c < 3; ++c) normals.push_back(n[c]);
        texcoords.push_back((static_cast<float>(axis) + (corner & 1 ? 0.9f : 0.1f)) / 3.0f);
        texcoords.push_back((side > 0 ? 0.5f : 0.0f) + (corner & 2 ? 0.45f : 0.05f));
      }
      if (side > 0) {
        indices.insert(indices.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
      } else {
        indices.insert(indices.end(), {first, first + 2, first + 1, first + 2, first + 3, first + 1});
      }
    }
  }
  Primitive primitive = triangles(positions, indices);
  primitive.normals = FloatArray(normals);
  primitive.texcoords[0] = FloatArray(texcoords);
  return primitive;
}

raster::Texture bumps() {
  std::vector<std::uint8_t> rgba;
  for (int j = 0; j < 32; ++j) {
    for (int i = 0; i < 32; ++i) {
      const auto height = static_cast<std::uint8_t>((i * 53 + j * 97 + i * j * 7) % 256);
      rgba.insert(rgba.end(), {height, 0, 0, 255});
    }
  }
  return raster::Texture::make_2d({32, 32, rgba}, {});
}

std::unique_ptr<PreparedGeometry> displaced(const Primitive& primitive, const HeightMap& heights,
                                            int pieces) {
  auto geometry = prepare(primitive, std::nullopt);
  displace(*geometry, heights, pieces);
  return geometry;
}

using Place = std::array<float, 3>;
Place place_of(const PreparedGeometry& geometry, std::uint32_t vertex) {
  const float* p = geometry.geometry.position.data + std::size_t{3} * vertex;
  return {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f};
}

/// How often each directed edge occurs, by the bits of its ends. Triangles without area have none.
std::map<std::pair<Place, Place>, int> edges_of(const PreparedGeometry& geometry) {
  std::map<std::pair<Place, Place>, int> edges;
  const auto& indices = geometry.geometry.indices;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Place a = place_of(geometry, indices[i + k]), b = place_of(geometry, indices[i + (k + 1) % 3]);
      if (a != b) ++edges[{a, b}];
    }
  }
  return edges;
}

/// Each edge is shared by two triangles, which run through it in opposite directions.
void expect_watertight(const PreparedGeometry& geometry, const char* what) {
  int open = 0;
  const auto edges = edges_of(geometry);
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) ++open;
  }
  EXPECT_GT(edges.size(), 0u);
  EXPECT_EQ(open, 0) << what;
}

TEST(Displacement, ASphereMovedByAConstantIsASphere) {  // T15
  const Primitive source = sphere(24, 12);
  HeightMap heights;
  heights.by = {0.5f, 0.25f, 0};
  const auto moved = displaced(source, heights, 1);
  for (std::uint32_t v = 0; v < moved->geometry.vertex_count; ++v) {
    EXPECT_NEAR(glm::length(at(moved->positions, v)), 1.75f, 1e-6f);
    // Normals are those of the new triangles: within the angle that these span.
    EXPECT_GT(glm::dot(at(moved->normals, v), at(moved->positions, v)) / 1.75f, 0.98f);
    EXPECT_NEAR(glm::length(at(moved->normals, v)), 1.0f, 1e-6f);
  }
  // Points within the old triangles lie as far above these.
  HeightMap unmoved;
  unmoved.by = {0, 0, 0};
  const auto flat = displaced(source, unmoved, 5);
  const auto fine = displaced(source, heights, 5);
  ASSERT_EQ(flat->geometry.vertex_count, fine->geometry.vertex_count);
  for (std::uint32_t v = 0; v < fine->geometry.vertex_count; ++v) {
    EXPECT_NEAR(glm::length(at(fine->positions, v)), glm::length(at(flat->positions, v)) + 0.75f, 2e-3f);
    EXPECT_NEAR(glm::distance(at(fine->positions, v), at(flat->positions, v)), 0.75f, 1e-6f);
    EXPECT_EQ(fine->displaced.amount[v], 0.75f);
  }
}

TEST(Displacement, ClosedSurfacesStayClosed) {
  const raster::Texture picture = bumps();
  HeightMap heights;
  heights.picture = &picture;
  heights.by = {0.7f, -0.2f, 0};
  for (const int pieces : {1, 2, 3, 5, 8, 13}) {
    expect_watertight(*displaced(sphere(9, 6), heights, pieces), "sphere");
    expect_watertight(*displaced(box(), heights, pieces), "box");
  }
}

TEST(Displacement, CutsEachTriangleIntoTheSquareOfThePieces) {
  HeightMap heights;
  heights.by = {0, 0, 0};
  for (const int pieces : {1, 2, 7}) {
    const auto geometry = displaced(box(), heights, pieces);
    const auto n = static_cast<std::size_t>(pieces);
    EXPECT_EQ(geometry->displaced.triangles, 12 * n * n);
    EXPECT_EQ(geometry->geometry.indices.size(), 36 * n * n);
    EXPECT_EQ(geometry->geometry.vertex_count, 12 * (n + 1) * (n + 2) / 2);
    double area = 0;
    for (std::size_t i = 0; i < geometry->indices.size(); i += 3) {
      const glm::vec3 a = at(geometry->positions, geometry->indices[i]);
      const glm::vec3 normal = glm::cross(at(geometry->positions, geometry->indices[i + 1]) - a,
                                          at(geometry->positions, geometry->indices[i + 2]) - a);
      area += glm::length(normal) / 2;
      EXPECT_GT(glm::dot(normal, a), 0.0f) << "wound as before";
    }
    EXPECT_NEAR(area, 24.0, 1e-4);
  }
}

TEST(Displacement, KeepsCreasesAndCoordinatesAtTheirCorners) {
  HeightMap heights;
  heights.by = {0.5f, 0, 0};
  const auto geometry = displaced(box(), heights, 4);
  // Corners of a box move along the diagonals, its faces' normals stay apart.
  std::map<Place, std::set<Place>> normals;
  for (std::uint32_t v = 0; v < geometry->geometry.vertex_count; ++v) {
    const glm::vec3 n = at(geometry->normals, v);
    normals[place_of(*geometry, v)].insert({n.x, n.y, n.z});
  }
  const float corner = 1.0f + 0.5f / std::sqrt(3.0f);
  int corners = 0;
  for (const auto& [place, here] : normals) {
    if (std::abs(std::abs(place[0]) - corner) < 1e-6f && std::abs(std::abs(place[1]) - corner) < 1e-6f &&
        std::abs(std::abs(place[2]) - corner) < 1e-6f) {
      ++corners;
      EXPECT_EQ(here.size(), 3u);
    }
  }
  EXPECT_EQ(corners, 8);
  // The middle of an edge of the picture's chart lies between its ends.
  const float* uv = geometry->texcoord_sets[0].data;
  for (std::uint32_t v = 0; v < geometry->geometry.vertex_count; ++v) {
    EXPECT_GE(uv[2 * v], 0.1f / 3 - 1e-6f);
    EXPECT_LE(uv[2 * v], 2.9f / 3 + 1e-6f);
  }
}

TEST(Displacement, SolidTexturesKeepThePlacesBeforeIt) {
  HeightMap heights;
  heights.by = {0.5f, 0, 0};
  const auto moved = displaced(box(), heights, 3);
  heights.by = {0, 0, 0};
  const auto flat = displaced(box(), heights, 3);
  const std::span<const float> rest(moved->rest.data, flat->positions.size());
  EXPECT_EQ(std::vector<float>(rest.begin(), rest.end()), flat->positions);
}

TEST(Displacement, HeightsComeFromThePicture) {
  const raster::Texture picture = bumps();
  Primitive square = testing::square();
  square.texcoords[0] = FloatArray(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1});
  HeightMap heights;
  heights.picture = &picture;
  heights.by = {2.0f, -0.5f, 0};
  const auto geometry = displaced(square, heights, 32);
  for (std::uint32_t v = 0; v < geometry->geometry.vertex_count; ++v) {
    const glm::vec3 p = at(geometry->positions, v);
    // At whole texels between four of them: their mean.
    const auto column = static_cast<int>(std::lround((p.x + 1) * 16)),
               row = static_cast<int>(std::lround((p.y + 1) * 16));
    double mean = 0;
    for (const int i : {column - 1, column}) {
      for (const int j : {row - 1, row}) mean += picture.texel(0, 0, (i + 32) % 32, (j + 32) % 32)[0] / 4.0;
    }
    EXPECT_NEAR(p.z, 2 * mean - 0.5, 2e-2) << column << " " << row;
  }
}

TEST(Displacement, HeightsComeFromAProcedure) {
  HeightMap heights;
  heights.solid.emplace();
  heights.solid->pattern.kind = raster::PatternKind::noise;
  heights.solid->pattern.octaves = 3;
  heights.solid->scale = 0.5f;
  heights.by = {0.8f, -0.4f, 0};
  const Primitive source = box();
  const auto geometry = prepare(source, std::nullopt);
  // Edges are 2 or 2√2 long: (2 + 2 + 2√2)/3 in the mean, in cells of ½ with 8 points each.
  EXPECT_EQ(displacement_pieces(*geometry, heights, std::uint64_t{1} << 40), 37);
  const auto moved = displaced(box(), heights, 24);
  expect_watertight(*moved, "noise");
  float least = 1, most = -1;
  for (const float amount : moved->displaced.amount) {
    least = std::min(least, amount);
    most = std::max(most, amount);
  }
  EXPECT_GT(most - least, 0.2f);
  EXPECT_GE(least, -0.4f);
  EXPECT_LE(most, 0.4f);
}

TEST(Displacement, PiecesAreATexelLongWhereMemoryAllows) {
  const raster::Texture picture = bumps();
  const Primitive source = box();
  const auto geometry = prepare(source, std::nullopt);
  HeightMap heights;
  heights.picture = &picture;
  const int wanted = displacement_pieces(*geometry, heights, std::uint64_t{1} << 40);
  EXPECT_GE(wanted, 8);
  EXPECT_LE(wanted, 16);
  const std::uint64_t half = displacement_bytes(*geometry, wanted) / 2;
  const int fewer = displacement_pieces(*geometry, heights, half);
  EXPECT_LT(fewer, wanted);
  EXPECT_LE(displacement_bytes(*geometry, fewer), half);
  heights.by.pieces = 77;
  EXPECT_EQ(displacement_pieces(*geometry, heights, half), 77);
  heights = {};
  EXPECT_EQ(displacement_pieces(*geometry, heights, half), 1);
}

/// A scene of one box, and settings that displace it.
struct Displaced1 {
  SceneBuilder builder;
  RenderSettings settings;
  std::vector<std::string> warnings;

  Displaced1() {
    builder.add_mesh_node(box());
    settings.displacement.source = "constant";
  }
};

TEST(Displacer, RefusesWhatGoesBeyondTheAccount) {
  Displaced1 test;
  test.settings.max_memory = std::uint64_t{16} << 20;
  test.settings.displacement.pieces = 256;
  TextureCache textures(test.builder.scene);
  Displacer displacer(test.builder.scene, textures);
  displacer.begin_frame(test.settings, test.warnings);
  const HeightMap heights = displacer.heights_of(kNone).value();
  for (int again = 0; again < 2; ++again) {
    try {
      displacer.displaced(0, 0, std::nullopt, heights);
      FAIL();
    } catch (const LimitError& error) {
      EXPECT_NE(std::string(error.what()).find("meshes[0].primitives[0]"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("--max-memory"), std::string::npos) << error.what();
    }
  }
}

TEST(Displacer, KeepsWhatDoesNotChange) {
  Displaced1 test;
  TextureCache textures(test.builder.scene);
  Displacer displacer(test.builder.scene, textures);
  displacer.begin_frame(test.settings, test.warnings);
  const PreparedGeometry* first =
      &displacer.displaced(0, 0, std::nullopt, displacer.heights_of(kNone).value());
  EXPECT_EQ(&displacer.displaced(0, 0, std::nullopt, displacer.heights_of(kNone).value()), first);
  EXPECT_NEAR(first->positions[0], -1 - 0.1 / std::sqrt(3.0), 1e-6);
  test.settings.displacement.scale = 0.4f;
  displacer.begin_frame(test.settings, test.warnings);
  const PreparedGeometry& second =
      displacer.displaced(0, 0, std::nullopt, displacer.heights_of(kNone).value());
  EXPECT_NEAR(second.positions[0], -1 - 0.4 / std::sqrt(3.0), 1e-6);
}

TEST(Displacer, TellsOfSurfacesThatCannotBeDisplaced) {
  Displaced1 test;
  const auto picture = std::make_shared<const raster::Texture>(bumps());
  test.settings.displacement.picture = picture;
  test.builder.add_mesh_node(testing::square());
  TextureCache textures(test.builder.scene);
  Displacer displacer(test.builder.scene, textures);
  displacer.begin_frame(test.settings, test.warnings);
  const PreparedGeometry& flat = displacer.displaced(1, 0, std::nullopt, displacer.heights_of(kNone).value());
  EXPECT_EQ(flat.displaced.pieces, 0);
  EXPECT_EQ(test.warnings, std::vector<std::string>{
                               "meshes[1].primitives[0] has no texture coordinates: it is not displaced"});
}

}  // namespace
}  // namespace barrido::scene
