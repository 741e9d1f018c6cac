// A run with one result of each outcome, for the tests of reports.
#pragma once

#include "viewer/compare/run.h"

namespace barrido::compare::test {

inline Result result_of(const std::string& name, Outcome outcome, const std::string& note = "") {
  Result result;
  result.pair = {name, "a/" + name, "b/" + name, "a/" + name};
  result.outcome = outcome;
  result.note = note;
  if (outcome == Outcome::missing) result.pair.actual.clear();
  if (outcome == Outcome::added) result.pair.expected.clear();
  const bool compared =
      outcome == Outcome::same || outcome == Outcome::warning || outcome == Outcome::different;
  if (compared || outcome == Outcome::missing) result.expected = PictureFacts{40, 30, 3, false};
  if (compared || outcome == Outcome::added) result.actual = PictureFacts{40, 30, 4, false};
  if (!compared) return result;
  Figures figures;
  figures.channels = 4;
  figures.pixels = 1200;
  if (outcome != Outcome::same) {
    figures.mean = 0.001;
    figures.rms = 0.01;
    figures.max = 0.5;
    figures.worst = {12, 7, 1, {0.5f, 0.5f, 0.5f, 1}, {0.5f, 1, 0.5f, 1}};
    figures.over_fail = 30;
    figures.over_warn = 60;
  }
  result.figures = figures;
  result.flip = FlipFigures{outcome == Outcome::same ? 0.0 : 0.25, 0.3, 0.9, 3, 4, {}};
  return result;
}

inline Run run_of_all_outcomes() {
  return {"a",
          "b",
          {},
          {result_of("added.png", Outcome::added, "not among the expected pictures"),
           result_of("deep/different.png", Outcome::different),
           result_of("error.png", Outcome::error, "error.png: bad"),
           result_of("missing.png", Outcome::missing, "not among the actual pictures"),
           result_of("same.png", Outcome::same), result_of("warning.png", Outcome::warning)}};
}

}  // namespace barrido::compare::test
