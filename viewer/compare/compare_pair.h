// One pair of files from paths to a result: loading, the same footing, figures, verdict. Everything that can
// be wrong with a file ends here as the pair's result, so that the other pairs of a folder are still
// compared.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "viewer/compare/figures.h"
#include "viewer/compare/find_pairs.h"
#include "viewer/compare/flip.h"

namespace barrido::compare {

struct Settings {
  Thresholds thresholds;
  bool flip = true;  ///< Compute FLIP.
  /// Also of files with the same bytes. Without it they are the same, and only their beginnings are looked
  /// at.
  bool facts = true;
  bool pixels = true;                                 ///< Likewise: a ComparedPair holds the pixels.
  std::uint64_t max_memory = std::uint64_t{4} << 30;  ///< Bytes that the two pictures may take.
};

/// From the best to the worst.
enum class Outcome {
  same,       ///< Within the thresholds.
  warning,    ///< The same, but over the thresholds for warnings.
  added,      ///< Only in the second folder.
  missing,    ///< Only in the first folder.
  different,  ///< Over the thresholds, or of another size.
  error,      ///< A file cannot be read.
};

/// "same", "warning", "added", "missing", "different", "error".
std::string_view name_of(Outcome outcome);

/// What the file says of a picture.
struct PictureFacts {
  int width = 0;
  int height = 0;
  int channels = 0;
  bool is_linear = false;
};

struct Result {
  Pair pair;
  Outcome outcome = Outcome::error;
  std::string note;  ///< Why, in words, where figures do not say it: an error, another size or kind.
  std::optional<PictureFacts> expected, actual;
  std::optional<Figures> figures;
  std::optional<FlipFigures> flip;
};

/// A result with the pixels it came from, which are dropped when the next pair comes.
struct ComparedPair {
  Result result;
  scene::StoredPicture expected, actual;  ///< On the same footing; empty where there is none.
  FlipMap flip;                           ///< Empty without FLIP, and where the pictures are equal.
};

/// Reads and compares. A picture of fractions that meets one of floats is taken to linear light first, and
/// straight colours that meet colours multiplied by alpha are multiplied, too.
ComparedPair compare_pair(const Pair& pair, const Settings& settings);

}  // namespace barrido::compare
