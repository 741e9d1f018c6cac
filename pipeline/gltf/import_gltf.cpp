// The import of a glTF model from beginning to end. Whatever the libraries throw is caught here and leaves as
// InputError.
#include "pipeline/gltf/import_gltf.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <new>

#include "pipeline/gltf/import_parts.h"

namespace barrido::scene {
namespace gltf {

float to_float(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

namespace {

Scene import_document(Report& report, const Document& document, const ImportOptions& options) {
  Scene scene;
  scene.source = report.file();
  scene.generator = document.model().asset.generator;
  AccessorReader reader(report, document);
  const DrawnElements drawn = find_drawn(document.model());
  Import import{report, document, reader, options, scene, drawn};
  check_extensions(import);
  import_materials(import);
  import_material_extras(import);
  import_images(import);
  import_variants(import);
  import_cameras(import);
  import_lights(import);
  import_meshes(import);
  import_nodes(import);
  import_skins(import);
  import_animations(import);
  import_extras(import);
  list_features(import);
  reader.finish();
  document.warn_of_unused(report);
  scene.warnings = report.take_warnings();
  return scene;
}

}  // namespace
}  // namespace gltf

Scene import_gltf(const std::filesystem::path& path, const ImportOptions& options) {
  gltf::Report report(path.string());
  try {
    ImportOptions limited = options;
    if (!limited.budget) limited.budget = std::make_shared<Budget>();
    const gltf::Document document(report, path, limited);
    return gltf::import_document(report, document, limited);
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    report.fail("", "does not fit into memory");
  } catch (const std::exception& error) {
    report.fail("", gltf::one_line(error.what()));
  }
}

}  // namespace barrido::scene
