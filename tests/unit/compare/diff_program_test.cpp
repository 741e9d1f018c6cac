// `barrido diff` as a user runs it: exit status, messages, and what is left on disk.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "tests/unit/compare/pictures.h"
#include "tests/unit/viewer/program.h"

namespace barrido::test {
namespace {

using compare::test::flat;
using compare::test::picture_of;
using compare::test::write_png;

class Diff : public ::testing::Test {
 protected:
  Diff() {
    write_png(path("a.png"), flat(40, 30, 100));
    write_png(path("b.png"),
              picture_of(40, 30, [](int x, int y, int) { return x == 3 && y == 4 ? 151 : 100; }));
    write_png(path("golden/one.png"), flat(40, 30, 100));
    write_png(path("golden/sub/two.png"), flat(40, 30, 100));
    write_png(path("golden/three.png"), flat(40, 30, 100));
    write_png(path("out/one.png"), flat(40, 30, 100));
    write_png(path("out/sub/two.png"), flat(40, 30, 120));
    write_png(path("out/four.png"), flat(40, 30, 100));
  }

  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
  Outcome diff(std::vector<std::string> words) const {
    words.insert(words.begin(), "diff");
    return run(words, {folder_.path(), "", false, 0});
  }
  void expect_error(const std::vector<std::string>& words, const std::string& message) const {
    const Outcome outcome = diff(words);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.error, "barrido: " + message + "\n");
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

