// Numbers and words from text: the whole text or nothing.
#include "viewer/barrido/values.h"

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

std::string complaint(const auto& parse) {
  try {
    parse();
  } catch (const ValueError& error) {
    return error.what();
  }
  return "";
}

TEST(Values, NumbersAreReadWhole) {
  EXPECT_EQ(parse_number("0.25", 0, 1), 0.25);
  EXPECT_EQ(parse_number("+1", -2, 2), 1.0);
  EXPECT_EQ(parse_number("-1.5e0", -2, 2), -1.5);
  EXPECT_EQ(parse_whole("007", 0, 9), 7);
}

TEST(Values, WhatIsNoNumberIsRefused) {
  for (const char* text : {"", " 1", "1 ", "1x", "nan", "NaN", "inf", "-inf", "1e999", "0x10", "+-1", "++1",
                           "+", "1,5", "--1"}) {
    EXPECT_THROW(parse_number(text, -kAnyNumber, kAnyNumber), ValueError) << text;
    EXPECT_THROW(parse_whole(text, -1000, 1000), ValueError) << text;
  }
  EXPECT_THROW(parse_whole("1.5", 0, 9), ValueError);
  EXPECT_THROW(parse_whole("99999999999999999999", 0, 9), ValueError);
}

TEST(Values, ComplaintsNameTheRange) {
  EXPECT_EQ(complaint([] { parse_number("7", 0.5, 6); }), "expected a number in 0.5..6");
  EXPECT_EQ(complaint([] { parse_number("x", 0, kAnyNumber); }), "expected a number of 0 or more");
  EXPECT_EQ(complaint([] { parse_number("x", -kAnyNumber, kAnyNumber); }), "expected a number");
  EXPECT_EQ(complaint([] { parse_whole("0", 1, 16384); }), "expected a whole number in 1..16384");
}

TEST(Values, SplitKeepsEmptyPieces) {
  EXPECT_EQ(split("a:b", ':'), (std::vector<std::string_view>{"a", "b"}));
  EXPECT_EQ(split(":", ':'), (std::vector<std::string_view>{"", ""}));
  EXPECT_EQ(split("", ':'), (std::vector<std::string_view>{""}));
}

TEST(Values, TuplesHaveExactlyTheirNumbers) {
  EXPECT_EQ((parse_tuple<3>("1,-2,.5", "X,Y,Z", -9, 9)), (std::array<float, 3>{1, -2, 0.5f}));
  for (const char* text : {"1,2", "1,2,3,4", "1,,3", "1,2,", "1;2;3", "1,2,nan", "1,2,10"}) {
    EXPECT_EQ(complaint([text] { parse_tuple<3>(text, "X,Y,Z", -9, 9); }),
              "expected X,Y,Z, 3 numbers in -9..9")
        << text;
  }
}

TEST(Values, ChoicesNameTheOthersAndTheNearOne) {
  constexpr std::array<Named<int>, 3> kRows{{{1, "flat"}, {2, "gouraud"}, {3, "phong"}}};
  const std::span<const Named<int>> kChoices(kRows);
  EXPECT_EQ(parse_choice("gouraud", kChoices), 2);
  EXPECT_EQ(complaint([&] { parse_choice("phnog", kChoices); }),
            "expected one of flat, gouraud, phong; did you mean 'phong'?");
  EXPECT_EQ(complaint([&] { parse_choice("wireframe", kChoices); }), "expected one of flat, gouraud, phong");
  EXPECT_THROW(parse_choice("", kChoices), ValueError);
  EXPECT_THROW(parse_choice("Flat", kChoices), ValueError);
}

}  // namespace
}  // namespace barrido::cli
