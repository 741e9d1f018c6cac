// Which word was meant.
#include "viewer/barrido/spelling.h"

#include <array>

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

TEST(Spelling, EditDistanceCountsLettersAndSwaps) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("resolution", "resolutoin"), 1);
  EXPECT_EQ(edit_distance("ca", "abc"), 3);  // Of optimal string alignment; no letter is edited twice.
}

TEST(Spelling, NearestIsTheFirstOfTheNearEnough) {
  constexpr std::array<std::string_view, 4> kNames{"--resolution", "--light", "--fps", "--up"};
  EXPECT_EQ(nearest("--resolutoin", kNames), "--resolution");
  EXPECT_EQ(nearest("--lights", kNames), "--light");
  EXPECT_EQ(nearest("--fsp", kNames), "--fps");
  EXPECT_EQ(nearest("--upp", kNames), "--up");
  EXPECT_EQ(nearest("--size", kNames), "");
  EXPECT_EQ(nearest("--something-else", kNames), "");
  EXPECT_EQ(nearest("", kNames), "");
  EXPECT_EQ(nearest(std::string(100'000, 'x'), kNames), "");
}

TEST(Spelling, ListsReadAsSentences) {
  constexpr std::array<std::string_view, 3> kNames{"a", "b", "c"};
  EXPECT_EQ(one_of(kNames), "one of a, b, c");
  EXPECT_EQ(one_of(std::span(kNames).first(2)), "a or b");
  EXPECT_EQ(did_you_mean("b", kNames), "; did you mean 'b'?");
  EXPECT_EQ(did_you_mean("xyzzy", kNames), "");
}

}  // namespace
}  // namespace barrido::cli
