// The report as text; what it does in a browser is tested in check_browser.py.
#include "viewer/compare/html_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/compare/pictures.h"

namespace barrido::compare::test {
namespace {

namespace fs = std::filesystem;

class Html : public testing::Test {
 protected:
  /// Compares folders a and b and writes the report; its text.
  std::string report() {
    HtmlReport html(folder_ / "report");
    compare::Run run{"a", "b", {}, {}};
    for (const Pair& pair : find_pairs(folder_ / "a", folder_ / "b")) {
      const ComparedPair compared = compare_pair(pair, run.settings);
      html.add(compared);
      run.results.push_back(compared.result);
    }
    html.write(run);
    return read_text(folder_ / "report/index.html");
  }
  static nlohmann::json data_of(const std::string& html) {
    const std::string begin = "<script type=\"application/json\" id=\"data\">";
    const std::size_t from = html.find(begin) + begin.size();
    return nlohmann::json::parse(html.substr(from, html.find("</script>", from) - from));
  }
  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  }
  TemporaryFolder folder_;
};

TEST_F(Html, HoldsThePicturesOfWhatDiffersAndOnlyThose) {
  write_png(folder_ / "a/same.png", flat(9, 9, 1));
  write_png(folder_ / "b/same.png", flat(9, 9, 1));
  write_png(folder_ / "a/x.png", flat(9, 9, 100));
  write_png(folder_ / "b/x.png", flat(9, 9, 110));
  write_png(folder_ / "b/new.png", flat(9, 9, 110));
  const std::string html = report();
  EXPECT_EQ(count(html, "<script type=\"text/plain\""), 5u) << "four of x.png, one of new.png";
  EXPECT_EQ(count(html, "<tr data-pair="), 3u);
  EXPECT_NE(html.find("<h1 class=\"failed\">2 of 3 pairs failed</h1>"), std::string::npos);
  const auto data = data_of(html);
  EXPECT_EQ(data[0]["name"], "x.png") << "worst first";
  EXPECT_EQ(data[0]["amplification"], 8) << "10/255 · 8 is below a half, · 16 is not";
  EXPECT_EQ(data[2]["pictures"]["expected"], "");
  EXPECT_EQ(count(html, "http"), 1u) << "nothing is fetched: only the name of a policy's header";
  EXPECT_EQ(fs::directory_iterator(folder_ / "report")->path().filename(), "index.html");
}

TEST_F(Html, NamesCannotBecomeElements) {
  const std::string name = "<script>alert(1)<\\script>&\"'.png";
  write_png(folder_ / "a/x.png", flat(2, 2, 1));
  write_png(folder_ / "b" / name, flat(2, 2, 1));
  const std::string html = report();
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;alert(1)&lt;\\script&gt;&amp;&quot;&#39;.png"), std::string::npos);
  EXPECT_EQ(data_of(html)[1]["name"], name);
}

TEST_F(Html, TheSameRunGivesTheSameBytes) {
  write_png(folder_ / "a/x.png", flat(9, 9, 100));
  write_png(folder_ / "b/x.png", flat(9, 9, 110));
  EXPECT_EQ(report(), report());
}

TEST_F(Html, AFolderThatCannotBeMadeIsOneClearError) {
  write_text(folder_ / "file", "x");
  EXPECT_EQ(scene::test::message_of([&] { HtmlReport html(folder_ / "file"); }),
            (folder_ / "file").string() + ": cannot be made: Not a directory");
}

}  // namespace
}  // namespace barrido::compare::test
