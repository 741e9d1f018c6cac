// Two pictures of any size, kind and numbers, and any thresholds, through the comparison and its reports.
#include <cmath>

#include "input.h"
#include "viewer/compare/compare_pair.h"
#include "viewer/compare/difference_picture.h"
#include "viewer/compare/false_color.h"
#include "viewer/compare/figures_text.h"
#include "viewer/compare/html_page.h"
#include "viewer/compare/report_pictures.h"
#include "viewer/compare/same_footing.h"
#include "viewer/compare/text_reports.h"

namespace barrido::fuzz {
namespace {

constexpr int kMaxSide = 20;

/// As files give them: fractions in 0..1, or floats of which only NaN and infinities are beyond a file's.
scene::StoredPicture any_picture(Input& input) {
  scene::StoredPicture picture;
  picture.width = input.between(1, kMaxSide);
  picture.height = input.between(1, kMaxSide);
  picture.channels = input.between(1, 4);
  picture.is_linear = input.flag();
  picture.is_associated = picture.is_linear && input.flag();
  const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.rgba.resize(pixels * 4);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    float* rgba = picture.rgba.data() + pixel * 4;
    for (int c = 0; c < 4; ++c) rgba[c] = picture.is_linear ? input.number() : input.fraction();
    if (picture.channels < 3) rgba[1] = rgba[2] = rgba[0];
    if (picture.channels % 2 == 1) rgba[3] = 1.0f;
  }
  return picture;
}

/// As the command line lets them pass: not negative, no NaN.
double any_threshold(Input& input) {
  const float value = std::fabs(input.number());
  return std::isnan(value) ? compare::kUnlimited : static_cast<double>(value);
}

compare::Thresholds any_thresholds(Input& input) {
  compare::Thresholds thresholds;
  for (double* value : {&thresholds.fail, &thresholds.fail_percent, &thresholds.hard_fail, &thresholds.warn,
                        &thresholds.warn_percent, &thresholds.hard_warn, &thresholds.fail_flip}) {
    *value = any_threshold(input);
  }
  thresholds.allow_failures = input.bits32();
  return thresholds;
}

void check_figures(const compare::Figures& figures, const scene::StoredPicture& a,
                   const scene::StoredPicture& b) {
  const std::uint64_t pixels = figures.pixels;
  require(figures.over_zero <= pixels && figures.over_fail <= pixels && figures.over_warn <= pixels,
          "more pixels differ than there are");
  // A NaN or an infinity that meets something else leaves no mean.
  require(figures.incomparable > 0 ||
              (!std::isnan(figures.mean) && !std::isnan(figures.rms) && !std::isnan(figures.max)),
          "a figure is no number");
  const auto& worst = figures.worst;
  require(worst.x >= 0 && worst.x < std::max(a.width, b.width) && worst.y >= 0 &&
              worst.y < std::max(a.height, b.height),
          "the worst pixel lies outside");
}

void check_flip(const compare::FlipMap& map) {
  for (const float error : map.errors) {
    require(error >= 0.0f && error <= 1.0f, "FLIP's error is not in 0..1");
    compare::false_color(error);
  }
  require(map.figures.mean >= 0.0 && map.figures.mean <= 1.0, "FLIP's mean is not in 0..1");
}

std::string any_name(Input& input) {
  const Bytes bytes = input.take(input.between(0, 24));
  return {bytes.begin(), bytes.end()};
}

void report(Input& input, compare::ComparedPair&& pair, const compare::Settings& settings) {
  compare::figures_text(pair.result, settings.thresholds);
  compare::headline(pair.result);
  compare::Run run{any_name(input), any_name(input), settings, {}};
  const compare::ReportPictures pictures = compare::report_pictures(pair);
  const std::vector<compare::Shown> shown{{"a", "b", "c", "d", pictures.amplification, pictures.exposure}};
  run.results.push_back(std::move(pair.result));
  compare::json_report(run);
  compare::junit_report(run);
  compare::page_before_pictures(run);
  compare::page_after_pictures(run, shown);
}

}  // namespace

void run_diff(Bytes bytes) {
  Input input(bytes);
  compare::Settings settings{any_thresholds(input), input.flag()};
  compare::DifferenceOptions options{input.flag(), input.number()};
  compare::ComparedPair pair;
  pair.result.pair.name = any_name(input);
  pair.result.note = any_name(input);
  pair.expected = any_picture(input);
  pair.actual = input.byte() < 32 ? pair.expected : any_picture(input);
  compare::difference_picture(pair.expected, pair.actual, options);
  compare::put_on_same_footing(pair.expected, pair.actual);
  const compare::Figures figures = compare::measure(pair.expected, pair.actual, settings.thresholds);
  check_figures(figures, pair.expected, pair.actual);
  if (settings.flip && figures.max != 0.0) {
    pair.flip = compare::flip(pair.expected, pair.actual);
    check_flip(pair.flip);
    pair.result.flip = pair.flip.figures;
  }
  const bool same = compare::judge(figures, settings.thresholds) == compare::Verdict::same;
  pair.result.outcome = same ? compare::Outcome::same : compare::Outcome::different;
  pair.result.figures = figures;
  report(input, std::move(pair), settings);
}

}  // namespace barrido::fuzz
