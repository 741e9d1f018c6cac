#include "random_geometry.h"

#include <algorithm>
#include <limits>

namespace barrido::raster::testing {
namespace {

constexpr int kLimit = kGuardBandPixels * kSubpixelUnits - 1;

struct Position {
  std::int32_t x, y;
};

class GeometryBuilder {
 public:
  GeometryBuilder(RandomBits& random, const GeometryOptions& options, PrimitiveChunk& chunk)
      : random_(random), options_(options), chunk_(chunk) {
    choose_vertex_ranges();
  }

  std::string build() {
    chunk_.topology = random_.pick({Topology::triangles, Topology::triangles, Topology::triangles,
                                    Topology::triangles, Topology::lines, Topology::points});
    chunk_.point_size = random_.pick({1.0f, 0.3f, 1.6f, 2.0f, 3.0f, 4.5f, 9.0f, 40.0f});
    chunk_.line_width = random_.pick({1.0f, 1.0f, 2.0f, 3.4f, 8.0f});
    const int flat_count = random_.between(1, 6);
    for (int k = 0; k < flat_count; ++k) {
      const auto color = random_.color(-0.2f, 1.4f);
      const auto specular = random_.color(0.0f, 0.8f);
      chunk_.flat.push_back(
          {{color[0], color[1], color[2], color[3]}, {specular[0], specular[1], specular[2]}});
    }
    if (chunk_.topology == Topology::points) return points();
    if (chunk_.topology == Topology::lines) return lines();
    switch (random_.between(0, 7)) {
      case 0:
        return scattered(random_.between(1, 40), "scattered");
      case 1:
        return slivers();
      case 2:
        return mesh(random_.pick({40, 100, 200}), "sub-pixel mesh");
      case 3:
        return mesh(random_.pick({400, 700, 1000, 1600, 3000, 9000}), "mesh");
      case 4:
        return full_screen_quads();
      case 5:
        return giants();
      case 6:
        return confetti();
      default:
        return repeated();
    }
  }

 private:
  /// How q, depth and the varyings of this chunk's vertices are distributed.
  void choose_vertex_ranges() {
    perspective_ = random_.chance(60);
    q_low_ = random_.pick({1.2f, 0.25f, 0.01f, 1e-4f});
    is_lit_ = random_.chance(40);
    flat_depth_ = random_.chance(40);
    varying_scale_ = random_.pick({1.0f, 1.0f, 4.0f, 60.0f});
    depth_low_ = random_.chance(15) ? -0.3f : 0.0f;
    depth_high_ = random_.chance(15) ? 1.3f : 1.0f;
  }

  /// Depths of an eighth are frequent, so that different primitives meet at equal depths.
  float random_depth() {
    if (random_.chance(50)) return static_cast<float>(random_.between(0, 8)) / 8.0f;
    return random_.number(depth_low_, depth_high_);
  }

  float random_varying() {
    // Half-way between two bytes: how colours are rounded must be the same too.
    if (random_.chance(8)) return (static_cast<float>(random_.between(0, 255)) + 0.5f) / 255.0f;
    if (options_.hostile && random_.chance(4)) {
      return random_.pick({kMaxRecordValue, -kMaxRecordValue, 1e15f, -1e12f, 1e-45f, -1e-38f, 0.0f, -0.0f});
    }
    return random_.number(-0.5f * varying_scale_, varying_scale_);
  }

  /// Varying k of a vertex: an opaque colour as lighting leaves it, or anything.
  float random_varying(int k) {
    if (!is_lit_ || random_.chance(2)) return random_varying();
    return k == 3 || random_.chance(10) ? 1.0f : random_.number(0.0f, 1.0f);
  }

