#include "viewer/compare/figures_text.h"

#include <cstdio>

namespace barrido::compare {
namespace {

std::string with_digits(const char* form, double value) {
  char text[64];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

std::string max_text(const Figures& figures) {
  std::string text = "  Max error  = " + figure(figures.max);
  if (figures.max == 0.0) return text + "\n";
  const WorstPixel& worst = figures.worst;
  return text + " @ (" + std::to_string(worst.x) + ", " + std::to_string(worst.y) + ", " +
         std::string(1, "RGBA"[worst.channel]) + ")  values are " +
         values_text(worst.expected, figures.channels) + " vs " +
         values_text(worst.actual, figures.channels) + "\n";
}

std::string over_text(std::uint64_t count, std::uint64_t pixels, double threshold, const char* of) {
  return "  " + std::to_string(count) + " pixels (" + short_figure(percent(count, pixels)) + "%) over " +
         figure(threshold) + of + "\n";
}

}  // namespace

double percent(std::uint64_t part, std::uint64_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string values_text(const std::array<float, 4>& values, int channels) {
  std::string text;
  for (int c = 0; c < channels; ++c) {
    const int channel = channels == 2 && c == 1 ? 3 : c;  // of grey and alpha
    text += (c > 0 ? ", " : "") +
            with_digits("%.8g", static_cast<double>(values[static_cast<std::size_t>(channel)]));
  }
  return text;
}

std::string short_figure(double value) { return with_digits("%.3g", value); }

std::string figure(double value) { return with_digits("%.6g", value); }

std::string figures_text(const Result& result, const Thresholds& thresholds) {
  std::string text;
  if (!result.note.empty()) text += "  " + result.note + "\n";
  if (!result.figures) return text;
  const Figures& figures = *result.figures;
  text += "  Mean error = " + figure(figures.mean) + "\n";
  text += "  RMS error  = " + figure(figures.rms) + "\n";
  text += "  Peak SNR   = " + figure(figures.psnr()) + "\n";
  text += max_text(figures);
  if (figures.incomparable > 0) {
    text += "  " + std::to_string(figures.incomparable) + (figures.incomparable == 1 ? " value" : " values") +
            " where a NaN or an infinity meets something else: no mean\n";
  }
  // As long as both thresholds are the same one line says it.
  if (thresholds.warn != thresholds.fail) {
    text += over_text(figures.over_warn, figures.pixels, thresholds.warn, " (warn)");
    text += over_text(figures.over_fail, figures.pixels, thresholds.fail, " (fail)");
  } else {
    text += over_text(figures.over_fail, figures.pixels, thresholds.fail, "");
  }
  if (!result.flip) return text;
  return text + "  FLIP mean  = " + figure(result.flip->mean) + ", weighted median " +
         figure(result.flip->weighted_median) + ", max " + figure(result.flip->max) + "\n";
}

std::string headline(const Result& result) {
  std::string text(name_of(result.outcome));
  const auto add = [&](const std::string& what) {
    text += (text.find(':') == std::string::npos ? ": " : ", ") + what;
  };
  if (!result.note.empty()) add(result.note);
  if (!result.figures || result.figures->max == 0.0) return text;
  const Figures& figures = *result.figures;
  add("max " + figure(figures.max) + " at (" + std::to_string(figures.worst.x) + ", " +
      std::to_string(figures.worst.y) + ")");
  add(short_figure(percent(figures.over_fail, figures.pixels)) + "% of the pixels");
  if (result.flip) add("FLIP " + with_digits("%.4g", result.flip->mean));
  return text;
}

}  // namespace barrido::compare
