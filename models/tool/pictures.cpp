#include "models/tool/pictures.h"

#include <algorithm>
#include <cmath>

#include "models/tool/noise.h"
#include "raster/base/portable_math.h"

namespace barrido::models {
namespace {

/// A size × size picture from a function of the pixel centre (s, t) in (0, 1), t down, to RGB in [0, 1].
template <typename Function>
Picture draw(int size, Function&& color_at) {
  Picture picture{size, size, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      append_pixel(picture, color_at((x + 0.5) / size, (y + 0.5) / size));
    }
  }
  return picture;
}

double fraction(double x) { return x - std::floor(x); }

/// 0 below a, 1 above b, smooth between.
double smooth_step(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

bool is_dark_square(double s, double t, int squares) {
  return (static_cast<int>(s * squares) + static_cast<int>(t * squares)) % 2 != 0;
}

double distance_to_line(double s, int squares) {
  const double f = fraction(s * squares);
  return std::min(f, 1.0 - f);
}

/// A place among bricks in running bond.
struct Brick {
  double edge;  ///< Distance from the brick's edge, where 1 is the picture.
  double tone;  ///< A random number of the brick, 0 to 1.
};

Brick brick_at(double s, double t) {
  constexpr int kColumns = 4;
  constexpr int kRows = 8;
  const double row = std::floor(t * kRows);
  const double x = s * kColumns + (fraction(row * 0.5) > 0.25 ? 0.5 : 0.0);
  const double edge_x = std::min(fraction(x), 1.0 - fraction(x)) / kColumns;
  const double edge_y = std::min(fraction(t * kRows), 1.0 - fraction(t * kRows)) / kRows;
  const double column = std::floor(x) - (x >= kColumns ? kColumns : 0);
  return {std::min(edge_x, edge_y), value_noise(column * 7.31 + 0.37, row * 3.77 + 0.61)};
}

}  // namespace

void append_pixel(Picture& picture, const Vec3& color) {
  for (const double c : {color.x, color.y, color.z}) {
    picture.rgb.push_back(static_cast<std::uint8_t>(std::floor(std::clamp(c, 0.0, 1.0) * 255.0 + 0.5)));
  }
}

Picture draw_checker(int size) {
  constexpr int kSquares = 8;
  return draw(size, [](double s, double t) {
    if (std::min(distance_to_line(s, kSquares), distance_to_line(t, kSquares)) < 0.04) {
      return Vec3(0.55, 0.53, 0.50);
    }
    return is_dark_square(s, t, kSquares) ? Vec3(0.24, 0.27, 0.33) : Vec3(0.93, 0.91, 0.86);
  });
}

Picture draw_patch(int size) {
  constexpr int kSquares = 8;
  return draw(size, [](double s, double t) {
    if (std::min({s, t, 1.0 - s, 1.0 - t}) < 0.03) return Vec3(0.12, 0.12, 0.14);
    // The arrow from the middle to the top left corner: a shaft along the diagonal and a head.
    const double along = s + t;
    const double across = std::fabs(s - t);
    const bool in_head = along > 0.18 && along < 0.5 && across < (along - 0.18) * 0.7;
    const bool in_shaft = along >= 0.5 && along < 1.0 && across < 0.08;
    if (in_head || in_shaft) return Vec3(1, 1, 1);
    // Whole squares of one colour keep the file small.
    const double column = std::floor(s * kSquares) / (kSquares - 1);
    const double row = std::floor(t * kSquares) / (kSquares - 1);
    const double shade = is_dark_square(s, t, kSquares) ? 0.75 : 1.0;
    return Vec3(0.25 + 0.7 * column, 0.25 + 0.7 * row, 0.65 - 0.4 * column) * shade;
  });
}

Picture draw_bricks(int size) {
  return draw(size, [](double s, double t) {
    const auto [edge, tone] = brick_at(s, t);
    const double brick = smooth_step(0.006, 0.012, edge);
    // Grain in a few steps: fine noise in full depth would not compress.
    const double grain = std::floor(turbulence(s * 32, t * 32, 2, 32) * 6) / 6 - 0.5;
    const Vec3 brick_color = lerp(Vec3(0.52, 0.22, 0.16), Vec3(0.74, 0.40, 0.27), tone) + Vec3(0.10 * grain);
    const Vec3 mortar = Vec3(0.72, 0.69, 0.64) + Vec3(0.08 * grain);
    return lerp(mortar, brick_color, brick);
  });
}

Picture draw_brick_heights(int size) {
  return draw(size, [](double s, double t) {
    const auto [edge, tone] = brick_at(s, t);
    const double grain = turbulence(s * 16, t * 16, 2, 16);
    return Vec3(smooth_step(0.003, 0.02, edge) * (0.75 + 0.15 * tone) + 0.1 * grain);
  });
}

Picture draw_normals(const Picture& heights, double height) {
  const int size = heights.width;
  const auto at = [&](int x, int y) {
    const int column = (x + size) % size, row = (y + size) % size;
    return heights.rgb[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                            static_cast<std::size_t>(column))] /
           255.0;
  };
  Picture normals{size, size, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double along_s = (at(x + 1, y) - at(x - 1, y)) * 0.5 * size * height;
      const double along_t = (at(x, y + 1) - at(x, y - 1)) * 0.5 * size * height;
      const double length = std::sqrt(along_s * along_s + along_t * along_t + 1.0);
      append_pixel(normals, Vec3(-along_s, along_t, 1.0) / length * 0.5 + Vec3(0.5));
    }
  }
  return normals;
}

Picture draw_brick_occlusion(int size) {
  return draw(size, [](double s, double t) {
    return Vec3(0.3 + 0.7 * smooth_step(0.0, 0.03, brick_at(s, t).edge), 0, 0);
  });
}

Picture draw_brick_shine(int size) {
  return draw(size, [](double s, double t) {
    const auto [edge, tone] = brick_at(s, t);
    return Vec3(smooth_step(0.006, 0.012, edge) * (0.4 + 0.6 * tone));
  });
}

Picture draw_marble(int size) {
  return draw(size, [](double s, double t) {
    constexpr int kPeriod = 4;
    const double bend = turbulence(s * kPeriod, t * kPeriod, 5, kPeriod);
    const double vein = 0.5 + 0.5 * portable_sin(2.0 * kPi * (2.0 * s + t + 2.2 * bend));
    const double v = vein * vein;
    return lerp(Vec3(0.93, 0.92, 0.89), Vec3(0.30, 0.36, 0.42), v * v);
  });
}

}  // namespace barrido::models
