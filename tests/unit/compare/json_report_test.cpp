// The report for programs.
#include "viewer/compare/text_reports.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/compare/results.h"

namespace barrido::compare::test {
namespace {

using Json = nlohmann::json;

TEST(JsonReport, HoldsTotalsThresholdsAndPairs) {
  const Json json = Json::parse(json_report(run_of_all_outcomes()));
  EXPECT_EQ(json["expected"], "a");
  EXPECT_EQ(json["totals"]["pairs"], 6);
  EXPECT_EQ(json["totals"]["failed"], 4);
  EXPECT_EQ(json["totals"]["same"], 1);
  EXPECT_EQ(json["thresholds"]["fail"], 1e-6);
  EXPECT_TRUE(json["thresholds"]["hardfail"].is_null());
  ASSERT_EQ(json["pairs"].size(), 6u);
  EXPECT_EQ(json["pairs"][0]["outcome"], "error");
  EXPECT_EQ(json["pairs"][0]["note"], "error.png: bad");
  const Json& different = json["pairs"][1];
  EXPECT_EQ(different["name"], "deep/different.png");
  EXPECT_EQ(different["expected"]["width"], 40);
  EXPECT_EQ(different["expected"]["channels"], "RGB");
  EXPECT_EQ(different["figures"]["max"], 0.5);
  EXPECT_EQ(different["figures"]["worst"]["x"], 12);
  EXPECT_EQ(different["figures"]["worst"]["channel"], "G");
  EXPECT_EQ(different["figures"]["worst"]["actual"][1], 1.0);
  EXPECT_NEAR(different["figures"]["psnr_db"].get<double>(), 40.0, 1e-9);
  EXPECT_EQ(different["flip"]["mean"], 0.25);
  EXPECT_TRUE(json["pairs"][2]["actual"].is_null());
  const Json& same = json["pairs"][5];
  EXPECT_TRUE(same["figures"]["psnr_db"].is_null());
  EXPECT_FALSE(same["figures"].contains("worst"));
}

TEST(JsonReport, NamesThatAreNoUtf8AndDifferencesThatAreInfinite) {
  compare::Run run{"a\xff", "b", {}, {result_of("\xc3(\".png", Outcome::different)}};
  run.results[0].figures->max = std::numeric_limits<double>::infinity();
  run.results[0].figures->worst.actual[0] = std::numeric_limits<float>::quiet_NaN();
  const Json json = Json::parse(json_report(run));
  EXPECT_EQ(json["expected"], "a\xef\xbf\xbd");
  EXPECT_TRUE(json["pairs"][0]["figures"]["max"].is_null());
  EXPECT_TRUE(json["pairs"][0]["figures"]["worst"]["actual"][0].is_null());
}

}  // namespace
}  // namespace barrido::compare::test
