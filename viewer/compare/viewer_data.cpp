#include "viewer/compare/viewer_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "viewer/compare/figures_text.h"

namespace barrido::compare {
namespace {

using Json = nlohmann::ordered_json;

std::string size_text(const PictureFacts& facts) {
  return std::to_string(facts.width) + " × " + std::to_string(facts.height) + " " +
         channels_name(facts.channels) + (facts.is_linear ? " floats" : "");
}

std::string facts_text(const Result& result, const Shown& shown) {
  const auto& facts = result.actual ? result.actual : result.expected;
  std::string text = facts ? size_text(*facts) : "";
  if (facts && facts->is_linear && shown.exposure != 0.0) {
    text += ", shown at " + short_figure(shown.exposure) + " stops";
  }
  return text;
}

/// Terms and values beside the lens.
Json figures_list(const Result& result) {
  Json list = Json::array();
  if (result.flip) {
    list.push_back({"FLIP mean", figure(result.flip->mean)});
    list.push_back({"FLIP weighted median", figure(result.flip->weighted_median)});
    list.push_back({"FLIP max", figure(result.flip->max)});
  }
  if (!result.figures) return list;
  const Figures& figures = *result.figures;
  list.push_back({"mean error", figure(figures.mean)});
  list.push_back({"RMS error", figure(figures.rms)});
  list.push_back({"PSNR", std::isinf(figures.psnr()) ? "∞" : figure(figures.psnr()) + " dB"});
  list.push_back({"max error", figure(figures.max)});
  list.push_back({"pixels over warn", std::to_string(figures.over_warn)});
  list.push_back({"pixels over fail", std::to_string(figures.over_fail)});
  list.push_back({"pixels", std::to_string(figures.pixels)});
  return list;
}

/// Whether all values are those of bytes, which the viewer shows anyway.
bool are_bytes(const std::array<float, 4>& values) {
  return std::all_of(values.begin(), values.end(), [](float value) {
    const float byte = value * 255.0f;
    return value >= 0.0f && value <= 1.0f && std::fabs(byte - std::round(byte)) < 1e-3f;
  });
}

Json worst_json(const Figures& figures) {
  const WorstPixel& worst = figures.worst;
  return {{"x", worst.x},
          {"y", worst.y},
          {"exact", !are_bytes(worst.expected) || !are_bytes(worst.actual)},
          {"expected", values_text(worst.expected, figures.channels)},
          {"actual", values_text(worst.actual, figures.channels)}};
}

Json pair_json(const Result& result, const Shown& shown) {
  Json json{{"name", result.pair.name},
            {"outcome", name_of(result.outcome)},
            {"note", result.note},
            {"facts", facts_text(result, shown)},
            {"figures", figures_list(result)},
            {"amplification", shown.amplification},
            {"pictures",
             {{"expected", shown.expected},
              {"actual", shown.actual},
              {"difference", shown.difference},
              {"flip", shown.flip}}}};
  if (result.figures && result.figures->max > 0.0) json["worst"] = worst_json(*result.figures);
  return json;
}

}  // namespace

std::string viewer_data(const Run& run, const std::vector<Shown>& shown) {
  Json json = Json::array();
  for (const std::size_t index : worst_first(run))
    json.push_back(pair_json(run.results[index], shown[index]));
  std::string escaped;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    escaped += c == '<' ? "\\u003c" : std::string(1, c);
  }
  return escaped;
}

}  // namespace barrido::compare
