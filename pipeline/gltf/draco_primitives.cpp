// The accessors of a compressed primitive say what is to come out of its stream: how many elements of which
// type. Memory is taken by them; a stream that holds something else is refused.
#include "pipeline/gltf/draco_primitives.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <tbb/parallel_for.h>
#include <nlohmann/json.hpp>

#include "pipeline/files/module_loader.h"
#include "pipeline/gltf/draco_module/interface.h"
#include "pipeline/gltf/json_values.h"
#include "pipeline/gltf/layout.h"

namespace barrido::scene::gltf {
namespace {

using nlohmann::json;

struct Output {
  int accessor = 0;
  std::uint32_t attribute = 0;  ///< Of the stream
  ByteBlock elements;
};

struct CompressedPrimitive {
  std::string place;
  int view = 0;
  int indices = -1;  ///< Accessor
  std::vector<Output> attributes;
  ByteBlock index_elements;
  std::size_t max_memory = 0;  ///< For the library's own use
  std::string problem;         ///< Why it cannot be decoded.
};

struct MeshCloser {
  const BarridoDracoFunctions* functions;
  void operator()(BarridoDracoMesh* mesh) const { functions->close(mesh); }
};

class Preparation {
 public:
  Preparation(const Report& report, const Document& document) : report_(report), document_(document) {}

  std::vector<CompressedPrimitive> run() {
    std::vector<CompressedPrimitive> all;
    const auto meshes = document_.tree().find("meshes");
    if (meshes == document_.tree().end()) return all;
    for (std::size_t mesh = 0; mesh < meshes->size(); ++mesh) {
      const json& primitives = (*meshes)[mesh]["primitives"];
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        const auto extensions = primitives[i].find("extensions");
        if (extensions == primitives[i].end() || !extensions->is_object()) continue;
        const auto draco = extensions->find("KHR_draco_mesh_compression");
        if (draco == extensions->end()) continue;
        CompressedPrimitive primitive;
        primitive.place = element("meshes", mesh) + '.' + element("primitives", i);
        prepare(primitive, primitives[i], *draco);
        all.push_back(std::move(primitive));
      }
    }
    return all;
  }

 private:
  const tinygltf::Accessor& accessor(int index) const {
    return document_.model().accessors[static_cast<std::size_t>(index)];
  }

  void prepare(CompressedPrimitive& primitive, const json& source, const json& draco) {
    primitive.indices = source.value("indices", -1);
    const auto view = whole_number(draco, "bufferView");
    if (!view || *view >= document_.model().bufferViews.size()) {
      primitive.problem = "the bufferView of its Draco stream is not there";
      return;
    }
    primitive.view = static_cast<int>(*view);
    if (const auto& problem = document_.view_problem(primitive.view)) primitive.problem = problem->reason;
    if (primitive.indices >= 0) look_at(primitive.indices, primitive);
    const std::size_t points = list_attributes(primitive, source["attributes"], draco);
    if (!primitive.problem.empty()) return;
    if (source.value("mode", 4) != 4) primitive.problem = "Draco's meshes are triangles, its mode is another";
    if (primitive.indices < 0) primitive.problem = "a primitive compressed by Draco needs indices";
    if (primitive.attributes.empty()) primitive.problem = "its Draco stream has no attributes";
    if (!document_.has_bytes(primitive.view)) primitive.problem = "its Draco stream has no bytes";
    if (!primitive.problem.empty()) return;
    for (Output& output : primitive.attributes) {
      output.elements = take(output.accessor, element_layout(accessor(output.accessor), 0).element_bytes);
    }
    primitive.index_elements = take(primitive.indices, sizeof(std::uint32_t));
    // Connectivity and one corner table an attribute; generous, and still no more than counts that are true.
    const std::size_t tables = primitive.attributes.size() + 1;
    const std::uint64_t due =
        (std::uint64_t{4} << 20) + tables * (accessor(primitive.indices).count * 96 + points * 192);
    primitive.max_memory = static_cast<std::size_t>(std::min(due, document_.budget().memory_left()));
  }

  /// Returns how many points their accessors have.
  std::size_t list_attributes(CompressedPrimitive& primitive, const json& attributes, const json& draco) {
    std::size_t points = 0;
    const auto ids = draco.find("attributes");
    if (ids == draco.end() || !ids->is_object()) return points;
    for (const auto& [name, accessor_index] : attributes.items()) {
      if (!ids->contains(name)) continue;
      const int index = accessor_index.get<int>();
      const auto id = whole_number(*ids, name.c_str());
      if (!id || *id > UINT32_MAX) {
        primitive.problem = "the number of its " + one_line(name, 40) + " in the Draco stream is none";
        return points;
      }
      if (points != 0 && accessor(index).count != points) primitive.problem = "its accessors differ in count";
      points = accessor(index).count;
      look_at(index, primitive);
      if (is_matrix(accessor(index).type)) primitive.problem = "an attribute is no matrix";
      primitive.attributes.push_back({index, static_cast<std::uint32_t>(*id), {}});
    }
    return points;
  }

