#include "pipeline/scene/import_gltf.h"
#include "viewer/barrido/arguments.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/console.h"
#include "viewer/barrido/help.h"
#include "viewer/barrido/info_validate.h"
#include "viewer/barrido/scene_summary.h"
#include "viewer/barrido/standard_streams.h"

namespace barrido::cli {
namespace {

enum InfoOption : std::size_t { kJson, kValidate, kHelp };

DrawingVerdict drawing_verdict(const std::string& file) {
  try {
    scene::import_gltf(file);
    return {};
  } catch (const scene::InputError& error) {
    return {false, error.what()};
  }
}

int validate(const std::string& file, bool as_json) {
  const scene::ValidationReport report = scene::validate_gltf(file);
  const DrawingVerdict verdict = drawing_verdict(file);
  write_standard_output(
      bytes_of(as_json ? validation_json(report, verdict) : validation_text(report, verdict)));
  return report.issues.count(scene::validation::Severity::error) == 0 ? kExitFine : kExitError;
}

}  // namespace

int run_info(std::span<const std::string> words) {
  const Arguments arguments = parse_arguments(info_syntax(), words);
  if (arguments.has(kHelp)) {
    write_standard_output(bytes_of(info_help()));
    return kExitFine;
  }
  if (arguments.files.empty()) throw UsageError("info: no FILE given; see barrido info --help");
  if (arguments.files.size() > 1) throw UsageError("info: one FILE at a time");
  if (arguments.has(kValidate)) return validate(arguments.files[0], arguments.has(kJson));
  const scene::Scene scene = scene::import_gltf(arguments.files[0]);
  const SceneSummary summary = summarize(scene);
  if (arguments.has(kJson)) {
    write_standard_output(bytes_of(info_json(scene, summary)));
    return kExitFine;
  }
  Console console({});
  for (const std::string& warning : scene.warnings) console.warning(warning);
  write_standard_output(bytes_of(info_text(scene, summary)));
  return kExitFine;
}

}  // namespace barrido::cli
