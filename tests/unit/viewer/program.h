// Runs the built program as a user does and tells what came out of it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace barrido::test {

struct Outcome {
  int status = -1;    ///< Exit status; 128 + n when signal n ended the program.
  std::string out;    ///< Standard output, whole.
  std::string error;  ///< Standard error, whole.
};

struct RunOptions {
  std::filesystem::path folder;    ///< Working directory.
  std::string out_path;            ///< Where standard output goes instead of into Outcome; empty: there.
  bool close_out = false;          ///< Start with standard output closed.
  std::uint64_t memory_bytes = 0;  ///< Limit of the address space; 0: none.
  std::string in_path{};           ///< File that is standard input; empty: the test's own.
};

/// Runs `barrido WORDS…` to its end.
Outcome run(const std::vector<std::string>& words, const RunOptions& options = {});

/// Starts `barrido WORDS…` with standard output into a pipe that the caller reads.
struct Running {
  pid_t process = 0;
  int output = -1;  ///< To be closed by the caller.
};
Running start(const std::vector<std::string>& words, const std::filesystem::path& folder);
/// Waits for its end and returns the exit status as Outcome does.
int wait_for(pid_t process);

/// A folder of its own that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Names of all files below, sorted, relative to the folder.
  std::vector<std::string> files() const;

 private:
  std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

/// Lines without their line feeds.
std::vector<std::string> lines_of(const std::string& text);

}  // namespace barrido::test