  void look_at(int index, CompressedPrimitive& primitive) const {
    if (const auto& problem = document_.accessor_problem(index)) primitive.problem = problem->reason;
  }

  static bool is_matrix(int type) {
    return type == TINYGLTF_TYPE_MAT2 || type == TINYGLTF_TYPE_MAT3 || type == TINYGLTF_TYPE_MAT4;
  }

  ByteBlock take(int index, std::uint64_t element_bytes) const {
    const std::uint64_t bytes = accessor(index).count * element_bytes;
    document_.budget().take(bytes, report_.file(), element("accessors", static_cast<std::size_t>(index)));
    return ByteBlock::allocate(static_cast<std::size_t>(bytes));
  }

  const Report& report_;
  const Document& document_;
};

std::string unlike(const char* what, std::uint64_t decoded, int accessor, std::uint64_t due) {
  return "its Draco stream holds " + std::to_string(decoded) + what +
         element("accessors", static_cast<std::size_t>(accessor)) + " has " + std::to_string(due);
}

/// Fills the primitive's blocks; returns the reason where it cannot.
std::string decode(const Document& document, CompressedPrimitive& primitive) {
  static const Module module("barrido_draco.so", BARRIDO_DRACO_ENTRY, BARRIDO_DRACO_INTERFACE_VERSION);
  const auto* functions = module.functions<BarridoDracoFunctions>();
  if (functions == nullptr) return module.problem("reading KHR_draco_mesh_compression");
  const std::span<const std::uint8_t> bytes = document.view_bytes(primitive.view);
  BarridoModuleError error{};
  BarridoDracoCounts counts{};
  const std::unique_ptr<BarridoDracoMesh, MeshCloser> mesh(
      functions->decode(bytes.data(), bytes.size(), primitive.max_memory, &counts, &error), {functions});
  if (!mesh) return error.text;
  const auto& accessors = document.model().accessors;
  const std::uint64_t indices = accessors[static_cast<std::size_t>(primitive.indices)].count;
  if (std::uint64_t{counts.faces} * 3 != indices) {
    return unlike(" indices, but ", std::uint64_t{counts.faces} * 3, primitive.indices, indices);
  }
  auto* index_out = reinterpret_cast<std::uint32_t*>(primitive.index_elements.writable());
  if (functions->read_indices(mesh.get(), index_out, &error) == 0) return error.text;
  for (Output& output : primitive.attributes) {
    const tinygltf::Accessor& accessor = accessors[static_cast<std::size_t>(output.accessor)];
    if (counts.points != accessor.count) {
      return unlike(" points, but ", counts.points, output.accessor, accessor.count);
    }
    const BarridoDracoAttribute wanted{
        output.attribute, accessor.componentType,
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type))};
    if (functions->read_attribute(mesh.get(), &wanted, output.elements.writable(), &error) == 0) {
      return error.text;
    }
  }
  return {};
}

bool has_bytes(const Document& document, int accessor) {
  const int view = document.model().accessors[static_cast<std::size_t>(accessor)].bufferView;
  return view >= 0 && !document.accessor_problem(accessor) && document.has_bytes(view);
}

bool has_fallback(const Document& document, const CompressedPrimitive& primitive) {
  return (primitive.indices < 0 || has_bytes(document, primitive.indices)) &&
         std::all_of(primitive.attributes.begin(), primitive.attributes.end(),
                     [&](const Output& output) { return has_bytes(document, output.accessor); });
}

void set_problem(int accessor, const CompressedPrimitive& primitive,
                 std::vector<std::optional<Problem>>& problems) {
  if (accessor < 0) return;
  std::optional<Problem>& problem = problems[static_cast<std::size_t>(accessor)];
  if (!problem) problem = {primitive.place, primitive.problem};
}

}  // namespace

std::map<int, DecodedAccessor> decode_draco_primitives(Report& report, const Document& document,
                                                       std::vector<std::optional<Problem>>& problems) {
  std::vector<CompressedPrimitive> primitives = Preparation(report, document).run();
  tbb::parallel_for(
      std::size_t{0}, primitives.size(),
      [&](std::size_t i) {
        CompressedPrimitive& primitive = primitives[i];
        if (!primitive.problem.empty() || document.budget().is_late()) return;
        primitive.problem = decode(document, primitive);
      },
      tbb::simple_partitioner());
  if (!primitives.empty()) document.budget().check_time(report.file(), "");
  std::map<int, DecodedAccessor> decoded;
  for (CompressedPrimitive& primitive : primitives) {
    if (primitive.problem.empty()) {
      decoded[primitive.indices] = {primitive.index_elements, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT};
      for (const Output& output : primitive.attributes) {
        const auto index = static_cast<std::size_t>(output.accessor);
        decoded[output.accessor] = {output.elements, document.model().accessors[index].componentType};
      }
    } else if (has_fallback(document, primitive)) {
      report.warn(primitive.place + ": " + primitive.problem + "; its uncompressed accessors are used");
    } else {
      set_problem(primitive.indices, primitive, problems);
      for (const Output& output : primitive.attributes) set_problem(output.accessor, primitive, problems);
    }
  }
  return decoded;
}

}  // namespace barrido::scene::gltf
