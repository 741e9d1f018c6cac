// Meshes: the accessors of each primitive become its arrays, all of one length, every index below it.
#include <algorithm>
#include <bit>
#include <cmath>

#include "pipeline/gltf/import_parts.h"

namespace barrido::scene::gltf {
namespace {

// glTF 2.0, section 3.7.2.1, and KHR_mesh_quantization.
constexpr unsigned kNormalizedUnsigned = kNormalizedUnsignedByte | kNormalizedUnsignedShort;
constexpr unsigned kNormalizedSigned = kNormalizedByte | kNormalizedShort;
constexpr unsigned kQuantized =
    kNormalizedUnsigned | kNormalizedSigned | kByte | kUnsignedByte | kShort | kUnsignedShort;

using Attributes = std::map<std::string, int>;

constexpr int kMissing = -1;
constexpr const char* kTexcoordNames[] = {"TEXCOORD_0", "TEXCOORD_1"};

int find(const Attributes& attributes, const char* name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? kMissing : found->second;
}

float length_squared(const float* v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// Normals as they are where all have unit length to a thousandth, else a copy in which they have. Normals of
/// no length stay as they are.
FloatArray made_unit(const FloatArray& normals) {
  constexpr float kTolerance = 2e-3f;
  bool all_unit = true;
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    all_unit &= std::abs(length_squared(normals.data() + i) - 1.0f) <= kTolerance;
  }
  if (all_unit) return normals;
  std::vector<float> unit(normals.values().begin(), normals.values().end());
  for (std::size_t i = 0; i < unit.size(); i += 3) {
    // In double precision, since squares of large or small floats leave the range of floats.
    const double x = unit[i], y = unit[i + 1], z = unit[i + 2];
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length == 0.0) continue;
    for (std::size_t c = 0; c < 3; ++c) unit[i + c] = static_cast<float>(unit[i + c] / length);
  }
  return FloatArray(std::move(unit));
}

/// Weights of a vertex with sum 1 (glTF 2.0, section 3.7.3.3); a vertex without any hangs on its first joint.
FloatArray made_sum_one(const FloatArray& weights) {
  constexpr float kTolerance = 1e-5f;
  bool all_one = true;
  for (std::size_t i = 0; i < weights.size(); i += 4) {
    const float* w = weights.data() + i;
    all_one &= std::abs(w[0] + w[1] + w[2] + w[3] - 1.0f) <= kTolerance;
    all_one &= std::min(std::min(w[0], w[1]), std::min(w[2], w[3])) >= 0.0f;
  }
  if (all_one) return weights;
  std::vector<float> scaled(weights.values().begin(), weights.values().end());
  for (std::size_t i = 0; i < scaled.size(); i += 4) {
    float* w = scaled.data() + i;
    double sum = 0.0;
    for (int c = 0; c < 4; ++c) sum += w[c] = std::max(w[c], 0.0f);
    if (sum == 0.0) w[0] = 1.0f;
    for (int c = 0; c < 4 && sum != 0.0; ++c) w[c] = static_cast<float>(w[c] / sum);
  }
  return FloatArray(std::move(scaled));
}

class MeshImporter {
 public:
  explicit MeshImporter(Import& import) : import_(import), reader_(import.reader) {}

  void run() {
    const auto& meshes = import_.document.model().meshes;
    import_.scene.meshes.reserve(meshes.size());
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      Mesh& mesh = import_.scene.meshes.emplace_back();
      const bool read = read_or_warn(import_, import_.drawn.meshes[i], "nothing draws this mesh",
                                     [&] { mesh = mesh_of(meshes[i], element("meshes", i)); });
      if (!read) mesh.name = meshes[i].name;
    }
  }

