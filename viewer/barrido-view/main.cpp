// The program barrido-view: the border at which every error becomes one line on standard error and exit
// status 2.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include "pipeline/files/error.h"
#include "viewer/barrido-view/app.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/standard_streams.h"

namespace {

using namespace barrido;

int run(const std::vector<std::string>& words) {
  const view::ViewArguments arguments = view::parse_view_arguments(words);
  if (arguments.help || arguments.version) {
    const std::string text = arguments.help ? view::view_help() : "barrido-view " BARRIDO_VERSION "\n";
    cli::write_standard_output(cli::bytes_of(text));
    return cli::kExitFine;
  }
  // A window that has nothing to show is no answer to a slip of the pen.
  for (const std::string& file : arguments.files) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) throw scene::InputError(file, "", "no such file");
  }
  return window::App(arguments).run();
}

int fail(const std::string& message) {
  cli::write_all(cli::kStandardError, cli::bytes_of("barrido-view: " + cli::on_one_line(message) + "\n"));
  return cli::kExitError;
}

}  // namespace

int main(int argument_count, char** arguments) {
  cli::prepare_standard_streams();
  try {
    return run({arguments + std::min(argument_count, 1), arguments + argument_count});
  } catch (const std::bad_alloc&) {
    return fail("not enough memory");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}
