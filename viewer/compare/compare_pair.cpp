#include "viewer/compare/compare_pair.h"

#include <array>

#include "pipeline/files/error.h"
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
