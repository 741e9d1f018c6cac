// The validation from beginning to end: container, text, shape, links, bytes, numbers. Each stage works on
// what the ones before have left standing.
#include "pipeline/validate/validate.h"

#include <exception>
#include <new>

#include "pipeline/files/error.h"
#include "pipeline/gltf/report.h"
#include "pipeline/validate/data_checks.h"
#include "pipeline/validate/report_info.h"
#include "pipeline/validate/resources.h"

namespace barrido::scene {
namespace validation {
namespace {

constexpr std::uint64_t kMaxTreeSteps = 20'000'000;

/// By content, then by name: an empty file has nothing but its name.
bool is_glb(std::span<const std::uint8_t> file, const std::filesystem::path& path) {
  constexpr std::string_view kMagic = "glTF";
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return text.starts_with(kMagic) || extension == ".glb";
}

void check_document(ValidationReport& report, JsonText& text, Resources& resources,
                    const ValidateOptions& options) {
  SchemaWalk walk(report.issues, text.document);
  if (!walk.run()) return;
  Budget steps(kMaxTreeSteps), numbers(options.max_numbers);
  Link link(walk, text, steps);
  link_accessors(link);
  link_images(link);
  link_meshes(link);
  link_nodes(link);
  link_animations(link);
  link.references.report_unused(link.issues);
  resources.load_buffers(link);
  resources.check_images(link);
  check_data(link, numbers);
  resources.check_textures(link);
  if (steps.exhausted() || numbers.exhausted()) link.issues.add(kDataNotChecked, "");
  report.info = info_of(link);
}

void validate(ValidationReport& report, const std::filesystem::path& path, const ValidateOptions& options) {
  const gltf::Content file = gltf::read_regular_file(path, options.max_file_bytes);
  if (!file.problem.empty()) gltf::Report(report.file).fail("", file.problem);
  const auto bytes = file.block.bytes();
  report.is_glb = is_glb(bytes, path);
  Chunks chunks;
  if (report.is_glb) {
    chunks = read_glb(report.issues, bytes);
    if (!chunks.has_json) return;
  } else {
    chunks.json = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  std::optional<JsonText> text =
      parse_json_text(report.issues, chunks.json, options.max_json_depth, options.max_json_values);
  if (!text) return;
  if (!text->document.is_object()) {
    report.issues.add(kTypeMismatch, "", {shown(text->document), "an object"});
    return;
  }
  Resources resources(path.parent_path(), report.is_glb ? &chunks : nullptr, file.block.owner(),
                      options.max_file_bytes);
  check_document(report, *text, resources, options);
}

}  // namespace
}  // namespace validation

ValidationReport validate_gltf(const std::filesystem::path& path, const ValidateOptions& options) {
  ValidationReport report{path.string(), false, validation::Issues(options.max_issues), {}};
  try {
    validation::validate(report, path, options);
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    gltf::Report(report.file).fail("", "does not fit into memory");
  } catch (const std::exception& error) {
    gltf::Report(report.file).fail("", gltf::one_line(error.what()));
  }
  return report;
}

}  // namespace barrido::scene
