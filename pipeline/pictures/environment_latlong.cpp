// Latitude-longitude pictures to cube maps. For a direction (x, y, z) the longitude is atan2(x, −z), 0 in the
// picture's middle and growing to the right, and the latitude asin(y/|d|). With s and t in [−1, 1] across
// a face (sc and tc of OpenGL 1.3, table 3.19) this becomes, on the four sides, longitude = centre − atan s
// and latitude = −atan(t/√(1 + s²)); above, longitude = atan2(s, −t) and latitude = atan(1/√(s² + t²));
// below, π − longitude and −latitude of the texel above. So three arc tangents serve six texels.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "pipeline/pictures/environment_layout.h"
#include "pipeline/pictures/environment_texels.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

constexpr int kMaxFaceSize = 2048;

/// Where a face is filled from: longitudes of the centres of the four sides, by the number of the face.
struct Side {
  std::size_t face;
  double center_longitude;
};
constexpr std::array<Side, 4> kSides{{{0, kPi / 2}, {1, -kPi / 2}, {4, kPi}, {5, 0.0}}};
constexpr std::size_t kTop = 2, kBottom = 3;

/// The picture as a function on the sphere, bilinear between the centres of its pixels.
class Panorama {
 public:
  explicit Panorama(const TexelReader& reader) : reader_(reader) {}

  /// Radians; longitude in [−2π, 2π], latitude in [−π/2, π/2].
  std::array<float, 4> sample(double longitude, double latitude) const {
    // One turn, and one row, more than needed: truncation is floor where nothing is negative.
    const double x = (1.5 + longitude / (2 * kPi)) * reader_.width() - 0.5;
    const double y = (0.5 - latitude / kPi) * reader_.height() + 0.5;
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(y);
    const auto fx = static_cast<float>(x - i);
    const auto fy = static_cast<float>(y - j);
    const auto upper = row_sample(i, j - 1, fx);
    const auto lower = row_sample(i, j, fx);
    std::array<float, 4> result{};
    for (std::size_t k = 0; k < 4; ++k) result[k] = upper[k] + fy * (lower[k] - upper[k]);
    return result;
  }

 private:
  /// Left and right edges meet; beyond a pole the picture goes on at the opposite longitude.
  std::array<float, 4> row_sample(int i, int j, float fx) const {
    const bool beyond_pole = j < 0 || j >= reader_.height();
    const int left = wrap(beyond_pole ? i + reader_.width() / 2 : i);
    const int right = wrap(left + 1);
    const int row = std::clamp(j, 0, reader_.height() - 1);
    const auto a = reader_.texel(left, row), b = reader_.texel(right, row);
    std::array<float, 4> result{};
    for (std::size_t k = 0; k < 4; ++k) result[k] = a[k] + fx * (b[k] - a[k]);
    return result;
  }

  /// For i in [0, 4·width).
  int wrap(int i) const {
    if (i >= 2 * reader_.width()) i -= 2 * reader_.width();
    return i >= reader_.width() ? i - reader_.width() : i;
  }

  const TexelReader& reader_;
};

/// The angles of one row of texels, the same for all faces.
struct RowAngles {
  std::vector<double> side_latitude, top_longitude, top_latitude;
};

double face_coordinate(int index, int size) { return (2.0 * index + 1.0) / size - 1.0; }

RowAngles angles_of_row(int row, int size) {
  const auto count = static_cast<std::size_t>(size);
  RowAngles angles{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  const double t = face_coordinate(row, size);
  for (int i = 0; i < (size + 1) / 2; ++i) {
    const double s = face_coordinate(i, size);
    const auto left = static_cast<std::size_t>(i), right = count - 1 - left;
    const double latitude = portable_atan2(-t, std::sqrt(1.0 + s * s));
    const double longitude_above = portable_atan2(s, -t);
    const double latitude_above = portable_atan2(1.0, std::sqrt(s * s + t * t));
    angles.side_latitude[left] = angles.side_latitude[right] = latitude;
    angles.top_latitude[left] = angles.top_latitude[right] = latitude_above;
    angles.top_longitude[right] = -longitude_above;
    angles.top_longitude[left] = longitude_above;
  }
  return angles;
}

}  // namespace

CubeMapImage cube_map_from_latitude_longitude(const Picture& picture, const EnvironmentEncoding& encoding) {
  const bool floats = std::holds_alternative<FloatImage>(picture);
  const TexelReader reader(picture, encoding.srgb);
  const TexelEncoder encoder(floats ? portable_exp2(encoding.exposure_ev) : 1.0f, encoding.srgb);
  const Panorama panorama(reader);

  CubeMapImage cube;
  cube.size = std::clamp(reader.height() / 2, 1, kMaxFaceSize);
  const auto size = static_cast<std::size_t>(cube.size);
  for (auto& face : cube.faces_rgba) face.resize(size * size * 4);
  std::vector<double> column_longitude(size);
  for (std::size_t i = 0; i < size; ++i) {
    column_longitude[i] = portable_atan2(face_coordinate(static_cast<int>(i), cube.size), 1.0);
  }

  tbb::parallel_for(0, cube.size, [&](int row) {
    const RowAngles angles = angles_of_row(row, cube.size);
    const auto put = [&](std::size_t face, std::size_t i, double longitude, double latitude) {
      const auto texel = panorama.sample(longitude, latitude);
      std::uint8_t* out = cube.faces_rgba[face].data() + (static_cast<std::size_t>(row) * size + i) * 4;
      for (std::size_t c = 0; c < 3; ++c) out[c] = encoder.color(texel[c]);
      out[3] = TexelEncoder::alpha(texel[3]);
    };
    for (std::size_t i = 0; i < size; ++i) {
      for (const Side& side : kSides) {
        put(side.face, i, side.center_longitude - column_longitude[i], angles.side_latitude[i]);
      }
      put(kTop, i, angles.top_longitude[i], angles.top_latitude[i]);
      put(kBottom, i, kPi - angles.top_longitude[i], -angles.top_latitude[i]);
    }
  });
  return cube;
}

}  // namespace barrido::scene
