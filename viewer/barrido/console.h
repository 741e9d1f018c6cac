// What the user sees while the program works: warnings and errors, one line each, and on a terminal a line of
// progress once something takes longer than a second. Safe to use from several threads.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "viewer/barrido/standard_streams.h"

namespace barrido::cli {

struct ConsoleOptions {
  int descriptor = kStandardError;           ///< Where messages and progress go.
  bool quiet = false;                        ///< No warnings, no progress.
  bool is_terminal = false;                  ///< Whether progress can be seen and erased again.
  std::chrono::milliseconds patience{1000};  ///< How long nothing is said.
};

class Console {
 public:
  explicit Console(const ConsoleOptions& options) : options_(options) {}
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// "barrido: warning: …"
  void warning(std::string_view message);
  /// "barrido: …"
  void error(std::string_view message);
  /// Text for standard output, or standard error; the progress line does not get into it.
  /// @throws scene::InputError when standard output cannot be written.
  void print(int descriptor, std::string_view text);

  /// What is being done now ("frame 3 of 12"); shown from when the program has worked for `patience`.
  void set_progress(std::string text);
  /// Erases the progress line and shows no more.
  void end_progress();

 private:
  void write_line(std::string_view prefix, std::string_view message);
  void show_progress();
  void erase_progress();  // With the mutex held, as the following.

  ConsoleOptions options_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string progress_;
  bool shown_ = false;
  bool ended_ = false;
  std::thread painter_;  // Started with the first progress on a terminal.
};

}  // namespace barrido::cli