 private:
  Mesh mesh_of(const tinygltf::Mesh& source, const std::string& place) {
    Mesh mesh;
    mesh.name = source.name;
    mesh.primitives.reserve(source.primitives.size());
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
      const tinygltf::Primitive& primitive = source.primitives[i];
      if (find(primitive.attributes, "POSITION") == kMissing) {
        import_.report.warn("a primitive without positions is not drawn");
        continue;
      }
      mesh.primitives.push_back(primitive_of(primitive, place + '.' + element("primitives", i)));
    }
    const std::size_t targets = source.primitives.empty() ? 0 : source.primitives[0].targets.size();
    if (!source.weights.empty() && source.weights.size() != targets) {
      import_.report.fail(place + ".weights", "there are " + std::to_string(source.weights.size()) +
                                                  " weights, but " + std::to_string(targets) +
                                                  " morph targets");
    }
    for (const double weight : source.weights) mesh.morph_weights.push_back(to_float(weight));
    mesh.morph_weights.resize(targets);
    return mesh;
  }

  Primitive primitive_of(const tinygltf::Primitive& source, const std::string& place) {
    Primitive primitive;
    primitive.mode = static_cast<pipeline::PrimitiveMode>(source.mode);  // Both follow OpenGL's constants.
    primitive.material = source.material < 0 ? kNone : source.material;
    primitive.variant_materials = variant_materials_of(import_, source, place);
    const int positions = find(source.attributes, "POSITION");
    count_vertices(place, reader_.count(positions));
    primitive.vertex_count = static_cast<std::uint32_t>(reader_.count(positions));
    read_attributes(source.attributes, place + ".attributes.", primitive);
    warn_of_others(source.attributes);
    read_skinning(source.attributes, place + ".attributes.", primitive);
    read_targets(source, place, primitive);
    if (source.indices >= 0) {
      const CheckedIndices& indices = reader_.indices(source.indices, place + ".indices");
      if (indices.largest >= primitive.vertex_count) {
        import_.report.fail(place + ".indices", "index " + std::to_string(indices.largest) +
                                                    " where there are only " +
                                                    std::to_string(primitive.vertex_count) + " vertices");
      }
      primitive.indices = indices.values;
    }
    return primitive;
  }

  void count_vertices(const std::string& place, std::uint64_t count) {
    vertices_ += count;
    if (vertices_ > import_.options.max_vertices || count > UINT32_MAX) {
      throw LimitError(import_.report.file(), place,
                       "the file has more than " + std::to_string(import_.options.max_vertices) +
                           " vertices, the importer's limit");
    }
  }

  /// Requires the format; kMissing stays kMissing.
  int attribute(const Attributes& attributes, const std::string& place, const char* name,
                std::initializer_list<int> components, unsigned formats, const Primitive& primitive) {
    const int accessor = find(attributes, name);
    if (accessor != kMissing) {
      reader_.require(accessor, place + name, components, formats, primitive.vertex_count);
    }
    return accessor;
  }

  void read_attributes(const Attributes& attributes, const std::string& place, Primitive& primitive) {
    const auto read = [&](const char* name, std::initializer_list<int> components, unsigned formats) {
      return attribute(attributes, place, name, components, formats, primitive);
    };
    primitive.positions = reader_.floats(read("POSITION", {3}, kFloat | kQuantized));
    if (const int normals = read("NORMAL", {3}, kFloat | kNormalizedSigned); normals != kMissing) {
      primitive.normals = once(unit_normals_, normals, made_unit);
    }
    if (const int tangents = read("TANGENT", {4}, kFloat | kNormalizedSigned); tangents != kMissing) {
      primitive.tangents = reader_.floats(tangents);
    }
    for (std::size_t set = 0; set < primitive.texcoords.size(); ++set) {
      const int texcoords = read(kTexcoordNames[set], {2}, kFloat | kQuantized);
      if (texcoords != kMissing) primitive.texcoords[set] = reader_.floats(texcoords);
    }
    if (const int colors = read("COLOR_0", {3, 4}, kFloat | kNormalizedUnsigned); colors != kMissing) {
      primitive.colors = reader_.floats(colors, 4);
    }
  }

  void read_skinning(const Attributes& attributes, const std::string& place, Primitive& primitive) {
    const int joints =
        attribute(attributes, place, "JOINTS_0", {4}, kUnsignedByte | kUnsignedShort, primitive);
    const int weights =
        attribute(attributes, place, "WEIGHTS_0", {4}, kFloat | kNormalizedUnsigned, primitive);
    if (find(attributes, "JOINTS_1") != kMissing) {
      import_.report.warn("more than four joints a vertex are not supported: the first four are used");
    }
    if (joints == kMissing || weights == kMissing) {
      if (joints != weights)
        import_.report.warn("joints without weights, or weights without joints, are ignored");
      return;
    }
    primitive.weights = once(sum_one_weights_, weights, made_sum_one);
    primitive.joints = reader_.unsigned_vec4(joints, place + "JOINTS_0");
    // A joint of no weight may be any number in real files; 0 is always a joint.
    for (std::size_t i = 0; i < primitive.weights.size(); ++i) {
      if (primitive.weights.data()[i] == 0.0f) primitive.joints[i / 4][i % 4] = 0;
    }
  }

  void read_targets(const tinygltf::Primitive& source, const std::string& place, Primitive& primitive) {
    primitive.morph_targets.reserve(source.targets.size());
    for (std::size_t i = 0; i < source.targets.size(); ++i) {
      const std::string target_place = place + '.' + element("targets", i) + '.';
      MorphTarget target;
      const int positions =
          attribute(source.targets[i], target_place, "POSITION", {3}, kFloat | kQuantized, primitive);
      const int normals =
          attribute(source.targets[i], target_place, "NORMAL", {3}, kFloat | kNormalizedSigned, primitive);
      if (positions != kMissing) target.positions = reader_.floats(positions);
      if (normals != kMissing) target.normals = reader_.floats(normals);
      const int tangents =
          attribute(source.targets[i], target_place, "TANGENT", {3}, kFloat | kNormalizedSigned, primitive);
      if (tangents != kMissing) target.tangents = reader_.floats(tangents);
      read_target_colors(source.targets[i], target_place, primitive, target);
      primitive.morph_targets.push_back(std::move(target));
    }
  }

  void read_target_colors(const Attributes& target, const std::string& place, const Primitive& primitive,
                          MorphTarget& to) {
    for (std::size_t set = 0; set < to.texcoords.size(); ++set) {
      const int texcoords =
          attribute(target, place, kTexcoordNames[set], {2}, kFloat | kQuantized, primitive);
      if (texcoords != kMissing) to.texcoords[set] = reader_.floats(texcoords);
    }
    const int colors = attribute(target, place, "COLOR_0", {3, 4},
                                 kFloat | kNormalizedUnsigned | kNormalizedSigned, primitive);
    if (colors == kMissing) return;
    to.colors = reader_.floats(colors, 4);
    if (reader_.components(colors) == 4) return;
    // An alpha that is not there does not change, where one that is missing in a colour is 1.
    std::vector<float> differences(to.colors.values().begin(), to.colors.values().end());
    for (std::size_t alpha = 3; alpha < differences.size(); alpha += 4) differences[alpha] = 0.0f;
    to.colors = FloatArray(std::move(differences));
  }

  /// Sets beyond those that are drawn.
  void warn_of_others(const Attributes& attributes) {
    for (const auto& [name, accessor] : attributes) {
      const bool is_extra_set =
          (name.starts_with("TEXCOORD_") && name != "TEXCOORD_0" && name != "TEXCOORD_1") ||
          (name.starts_with("COLOR_") && name != "COLOR_0");
      if (is_extra_set) import_.report.warn(one_line(name, 40) + " is ignored");
    }
  }

  /// Primitives that share an accessor share what is made of it.
  FloatArray once(std::map<int, FloatArray>& made, int accessor, FloatArray (*make)(const FloatArray&)) {
    const auto [entry, is_new] = made.try_emplace(accessor);
    if (is_new) entry->second = make(reader_.floats(accessor));
    return entry->second;
  }

  Import& import_;
  AccessorReader& reader_;
  std::uint64_t vertices_ = 0;
  std::map<int, FloatArray> unit_normals_;
  std::map<int, FloatArray> sum_one_weights_;
};

}  // namespace

void import_meshes(Import& import) { MeshImporter(import).run(); }

}  // namespace barrido::scene::gltf
