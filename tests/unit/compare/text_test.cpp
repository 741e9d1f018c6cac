// Texts: figures as idiff prints them, UTF-8, base64.
#include <gtest/gtest.h>

#include "tests/unit/compare/results.h"
#include "viewer/compare/figures_text.h"
#include "viewer/compare/text_encoding.h"

namespace barrido::compare::test {
namespace {

TEST(FiguresText, StandsLineByLine) {
  EXPECT_EQ(figures_text(result_of("x.png", Outcome::different, "RGB expected, RGBA found"), {}),
            "  RGB expected, RGBA found\n"
            "  Mean error = 0.001\n"
            "  RMS error  = 0.01\n"
            "  Peak SNR   = 40\n"
            "  Max error  = 0.5 @ (12, 7, G)  values are 0.5, 0.5, 0.5, 1 vs 0.5, 1, 0.5, 1\n"
            "  30 pixels (2.5%) over 1e-06\n"
            "  FLIP mean  = 0.25, weighted median 0.3, max 0.9\n");
}

TEST(FiguresText, TellsApartWarningsAndFailures) {
  Thresholds thresholds;
  thresholds.warn = 0.25f;
  thresholds.fail = 0.5f;
  EXPECT_NE(figures_text(result_of("x.png", Outcome::different), thresholds)
                .find("  60 pixels (5%) over 0.25 (warn)\n  30 pixels (2.5%) over 0.5 (fail)\n"),
            std::string::npos);
}

TEST(FiguresText, ValuesOfGreyAndAlpha) {
  EXPECT_EQ(values_text({0.1f, 0.1f, 0.1f, 0.5f}, 2), "0.1, 0.5");
  EXPECT_EQ(values_text({0.1f, 0.1f, 0.1f, 1}, 1), "0.1");
}

TEST(Headline, SaysWhyInALine) {
  EXPECT_EQ(headline(result_of("x", Outcome::missing, "not among the actual pictures")),
            "missing: not among the actual pictures");
  EXPECT_EQ(headline(result_of("x", Outcome::same)), "same");
}

TEST(ValidUtf8, KeepsCharactersAndReplacesTheRest) {
  const std::string replacement = "\xef\xbf\xbd";
  EXPECT_EQ(valid_utf8("aé木🌳"), "aé木🌳");
  EXPECT_EQ(valid_utf8("\xff"), replacement);
  EXPECT_EQ(valid_utf8("\xc3("), replacement + "(");
  EXPECT_EQ(valid_utf8("\xe6\x9c"), replacement + replacement) << "cut off";
  EXPECT_EQ(valid_utf8("\xc0\xaf"), replacement + replacement) << "overlong";
  EXPECT_EQ(valid_utf8("\xed\xa0\x80"), replacement + replacement + replacement) << "a surrogate";
  EXPECT_EQ(valid_utf8("\xef\xbf\xbf"), replacement + replacement + replacement) << "no character";
}

TEST(Base64, OfRfc4648) {
  const auto encode = [](const std::string& text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encode("\xfb\xff"), "+/8=");
}

}  // namespace
}  // namespace barrido::compare::test
