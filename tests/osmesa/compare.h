// Differences of two pictures by class of pixel, held against a feature's gate.
#pragma once

#include <string>

#include "tests/osmesa/classify.h"
#include "tests/osmesa/generator.h"

namespace barrido::crosscheck {

struct ClassFigures {
  std::uint64_t pixels = 0;
  std::uint64_t different = 0;                 ///< In any channel, by any amount.
  std::uint64_t excessive = 0;                 ///< By more than the pixel is allowed.
  int worst = 0;                               ///< Largest difference of a channel, in 1/255.
  std::array<std::uint64_t, 256> histogram{};  ///< Pixels by their largest difference.

  ClassFigures& operator+=(const ClassFigures& other);
};

struct Figures {
  std::uint64_t pairs = 0;
  std::uint64_t pixels = 0;
  std::array<ClassFigures, kPixelClasses> by_class;  ///< By PixelClass.
  double worst_depth = 0.0;                          ///< Largest difference of depth in the interior.
  std::uint64_t second_looks = 0;                    ///< Pixels that are right by more exact colours only.
  std::string first_excess;                          ///< The first excessive pixel of the interior, in words.

  Figures& operator+=(const Figures& other);
  const ClassFigures& of(PixelClass kind) const { return by_class[static_cast<std::size_t>(kind)]; }
};

/// With `deep`, a pixel that differs too much from `reference` may be within the gate of that instead, or of
/// the colour in double precision where the rule knows it: then OpenGL itself is off.
Figures compare(const Picture& barrido, const Picture& reference, const std::vector<PixelRule>& rules,
                const Gate& gate, const DeepPicture* deep = nullptr);

/// Pixels of all classes that differ by more than they may.
std::uint64_t excessive_pixels(const Figures& figures);

double per_million(std::uint64_t part, std::uint64_t whole);

/// What is wrong with one pair: its interior. Empty when nothing.
std::string interior_failure(const Figures& figures, const Gate& gate);
/// What is wrong with all pairs of a feature together. Empty when nothing.
std::string feature_failure(const Figures& figures, const Gate& gate);

}  // namespace barrido::crosscheck
