#include "pipeline/scene/import_gltf.h"
#include "viewer/barrido/arguments.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/console.h"
#include "viewer/barrido/help.h"
#include "viewer/barrido/scene_summary.h"
#include "viewer/barrido/standard_streams.h"

namespace barrido::cli {
namespace {

enum InfoOption : std::size_t { kJson, kHelp };

}  // namespace

int run_info(std::span<const std::string> words) {
  const Arguments arguments = parse_arguments(info_syntax(), words);
  if (arguments.has(kHelp)) {
    write_standard_output(bytes_of(info_help()));
    return kExitFine;
  }
  if (arguments.files.empty()) throw UsageError("info: no FILE given; see barrido info --help");
  if (arguments.files.size() > 1) throw UsageError("info: one FILE at a time");
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
