// The course's table of costs, from counters to text and JSON.
#include "viewer/barrido/cost_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace barrido::cli {
namespace {

FrameCost frame_of(pipeline::ShadeModel shading, std::uint64_t scale) {
  FrameCost frame;
  frame.name = "a/x.png";
  frame.model = "a.glb";
  frame.shading = shading;
  frame.width = 4;
  frame.height = 2;
  frame.counts.vertices = 8 * scale;
  frame.counts.primitives_in = 12 * scale;
  frame.counts.illuminations_vertex = 300 * scale;
  frame.counts.illuminations_fragment = 700 * scale;
  frame.counts.interpolations = 5000 * scale;
  frame.counts.powers = 40 * scale;
  frame.counts.raster.primitives = 10 * scale;
  frame.counts.raster.spans = 50 * scale;
  frame.counts.raster.fragments_shaded = 1000 * scale;
  frame.draw_ms = 2.0;
  frame.write_ms = 1.5;
  return frame;
}

CostReport report() {
  CostReport report;
  report.models.push_back({"a.glb", 3.25});
  report.frames = {frame_of(pipeline::ShadeModel::phong, 1), frame_of(pipeline::ShadeModel::flat, 1),
                   frame_of(pipeline::ShadeModel::phong, 3)};
  report.total_ms = 20.0;
  report.threads = 2;
  report.simd = "avx2";
  return report;
}

TEST(CostReport, TextNamesTheStagesThatTookTime) {
  CostReport report;
  report.frames = {frame_of(pipeline::ShadeModel::phong, 1), frame_of(pipeline::ShadeModel::phong, 1)};
  EXPECT_EQ(cost_text(report).find("ms of all threads"), std::string::npos);
  report.frames[0].stage_ms[static_cast<std::size_t>(raster::Stage::texture)] = 3.0;
  report.frames[1].stage_ms[static_cast<std::size_t>(raster::Stage::texture)] = 2.0;
  report.frames[1].stage_ms[static_cast<std::size_t>(raster::Stage::resolve)] = 1.0;
  EXPECT_NE(cost_text(report).find("  ms of all threads: texture 2.50, resolve 0.50\n"), std::string::npos);
  const auto json = nlohmann::json::parse(cost_json(report));
  EXPECT_EQ(json["frames"][1]["stage_ms"]["texture"], 2.0);
  EXPECT_EQ(json["frames"][0]["stage_ms"]["resolve"], 0.0);
}

TEST(CostReport, TextHasATableForEachMode) {
  const std::string text = cost_text(report());
  EXPECT_EQ(text,
            "flat: 1 frame, drawn in 2.00 ms, written in 1.50 ms\n"
            "                           per frame       per polygon      per scanline\n"
            "  illuminations                1,000            100.00             20.00\n"
            "  interpolations               5,000            500.00            100.00\n"
            "  additions                    5,000            500.00            100.00\n"
            "  powers                          40              4.00              0.80\n"
            "  fragments                    1,000            100.00             20.00\n"
            "  8 vertices, 12 polygons of which 10 drawn, 50 scanlines a frame\n"
            "\n"
            "phong: 2 frames, drawn in 2.00 ms, written in 1.50 ms each\n"
            "                           per frame       per polygon      per scanline\n"
            "  illuminations                2,000            100.00             20.00\n"
            "  interpolations              10,000            500.00            100.00\n"
            "  additions                   10,000            500.00            100.00\n"
            "  powers                          80              4.00              0.80\n"
            "  fragments                    2,000            100.00             20.00\n"
            "  16 vertices, 24 polygons of which 20 drawn, 100 scanlines a frame\n"
            "\n"
            "loaded a.glb in 3.25 ms\n"
            "all in 20.00 ms, 2 threads, avx2\n");
}

TEST(CostReport, JsonHasFramesAndModes) {
  const auto json = nlohmann::json::parse(cost_json(report()));
  EXPECT_EQ(json["models"][0]["file"], "a.glb");
  EXPECT_EQ(json["simd"], "avx2");
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["modes"]["phong"]["frames"], 2);
  EXPECT_EQ(json["modes"]["phong"]["illuminations"], 4000);
  EXPECT_EQ(json["modes"]["phong"]["per_frame"]["powers"], 80.0);
  EXPECT_EQ(json["modes"]["flat"]["per_polygon"]["interpolations"], 500.0);
  EXPECT_FALSE(json["modes"].contains("gouraud"));
  ASSERT_EQ(json["frames"].size(), 3u);
  EXPECT_EQ(json["frames"][1]["shading"], "flat");
  EXPECT_EQ(json["frames"][1]["counts"]["per_scanline"]["powers"], 0.8);
  EXPECT_EQ(json["frames"][1]["stages"]["illuminations_vertex"], 300);
  EXPECT_FALSE(json["frames"][1].contains("sha256"));
}

TEST(CostReport, NothingDrawnDividesByNothing) {
  CostReport empty;
  empty.frames.push_back({});
  EXPECT_NE(
      cost_text(empty).find("  illuminations                    0                 -                 -\n"),
      std::string::npos);
  EXPECT_TRUE(
      nlohmann::json::parse(cost_json(empty))["frames"][0]["counts"]["per_polygon"]["powers"].is_null());
}

TEST(CostReport, NamesNeedNotBeUtf8) {
  CostReport odd = report();
  odd.frames[0].name = "\xff\xfe.png";
  EXPECT_TRUE(nlohmann::json::accept(cost_json(odd)));
}

}  // namespace
}  // namespace barrido::cli
