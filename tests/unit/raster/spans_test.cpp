// Spans against a point-in-triangle test in exact integers, with vertices on coarse grids so that ties are
// frequent; and points and lines against pixels written down by hand.
#include "raster/reference/spans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace barrido::raster::reference {
namespace {

using Pixels = std::set<std::pair<int, int>>;

Pixels pixels_of(const std::vector<Span>& spans) {
  Pixels pixels;
  for (const Span& span : spans) {
    for (int x = span.first; x < span.end; ++x) {
      EXPECT_TRUE(pixels.insert({x, span.y}).second) << "pixel twice: " << x << ", " << span.y;
    }
  }
  return pixels;
}

PrimitiveRecord record(std::array<std::int32_t, 3> x, std::array<std::int32_t, 3> y) {
  PrimitiveRecord p{};
  for (std::size_t k = 0; k < 3; ++k) {
    p.x[k] = x[k];
    p.y[k] = y[k];
  }
  return p;
}

/// Side of the edge a → b on which a point just right of (x, y), and by far less above it, lies: the tie rule
/// as an infinitesimal shift.
int side(const PrimitiveRecord& p, int a, int b, std::int64_t x, std::int64_t y) {
  const std::int64_t dx = p.x[b] - p.x[a];
  const std::int64_t dy = p.y[b] - p.y[a];
  const std::int64_t e = dx * (y - p.y[a]) - dy * (x - p.x[a]);
  if (e != 0) return e > 0 ? 1 : -1;
  if (dy != 0) return dy < 0 ? 1 : -1;
  return dx > 0 ? 1 : dx < 0 ? -1 : 0;
}

bool is_inside(const PrimitiveRecord& p, int pixel_x, int pixel_y) {
  const std::int64_t x = std::int64_t{pixel_x} * 256 + 128;
  const std::int64_t y = std::int64_t{pixel_y} * 256 + 128;
  const int s = side(p, 0, 1, x, y);
  return s != 0 && s == side(p, 1, 2, x, y) && s == side(p, 2, 0, x, y);
}

TEST(TriangleSpans, AgreeWithAnExactPointInTriangleTest) {
  std::mt19937_64 bits(42);
  constexpr int kSide = 24;
  // Vertices on a grid of this many units: 128 puts a quarter of them on pixel centres.
  for (const int grid : {256, 128, 64, 3, 1}) {
    for (int trial = 0; trial < 3000; ++trial) {
      const int range = (kSide + 8) * 256 / grid;
      const auto coordinate = [&] {
        return (static_cast<int>(bits() % static_cast<unsigned>(range)) - 4 * 256 / grid) * grid;
      };
      const auto p =
          record({coordinate(), coordinate(), coordinate()}, {coordinate(), coordinate(), coordinate()});
      const Pixels covered = pixels_of(triangle_spans(p, {kSide, kSide}));
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          ASSERT_EQ(covered.count({x, y}) == 1, is_inside(p, x, y))
              << "pixel " << x << ", " << y << " of (" << p.x[0] << ", " << p.y[0] << ") (" << p.x[1] << ", "
              << p.y[1] << ") (" << p.x[2] << ", " << p.y[2] << ")";
        }
      }
    }
  }
}

TEST(TriangleSpans, TiesGoToTheLowerLeft) {
  // A square from centre to centre: its left column and lower row belong to it, its right and upper do not.
  const int a = 128;
  const int b = 128 + 3 * 256;
  Pixels covered = pixels_of(triangle_spans(record({a, b, b}, {a, a, b}), {8, 8}));
  const Pixels other = pixels_of(triangle_spans(record({a, b, a}, {a, b, b}), {8, 8}));
  for (const auto& pixel : other) EXPECT_TRUE(covered.insert(pixel).second) << "diagonal drawn twice";
  Pixels expected;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) expected.insert({x, y});
  }
  EXPECT_EQ(covered, expected);
}

TEST(TriangleSpans, WithoutAreaThereIsNothing) {
  EXPECT_TRUE(triangle_spans(record({0, 512, 1024}, {0, 512, 1024}), {8, 8}).empty());
  EXPECT_TRUE(triangle_spans(record({0, 512, 1024}, {300, 300, 300}), {8, 8}).empty());
  EXPECT_TRUE(triangle_spans(record({77, 77, 77}, {5, 5, 5}), {8, 8}).empty());
}

TEST(TriangleSpans, GuardBandTrianglesFillTheFrame) {
  constexpr int kFar = kGuardBandPixels * 256 - 1;
  const auto spans = triangle_spans(record({-kFar, kFar, -kFar}, {-kFar, -kFar, kFar}), {300, 200});
  const auto rest = triangle_spans(record({kFar, kFar, -kFar}, {-kFar, kFar, kFar}), {300, 200});
  EXPECT_EQ(pixels_of(spans).size() + pixels_of(rest).size(), 300u * 200u);
}

TEST(TriangleSpans, AreCutAtTiles) {
  const auto spans = triangle_spans(record({0, 300 * 256, 0}, {0, 0, 600 * 256}), {300, 1});
  ASSERT_EQ(spans.size(), 3u);
  EXPECT_EQ(spans[0].end, 128);
  EXPECT_EQ(spans[1].first, 128);
  EXPECT_EQ(spans[1].end, 256);
  EXPECT_EQ(spans[2].first, 256);
}

