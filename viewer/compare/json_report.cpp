#include "viewer/compare/text_reports.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace barrido::compare {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json facts_json(const std::optional<PictureFacts>& facts, const std::filesystem::path& path) {
  if (path.empty()) return {};
  Json json{{"file", path.generic_string()}};
  if (!facts) return json;
  json["width"] = facts->width;
  json["height"] = facts->height;
  json["channels"] = channels_name(facts->channels);
  json["values"] = facts->is_linear ? "linear floats" : "fractions";
  return json;
}

Json values_json(const std::array<float, 4>& values) {
  Json json = Json::array();
  for (const float value : values) json.push_back(number(value));
  return json;
}

Json figures_json(const Figures& figures) {
  Json json{{"mean", number(figures.mean)},
            {"rms", number(figures.rms)},
            {"psnr_db", number(figures.psnr())},
            {"max", number(figures.max)},
            {"incomparable_values", figures.incomparable},
            {"pixels", figures.pixels},
            {"pixels_over_fail", figures.over_fail},
            {"pixels_over_warn", figures.over_warn}};
  if (figures.max > 0.0) {
    const WorstPixel& worst = figures.worst;
    json["worst"] = {{"x", worst.x},
                     {"y", worst.y},
                     {"channel", std::string(1, "RGBA"[worst.channel])},
                     {"expected", values_json(worst.expected)},
                     {"actual", values_json(worst.actual)}};
  }
  return json;
}

Json flip_json(const FlipFigures& flip) {
  Json json{{"mean", flip.mean}, {"weighted_median", flip.weighted_median}, {"max", flip.max}};
  if (flip.max > 0.0) json["worst"] = {{"x", flip.max_x}, {"y", flip.max_y}};
  if (flip.exposures) {
    json["exposures"] = {
        {"start", flip.exposures->start}, {"stop", flip.exposures->stop}, {"count", flip.exposures->count}};
  }
  return json;
}

Json result_json(const Result& result) {
  Json json{{"name", result.pair.name},
            {"outcome", name_of(result.outcome)},
            {"note", result.note},
            {"expected", facts_json(result.expected, result.pair.expected)},
            {"actual", facts_json(result.actual, result.pair.actual)}};
  if (result.figures) json["figures"] = figures_json(*result.figures);
  if (result.flip) json["flip"] = flip_json(*result.flip);
  return json;
}

Json thresholds_json(const Thresholds& thresholds) {
  return {{"fail", thresholds.fail},
          {"failpercent", thresholds.fail_percent},
          {"allowfailures", thresholds.allow_failures},
          {"hardfail", number(thresholds.hard_fail)},
          {"warn", thresholds.warn},
          {"warnpercent", thresholds.warn_percent},
          {"hardwarn", number(thresholds.hard_warn)},
          {"failflip", number(thresholds.fail_flip)}};
}

}  // namespace

std::string json_report(const Run& run) {
  const Totals totals = totals_of(run);
  Json counts{{"pairs", totals.all()}, {"failed", totals.failed()}};
  for (std::size_t i = 0; i < totals.counts.size(); ++i) {
    counts[std::string(name_of(static_cast<Outcome>(i)))] = totals.counts[i];
  }
  Json json{{"expected", run.expected},
            {"actual", run.actual},
            {"thresholds", thresholds_json(run.settings.thresholds)},
            {"totals", counts},
            {"pairs", Json::array()}};
  for (const std::size_t index : worst_first(run)) json["pairs"].push_back(result_json(run.results[index]));
  // Names of files need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace barrido::compare
