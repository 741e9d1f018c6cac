#include "tests/unit/viewer/program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

namespace barrido::test {
namespace {

void redirect(int descriptor, const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(97);
  close(file);
}

/// In the child: becomes the program.
[[noreturn]] void become_program(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(98);
  std::vector<char*> arguments;
  arguments.push_back(const_cast<char*>(BARRIDO_PROGRAM));
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(BARRIDO_PROGRAM, arguments.data());
  _exit(99);
}

void limit_memory(std::uint64_t bytes) {
  if (bytes == 0) return;
  const rlimit limit{bytes, bytes};
  if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(96);
}

}  // namespace

Outcome run(const std::vector<std::string>& words, const RunOptions& options) {
  const TemporaryFolder captured;
  const std::string out = options.out_path.empty() ? (captured.path() / "out").string() : options.out_path;
  const std::string error = (captured.path() / "error").string();
  const pid_t child = fork();
  if (child == 0) {
    redirect(STDERR_FILENO, error);
    if (options.close_out) {
      close(STDOUT_FILENO);
    } else {
      redirect(STDOUT_FILENO, out);
    }
    if (!options.in_path.empty()) {
      const int file = open(options.in_path.c_str(), O_RDONLY);
      if (file < 0 || dup2(file, STDIN_FILENO) < 0) _exit(95);
      close(file);
    }
    limit_memory(options.memory_bytes);
    become_program(words, options.folder);
  }
  Outcome outcome;
  outcome.status = wait_for(child);
  if (options.out_path.empty() && !options.close_out) outcome.out = read_text(out);
  outcome.error = read_text(error);
  return outcome;
}

Running start(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {};
  Running running;
  running.process = fork();
  if (running.process == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    become_program(words, folder);
  }
  close(ends[1]);
  running.output = ends[0];
  return running;
}

int wait_for(pid_t process) {
  int status = 0;
  if (waitpid(process, &status, 0) != process) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "barrido-test-XXXXXX").string();
  if (mkdtemp(name.data()) != nullptr) path_ = name;
  EXPECT_FALSE(path_.empty());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
    if (!entry.is_directory()) names.push_back(entry.path().lexically_relative(path_).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace barrido::test
