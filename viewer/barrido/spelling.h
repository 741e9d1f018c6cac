// Words that are nearly right: which of the known ones was meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace barrido::cli {

/// Fewest insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (the optimal
/// string alignment distance).
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, the first of several; empty when none is near enough (at most a third of
/// the word's letters, and at least one, may differ).
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// "; did you mean 'phong'?" or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// "one of a, b, c", or "a or b" when there are two.
std::string one_of(std::span<const std::string_view> names);

}  // namespace barrido::cli
