// Which frames a call makes, and what they are called.
#include "viewer/barrido/frame_plan.h"

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

using Words = std::vector<std::string>;

std::vector<std::string> outputs(const Words& words, const FileFacts& facts) {
  std::vector<std::string> names;
  for (const PlannedFrame& frame : plan_frames(parse_render_options(words), facts))
    names.push_back(frame.output);
  return names;
}

std::vector<std::string> labels(const Words& words, const FileFacts& facts) {
  std::vector<std::string> names;
  for (const PlannedFrame& frame : plan_frames(parse_render_options(words), facts))
    names.push_back(frame.label);
  return names;
}

std::string complaint(const auto& act) {
  try {
    act();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

std::string name_complaint(const Words& words) {
  return complaint([&] { check_output_names(parse_render_options(words)); });
}

TEST(FramePlan, OneFrameByDefault) {
  const FileFacts facts{"models/teapot.v2.glb", 2, 1};
  const auto frames = plan_frames(parse_render_options(Words{"a", "-o", "x.png"}), facts);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].output, "x.png");
  EXPECT_EQ(frames[0].label, "teapot.v2/phong");
  EXPECT_EQ(frames[0].camera, scene::kNone);
  EXPECT_EQ(frames[0].animation, scene::kNone);
}

TEST(FramePlan, CamerasThenShadingsThenMoments) {
  const Words words{"a",         "-o",         "{model}/{shading}/{camera}/{frame:02}.png",
                    "--shading", "flat,phong", "--camera-index",
                    "all",       "--frames",   "9:10",
                    "--fps",     "10"};
  EXPECT_EQ(outputs(words, {"a.glb", 2, 1}),
            (Words{"a/flat/0/09.png", "a/flat/0/10.png", "a/phong/0/09.png", "a/phong/0/10.png",
                   "a/flat/1/09.png", "a/flat/1/10.png", "a/phong/1/09.png", "a/phong/1/10.png"}));
  EXPECT_EQ(labels(words, {"a.glb", 1, 1}), (Words{"a/flat/camera0/frame9", "a/flat/camera0/frame10",
                                                   "a/phong/camera0/frame9", "a/phong/camera0/frame10"}));
  const auto frames = plan_frames(parse_render_options(words), {"a.glb", 1, 1});
  EXPECT_DOUBLE_EQ(frames[0].time_s, 0.9);
  EXPECT_DOUBLE_EQ(frames[1].time_s, 1.0);
  EXPECT_EQ(frames[0].animation, 0);
}

TEST(FramePlan, TurntablesGoRoundOnce) {
  const auto frames = plan_frames(
      parse_render_options(Words{"a", "-o", "{frame}.png", "--turntable", "4", "--azimuth", "10"}),
      {"a.glb", 0, 0});
  ASSERT_EQ(frames.size(), 4u);
  scene::RenderSettings base;
  base.camera.azimuth_deg = 10.0f;
  EXPECT_EQ(settings_of(base, frames[0]).camera.azimuth_deg, 10.0f);
  EXPECT_EQ(settings_of(base, frames[3]).camera.azimuth_deg, 280.0f);
  EXPECT_EQ(frames[3].output, "3.png");
}

TEST(FramePlan, SettingsOfAFrame) {
  const Words words{"a", "-o",          "a.png", "--shading", "flat", "--camera-index",
                    "1", "--animation", "1",     "--time",    "2"};
  const auto frames = plan_frames(parse_render_options(words), {"a.glb", 2, 2});
  const scene::RenderSettings settings = settings_of({}, frames.at(0));
  EXPECT_EQ(settings.shading, pipeline::ShadeModel::flat);
  EXPECT_EQ(settings.camera.camera_index, 1);
  EXPECT_EQ(settings.animation, 1);
  EXPECT_EQ(settings.time_s, 2.0);
}

TEST(FramePlan, WithoutACameraChosenItsNameIsAuto) {
  EXPECT_EQ(outputs({"a", "-o", "{camera}.png"}, {"a.glb", 3, 0}), Words{"auto.png"});
}

TEST(FramePlan, FramesOfASheetOrOfAHashHaveNoFile) {
  EXPECT_EQ(outputs({"a", "-o", "s.png", "--sheet"}, {"a.glb", 0, 0}), Words{""});
  EXPECT_EQ(outputs({"a", "--hash"}, {"a.glb", 0, 0}), Words{""});
}

TEST(FramePlan, WhatTheFileLacksIsNamed) {
  const auto plan = [](const Words& words, const FileFacts& facts) {
    return complaint([&] { plan_frames(parse_render_options(words), facts); });
  };
  EXPECT_EQ(plan({"a", "-o", "a.png", "--camera-index", "2"}, {"a.glb", 2, 0}),
            "a.glb: --camera-index 2: the scene has only cameras 0 to 1");
  EXPECT_EQ(plan({"a", "-o", "a.png", "--camera-index", "1"}, {"a.glb", 1, 0}),
            "a.glb: --camera-index 1: the scene has only camera 0");
  EXPECT_EQ(plan({"a", "-o", "a.png", "--camera-index", "0"}, {"a.glb", 0, 0}),
            "a.glb: --camera-index 0: the scene has no camera");
  EXPECT_EQ(plan({"a", "-o", "{camera}.png", "--camera-index", "all"}, {"a.glb", 0, 0}),
            "a.glb: --camera-index all: the scene has no camera");
  EXPECT_EQ(plan({"a", "-o", "a.png", "--time", "1"}, {"a.glb", 0, 0}),
            "a.glb: --time: the file has no animation");
  EXPECT_EQ(plan({"a", "-o", "{frame}.png", "--frames", "0:1"}, {"a.glb", 0, 0}),
            "a.glb: --frames: the file has no animation");
  EXPECT_EQ(plan({"a", "-o", "a.png", "--animation", "3"}, {"a.glb", 0, 3}),
            "a.glb: --animation 3: the file has only animations 0 to 2");
}

