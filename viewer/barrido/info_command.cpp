#include <filesystem>

#include "pipeline/gltf/import_gltf.h"
#include "viewer/barrido/arguments.h"
#include "viewer/barrido/call_limits.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/console.h"
#include "viewer/barrido/frame_plan.h"
#include "viewer/barrido/help.h"
#include "viewer/barrido/info_validate.h"
#include "viewer/barrido/scene_summary.h"
#include "viewer/barrido/standard_streams.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

enum InfoOption : std::size_t { kJson, kValidate, kMaxMemory, kMaxSeconds, kHelp };

DrawingVerdict drawing_verdict(const std::string& file, CallLimits& limits) {
  try {
    scene::ImportOptions import;
    import.budget = limits.open(file);
    scene::import_gltf(file, import);
    return {};
  } catch (const scene::InputError& error) {
    return {false, error.what()};
  }
}

/// The validator has limits of its own; here is the end for what they do not foresee.
void allow_validation(const std::string& file, CallLimits& limits) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (!error) limits.open(file, true)->add_file(bytes, scene::Budget::Kind::model, file);
}

int validate(const std::string& file, bool as_json, CallLimits& limits) {
  allow_validation(file, limits);
  const scene::ValidationReport report = scene::validate_gltf(file);
  const DrawingVerdict verdict = drawing_verdict(file, limits);
  write_standard_output(
      bytes_of(as_json ? validation_json(report, verdict) : validation_text(report, verdict)));
  return report.issues.count(scene::validation::Severity::error) == 0 ? kExitFine : kExitError;
}

LimitOptions limits_of(const Arguments& arguments) {
  LimitOptions limits;
  for (const GivenOption& given : arguments.options) {
    try {
      if (given.index == kMaxMemory) limits.max_memory = parse_memory(given.value);
      if (given.index == kMaxSeconds) limits.max_seconds = parse_seconds(given.value);
    } catch (const ValueError& error) {
      throw UsageError(std::string(info_syntax()[given.index].name) + ": '" + given.value +
                       "': " + error.what());
    }
  }
  return limits;
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
  CallLimits limits(limits_of(arguments));
  const std::string& file = arguments.files[0];
  if (arguments.has(kValidate) && file == "-") {
    throw UsageError("info: --validate reads a file several times, standard input can be read only once");
  }
  if (arguments.has(kValidate)) return validate(file, arguments.has(kJson), limits);
  scene::ImportOptions import;
  import.budget = limits.open(shown_file(file));
  const scene::Scene scene = read_model(file, import);
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