  std::uint32_t add_vertex(float depth) {
    const VaryingList& layout = chunk_.state->varyings;
    const auto stride = static_cast<std::size_t>(record_stride(layout.count));
    const std::size_t first = chunk_.own_records.size();
    chunk_.own_records.resize(first + stride);
    float* record = chunk_.own_records.data() + first;
    const float q = perspective_ ? random_.number(q_low_, 2.0f) : 1.0f;
    record[kRecordDepth] = depth;
    record[kRecordQ] = q;
    for (int k = 0; k < layout.count; ++k) {
      const float value = random_varying(k);
      record[kRecordVaryings + k] = k < layout.affine_count ? value : value * q;
    }
    if (options_.hostile && random_.chance(2)) record[random_.between(0, 1)] = random_varying();
    return static_cast<std::uint32_t>(first / stride);
  }
  std::uint32_t add_vertex() { return add_vertex(flat_depth_ ? primitive_depth_ : random_depth()); }

  Position anywhere(int margin_pixels) {
    return {random_.between(-margin_pixels * kSubpixelUnits,
                            (options_.frame_width + margin_pixels) * kSubpixelUnits),
            random_.between(-margin_pixels * kSubpixelUnits,
                            (options_.frame_height + margin_pixels) * kSubpixelUnits)};
  }

  Position near(Position p, int reach_units) {
    return {std::clamp(p.x + random_.between(-reach_units, reach_units), -kLimit, kLimit),
            std::clamp(p.y + random_.between(-reach_units, reach_units), -kLimit, kLimit)};
  }

  /// The nearest position that `grid` divides: edges and corners that meet pixel centres, for half pixels.
  static Position snapped(Position p, int grid) { return {p.x / grid * grid, p.y / grid * grid}; }

  void add_primitive(std::initializer_list<Position> positions,
                     std::initializer_list<std::uint32_t> vertices) {
    PrimitiveRecord record{};
    std::size_t k = 0;
    for (const Position& p : positions) {
      record.x[k] = p.x;
      record.y[k++] = p.y;
    }
    std::copy(vertices.begin(), vertices.end(), record.vertex);
    record.flat_and_facing =
        static_cast<std::uint32_t>(random_.between(0, static_cast<int>(chunk_.flat.size()) - 1));
    if (random_.chance(20)) record.flat_and_facing |= kBackFacing;
    chunk_.primitives.push_back(record);
  }

  void add_triangle(Position a, Position b, Position c) {
    primitive_depth_ = random_depth();
    const std::uint32_t v[3] = {add_vertex(), add_vertex(), add_vertex()};
    add_primitive({a, b, c}, {v[0], v[1], v[2]});
  }

  std::string scattered(int count, const char* name) {
    for (int k = 0; k < count; ++k) {
      const Position a = anywhere(40);
      const Position b = anywhere(40);
      add_triangle(a, b, anywhere(40));
    }
    return name;
  }

  /// Triangles of all sizes on top of each other, many at equal depths.
  std::string confetti() {
    const Position middle = anywhere(0);
    for (int k = random_.between(5, 150); k > 0; --k) {
      const Position at = near(middle, 3000);
      const int size = random_.pick({200, 500, 500, 1000, 4000, 12000});
      const Position b = near(at, size);
      add_triangle(at, b, near(at, size));
    }
    return "confetti";
  }

  std::string slivers() {
    for (int k = random_.between(5, 60); k > 0; --k) {
      const Position a = anywhere(20);
      const Position b = anywhere(20);
      const Position end = random_.chance(50) ? a : b;
      add_triangle(a, b, near(end, random_.pick({1, 3, 40, 300})));
    }
    return "slivers";
  }

