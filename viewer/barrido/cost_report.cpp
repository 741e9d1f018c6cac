#include "viewer/barrido/cost_report.h"

#include <array>

#include "pipeline/names.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

constexpr std::size_t kNameWidth = 16;
constexpr std::size_t kNumberWidth = 18;

/// The frames of one mode together.
struct ModeSum {
  std::uint64_t frames = 0;
  CourseCounts counts;
  pipeline::Statistics raw;
  double draw_ms = 0.0;
  double write_ms = 0.0;
  std::array<double, raster::kStageCount> stage_ms{};
};

ModeSum sum_of_mode(const CostReport& report, pipeline::ShadeModel mode) {
  ModeSum sum;
  for (const FrameCost& frame : report.frames) {
    if (frame.shading != mode) continue;
    ++sum.frames;
    sum.counts += course_counts(frame.counts);
    sum.raw.vertices += frame.counts.vertices;
    sum.raw.primitives_in += frame.counts.primitives_in;
    sum.raw.raster.mapped += frame.counts.raster.mapped;
    sum.raw.raster.patterns += frame.counts.raster.patterns;
    sum.raw.raster.noise += frame.counts.raster.noise;
    sum.raw.displaced_vertices += frame.counts.displaced_vertices;
    sum.raw.displaced_triangles += frame.counts.displaced_triangles;
    sum.raw.raster.texel_fetches += frame.counts.raster.texel_fetches;
    sum.raw.raster.sorted_fragments += frame.counts.raster.sorted_fragments;
    sum.draw_ms += frame.draw_ms;
    sum.write_ms += frame.write_ms;
    for (std::size_t stage = 0; stage < sum.stage_ms.size(); ++stage)
      sum.stage_ms[stage] += frame.stage_ms[stage];
  }
  return sum;
}

std::string ratio(std::uint64_t count, std::uint64_t parts, int digits) {
  if (parts == 0) return "-";
  return fixed(static_cast<double>(count) / static_cast<double>(parts), digits);
}

std::string row(const std::string& name, const std::array<std::string, 3>& numbers) {
  std::string line = "  " + left(name, kNameWidth);
  for (const std::string& number : numbers) line += right(number, kNumberWidth);
  return line + "\n";
}

std::string count_row(const char* name, std::uint64_t count, const ModeSum& sum) {
  const std::string per_frame =
      sum.frames == 1 ? grouped(count) : grouped((count + sum.frames / 2) / sum.frames);
  return row(name, {per_frame, ratio(count, sum.counts.polygons, 2), ratio(count, sum.counts.scanlines, 2)});
}

/// Milliseconds of each stage that took any, a frame, all threads together.
std::string stage_line(const ModeSum& sum) {
  std::string text;
  for (std::size_t stage = 0; stage < sum.stage_ms.size(); ++stage) {
    if (sum.stage_ms[stage] <= 0.0) continue;
    text += (text.empty() ? "  ms of all threads: " : ", ") + std::string(raster::kStageNames[stage]) + " " +
            fixed(sum.stage_ms[stage] / static_cast<double>(sum.frames), 2);
  }
  return text.empty() ? text : text + "\n";
}

std::string mode_table(pipeline::ShadeModel mode, const ModeSum& sum) {
  std::string text = std::string(name_of(mode)) + ": " + counted(sum.frames, "frame", "frames") +
                     ", drawn in " + fixed(sum.draw_ms / static_cast<double>(sum.frames), 2) + " ms";
  if (sum.write_ms > 0.0)
    text += ", written in " + fixed(sum.write_ms / static_cast<double>(sum.frames), 2) + " ms";
  text += sum.frames > 1 ? " each\n" : "\n";
  text += row("", {"per frame", "per polygon", "per scanline"});
  text += count_row("illuminations", sum.counts.illuminations, sum);
  text += count_row("interpolations", sum.counts.interpolations, sum);
  text += count_row("additions", sum.counts.additions, sum);
  text += count_row("powers", sum.counts.powers, sum);
  text += count_row("fragments", sum.counts.fragments, sum);
  const raster::RasterStatistics& made = sum.raw.raster;
  if (made.mapped > 0) text += count_row("mapped", made.mapped, sum);
  if (made.patterns > 0) text += count_row("procedures", made.patterns, sum);
  if (made.noise > 0) text += count_row("noise", made.noise, sum);
  const auto per_frame = [&sum](std::uint64_t count) { return grouped(count / sum.frames); };
  text += "  " + per_frame(sum.raw.vertices) + " vertices, " + per_frame(sum.raw.primitives_in) +
          " polygons of which " + per_frame(sum.counts.polygons) + " drawn, " +
          per_frame(sum.counts.scanlines) + " scanlines a frame\n";
  if (sum.raw.raster.texel_fetches > 0) {
    text += "  " + per_frame(sum.raw.raster.texel_fetches) + " texels, " +
            ratio(sum.raw.raster.texel_fetches, sum.counts.fragments, 2) + " a fragment\n";
  }
  if (sum.raw.displaced_triangles > 0) {
    text += "  displacement made " + per_frame(sum.raw.displaced_vertices) + " vertices and " +
            per_frame(sum.raw.displaced_triangles) + " triangles\n";
  }
  if (const std::uint64_t sorted = sum.raw.raster.sorted_fragments; sorted > 0) {
    text += "  " + per_frame(sorted) + " fragments put in order by depth a frame\n";
  }
  return text + stage_line(sum);
}

}  // namespace

CourseCounts course_counts(const pipeline::Statistics& statistics) {
  CourseCounts counts;
  counts.illuminations = statistics.illuminations_vertex + statistics.illuminations_fragment;
  counts.interpolations = statistics.interpolations;
  counts.additions = statistics.interpolations;
  counts.powers = statistics.powers;
  counts.polygons = statistics.raster.primitives;
  counts.scanlines = statistics.raster.spans;
  counts.fragments = statistics.raster.fragments_shaded;
  return counts;
}

CourseCounts& operator+=(CourseCounts& sum, const CourseCounts& counts) {
  sum.illuminations += counts.illuminations;
  sum.interpolations += counts.interpolations;
  sum.additions += counts.additions;
  sum.powers += counts.powers;
  sum.polygons += counts.polygons;
  sum.scanlines += counts.scanlines;
  sum.fragments += counts.fragments;
  return sum;
}

std::string cost_text(const CostReport& report) {
  std::string text;
  for (const pipeline::ShadingMode& mode : pipeline::kShadingModes) {
    const ModeSum sum = sum_of_mode(report, mode.model);
    if (sum.frames > 0) text += mode_table(mode.model, sum) + "\n";
  }
  for (const ModelCost& model : report.models) {
    text += "loaded " + model.path + " in " + fixed(model.load_ms, 2) + " ms\n";
  }
  if (report.environment_ms > 0.0) text += "environment in " + fixed(report.environment_ms, 2) + " ms\n";
  return text + "all in " + fixed(report.total_ms, 2) + " ms, " +
         counted(static_cast<std::uint64_t>(report.threads), "thread", "threads") + ", " + report.simd + "\n";
}

}  // namespace barrido::cli
