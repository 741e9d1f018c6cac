#include "viewer/compare/run.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace barrido::compare {
namespace {

constexpr Outcome kWorstFirst[] = {Outcome::error, Outcome::different, Outcome::missing,
                                   Outcome::added, Outcome::warning,   Outcome::same};

/// Greater is worse. Another size is worse than any figure over what both cover.
double badness(const Result& result) {
  const auto &a = result.expected, &b = result.actual;
  if (a && b && (a->width != b->width || a->height != b->height)) return kUnlimited;
  if (result.figures && result.figures->incomparable > 0) return kUnlimited;
  if (result.flip) return result.flip->mean;
  return result.figures ? result.figures->rms : 0.0;
}

}  // namespace

std::size_t Totals::all() const { return std::accumulate(counts.begin(), counts.end(), std::size_t{0}); }

std::size_t Totals::failed() const { return all() - (*this)[Outcome::same] - (*this)[Outcome::warning]; }

Totals totals_of(const Run& run) {
  Totals totals;
  for (const Result& result : run.results) ++totals.counts[static_cast<std::size_t>(result.outcome)];
  return totals;
}

std::vector<std::size_t> worst_first(const Run& run) {
  std::vector<std::size_t> order(run.results.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // The outcomes stand from the best to the worst.
  const auto key = [&](std::size_t i) {
    const Result& result = run.results[i];
    return std::tuple(-static_cast<int>(result.outcome), -badness(result));
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

std::string totals_text(const Totals& totals) {
  std::string text = std::to_string(totals.all()) + (totals.all() == 1 ? " pair: " : " pairs: ");
  bool first = true;
  for (const Outcome outcome : kWorstFirst) {
    if (totals[outcome] == 0) continue;
    text += (first ? "" : ", ") + std::to_string(totals[outcome]) + " " + std::string(name_of(outcome));
    first = false;
  }
  return text;
}

}  // namespace barrido::compare
