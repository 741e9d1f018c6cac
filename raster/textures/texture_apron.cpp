// Aprons: the ring of texels around a level that resolves wrap modes and cube seams once, so that filters may
// read two neighbours without asking where they are. Enters a level with its interior filled.
#include <algorithm>
#include <cstdlib>

#include "raster/textures/texture_level.h"

namespace barrido::raster {
namespace {

constexpr int kBorder = -1;

/// The interior texel that stands at `index` (-1 or size at the rim, else itself), or kBorder.
int wrapped_index(int index, int size, Wrap wrap) {
  if (index >= 0 && index < size) return index;
  switch (wrap) {
    case Wrap::repeat:
      return index < 0 ? size - 1 : 0;
    case Wrap::mirrored_repeat:
    case Wrap::clamp_to_edge:
      return index < 0 ? 0 : size - 1;
    case Wrap::clamp_to_border:
    case Wrap::clamp:
      break;
  }
  return kBorder;
}

/// Calls `visit(i, j)` for every texel of the apron.
template <class Visit>
void for_each_apron_texel(int width, int height, Visit visit) {
  for (int i = -1; i <= width; ++i) {
    visit(i, -1);
    visit(i, height);
  }
  for (int j = 0; j < height; ++j) {
    visit(-1, j);
    visit(width, j);
  }
}

/// A position on the surface of the cube [-n, n]³, in half texels: texel centres are at odd or even integers
/// alike for all faces, as n is the number of texels along an edge.
struct CubePoint {
  int axis[3];
};

/// Where (sc, tc) of a face lies on the cube: table 3.19 of OpenGL 1.3 read backwards.
CubePoint point_on_face(int face, int sc, int tc, int major) {
  switch (face) {
    case 0:
      return {{major, -tc, -sc}};
    case 1:
      return {{-major, -tc, sc}};
    case 2:
      return {{sc, major, tc}};
    case 3:
      return {{sc, -major, -tc}};
    case 4:
      return {{sc, -tc, major}};
    default:
      return {{-sc, -tc, -major}};
  }
}

struct FaceTexel {
  int face;
  int i;
  int j;
};

/// The texel of the face that `point` lies on; `point` has one coordinate of magnitude n.
FaceTexel texel_at_point(const CubePoint& point, int n) {
  const auto [x, y, z] = point.axis;
  FaceTexel result{};
  int sc = 0;
  int tc = 0;
  if (std::abs(x) == n) {
    result.face = x > 0 ? 0 : 1;
    sc = x > 0 ? -z : z;
    tc = -y;
  } else if (std::abs(y) == n) {
    result.face = y > 0 ? 2 : 3;
    sc = x;
    tc = y > 0 ? z : -z;
  } else {
    result.face = z > 0 ? 4 : 5;
    sc = z > 0 ? x : -x;
    tc = -y;
  }
  result.i = (sc + n - 1) / 2;
  result.j = (tc + n - 1) / 2;
  return result;
}

/// The texel that touches (i, j) of `face` across one of its edges: fold the half texel that sticks out of
/// the face around the edge. Exactly one of i, j is outside [0, n).
FaceTexel texel_across_edge(int face, int i, int j, int n) {
  const int sc = std::clamp(2 * i + 1 - n, -n, n);
  const int tc = std::clamp(2 * j + 1 - n, -n, n);
  return texel_at_point(point_on_face(face, sc, tc, n - 1), n);
}

template <class Channel>
void fill_seamless_face(const LevelView<Channel> (&faces)[kCubeFaces], int face) {
  const LevelView<Channel>& own = faces[face];
  const int n = own.width;
  for (int k = 0; k < n; ++k) {
    const int rim[4][2] = {{k, -1}, {k, n}, {-1, k}, {n, k}};
    for (const auto& [i, j] : rim) {
      const FaceTexel other = texel_across_edge(face, i, j, n);
      std::copy_n(faces[other.face].at(other.i, other.j), 4, own.at(i, j));
    }
  }
  for (const int j : {-1, n}) {
    for (const int i : {-1, n}) {
      const int inner_i = std::clamp(i, 0, n - 1);
      const int inner_j = std::clamp(j, 0, n - 1);
      for (int c = 0; c < 4; ++c) {
        const std::uint32_t sum =
            std::uint32_t{own.at(inner_i, inner_j)[c]} + own.at(i, inner_j)[c] + own.at(inner_i, j)[c];
        own.at(i, j)[c] = static_cast<Channel>((sum + 1) / 3);
      }
    }
  }
}

}  // namespace

template <class Channel>
void fill_apron(const LevelView<Channel>& level, Wrap wrap_s, Wrap wrap_t, const Channel border[4]) {
  for_each_apron_texel(level.width, level.height, [&](int i, int j) {
    const int source_i = wrapped_index(i, level.width, wrap_s);
    const int source_j = wrapped_index(j, level.height, wrap_t);
    const bool outside = source_i == kBorder || source_j == kBorder;
    std::copy_n(outside ? border : level.at(source_i, source_j), 4, level.at(i, j));
  });
}

template <class Channel>
void fill_cube_aprons(const LevelView<Channel> (&faces)[kCubeFaces], bool seamless) {
  for (int face = 0; face < kCubeFaces; ++face) {
    if (seamless) {
      fill_seamless_face(faces, face);
    } else {
      const Channel unused[4] = {0, 0, 0, 0};
      fill_apron(faces[face], Wrap::clamp_to_edge, Wrap::clamp_to_edge, unused);
    }
  }
}

template void fill_apron(const LevelView<std::uint8_t>&, Wrap, Wrap, const std::uint8_t[4]);
template void fill_apron(const LevelView<std::uint16_t>&, Wrap, Wrap, const std::uint16_t[4]);
template void fill_cube_aprons(const LevelView<std::uint8_t> (&)[kCubeFaces], bool);
template void fill_cube_aprons(const LevelView<std::uint16_t> (&)[kCubeFaces], bool);

}  // namespace barrido::raster
