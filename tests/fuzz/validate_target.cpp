// The validator of glTF files, on .gltf and .glb: it may not be able to read a file at all, else it reports,
// and its reports can be written.
#include "model_file.h"
#include "pipeline/files/error.h"
#include "pipeline/validate/validate.h"
#include "targets.h"

namespace barrido::fuzz {

void run_validate(Bytes bytes) {
  static const ModelFile file;
  scene::ValidateOptions options;
  options.max_file_bytes = 1 << 22;
  options.max_issues = 1000;
  options.max_numbers = 100'000;
  try {
    scene::validate_gltf(file.write("model.gltf", bytes), options);
  } catch (const scene::InputError&) {
  }
}

}  // namespace barrido::fuzz