  /// A jittered grid of cells of `cell` units whose vertices are shared.
  std::string mesh(int cell, const char* name) {
    const int columns = std::min(24, options_.frame_width * kSubpixelUnits / cell + 2);
    const int rows = std::min(24, options_.frame_height * kSubpixelUnits / cell + 2);
    const Position origin = anywhere(2);
    const int grid = random_.pick({1, 1, kSubpixelUnits / 2});
    std::vector<Position> positions;
    std::vector<std::uint32_t> vertices;
    primitive_depth_ = random_depth();
    for (int j = 0; j <= rows; ++j) {
      for (int i = 0; i <= columns; ++i) {
        positions.push_back(snapped(near({origin.x + i * cell, origin.y + j * cell}, cell / 3), grid));
        vertices.push_back(add_vertex());
      }
    }
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        const auto a = static_cast<std::size_t>(j * (columns + 1) + i);
        const std::size_t b = a + 1;
        const std::size_t c = a + static_cast<std::size_t>(columns) + 1;
        const std::size_t d = c + 1;
        add_primitive({positions[a], positions[b], positions[d]}, {vertices[a], vertices[b], vertices[d]});
        add_primitive({positions[a], positions[d], positions[c]}, {vertices[a], vertices[d], vertices[c]});
      }
    }
    return name;
  }

  std::string full_screen_quads() {
    const Position low{0, 0};
    const Position high{options_.frame_width * kSubpixelUnits, options_.frame_height * kSubpixelUnits};
    for (int k = random_.between(1, 5); k > 0; --k) {
      primitive_depth_ = random_depth();
      const std::uint32_t v[4] = {add_vertex(), add_vertex(), add_vertex(), add_vertex()};
      add_primitive({low, {high.x, low.y}, high}, {v[0], v[1], v[2]});
      add_primitive({low, high, {low.x, high.y}}, {v[0], v[2], v[3]});
    }
    return "full-screen quads";
  }

  std::string giants() {
    const auto far = [this] {
      return Position{random_.between(-kLimit, kLimit), random_.between(-kLimit, kLimit)};
    };
    for (int k = random_.between(1, 8); k > 0; --k) {
      const Position a = far();
      const Position b = far();
      add_triangle(a, b, random_.chance(50) ? far() : anywhere(10));
    }
    return "giants";
  }

  /// The same triangle several times: equal depths, decided by the comparison alone.
  std::string repeated() {
    for (int k = random_.between(1, 6); k > 0; --k) {
      const Position a = anywhere(20);
      const Position b = anywhere(20);
      const Position c = anywhere(20);
      primitive_depth_ = random_depth();
      const std::uint32_t v[3] = {add_vertex(), add_vertex(), add_vertex()};
      for (int copy = random_.between(2, 5); copy > 0; --copy) add_primitive({a, b, c}, {v[0], v[1], v[2]});
    }
    return "repeated";
  }

  std::string lines() {
    Position a = anywhere(30);
    for (int k = random_.between(1, 60); k > 0; --k) {
      const bool strip = random_.chance(50);
      if (!strip) a = anywhere(30);
      Position b = random_.chance(60) ? anywhere(30) : near(a, 1500);
      if (random_.chance(15)) b.x = a.x;
      if (random_.chance(15)) b.y = a.y;
      primitive_depth_ = random_depth();
      const std::uint32_t va = add_vertex();
      const std::uint32_t vb = add_vertex();
      add_primitive({a, b}, {va, vb});
      a = b;
    }
    return "lines";
  }

  std::string points() {
    for (int k = random_.between(1, 120); k > 0; --k) {
      primitive_depth_ = random_depth();
      const Position at = anywhere(30);
      add_primitive({at}, {add_vertex()});
    }
    return "points";
  }

  RandomBits& random_;
  const GeometryOptions options_;
  PrimitiveChunk& chunk_;
  bool perspective_ = false;
  bool flat_depth_ = false;
  float q_low_ = 0.25f;
  float varying_scale_ = 1.0f;
  bool is_lit_ = false;
  float depth_low_ = 0.0f;
  float depth_high_ = 1.0f;
  float primitive_depth_ = 0.5f;
};

}  // namespace

std::string fill_random_geometry(RandomBits& random, const GeometryOptions& options, PrimitiveChunk& chunk) {
  const std::string name = GeometryBuilder(random, options, chunk).build();
  return name + " × " + std::to_string(chunk.primitives.size());
}

}  // namespace barrido::raster::testing
