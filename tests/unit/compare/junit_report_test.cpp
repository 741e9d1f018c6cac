// The report for CI systems; that it is XML is tested with a reader of XML, in check_junit.py.
#include "viewer/compare/text_reports.h"

#include <gtest/gtest.h>

#include "tests/unit/compare/results.h"

namespace barrido::compare::test {
namespace {

TEST(JunitReport, APairIsATestCase) {
  const std::string xml = junit_report(run_of_all_outcomes());
  EXPECT_NE(xml.find("<testsuites tests=\"6\" failures=\"3\" errors=\"1\">"), std::string::npos) << xml;
  EXPECT_NE(xml.find("<testcase classname=\"barrido.diff/deep\" name=\"different.png\">"), std::string::npos);
  EXPECT_NE(xml.find("<failure message=\"different: max 0.5 at (12, 7), 2.5% of the pixels, FLIP 0.25\" "
                     "type=\"different\">"),
            std::string::npos)
      << xml;
  EXPECT_NE(xml.find("<error message=\"error: error.png: bad\" type=\"error\">"), std::string::npos);
  EXPECT_NE(xml.find("<testcase classname=\"barrido.diff\" name=\"same.png\"/>"), std::string::npos);
  EXPECT_NE(xml.find("<system-out>warning"), std::string::npos);
}

TEST(EscapeXml, WhatWouldEndOrBreakTheText) {
  EXPECT_EQ(escape_xml("<a href=\"x\">&'</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(escape_xml("line\nnext\ttab"), "line&#10;next&#9;tab");
  EXPECT_EQ(escape_xml(std::string("\x01\x1b\x00", 3)), "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
  EXPECT_EQ(escape_xml("Bäume 木 🌳"), "Bäume 木 🌳");
}

}  // namespace
}  // namespace barrido::compare::test
