#include "viewer/compare/compare_pair.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include "pipeline/files/error.h"
#include "pipeline/pictures/format.h"
#include "pipeline/pictures/read.h"
#include "viewer/compare/same_footing.h"

namespace barrido::compare {
namespace {

using scene::StoredPicture;

PictureFacts facts_of(const StoredPicture& picture) {
  return {picture.width, picture.height, picture.channels, picture.is_linear};
}

std::string size_text(const StoredPicture& picture) {
  return std::to_string(picture.width) + " x " + std::to_string(picture.height);
}

void add_sentence(std::string& text, const std::string& sentence) {
  text += (text.empty() ? "" : "; ") + sentence;
}

/// What figures alone would not tell.
std::string note_on(const StoredPicture& expected, const StoredPicture& actual) {
  std::string note;
  if (expected.width != actual.width || expected.height != actual.height) {
    add_sentence(note, "size " + size_text(expected) + " expected, " + size_text(actual) + " found");
  }
  if (expected.channels != actual.channels) {
    add_sentence(note, std::string(channels_name(expected.channels)) + " expected, " +
                           channels_name(actual.channels) + " found");
  }
  if (expected.is_linear != actual.is_linear) {
    add_sentence(note, "bytes and floats, compared in linear light");
  }
  return note;
}

Outcome outcome_of(Verdict verdict) {
  if (verdict == Verdict::different) return Outcome::different;
  return verdict == Verdict::warning ? Outcome::warning : Outcome::same;
}

void compare_pictures(ComparedPair& pair, const Settings& settings) {
  Result& result = pair.result;
  result.note = note_on(pair.expected, pair.actual);
  put_on_same_footing(pair.expected, pair.actual);
  result.figures = measure(pair.expected, pair.actual, settings.thresholds);
  const bool equal = result.figures->max == 0.0;
  if (settings.flip && equal) result.flip = FlipFigures{};
  if (settings.flip && !equal) {
    pair.flip = flip(pair.expected, pair.actual);
    result.flip = pair.flip.figures;
  }
  const bool same_size =
      pair.expected.width == pair.actual.width && pair.expected.height == pair.actual.height;
  result.outcome = same_size ? outcome_of(judge(*result.figures, settings.thresholds)) : Outcome::different;
  if (result.flip && result.flip->mean > settings.thresholds.fail_flip) result.outcome = Outcome::different;
}

/// @return false when there is a file that cannot be read; the reason is added to `note`.
bool load(const std::filesystem::path& path, StoredPicture& picture, std::optional<PictureFacts>& facts,
          std::string& note, scene::Budget& budget) {
  if (path.empty()) return true;
  try {
    scene::ImageLimits limits;
    limits.budget = &budget;
    picture = scene::read_stored_picture(path, limits);
    facts = facts_of(picture);
    return true;
  } catch (const scene::InputError& error) {
    add_sentence(note, error.what());
    return false;
  }
}

/// Whether both files hold the same bytes, which begin as a picture does that can be read.
bool hold_same_bytes(const Pair& pair) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (pair.expected.empty() || pair.actual.empty()) return false;
  if (!fs::is_regular_file(pair.expected, error) || !fs::is_regular_file(pair.actual, error)) return false;
  if (fs::file_size(pair.expected, error) != fs::file_size(pair.actual, error) || error) return false;
  std::ifstream a(pair.expected, std::ios::binary), b(pair.actual, std::ios::binary);
  std::array<char, 1 << 16> from_a{}, from_b{};
  for (bool first = true; a && b; first = false) {
    a.read(from_a.data(), from_a.size());
    b.read(from_b.data(), from_b.size());
    const std::streamsize count = a.gcount();
    if (count != b.gcount() || !std::equal(from_a.begin(), from_a.begin() + count, from_b.begin()))
      return false;
    if (!first) continue;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(from_a.data());
    const auto* format = scene::format_by_content({bytes, static_cast<std::size_t>(count)}, pair.expected);
    if (format == nullptr || !format->is_read) return false;
  }
  return a.eof() && b.eof();
}

/// Of equal pictures; nothing need be compared.
Figures figures_of_equal(const StoredPicture& picture) {
  Figures figures;
  figures.channels = picture.channels;
  figures.pixels = static_cast<std::uint64_t>(picture.width) * static_cast<std::uint64_t>(picture.height);
  return figures;
}

}  // namespace

std::string_view name_of(Outcome outcome) {
  constexpr std::array<std::string_view, 6> kNames{"same",    "warning",   "added",
                                                   "missing", "different", "error"};
  return kNames[static_cast<std::size_t>(outcome)];
}

ComparedPair compare_pair(const Pair& pair, const Settings& settings) {
  ComparedPair compared;
  Result& result = compared.result;
  result.pair = pair;
  constexpr double kNever = 1e9;
  scene::Budget budget({settings.max_memory, kNever});
  if (!settings.pixels && hold_same_bytes(pair)) {
    result.outcome = Outcome::same;
    if (!settings.facts) return compared;
    if (load(pair.expected, compared.expected, result.expected, result.note, budget)) {
      result.actual = result.expected;
      result.figures = figures_of_equal(compared.expected);
      if (settings.flip) result.flip = FlipFigures{};
    } else {
      result.outcome = Outcome::error;
    }
    compared.expected = {};
    return compared;
  }
  const bool expected_read = load(pair.expected, compared.expected, result.expected, result.note, budget);
  const bool actual_read = load(pair.actual, compared.actual, result.actual, result.note, budget);
  if (!expected_read || !actual_read) return compared;
  if (result.expected && result.actual) {
    compare_pictures(compared, settings);
  } else {
    result.outcome = result.expected ? Outcome::missing : Outcome::added;
    result.note = result.expected ? "not among the actual pictures" : "not among the expected pictures";
  }
  return compared;
}

}  // namespace barrido::compare
