// barrido-crosscheck: draws scene pairs with Barrido and with OSMesa and holds the differences against the
// gates of each feature. Exit status 0 when all gates hold, 1 when one does not, 2 on bad options or when
// OSMesa fails.
#include <charconv>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "tests/osmesa/gl_renderer.h"
#include "tests/osmesa/report.h"

namespace barrido::crosscheck {
namespace {

constexpr const char* kUsage =
    "usage: barrido-crosscheck [--pairs N] [--seed S] [--feature F] [--out DIR] [--table FILE]\n"
    "  --pairs N      scenes to draw, over all features in turn (250)\n"
    "  --seed S       seed of the first scene; the next one's is S + 1 (1)\n"
    "  --feature F    only this feature\n"
    "  --out DIR      where pictures of failures go (crosscheck)\n"
    "  --table FILE   write the table of all features\n"
    "features:\n";

struct Options {
  std::uint64_t pairs = 250;
  std::uint64_t seed = 1;
  std::optional<std::size_t> feature;
  std::filesystem::path out = "crosscheck";
  std::filesystem::path table;
};

std::uint64_t number_of(std::string_view option, std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::invalid_argument(std::string(option) + ": '" + std::string(text) + "' is not a number");
  }
  return value;
}

std::size_t feature_of(std::string_view name) {
  for (std::size_t i = 0; i < features().size(); ++i) {
    if (features()[i].name == name) return i;
  }
  throw std::invalid_argument("--feature: there is no '" + std::string(name) + "'; --help lists them");
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    if (i + 1 == argc) throw std::invalid_argument(std::string(name) + ": a value is missing");
    const std::string_view value = argv[i + 1];
    if (name == "--pairs") {
      options.pairs = number_of(name, value);
    } else if (name == "--seed") {
      options.seed = number_of(name, value);
    } else if (name == "--feature") {
      options.feature = feature_of(value);
    } else if (name == "--out") {
      options.out = value;
    } else if (name == "--table") {
      options.table = value;
    } else {
      throw std::invalid_argument("unknown option " + std::string(name));
    }
  }
  return options;
}

/// Draws one pair; a failure of its interior is printed, with pictures.
Figures run_pair(GlRenderer& reference, const Feature& feature, std::uint64_t seed, const Options& options,
                 int& failures) {
  const ScenePair pair = make_pair(feature, seed);
  const Picture actual = draw_with_barrido(pair);
  const Picture expected = reference.draw(pair);
  const std::vector<PixelRule> rules = classify(pair);
  Figures figures = compare(actual, expected, rules, feature.gate);
  if (excessive_pixels(figures) > 0) {
    const DeepPicture deep = reference.draw_deep(pair);
    figures = compare(actual, expected, rules, feature.gate, &deep);
  }
  const std::string failure = interior_failure(figures, feature.gate);
  if (!failure.empty() || options.pairs == 1) {
    write_pictures(options.out, slug(feature.name) + "-" + std::to_string(seed), expected, actual);
  }
  if (!failure.empty() && ++failures <= 50) {
    std::printf("FAILED --feature \"%s\" --seed %llu --pairs 1: %s\n", feature.name,
                static_cast<unsigned long long>(seed), failure.c_str());
  }
  return figures;
}

struct Worst {
  std::uint64_t seed = 0;
  std::uint64_t excessive = 0;
};

int run(const Options& options) {
  GlRenderer reference;
  const std::vector<Feature> list = features_against(reference.description());
  std::vector<Figures> totals(list.size());
  std::vector<Worst> worst(list.size());
  int failures = 0;
  for (std::uint64_t i = 0; i < options.pairs; ++i) {
    const std::size_t f = options.feature.value_or(i % list.size());
    const Figures figures = run_pair(reference, list[f], options.seed + i, options, failures);
    const std::uint64_t excessive =
        figures.of(PixelClass::edge).excessive + figures.of(PixelClass::tie).excessive;
    if (excessive > worst[f].excessive) worst[f] = {options.seed + i, excessive};
    totals[f] += figures;
  }
  for (std::size_t f = 0; f < totals.size(); ++f) {
    const std::string failure = feature_failure(totals[f], list[f].gate);
    if (failure.empty()) continue;
    ++failures;
    std::printf("FAILED %s, all %llu pairs: %s; most in --seed %llu --pairs 1\n", list[f].name,
                static_cast<unsigned long long>(totals[f].pairs), failure.c_str(),
                static_cast<unsigned long long>(worst[f].seed));
  }
  if (!options.table.empty()) {
    write_table(options.table, list, totals, reference.description(),
                "barrido-crosscheck --pairs " + std::to_string(options.pairs) + " --seed " +
                    std::to_string(options.seed) + " --table " + options.table.generic_string());
  }
  std::printf("%llu pairs against %s: %d failed\n", static_cast<unsigned long long>(options.pairs),
              reference.description().c_str(), failures);
  return failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace barrido::crosscheck

int main(int argc, char** argv) {
  using namespace barrido::crosscheck;
  if (argc == 2 && std::string_view(argv[1]) == "--help") {
    std::printf("%s", kUsage);
    for (const Feature& feature : features()) std::printf("  %s\n", feature.name);
    return 0;
  }
  try {
    return run(parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "barrido-crosscheck: %s\n", error.what());
    return 2;
  }
}