TEST(PointSpans, LowestCornerAndSize) {
  const auto lowest_and_count = [](int x, int y, float size) {
    const Pixels pixels = pixels_of(point_spans(record({x, 0, 0}, {y, 0, 0}), size, {100, 100}));
    return std::make_pair(*pixels.begin(), pixels.size());
  };
  using Expected = std::pair<std::pair<int, int>, std::size_t>;
  EXPECT_EQ(lowest_and_count(2560, 5120, 1.0f), (Expected{{10, 20}, 1}));
  EXPECT_EQ(lowest_and_count(2560 + 255, 5120 + 255, 1.0f), (Expected{{10, 20}, 1}));
  EXPECT_EQ(lowest_and_count(2560, 5120, 2.0f), (Expected{{9, 19}, 4}));
  EXPECT_EQ(lowest_and_count(2560 + 128, 5120 + 127, 2.0f), (Expected{{10, 19}, 4}));
  EXPECT_EQ(lowest_and_count(2560, 5120, 3.0f), (Expected{{9, 19}, 9}));
  EXPECT_EQ(lowest_and_count(2560, 5120, 2.5f), (Expected{{9, 19}, 9}));
  EXPECT_EQ(lowest_and_count(2560, 5120, 0.0f), (Expected{{10, 20}, 1}));
  EXPECT_EQ(lowest_and_count(0, 0, 1e9f), (Expected{{0, 0}, 10000}));
  EXPECT_TRUE(point_spans(record({-1, 0, 0}, {50, 0, 0}), 1.0f, {100, 100}).empty());
}

Pixels line(std::array<double, 2> a, std::array<double, 2> b, float width = 1.0f) {
  const auto units = [](double v) { return static_cast<std::int32_t>(v * 256); };
  return pixels_of(
      line_spans(record({units(a[0]), units(b[0]), 0}, {units(a[1]), units(b[1]), 0}), width, {100, 100}));
}

TEST(LineSpans, AreHalfOpenAtTheSecondEnd) {
  EXPECT_EQ(line({0.5, 0.5}, {4.5, 0.5}), (Pixels{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
  EXPECT_EQ(line({4.5, 0.5}, {0.5, 0.5}), (Pixels{{1, 0}, {2, 0}, {3, 0}, {4, 0}}));
  EXPECT_EQ(line({2.5, 0.5}, {2.5, 3.5}), (Pixels{{2, 0}, {2, 1}, {2, 2}}));
  EXPECT_EQ(line({2.5, 3.5}, {2.5, 0.5}), (Pixels{{2, 1}, {2, 2}, {2, 3}}));
  EXPECT_TRUE(line({2.5, 2.5}, {2.5, 2.5}).empty());
}

TEST(LineSpans, FollowTheSlope) {
  EXPECT_EQ(line({0, 0}, {4, 2}), (Pixels{{0, 0}, {1, 0}, {2, 1}, {3, 1}}));
  EXPECT_EQ(line({0, 2}, {4, 0}), (Pixels{{0, 1}, {1, 1}, {2, 0}, {3, 0}}));
  EXPECT_EQ(line({0, 0}, {-4, -2}), Pixels{});
  EXPECT_EQ(line({4, 2}, {0, 0}), (Pixels{{0, 0}, {1, 0}, {2, 1}, {3, 1}}));
  EXPECT_EQ(line({0, 0}, {3, 3}), (Pixels{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(LineSpans, WideLinesAreColumns) {
  EXPECT_EQ(line({0.5, 5.5}, {2.5, 5.5}, 3.0f), (Pixels{{0, 4}, {0, 5}, {0, 6}, {1, 4}, {1, 5}, {1, 6}}));
  EXPECT_EQ(line({0.5, 5.5}, {1.5, 5.5}, 2.0f), (Pixels{{0, 5}, {0, 6}}));
  EXPECT_EQ(line({5.5, 0.5}, {5.5, 1.5}, 3.0f), (Pixels{{4, 0}, {5, 0}, {6, 0}}));
}

TEST(LineSpans, StripsTouchEachPixelOnce) {
  std::mt19937_64 bits(9);
  for (int trial = 0; trial < 2000; ++trial) {
    // Monotonous in x with slopes below 1: all pieces are x-major.
    double x = 1.0;
    double y = 50.0;
    std::size_t total = 0;
    Pixels all;
    for (int piece = 0; piece < 6; ++piece) {
      const double dx = static_cast<double>(bits() % 3000) / 256.0;
      const double dy = dx * (static_cast<double>(bits() % 512) / 256.0 - 1.0);
      const Pixels pixels = line({x, y}, {x + dx, y + dy});
      total += pixels.size();
      all.insert(pixels.begin(), pixels.end());
      x = std::floor((x + dx) * 256) / 256;
      y = std::floor((y + dy) * 256) / 256;
    }
    ASSERT_EQ(all.size(), total);
    ASSERT_EQ(static_cast<int>(total), static_cast<int>(std::ceil(x - 0.5)) - 1);
  }
}

}  // namespace
}  // namespace barrido::raster::reference
