#include "tests/bench/scaling.h"

#include <cmath>
#include <functional>
#include <stdexcept>

#include "tests/bench/scaling_threads.h"

namespace barrido::bench {
namespace {

/// What OpenGL guarantees, and all that Mesa has.
constexpr int kPeerLights = 8;

/// A row is printed as soon as it is measured.
class Series {
 public:
  Series(std::string name, std::string title, const Options& options) : options_(options) {
    table_.name = std::move(name);
    table_.title = std::move(title);
    options_.harness.least_rounds = 3;  // the largest frames take seconds
    print_header(table_);
  }

  void add(const std::string& id, double millions, const std::string& unit, const ScenePair& scene,
           bool peer_can = true) {
    Measurement row = measure(scene, options_, {.can = peer_can});
    row.id = id;
    row.millions = millions;
    row.unit = unit;
    print_row(row);
    table_.rows.push_back(std::move(row));
  }

  Table take() { return std::move(table_); }

 private:
  Options options_;
  Table table_;
};

std::string with_side(int side) { return std::to_string(side) + "x" + std::to_string(side); }

double megapixels(const Scale& scale) { return 1e-6 * scale.width * scale.height; }

std::vector<Table> triangles(const Options& options) {
  Series series("triangles", "Triangles: the ellipsoid of W7, Gouraud, one light", options);
  for (const int wanted : {1'000, 10'000, 100'000, 1'000'000, 10'000'000}) {
    EllipsoidOptions ellipsoid_options;
    ellipsoid_options.slices = static_cast<int>(std::lround(std::sqrt(wanted)));
    ellipsoid_options.stacks = ellipsoid_options.slices / 2 + 1;
    ellipsoid_options.silhouette = 0.98;
    const ScenePair scene = ellipsoid(options.scale, ellipsoid_options);
    const std::size_t count = scene.draws[0].mesh.indices.size() / 3;
    series.add(std::to_string(count) + " triangles", 1e-6 * static_cast<double>(count), "Mtri/s", scene);
  }
  return {series.take()};
}

Table lights(pipeline::ShadeModel shading, const std::string& name, const std::string& title,
             const Options& options) {
  Series series(name, title, options);
  for (int count = 1; count <= 64; count *= 2) {
    EllipsoidOptions ellipsoid_options;
    ellipsoid_options.shading = shading;
    ellipsoid_options.lights = count;
    series.add(std::to_string(count) + (count == 1 ? " light" : " lights"), 0, "",
               ellipsoid(options.scale, ellipsoid_options), count <= kPeerLights);
  }
  return series.take();
}

std::vector<Table> lights(const Options& options) {
  std::vector<Table> tables;
  tables.push_back(lights(pipeline::ShadeModel::gouraud, "lights_gouraud",
                          "Lights: W8's ellipsoid, Gouraud; the peer has 8", options));
  tables.push_back(lights(pipeline::ShadeModel::phong, "lights_phong",
                          "Lights: W9's ellipsoid, Phong; the peer has 8", options));
  return tables;
}

GroundOptions one_ground() {
  GroundOptions ground;
  ground.min_filter = raster::MinFilter::linear_mipmap_linear;
  ground.layers = 1;
  return ground;
}

std::vector<Table> resolution(const Options& options) {
  Series series("resolution", "Resolution: one ground plane of W5, trilinear", options);
  for (int side = 256; side <= 8192; side *= 2) {
    const Scale scale{side, side};
    series.add(with_side(side), megapixels(scale), "Mpix/s", ground_layers(scale, one_ground()));
  }
  return {series.take()};
}

std::vector<Table> texture(const Options& options) {
  Series series("texture", "Texture: one ground plane of W5, trilinear", options);
  for (int side = 256; side <= 8192; side *= 2) {
    GroundOptions ground = one_ground();
    ground.texture_side = side;
    series.add(with_side(side), megapixels(options.scale), "Mpix/s", ground_layers(options.scale, ground));
  }
  return {series.take()};
}

}  // namespace

const std::vector<std::string>& scaling_names() {
  static const std::vector<std::string> names{"triangles", "lights", "resolution", "texture", "threads"};
  return names;
}

std::vector<Table> run_scaling(const std::string& name, const Options& options) {
  if (name == "triangles") return triangles(options);
  if (name == "lights") return lights(options);
  if (name == "resolution") return resolution(options);
  if (name == "texture") return texture(options);
  if (name == "threads") return {scaling_by_threads(options)};
  throw std::invalid_argument("no scaling run is called '" + name + "'");
}

}  // namespace barrido::bench
