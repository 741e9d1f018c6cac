// `barrido diff`: compares pair by pair, holds the pixels of one pair at a time, and writes what was asked
// for.
#include <unistd.h>

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "pipeline/files/write_file.h"
#include "pipeline/pictures/image_io.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/console.h"
#include "viewer/barrido/diff_options.h"
#include "viewer/barrido/help.h"
#include "viewer/barrido/process_guard.h"
#include "viewer/barrido/standard_streams.h"
#include "viewer/compare/bless.h"
#include "viewer/compare/figures_text.h"
#include "viewer/compare/html_report.h"
#include "viewer/compare/text_reports.h"

namespace barrido::cli {
namespace {

using compare::ComparedPair;
using compare::Outcome;
using compare::Result;

/// Each holds the pixels of two pictures.
constexpr std::size_t kMostPairsAtATime = 16;

class DiffCall {
 public:
  DiffCall(const DiffOptions& options, Console& console) : options_(options), console_(console) {}

  int run() {
    const std::vector<compare::Pair> pairs = compare::find_pairs(
        options_.expected, options_.actual,
        options_.bless ? compare::MissingExpected::is_empty : compare::MissingExpected::is_an_error);
    folders_ = std::filesystem::is_directory(options_.actual);
    if (folders_ && !options_.output.empty()) {
      throw UsageError("--output: only for two pictures; of folders, --html shows the differences");
    }
    if (!options_.html.empty()) html_.emplace(options_.html);
    if (!options_.output.empty()) check_output();
    run_ = {options_.expected, options_.actual, options_.settings, {}};
    run_.settings.pixels = html_.has_value() || !options_.output.empty();
    run_.settings.facts = !options_.json.empty();
    compare_all(pairs);
    console_.end_progress();
    if (folders_) print(compare::totals_text(compare::totals_of(run_)) + "\n");
    write_reports();
    return options_.bless ? bless() : status();
  }

 private:
  /// An input must not be lost to the picture of a difference.
  void check_output() const {
    for (const std::string& input : {options_.expected, options_.actual}) {
      std::error_code ignored;
      if (std::filesystem::equivalent(options_.output, input, ignored)) {
        throw UsageError("--output: '" + options_.output + "' is one of the two pictures");
      }
    }
  }

  /// As many pairs at a time as there are threads; they are told in their order.
  void compare_all(const std::vector<compare::Pair>& pairs) {
    using tbb::filter_mode;
    using Compared = std::shared_ptr<ComparedPair>;
    std::size_t next = 0;
    const auto take = [&](tbb::flow_control& control) -> std::size_t {
      if (next == pairs.size()) control.stop();
      return next++;
    };
    const auto compare = [&](std::size_t index) {
      return std::make_shared<ComparedPair>(compare::compare_pair(pairs[index], run_.settings));
    };
    const auto tell = [&](const Compared& compared) {
      add(*compared);
      console_.set_progress("compared " + compared->result.pair.name + " (" +
                            std::to_string(run_.results.size()) + " of " + std::to_string(pairs.size()) +
                            ")");
    };
    const auto threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    tbb::parallel_pipeline(std::min<std::size_t>(threads, kMostPairsAtATime),
                           tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, take) &
                               tbb::make_filter<std::size_t, Compared>(filter_mode::parallel, compare) &
                               tbb::make_filter<Compared, void>(filter_mode::serial_in_order, tell));
  }

  void add(const ComparedPair& compared) {
    const Result& result = compared.result;
    if (result.outcome == Outcome::error) {
      console_.error(result.note);
    } else if (folders_) {
      if (result.outcome != Outcome::same) print_line(result.pair.name + ": " + compare::headline(result));
    } else {
      print_pair(result);
      if (!options_.output.empty() && result.figures) write_difference(compared);
    }
    if (html_) html_->add(compared);
    run_.results.push_back(result);
  }

  /// As idiff, whose users look for these words.
  void print_pair(const Result& result) {
    std::string text = "Comparing \"" + options_.expected + "\" and \"" + options_.actual + "\"\n";
    const bool equal = result.figures ? result.figures->max == 0.0 : result.outcome == Outcome::same;
    if (!equal || !result.note.empty()) text += compare::figures_text(result, options_.settings.thresholds);
    const bool same = result.outcome == Outcome::same;
    text += same ? "PASS\n" : result.outcome == Outcome::warning ? "WARNING\n" : "FAILURE\n";
    print(text);
  }

  void write_difference(const ComparedPair& compared) {
    const auto picture = compare::difference_picture(compared.expected, compared.actual, options_.difference);
    scene::write_image(options_.output, {picture.width, picture.height, picture.rgba8, picture.rgba_float});
  }

  void write_reports() {
    if (html_) html_->write(run_);
    if (!options_.json.empty()) write_text(options_.json, compare::json_report(run_));
    if (!options_.junit.empty()) write_text(options_.junit, compare::junit_report(run_));
  }

  void write_text(const std::string& path, const std::string& text) {
    if (path == "-") {
      console_.print(kStandardOutput, text);
    } else {
      scene::write_file(path, bytes_of(text));
    }
  }

  /// Afterwards, only what could not be copied, or is missing, still differs.
  int bless() {
    const compare::Blessed blessed = compare::bless(run_);
    for (const auto& path : blessed.replaced) print_line("blessed " + path.string() + ": replaced");
    for (const auto& path : blessed.added) print_line("blessed " + path.string() + ": new");
    for (const auto& path : blessed.kept) print_line("kept " + path.string() + ": has no counterpart");
    if (blessed.replaced.empty() && blessed.added.empty()) print("nothing to bless\n");
    for (const Result& result : run_.results) {
      if (result.outcome == Outcome::error && !result.actual) return kExitError;
    }
    return blessed.kept.empty() ? kExitFine : kExitDifferent;
  }

  /// What people read gives way to a report on standard output.
  void print(const std::string& text) {
    if (options_.quiet) return;
    const bool report_on_output = options_.json == "-" || options_.junit == "-";
    console_.print(report_on_output ? kStandardError : kStandardOutput, text);
  }

  /// Names may hold line feeds.
  void print_line(const std::string& line) { print(on_one_line(line) + "\n"); }

  int status() const {
    const compare::Totals totals = compare::totals_of(run_);
    if (totals[Outcome::error] > 0) return kExitError;
    return totals.failed() > 0 ? kExitDifferent : kExitFine;
  }

  const DiffOptions& options_;
  Console& console_;
  compare::Run run_;
  bool folders_ = false;
  std::optional<compare::HtmlReport> html_;
};

}  // namespace

int run_diff(std::span<const std::string> words) {
  const DiffOptions options = parse_diff_options(words);
  if (options.help) {
    write_standard_output(bytes_of(diff_help()));
    return kExitFine;
  }
  ConsoleOptions console_options;
  console_options.quiet = options.quiet;
  console_options.is_terminal = isatty(kStandardError) == 1;
  Console console(console_options);
  if (options.limits.max_memory) limit_data(*options.limits.max_memory);
  if (options.limits.max_seconds) {
    start_clock(
        ClockKind::wall, *options.limits.max_seconds,
        options.expected + ", " + options.actual + ": not compared within the seconds of --max-seconds");
  }
  std::optional<tbb::global_control> threads;
  if (options.threads > 0) {
    threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  }
  return DiffCall(options, console).run();
}

}  // namespace barrido::cli
