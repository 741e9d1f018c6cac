#include <tbb/global_control.h>
#include <unistd.h>

#include <optional>

#include "raster/base/simd_target.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/console.h"
#include "viewer/barrido/help.h"
#include "viewer/barrido/render_call.h"
#include "viewer/barrido/render_options.h"
#include "viewer/barrido/standard_streams.h"

namespace barrido::cli {

int run_render(std::span<const std::string> words) {
  const RenderOptions options = parse_render_options(words);
  if (options.help) {
    write_standard_output(bytes_of(render_help()));
    return kExitFine;
  }
  std::optional<tbb::global_control> threads;
  if (options.threads > 0) {
    threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  }
  raster::set_simd_target(options.simd);  // That it is available was checked with the option.
  ConsoleOptions console_options;
  console_options.quiet = options.quiet;
  console_options.is_terminal = isatty(kStandardError) == 1;
  Console console(console_options);
  return RenderCall(options, console).run();
}

}  // namespace barrido::cli