  TemporaryFolder folder_;
};

TEST_F(Diff, EqualPicturesPass) {
  const Outcome outcome = diff({"a.png", "a.png"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "Comparing \"a.png\" and \"a.png\"\nPASS\n");
  EXPECT_EQ(outcome.error, "");
}

TEST_F(Diff, DifferentPicturesFailWithFigures) {
  const Outcome outcome = diff({"a.png", "b.png"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.error, "");
  const auto lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 8u) << outcome.out;
  EXPECT_EQ(lines[0], "Comparing \"a.png\" and \"b.png\"");
  EXPECT_EQ(lines[1], "  Mean error = 0.000166667");
  EXPECT_EQ(lines[4],
            "  Max error  = 0.2 @ (3, 4, R)  values are 0.39215687, 0.39215687, 0.39215687 vs 0.59215689, "
            "0.59215689, "
            "0.59215689");
  EXPECT_EQ(lines[5], "  1 pixels (0.0833%) over 1e-06");
  EXPECT_EQ(lines[6].find("  FLIP mean  = "), 0u);
  EXPECT_EQ(lines[7], "FAILURE");
}

TEST_F(Diff, ThresholdsDecideTheStatus) {
  EXPECT_EQ(diff({"a.png", "b.png", "--fail", "0.21", "--warn", "0.21"}).out.substr(0, 9), "Comparing");
  EXPECT_EQ(diff({"a.png", "b.png", "--fail", "0.21"}).status, 0);
  const Outcome warning = diff({"a.png", "b.png", "-failpercent", "1"});
  EXPECT_EQ(warning.status, 0) << "a warning is printed, but not a difference";
  EXPECT_EQ(lines_of(warning.out).back(), "WARNING");
  EXPECT_EQ(lines_of(diff({"a.png", "b.png", "-fail", "0.21", "-warn", "0.21"}).out).back(), "PASS");
  EXPECT_EQ(diff({"a.png", "b.png", "-failpercent", "1", "-hardfail", "0.1"}).status, 1);
  EXPECT_EQ(diff({"a.png", "b.png", "-fail", "1", "--failflip", "0.00001"}).status, 1);
  EXPECT_EQ(diff({"a.png", "b.png", "-fail", "1", "--failflip", "0.5"}).status, 0);
}

TEST_F(Diff, FoldersAreTotalledAndWhatDiffersIsALine) {
  const Outcome outcome = diff({"golden", "out"});
  EXPECT_EQ(outcome.status, 1);
  const auto lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 4u) << outcome.out;
  EXPECT_EQ(lines[0], "four.png: added: not among the expected pictures");
  EXPECT_EQ(lines[1].find("sub/two.png: different: max 0.0784314 at (0, 0), 100% of the pixels, FLIP 0."),
            0u);
  EXPECT_EQ(lines[2], "three.png: missing: not among the actual pictures");
  EXPECT_EQ(lines[3], "4 pairs: 1 different, 1 missing, 1 added, 1 same");
  EXPECT_EQ(diff({"golden", "golden"}).out, "3 pairs: 3 same\n");
  EXPECT_EQ(diff({"golden", "out", "--quiet"}).out, "");
}

TEST_F(Diff, ReportsAreWritten) {
  const Outcome outcome =
      diff({"golden", "out", "--html", "deep/report", "--junit", "r.xml", "--json", "r.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(nlohmann::json::parse(read_text(path("r.json")))["totals"]["failed"], 3);
  EXPECT_EQ(read_text(path("r.xml")).substr(0, 38), "<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
  EXPECT_GT(std::filesystem::file_size(path("deep/report/index.html")), 10'000u);
}

TEST_F(Diff, AReportOnStandardOutputStandsAlone) {
  const Outcome outcome = diff({"golden", "out", "--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["totals"]["pairs"], 4);
  EXPECT_NE(outcome.error.find("4 pairs: "), std::string::npos);
}

TEST_F(Diff, TheDifferenceIsAPicture) {
  EXPECT_EQ(diff({"a.png", "b.png", "-o", "d.png", "-abs", "-scale", "2"}).status, 1);
  const auto picture = scene::read_image(path("d.png"));
  EXPECT_EQ(picture.rgba[(4 * 40 + 3) * 4], 102);
  EXPECT_EQ(picture.rgba[0], 0);
  EXPECT_EQ(diff({"a.png", "b.png", "-o", "signed.png"}).status, 1);
  EXPECT_EQ(scene::read_image(path("signed.png")).rgba[(4 * 40 + 3) * 4], 0) << "A - B is negative";
  expect_error({"golden", "out", "-o", "d.png"},
               "--output: only for two pictures; of folders, --html shows the differences");
}

TEST_F(Diff, BlessMakesTheFoldersTheSame) {
  const Outcome outcome = diff({"golden", "out", "--bless", "-q"});
  EXPECT_EQ(outcome.status, 1) << "three.png is still without counterpart";
  std::filesystem::remove(path("golden/three.png"));
  EXPECT_EQ(diff({"golden", "out"}).status, 0);
  EXPECT_EQ(read_text(path("golden/sub/two.png")), read_text(path("out/sub/two.png")));
}

TEST_F(Diff, BlessTellsWhatItDid) {
  const auto lines = lines_of(diff({"golden", "out", "--bless"}).out);
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_EQ(lines[4], "blessed golden/sub/two.png: replaced");
  EXPECT_EQ(lines[5], "blessed golden/four.png: new");
  EXPECT_EQ(lines[6], "kept golden/three.png: has no counterpart");
  const Outcome first = diff({"new/first.png", "a.png", "--bless"});
  EXPECT_EQ(first.status, 0);
  EXPECT_EQ(lines_of(first.out).back(), "blessed new/first.png: new");
  EXPECT_EQ(lines_of(diff({"new/first.png", "a.png", "--bless"}).out).back(), "nothing to bless");
}

TEST_F(Diff, BadInputIsOneLineAndStatusTwo) {
  write_text(path("cut.png"), read_text(path("b.png")).substr(0, 60));
  write_text(path("text.png"), "no picture");
  expect_error({"a.png", "none.png"}, "none.png: cannot be read: No such file or directory");
  expect_error({"golden", "a.png"}, "golden: is a folder and cannot be compared with the file a.png");
  expect_error({"a.png", "text.png"},
               "text.png: not a picture in a format that is read (PNG, JPEG, EXR, HDR, TIFF, BMP, TGA)");
  expect_error({"a.png", "/dev/null"}, "/dev/null: is not a regular file");
  const Outcome cut = diff({"a.png", "cut.png"});
  EXPECT_EQ(cut.status, 2);
  EXPECT_EQ(cut.error.find("barrido: cut.png: damaged PNG: "), 0u) << cut.error;
  EXPECT_EQ(lines_of(cut.error).size(), 1u);
  expect_error({"a.png", "b.png", "--json", "none/x.json"},
               "none/x.json: cannot be written: No such file or directory");
  expect_error({"a.png", "b.png", "-o", "none/x.png"},
               "none/x.png: cannot be written: No such file or directory");
  expect_error({"a.png", "b.png", "--html", "text.png"}, "text.png: cannot be made: Not a directory");
  expect_error({"a.png"},
               "diff: needs two pictures or two folders, A (expected) and B (actual); see barrido diff "
               "--help");
}

TEST_F(Diff, OneBadFileOfAFolderDoesNotHideTheOthers) {
  write_text(path("out/one.png"), "no picture");
  const Outcome outcome = diff({"golden", "out", "--html", "report"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(lines_of(outcome.error).size(), 1u);
  EXPECT_EQ(lines_of(outcome.out).back(), "4 pairs: 1 error, 1 different, 1 missing, 1 added");
  EXPECT_TRUE(exists("report/index.html"));
}

TEST_F(Diff, NothingIsLeftBehind) {
  const auto before = folder_.files();
  diff({"a.png", "b.png", "--json", "none/x.json", "-o", "none/x.png"});
  diff({"golden", "none"});
  EXPECT_EQ(folder_.files(), before);
}

TEST_F(Diff, AFullDiskLeavesTheOldReport) {
  EXPECT_EQ(diff({"golden", "out", "--json", "/dev/full"}).error,
            "barrido: /dev/full: cannot be written: No space left on device\n");
}

TEST_F(Diff, OpenImageIoIsNotLoadedForPng) {
  ::setenv("LD_DEBUG", "files", 1);
  const Outcome traced = run({"diff", "a.png", "b.png", "-q"}, {folder_.path(), "", false, 0});
  ::unsetenv("LD_DEBUG");
  EXPECT_EQ(traced.status, 1);
  EXPECT_NE(traced.error.find("libtbb"), std::string::npos) << "the loader tells what it loads";
  EXPECT_EQ(traced.error.find("OpenImageIO"), std::string::npos);
}

}  // namespace
}  // namespace barrido::test
