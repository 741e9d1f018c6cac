// Messages and progress, looked at through a pipe.
#include "viewer/barrido/console.h"

#include <unistd.h>

#include <array>

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

using std::chrono::milliseconds;

class Pipe {
 public:
  Pipe() { EXPECT_EQ(pipe(ends_.data()), 0); }
  ~Pipe() { close(ends_[0]); }
  int input() const { return ends_[1]; }

  /// Everything written so far; no more can be written.
  std::string finish() {
    close(ends_[1]);
    std::string text;
    std::array<char, 256> buffer{};
    for (ssize_t count = 0; (count = read(ends_[0], buffer.data(), buffer.size())) > 0;) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  std::array<int, 2> ends_{};
};

TEST(Console, MessagesAreOneLineEach) {
  Pipe seen;
  Console console({seen.input(), false, false, milliseconds(0)});
  console.warning("a.glb: odd\nname");
  console.error("b.glb: broken");
  console.print(seen.input(), "text\n");
  EXPECT_EQ(seen.finish(), "barrido: warning: a.glb: odd\\nname\nbarrido: b.glb: broken\ntext\n");
}

TEST(Console, QuietLeavesOnlyErrors) {
  Pipe seen;
  Console console({seen.input(), true, true, milliseconds(0)});
  console.set_progress("working");
  console.warning("w");
  console.error("e");
  console.end_progress();
  EXPECT_EQ(seen.finish(), "barrido: e\n");
}

TEST(Console, ProgressIsForTerminals) {
  Pipe seen;
  Console console({seen.input(), false, false, milliseconds(0)});
  console.set_progress("working");
  usleep(20'000);
  console.end_progress();
  EXPECT_EQ(seen.finish(), "");
}

TEST(Console, ProgressComesWhenPatienceEndsAndIsErased) {
  Pipe seen;
  Console console({seen.input(), false, true, milliseconds(1)});
  console.set_progress("frame 1\tof 2");
  usleep(50'000);
  console.warning("w");
  console.end_progress();
  console.set_progress("nothing any more");
  EXPECT_EQ(seen.finish(), "\r\x1b[Kframe 1\\x09of 2\r\x1b[Kbarrido: warning: w\n");
}

TEST(Console, WhatIsFastShowsNoProgress) {
  Pipe seen;
  {
    Console console({seen.input(), false, true, milliseconds(1000)});
    console.set_progress("frame 1 of 2");
  }
  EXPECT_EQ(seen.finish(), "");
}

TEST(Console, LongProgressIsCutBetweenCharacters) {
  Pipe seen;
  Console console({seen.input(), false, true, milliseconds(1)});
  std::string text = "a";
  for (int i = 0; i < 100; ++i) text += "é";
  console.set_progress(text);
  usleep(50'000);
  console.end_progress();
  const std::string written = seen.finish();
  EXPECT_EQ(written.substr(0, 4 + 77), "\r\x1b[K" + text.substr(0, 77));
  EXPECT_EQ(written.substr(4 + 77), "\r\x1b[K");
}

}  // namespace
}  // namespace barrido::cli
