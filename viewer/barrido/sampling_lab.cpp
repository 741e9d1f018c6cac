#include "viewer/barrido/sampling_lab.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "pipeline/scene/names.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

constexpr int kReferenceSide = 32;
constexpr int kSides[] = {1, 2, 3, 4, 5, 6, 8, 10, 12, 16};
constexpr float kThresholds[] = {0.4f, 0.2f, 0.1f, 0.05f, 0.02f, 0.01f};

using Floats = raster::PixelArray<float>;

double rms(const Floats& a, const Floats& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (i % 4 == 3) continue;
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    squares += difference * difference;
  }
  return std::sqrt(squares / std::max<double>(1.0, static_cast<double>(a.size()) * 0.75));
}

/// Of the points that have an error.
double slope_of(const std::vector<SamplingPoint>& points) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const SamplingPoint& p : points) {
    if (!(p.error > 0.0)) continue;
    const double u = std::log(p.samples), v = 2.0 * std::log(p.error);
    n += 1.0;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  const double spread = n * xx - x * x;
  return spread > 0.0 ? (n * xy - x * y) / spread : 0.0;
}

SamplingCurve measure_grid(scene::SceneRenderer& renderer, scene::RenderSettings settings,
                           scene::Sampling sampling, const Floats& reference) {
  SamplingCurve curve{std::string(name_of(sampling)), {}, 0.0};
  settings.samples.sampling = sampling;
  for (const int side : kSides) {
    settings.samples.count = side * side;
    const raster::Framebuffer frame = renderer.render(settings);
    curve.points.push_back({static_cast<double>(side) * side, rms(frame.color_float(), reference)});
  }
  curve.slope = slope_of(curve.points);
  return curve;
}

SamplingCurve measure_adaptive(scene::SceneRenderer& renderer, scene::RenderSettings settings,
                               const Floats& reference) {
  SamplingCurve curve{"adaptive", {}, 0.0};
  settings.samples.sampling = scene::Sampling::adaptive;
  settings.samples.adaptive_depth = 3;
  for (const float threshold : kThresholds) {
    settings.samples.adaptive_threshold = threshold;
    raster::SampleReport report;
    report.counts.resize(reference.size() / 4);
    report.slivers.resize(reference.size() / 4);
    settings.sample_report = &report;
    const raster::Framebuffer frame = renderer.render(settings);
    double samples = 0.0;
    for (const std::uint16_t count : report.counts) samples += count;
    curve.points.push_back(
        {samples / static_cast<double>(report.counts.size()), rms(frame.color_float(), reference)});
  }
  curve.slope = slope_of(curve.points);
  return curve;
}

/// Places of the plot's numbers, both axes logarithmic.
struct Plot {
  double least_samples = 1.0, most_samples = 256.0, least = 1e-4, most = 1.0;

  double x(double samples) const {
    return 70.0 + 520.0 * std::log(samples / least_samples) / std::log(most_samples / least_samples);
  }
  double y(double error) const {
    return 20.0 + 320.0 * std::log(most / std::max(error, least)) / std::log(most / least);
  }
};

std::string line(double x0, double y0, double x1, double y1, const char* color) {
  return "<line x1='" + fixed(x0, 1) + "' y1='" + fixed(y0, 1) + "' x2='" + fixed(x1, 1) + "' y2='" +
         fixed(y1, 1) + "' stroke='" + color + "'/>\n";
}

std::string text(double x, double y, const std::string& words, const char* anchor = "middle",
                 const char* color = "#222") {
  std::string escaped;
  for (const char c : words) {
    escaped += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return "<text x='" + fixed(x, 1) + "' y='" + fixed(y, 1) + "' text-anchor='" + anchor + "' fill='" + color +
         "'>" + escaped + "</text>\n";
}

std::string draw_axes(const Plot& plot) {
  std::string svg;
  for (double samples = 1.0; samples <= plot.most_samples; samples *= 4.0) {
    svg += line(plot.x(samples), 20, plot.x(samples), 340, "#ddd");
    svg += text(plot.x(samples), 358, fixed(samples, 0));
  }
  for (double error = plot.most; error >= plot.least * 0.999; error /= 10.0) {
    svg += line(70, plot.y(error), 590, plot.y(error), "#ddd");
    svg += text(64, plot.y(error) + 4, shortest_double(error), "end");
  }
  return svg + text(330, 376, "samples a pixel") +
         text(74, 14, "root mean square error of linear light", "start");
}

std::string draw_curve(const Plot& plot, const SamplingCurve& curve, const char* color, int number) {
  std::string points;
  for (const SamplingPoint& p : curve.points) {
    if (p.error > 0.0) points += fixed(plot.x(p.samples), 1) + "," + fixed(plot.y(p.error), 1) + " ";
  }
  return "<polyline fill='none' stroke-width='2' stroke='" + std::string(color) + "' points='" + points +
         "'/>\n" + text(580, 40 + 18 * number, curve.name + ", slope " + fixed(curve.slope, 2), "end", color);
}

}  // namespace

SamplingFigures measure_sampling(scene::SceneRenderer& renderer, scene::RenderSettings settings) {
  settings.keep_float = true;
  SamplingFigures figures;
  figures.width = settings.width;
  figures.height = settings.height;
  figures.reference_samples = kReferenceSide * kReferenceSide;
  settings.samples.sampling = scene::Sampling::uniform;
  settings.samples.count = figures.reference_samples;
  const raster::Framebuffer reference = renderer.render(settings);
  using scene::Sampling;
  figures.curves.push_back(measure_grid(renderer, settings, Sampling::uniform, reference.color_float()));
  figures.curves.push_back(measure_grid(renderer, settings, Sampling::jittered, reference.color_float()));
  const scene::SampleChoice& choice = settings.samples;
  if (!choice.moves() && !choice.has_lens() && choice.filter == raster::PixelFilter{}) {
    figures.curves.push_back(measure_adaptive(renderer, settings, reference.color_float()));
  }
  return figures;
}

std::string figures_json(const SamplingFigures& figures, const std::string& model) {
  nlohmann::ordered_json json{{"model", model},
                              {"width", figures.width},
                              {"height", figures.height},
                              {"referenceSamples", figures.reference_samples},
                              {"patterns", nlohmann::ordered_json::array()}};
  for (const SamplingCurve& curve : figures.curves) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const SamplingPoint& p : curve.points)
      points.push_back({{"samples", p.samples}, {"error", p.error}});
    json["patterns"].push_back({{"name", curve.name}, {"slope", curve.slope}, {"points", points}});
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string figures_svg(const SamplingFigures& figures, const std::string& model) {
  Plot plot;
  double least = 1.0, most = 1e-6;
  for (const SamplingCurve& curve : figures.curves) {
    for (const SamplingPoint& p : curve.points) {
      if (p.error > 0.0) least = std::min(least, p.error);
      most = std::max(most, p.error);
    }
  }
  plot.least = std::pow(10.0, std::floor(std::log10(std::min(least, most))));
  plot.most = std::max(std::pow(10.0, std::ceil(std::log10(most))), plot.least * 10.0);
  std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 600 400' font-family='sans-serif' "
      "font-size='12'>\n"
      "<rect width='600' height='400' fill='white'/>\n" +
      draw_axes(plot);
  constexpr const char* kColors[] = {"#1f5fbf", "#c0392b", "#2e8b57"};
  for (std::size_t i = 0; i < figures.curves.size(); ++i) {
    svg += draw_curve(plot, figures.curves[i], kColors[i], static_cast<int>(i));
  }
  return svg + text(330, 394, model) + "</svg>\n";
}

}  // namespace barrido::cli
