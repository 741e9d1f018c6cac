#include "viewer/barrido/diff_options.h"

#include <array>
#include <vector>

#include "viewer/barrido/spelling.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

using Options = DiffOptions;
using Text = std::string_view;

constexpr auto kFlag = OptionKind::flag;
constexpr auto kValue = OptionKind::value;
constexpr double kMostPercent = 100.0;

double parse_difference(Text text) { return parse_number(text, 0.0, kAnyNumber); }
double parse_percent(Text text) { return parse_number(text, 0.0, kMostPercent); }

struct DiffOption {
  OptionSyntax syntax;
  /// Reads the value (empty for a flag). @throws ValueError.
  void (*apply)(Options& options, Text value);
};

constexpr DiffOption kTable[] = {
    {{"Thresholds", "--fail", "", kValue, "VAL",
      "A pixel fails when one of its values differs by more than VAL. Default 1e-06."},
     [](Options& o, Text text) { o.settings.thresholds.fail = parse_difference(text); }},
    {{"Thresholds", "--failpercent", "", kValue, "PERCENT",
      "Allow so many percent of the pixels to fail. Default 0."},
     [](Options& o, Text text) { o.settings.thresholds.fail_percent = parse_percent(text); }},
    {{"Thresholds", "--allowfailures", "", kValue, "N", "Allow N pixels to fail. Default 0."},
     [](Options& o, Text text) {
       o.settings.thresholds.allow_failures = static_cast<std::uint64_t>(parse_whole(text, 0, 1 << 30));
     }},
    {{"Thresholds", "--hardfail", "", kValue, "VAL",
      "Different if any pixel differs by more than VAL, whatever is allowed above."},
     [](Options& o, Text text) { o.settings.thresholds.hard_fail = parse_difference(text); }},
    {{"Thresholds", "--failflip", "", kValue, "MEAN",
      "Different if the mean of FLIP, 0..1, is more than MEAN: what a person sees of the difference."},
     [](Options& o, Text text) { o.settings.thresholds.fail_flip = parse_number(text, 0.0, 1.0); }},
    {{"Thresholds", "--warn", "", kValue, "VAL", "As --fail, but only for a warning. Default 1e-06."},
     [](Options& o, Text text) { o.settings.thresholds.warn = parse_difference(text); }},
    {{"Thresholds", "--warnpercent", "", kValue, "PERCENT", "As --failpercent, for a warning."},
     [](Options& o, Text text) { o.settings.thresholds.warn_percent = parse_percent(text); }},
    {{"Thresholds", "--hardwarn", "", kValue, "VAL", "As --hardfail, for a warning."},
     [](Options& o, Text text) { o.settings.thresholds.hard_warn = parse_difference(text); }},
    {{"Output", "--output", "-o", kValue, "DIFFIMAGE",
      "Write the difference A - B of two pictures; by its extension png, exr and more. It is written even "
      "when nothing differs."},
     [](Options& o, Text text) { o.output = text; }},
    {{"Output", "--abs", "", kFlag, "", "For -o: the absolute value |A - B|."},
     [](Options& o, Text) { o.difference.absolute = true; }},
    {{"Output", "--scale", "", kValue, "FACTOR", "For -o: the difference times FACTOR."},
     [](Options& o, Text text) { o.difference.scale = static_cast<float>(parse_number(text, 0.0, 1e9)); }},
    {{"Output", "--html", "", kValue, "DIR",
      "Write DIR/index.html, one file that needs no other and no network: a table, worst first, and for each "
      "pair expected, actual, amplified difference and FLIP, with slider, blink and lens."},
     [](Options& o, Text text) { o.html = text; }},
    {{"Output", "--junit", "", kValue, "FILE", "Write JUnit XML for a CI system; - is standard output."},
     [](Options& o, Text text) { o.junit = text; }},
    {{"Output", "--json", "", kValue, "FILE", "Write all figures as JSON; - is standard output."},
     [](Options& o, Text text) { o.json = text; }},
    {{"Output", "--quiet", "-q", kFlag, "", "Print nothing but errors."},
     [](Options& o, Text) { o.quiet = true; }},
    {{"Execution", "--bless", "", kFlag, "",
      "Make what differs or is new the expected picture: copy it from B over A's, file by file, and tell "
      "which. Nothing is deleted; what is within the thresholds stays as it is. A need not exist."},
     [](Options& o, Text) { o.bless = true; }},
    {{"Execution", "--max-memory", "", kValue, "SIZE",
      "Take no more memory than SIZE, as 512M or 4G. Default: 4G for the pictures of a pair."},
     [](Options& o, Text text) {
       o.limits.max_memory = parse_memory(text);
       o.settings.max_memory = *o.limits.max_memory;
     }},
    {{"Execution", "--max-seconds", "", kValue, "N", "End after N seconds. Default: never."},
     [](Options& o, Text text) { o.limits.max_seconds = parse_seconds(text); }},
    {{"Execution", "--threads", "", kValue, "N",
      "Use N threads, 1..1024. Default: all. Never changes a figure."},
     [](Options& o, Text text) { o.threads = parse_whole(text, 1, 1024); }},
    {{"Execution", "--no-flip", "", kFlag, "", "Leave out FLIP, which takes most of the time."},
     [](Options& o, Text) { o.settings.flip = false; }},
    {{"Execution", "--help", "-h", kFlag, "", "This text."}, [](Options& o, Text) { o.help = true; }},
};

