#include "pipeline/scene/sample_loop.h"

#include "raster/tiles/sample_pattern.h"

namespace barrido::scene {
namespace {

double moment_of(const SampleChoice& choice, double share) {
  if (!choice.shutter) return 0.0;
  const double open = static_cast<double>(choice.shutter->open);
  return open + (static_cast<double>(choice.shutter->close) - open) * share;
}

void draw_each(const RenderSettings& settings, const Lens& lens, const raster::SampleSettings& all,
               const std::function<void(const SampleGo&)>& draw) {
  const SampleChoice& choice = settings.samples;
  raster::FrameSums sums(settings.width, settings.height, all.sums_weights());
  for (int i = 0; i < choice.count; ++i) {
    const raster::SampleMoment moment = raster::sample_moment(
        i, choice.count, static_cast<std::uint32_t>(choice.seed), choice.sampling == Sampling::jittered);
    const RenderSettings then = at_moment(settings, moment_of(choice, moment.time));
    raster::SampleSettings one = all;
    one.samples = {all.samples[static_cast<std::size_t>(i)]};
    if (one.jitter) one.jitter->first = i;
    one.sums = &sums;
    one.is_first = i == 0;
    one.is_last = i + 1 == choice.count;
    SampleGo go{then, &one, {}, one.is_first};
    if (choice.has_lens()) {
      go.look = [&](View& view) {
        view = through_lens(view, lens, lens.radius * moment.lens_x, lens.radius * moment.lens_y);
      };
    }
    draw(go);
  }
}

}  // namespace

void for_each_go(const RenderSettings& settings, const Lens& lens,
                 const std::function<void(const SampleGo&)>& draw) {
  const SampleChoice& choice = settings.samples;
  if (choice.is_plain()) return draw({settings});
  raster::SampleSettings all;
  all.samples = raster::uniform_samples(choice.count, choice.filter);
  all.total_weight = raster::total_weight(all.samples);
  all.order = choice.order;
  if (choice.sampling == Sampling::jittered) {
    all.jitter =
        raster::JitterSettings{static_cast<std::uint32_t>(choice.seed), choice.filter, 0, choice.count};
  }
  if (choice.sampling == Sampling::adaptive) {
    all.adaptive =
        raster::AdaptiveSettings{choice.adaptive_threshold, choice.adaptive_depth, !choice.corners_only};
    all.report = settings.sample_report;
  }
  if (choice.moves() || choice.has_lens()) return draw_each(settings, lens, all, draw);
  draw({settings, &all});
}

void set_background(raster::SampleSettings& samples, const SceneFrame& frame,
                    const std::optional<Backing>& backing) {
  const glm::vec4& c = frame.clear_color;
  samples.background = {c.r, c.g, c.b, c.a};
  samples.background_depth = frame.view.clear_depth;
  samples.alpha = backing      ? raster::SampleAlpha::blended
                  : c.a < 1.0f ? raster::SampleAlpha::straight
                               : raster::SampleAlpha::opaque;
}

}  // namespace barrido::scene