TEST(FramePlan, MissingPlaceholdersAreNamed) {
  EXPECT_EQ(name_complaint({"a.glb", "-o", "x.png", "--shading", "flat,phong"}),
            "--output: 'x.png': the frames need different names: add {shading}, or use --sheet");
  EXPECT_EQ(
      name_complaint({"a.glb", "b.glb", "-o", "x.png", "--shading", "all", "--turntable", "2"}),
      "--output: 'x.png': the frames need different names: add {model} and {shading} and {frame}, or use "
      "--sheet");
  EXPECT_EQ(name_complaint({"a.glb", "-o", "x.png", "--camera-index", "all"}),
            "--output: 'x.png': the frames need different names: add {camera}, or use --sheet");
  EXPECT_EQ(name_complaint({"a.glb", "b.glb", "-o", "-"}),
            "--output: '-': standard output holds one picture; several frames need --sheet or --raw");
  EXPECT_EQ(name_complaint({"a.glb", "b.glb", "-o", "-", "--sheet"}), "");
  EXPECT_EQ(name_complaint({"a.glb", "-o", "-", "--turntable", "1"}), "");
  EXPECT_EQ(name_complaint({"a.glb", "b.glb", "--hash"}), "");
}

TEST(FramePlan, FoldersTellModelsOfOneNameApart) {
  const char* const kOutput = "out/{folder}/{model}.png";
  EXPECT_EQ(name_complaint({"a/x.glb", "b/x.glb", "-o", kOutput}), "");
  EXPECT_EQ(name_complaint({"a/x.glb", "b/y.glb", "-o", "{folder}.png"}), "");
  EXPECT_NE(name_complaint({"a/x.glb", "b/x.glb", "-o", "{model}.png"}), "");
  const auto name_of = [&](const char* path) { return outputs({path, "-o", kOutput}, {path, 0, 0}).at(0); };
  EXPECT_EQ(name_of("a/b/x.glb"), "out/a/b/x.png");
  EXPECT_EQ(name_of("x.glb"), "out/./x.png");
  EXPECT_EQ(name_of("/a/x.glb"), "out/a/x.png");
  EXPECT_EQ(name_of("../../a/x.glb"), "out/up/up/a/x.png");
}

TEST(FramePlan, EqualNamesAreRefused) {
  EXPECT_EQ(name_complaint({"x/a.glb", "y/a.gltf", "-o", "{model}.png"}),
            "a.png: two frames would have this name: x/a.glb phong and y/a.gltf phong");
  EXPECT_EQ(name_complaint({"a.glb", "a.glb", "-o", "{model}.png"}),
            "a.png: two frames would have this name: a.glb phong and a.glb phong");
  EXPECT_EQ(name_complaint({"x/a.glb", "y/b.gltf", "-o", "{model}.png"}), "");
}

TEST(FramePlan, FormatsAreKnownBeforeAnythingIsLoaded) {
  EXPECT_EQ(
      name_complaint({"a.glb", "-o", "a.xyz"}),
      "--output: 'a.xyz': no picture format is known by the extension '.xyz'; expected png, jpg, tif, exr, "
      "hdr or gif, for example");
  EXPECT_EQ(name_complaint({"a.glb", "-o", "picture"}),
            "--output: 'picture': has no extension; expected png, jpg, tif, exr, hdr or gif, for example");
  EXPECT_EQ(name_complaint({"a.glb", "-o", "a", "--sheet"}),
            "--output: 'a': has no extension; expected png, jpg, tif, exr, hdr or gif, for example");
  for (const char* name : {"a.png", "a.jpg", "a.jpeg", "a.PNG", "a.tif", "a.exr", "a.hdr"}) {
    EXPECT_EQ(name_complaint({"a.glb", "-o", name}), "") << name;
  }
}

TEST(FramePlan, ASheetHasOneName) {
  EXPECT_EQ(sheet_name(parse_render_options(Words{"x/a.glb", "-o", "{model}.png", "--sheet"})), "a.png");
  EXPECT_EQ(name_complaint({"a.glb", "-o", "{shading}.png", "--sheet"}),
            "--output: '{shading}.png': a sheet is one picture for every {shading}; leave it out");
  EXPECT_EQ(name_complaint({"a.glb", "b.glb", "-o", "{model}.png", "--sheet"}),
            "--output: '{model}.png': a sheet is one picture for every {model}; leave it out");
}

}  // namespace
}  // namespace barrido::cli
