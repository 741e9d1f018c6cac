#include <nlohmann/json.hpp>

#include "pipeline/names.h"
#include "viewer/barrido/cost_report.h"

namespace barrido::cli {
namespace {

using Json = nlohmann::ordered_json;

Json ratio(std::uint64_t count, std::uint64_t parts) {
  return parts == 0 ? Json() : Json(static_cast<double>(count) / static_cast<double>(parts));
}

/// The four quantities of the course's table, divided by `parts`.
Json per(const CourseCounts& counts, std::uint64_t parts) {
  return {{"illuminations", ratio(counts.illuminations, parts)},
          {"interpolations", ratio(counts.interpolations, parts)},
          {"additions", ratio(counts.additions, parts)},
          {"powers", ratio(counts.powers, parts)}};
}

Json counts_json(const CourseCounts& counts) {
  return {{"illuminations", counts.illuminations},
          {"interpolations", counts.interpolations},
          {"additions", counts.additions},
          {"powers", counts.powers},
          {"polygons", counts.polygons},
          {"scanlines", counts.scanlines},
          {"fragments", counts.fragments},
          {"per_polygon", per(counts, counts.polygons)},
          {"per_scanline", per(counts, counts.scanlines)}};
}

Json frame_json(const FrameCost& frame) {
  Json json{{"name", frame.name},
            {"model", frame.model},
            {"shading", name_of(frame.shading)},
            {"width", frame.width},
            {"height", frame.height},
            {"draw_ms", frame.draw_ms},
            {"write_ms", frame.write_ms},
            {"counts", counts_json(course_counts(frame.counts))}};
  json["stages"] = {{"draws", frame.counts.draws},
                    {"displaced_vertices", frame.counts.displaced_vertices},
                    {"displaced_triangles", frame.counts.displaced_triangles},
                    {"vertices", frame.counts.vertices},
                    {"primitives_in", frame.counts.primitives_in},
                    {"primitives_culled", frame.counts.primitives_culled},
                    {"primitives_clipped", frame.counts.primitives_clipped},
                    {"illuminations_vertex", frame.counts.illuminations_vertex},
                    {"illuminations_fragment", frame.counts.illuminations_fragment},
                    {"fragments_covered", frame.counts.raster.fragments_covered},
                    {"fragments_shaded", frame.counts.raster.fragments_shaded},
                    {"texel_fetches", frame.counts.raster.texel_fetches},
                    {"mapped", frame.counts.raster.mapped},
                    {"procedures", frame.counts.raster.patterns},
                    {"noise", frame.counts.raster.noise},
                    {"fragments_sorted", frame.counts.raster.sorted_fragments}};
  Json times = Json::object();
  for (std::size_t stage = 0; stage < frame.stage_ms.size(); ++stage) {
    times[std::string(raster::kStageNames[stage])] = frame.stage_ms[stage];
  }
  json["stage_ms"] = std::move(times);
  if (!frame.sha256.empty()) json["sha256"] = frame.sha256;
  return json;
}

Json modes_json(const CostReport& report) {
  Json modes = Json::object();
  for (const auto& [shading, name, title] : names_of<pipeline::ShadeModel>()) {
    std::uint64_t frames = 0;
    double draw_ms = 0.0;
    CourseCounts sum;
    for (const FrameCost& frame : report.frames) {
      if (frame.shading != shading) continue;
      ++frames;
      draw_ms += frame.draw_ms;
      sum += course_counts(frame.counts);
    }
    if (frames == 0) continue;
    Json json = counts_json(sum);
    json["frames"] = frames;
    json["draw_ms"] = draw_ms;
    json["per_frame"] = per(sum, frames);
    modes[std::string(name)] = std::move(json);
  }
  return modes;
}

}  // namespace

std::string cost_json(const CostReport& report) {
  Json json;
  json["models"] = Json::array();
  for (const ModelCost& model : report.models) {
    json["models"].push_back({{"file", model.path}, {"load_ms", model.load_ms}});
  }
  json["environment_ms"] = report.environment_ms;
  json["total_ms"] = report.total_ms;
  json["threads"] = report.threads;
  json["simd"] = report.simd;
  json["modes"] = modes_json(report);
  json["frames"] = Json::array();
  for (const FrameCost& frame : report.frames) json["frames"].push_back(frame_json(frame));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace barrido::cli