constexpr auto kSyntax = [] {
  std::array<OptionSyntax, std::size(kTable)> syntax{};
  for (std::size_t i = 0; i < syntax.size(); ++i) syntax[i] = kTable[i].syntax;
  return syntax;
}();

/// "-failpercent" to "--failpercent", also with "=1" behind it, and what is nearly such an option, so that
/// the right spelling is proposed.
std::string with_two_dashes(const std::string& word) {
  if (word.size() < 3 || word[0] != '-' || word[1] == '-') return word;
  std::vector<std::string_view> names;
  names.reserve(kSyntax.size());
  for (const OptionSyntax& option : kSyntax) names.push_back(option.name);
  const std::string longer = "-" + word;
  return nearest(longer.substr(0, longer.find('=')), names).empty() ? word : longer;
}

std::vector<std::string> with_two_dashes(std::span<const std::string> words) {
  std::vector<std::string> normalized;
  normalized.reserve(words.size());
  bool options_ended = false;
  for (const std::string& word : words) {
    options_ended = options_ended || word == "--";
    normalized.push_back(options_ended ? word : with_two_dashes(word));
  }
  return normalized;
}

void apply(DiffOptions& options, const GivenOption& given) {
  const DiffOption& option = kTable[given.index];
  try {
    option.apply(options, given.value);
  } catch (const ValueError& error) {
    throw UsageError(std::string(option.syntax.name) + ": '" + given.value + "': " + error.what());
  }
}

void check(const DiffOptions& options, std::size_t files) {
  if (files != 2) {
    throw UsageError(
        "diff: needs two pictures or two folders, A (expected) and B (actual); see barrido diff --help");
  }
  if (options.expected.empty() || options.actual.empty()) throw UsageError("diff: a file with an empty name");
  if (options.html == "-") throw UsageError("--html: '-': expected a folder");
  if (options.junit == "-" && options.json == "-") {
    throw UsageError("--junit: '-': standard output cannot hold JSON as well");
  }
  const bool scaled = options.difference.absolute || options.difference.scale != 1.0f;
  if (scaled && options.output.empty()) {
    throw UsageError(std::string(options.difference.absolute ? "--abs" : "--scale") + ": only with --output");
  }
  const bool flip_wanted = options.settings.thresholds.fail_flip <= 1.0;
  if (flip_wanted && !options.settings.flip)
    throw UsageError("--failflip: cannot be used together with --no-flip");
}

}  // namespace

std::span<const OptionSyntax> diff_syntax() { return kSyntax; }

DiffOptions parse_diff_options(std::span<const std::string> words) {
  const Arguments arguments = parse_arguments(kSyntax, with_two_dashes(words));
  DiffOptions options;
  for (const GivenOption& given : arguments.options) {
    if (kTable[given.index].syntax.name == "--help") options.help = true;
  }
  if (options.help) return options;
  for (const GivenOption& given : arguments.options) apply(options, given);
  if (arguments.files.size() == 2) {
    options.expected = arguments.files[0];
    options.actual = arguments.files[1];
  }
  check(options, arguments.files.size());
  return options;
}

}  // namespace barrido::cli
