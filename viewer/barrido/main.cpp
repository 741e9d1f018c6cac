// The program barrido: chooses the command and is the border at which every error becomes one line on
// standard error and exit status 2. The offscreen program: no GL, no window system.
#include <algorithm>
#include <array>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/barrido/commands.h"
#include "viewer/barrido/console.h"
#include "viewer/barrido/help.h"
#include "viewer/barrido/process_guard.h"
#include "viewer/barrido/spelling.h"
#include "viewer/barrido/standard_streams.h"

namespace {

using namespace barrido::cli;

int print(const std::string& text) {
  write_standard_output(bytes_of(text));
  return kExitFine;
}

int run(const std::vector<std::string>& words) {
  if (words.empty()) throw UsageError("no command given; see barrido --help");
  const std::string& command = words[0];
  const std::span<const std::string> rest(words.begin() + 1, words.end());
  if (command == "render") return run_render(rest);
  if (command == "inspect") return run_inspect(rest);
  if (command == "lab") return run_lab(rest);
  if (command == "info") return run_info(rest);
  if (command == "diff") return run_diff(rest);
  if (command == "--version" || command == "-V") return print(version_text());
  if (command == "help" && !rest.empty()) return run({rest[0], "--help"});
  if (command == "--help" || command == "-h" || command == "help") return print(general_help());
  constexpr std::array<std::string_view, 7> kCommands{"render", "inspect", "info",     "lab",
                                                      "diff",   "--help",  "--version"};
  const bool is_option = command.size() > 1 && command[0] == '-';
  throw UsageError((is_option ? "unknown option '" : "unknown command '") + command + "'" +
                   did_you_mean(command, kCommands) + " (see barrido --help)");
}

int fail(const std::string& message) {
  Console({}).error(message);
  return kExitError;
}

}  // namespace

int main(int argument_count, char** arguments) {
  prepare_standard_streams();
  guard_process();
  try {
    return run({arguments + std::min(argument_count, 1), arguments + argument_count});
  } catch (const std::exception& error) {
    return fail(is_out_of_memory(error) ? out_of_memory() : error.what());
  }
}
