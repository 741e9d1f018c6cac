// One target as libFuzzer wants it; BARRIDO_FUZZ_TARGET is its name.
#include <tbb/global_control.h>

#include "mutators.h"
#include "targets.h"

namespace {

using namespace barrido::fuzz;

constexpr std::string_view kName = BARRIDO_FUZZ_TARGET;

constexpr const Target& chosen_target() {
  for (const Target& target : kTargets) {
    if (target.name == kName) return target;
  }
  throw "no target has this name";
}
constexpr const Target& kTarget = chosen_target();

/// Null: libFuzzer's own mutations.
constexpr Mutator chosen_mutator() {
  if (kName == "gltf" || kName == "validate") return mutate_gltf;
  if (kName == "glb") return mutate_glb;
  return kName == "image" ? mutate_image : nullptr;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // Runs are short, and what two processors do in turns is not the same every time.
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kTarget.run({data, size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t capacity,
                                               unsigned seed) {
  constexpr Mutator kMutator = chosen_mutator();
  if constexpr (kMutator == nullptr) {
    return LLVMFuzzerMutate(data, size, capacity);
  } else {
    return kMutator(data, size, capacity, seed);
  }
}
