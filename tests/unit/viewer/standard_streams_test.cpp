// Standard descriptors that are closed stay out of use.
#include "viewer/barrido/standard_streams.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include <gtest/gtest.h>

namespace barrido::cli {
namespace {

/// Exit status of `act` in a process of its own.
int status_of(int (*act)()) {
  const pid_t child = fork();
  if (child == 0) _exit(act());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(StandardStreams, NoFileTakesThePlaceOfAClosedOne) {
  const auto act = [] {
    for (int descriptor = 0; descriptor <= 2; ++descriptor) close(descriptor);
    prepare_standard_streams();
    const int file = open("/dev/null", O_RDWR);
    const bool output_fails = write_all(kStandardOutput, bytes_of("x")) == EBADF;
    char byte = 0;
    const bool input_fails = read(0, &byte, 1) < 0;
    return file > 2 && output_fails && input_fails ? 0 : 1;
  };
  EXPECT_EQ(status_of(act), 0);
}

TEST(StandardStreams, AClosedPipeIsAnErrorOfTheWrite) {
  const auto act = [] {
    prepare_standard_streams();
    int ends[2];
    if (pipe(ends) != 0) return 2;
    close(ends[0]);
    return write_all(ends[1], bytes_of("x")) == EPIPE ? 0 : 1;
  };
  EXPECT_EQ(status_of(act), 0);
}

}  // namespace
}  // namespace barrido::cli
