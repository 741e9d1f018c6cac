#include "viewer/barrido/process_guard.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>

#include "pipeline/files/budget.h"
#include "pipeline/files/temporary_files.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/standard_streams.h"

// Sanitizers reserve terabytes of addresses, which count as data: there, a limit would end the program at
// once.
#if defined(__has_feature)
#define BARRIDO_HAS_FEATURE(feature) __has_feature(feature)
#else
#define BARRIDO_HAS_FEATURE(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || \
    BARRIDO_HAS_FEATURE(address_sanitizer) || BARRIDO_HAS_FEATURE(thread_sanitizer)
#define BARRIDO_RESERVES_TERABYTES true
#else
#define BARRIDO_RESERVES_TERABYTES false
#endif

namespace barrido::cli {
namespace {

/// The line for the end, in memory that a handler of a signal may read: the one that is not shown is filled,
/// then they are exchanged.
struct Line {
  std::array<char, 1024> text{};
  std::size_t size = 0;
};
std::array<Line, 2> lines;
std::atomic<const Line*> last_line{nullptr};
std::mutex line_mutex;
std::atomic<std::uint64_t> data_limit{0};

/// Only what a handler of a signal may do.
[[noreturn]] void leave_with(const Line* line) {
  scene::remove_temporary_files();
  if (line != nullptr) {
    // Where could it be told that this fails?
    [[maybe_unused]] const ssize_t written = ::write(kStandardError, line->text.data(), line->size);
  }
  ::_exit(kExitError);
}

extern "C" void on_alarm(int) { leave_with(last_line); }

extern "C" void on_end(int number) {
  scene::remove_temporary_files();
  std::signal(number, SIG_DFL);
  ::raise(number);  // Comes when this handler returns.
}

void handle(int number, void (*handler)(int)) {
  struct sigaction action {};
  ::sigaction(number, nullptr, &action);
  // Who starts a program in the background has it ignore interruptions; that stays so.
  if (number != SIGALRM && number != SIGPROF && action.sa_handler == SIG_IGN) return;
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(number, &action, nullptr);
}

/// Memory that runs out where no exception may leave.
[[noreturn]] void on_terminate() {
  static Line line;
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    constexpr std::string_view kText = "barrido: not enough memory (--max-memory may allow more)\n";
    std::copy(kText.begin(), kText.end(), line.text.begin());
    line.size = kText.size();
    leave_with(&line);
  } catch (...) {
    scene::remove_temporary_files();
  }
  std::abort();
}

void set_line(const std::string& message) {
  const std::lock_guard lock(line_mutex);
  Line& line = last_line == &lines[0] ? lines[1] : lines[0];
  const bool terminal = ::isatty(kStandardError) == 1;
  const std::string text = (terminal ? "\r\x1b[K" : "") + ("barrido: " + on_one_line(message));
  line.size = std::min(text.size(), line.text.size() - 1);
  std::memcpy(line.text.data(), text.data(), line.size);
  line.text[line.size++] = '\n';
  last_line = &line;
}

void set_timer(ClockKind kind, double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>((seconds - static_cast<double>(timer.it_value.tv_sec)) * 1e6);
  ::setitimer(kind == ClockKind::wall ? ITIMER_REAL : ITIMER_PROF, &timer, nullptr);
}

}  // namespace

void guard_process() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) handle(number, on_end);
  handle(SIGALRM, on_alarm);
  handle(SIGPROF, on_alarm);
  std::signal(SIGXFSZ, SIG_IGN);
  std::set_terminate(on_terminate);
}

void start_clock(ClockKind kind, double seconds, const std::string& message) {
  set_line(message);
  set_timer(kind, std::max(seconds, 1e-3));
}

void rename_clock(const std::string& message) { set_line(message); }

void stop_clock() {
  set_timer(ClockKind::wall, 0.0);
  set_timer(ClockKind::processor, 0.0);
}

void limit_data(std::uint64_t bytes) {
  if constexpr (BARRIDO_RESERVES_TERABYTES) return;
  static const rlimit at_start = [] {
    rlimit limit{};
    ::getrlimit(RLIMIT_DATA, &limit);
    return limit;
  }();
  rlimit limit = at_start;
  limit.rlim_cur = std::min<rlim_t>(bytes, at_start.rlim_cur);
  if (::setrlimit(RLIMIT_DATA, &limit) == 0) data_limit = limit.rlim_cur;
}

std::string out_of_memory() {
  if (data_limit == 0) return "not enough memory";
  return "not enough memory (--max-memory is " + scene::shown_bytes(data_limit) + ")";
}

bool is_out_of_memory(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
         std::string_view(error.what()).starts_with("pthread_create has failed");
}

}  // namespace barrido::cli
