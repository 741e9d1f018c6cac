// Numbers as people read them.
#include "viewer/barrido/text_format.h"

#include <gtest/gtest.h>

#include <limits>

#include "viewer/barrido/standard_streams.h"

namespace barrido::cli {
namespace {

TEST(TextFormat, ThousandsAreGrouped) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(12345678), "12,345,678");
}

TEST(TextFormat, NumbersNeedNoLocale) {
  EXPECT_EQ(fixed(12.345, 1), "12.3");
  EXPECT_EQ(fixed(std::numeric_limits<double>::max(), 2).size(), 312u);
  EXPECT_EQ(shortest(0.1f), "0.1");
  EXPECT_EQ(counted(1, "mesh", "meshes"), "1 mesh");
  EXPECT_EQ(counted(2000, "mesh", "meshes"), "2,000 meshes");
}

TEST(TextFormat, PaddingCountsCharacters) {
  EXPECT_EQ(left("ab", 4), "ab  ");
  EXPECT_EQ(right("ab", 4), "  ab");
  EXPECT_EQ(right("é", 3), "  é");
  EXPECT_EQ(left("abc", 2), "abc");
}

TEST(TextFormat, ControlCharactersBreakNoLine) {
  EXPECT_EQ(on_one_line("a\nb\r\x1b[31m\x7f"), "a\\nb\\x0d\\x1b[31m\\x7f");
  EXPECT_EQ(on_one_line("Zürich"), "Zürich");
}

}  // namespace
}  // namespace barrido::cli
