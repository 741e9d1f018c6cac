// The commands of the program. Each takes the words after its name and returns the exit status: 0 fine, 1
// pictures differ, 2 error. All exceptions but those that main names are turned into messages inside.
#pragma once

#include <span>
#include <string>

namespace barrido::cli {

inline constexpr int kExitFine = 0;
inline constexpr int kExitDifferent = 1;
inline constexpr int kExitError = 2;

/// `barrido render FILE… -o OUT`. @throws UsageError, std::bad_alloc, scene::InputError.
int run_render(std::span<const std::string> words);

/// `barrido inspect FILE --pixel X,Y`. @throws UsageError, std::bad_alloc, scene::InputError.
int run_inspect(std::span<const std::string> words);

/// `barrido lab sampling FILE`. @throws UsageError, std::bad_alloc, scene::InputError.
int run_lab(std::span<const std::string> words);

/// `barrido info FILE [--json] [--validate]`. @throws UsageError, std::bad_alloc, scene::InputError.
int run_info(std::span<const std::string> words);

/// `barrido diff A B`. @throws UsageError, std::bad_alloc, scene::InputError.
int run_diff(std::span<const std::string> words);

}  // namespace barrido::cli
