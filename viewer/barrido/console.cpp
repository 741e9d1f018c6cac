#include "viewer/barrido/console.h"

namespace barrido::cli {
namespace {

constexpr std::string_view kEraseLine = "\r\x1b[K";
constexpr std::chrono::milliseconds kBetweenPaintings{100};

/// So much of a line as fits any terminal: a line that wraps cannot be erased. Cut between characters of
/// UTF-8.
std::string cut(std::string line) {
  constexpr std::size_t kWidth = 78;
  if (line.size() <= kWidth) return line;
  std::size_t end = kWidth;
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0) == 0x80) --end;
  line.resize(end);
  return line;
}

}  // namespace

Console::~Console() { end_progress(); }

void Console::warning(std::string_view message) {
  if (!options_.quiet) write_line("barrido: warning: ", message);
}

void Console::error(std::string_view message) { write_line("barrido: ", message); }

void Console::write_line(std::string_view prefix, std::string_view message) {
  const std::string line = std::string(prefix) + on_one_line(message) + "\n";
  const std::lock_guard lock(mutex_);
  erase_progress();
  write_all(options_.descriptor, bytes_of(line));  // Where could a failure be told?
}

void Console::print(int descriptor, std::string_view text) {
  const std::lock_guard lock(mutex_);
  erase_progress();
  if (descriptor == kStandardOutput) {
    write_standard_output(bytes_of(text));
  } else {
    write_all(descriptor, bytes_of(text));
  }
}

void Console::set_progress(std::string text) {
  if (options_.quiet || !options_.is_terminal) return;
  const std::lock_guard lock(mutex_);
  progress_ = cut(on_one_line(text));
  if (!painter_.joinable() && !ended_) painter_ = std::thread([this] { show_progress(); });
}

void Console::end_progress() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  if (painter_.joinable()) painter_.join();
  const std::lock_guard lock(mutex_);
  erase_progress();
}

void Console::show_progress() {
  std::unique_lock lock(mutex_);
  const auto ended = [this] { return ended_; };
  if (changed_.wait_for(lock, options_.patience, ended)) return;
  std::string painted;
  do {
    if (shown_ && progress_ == painted) continue;
    painted = progress_;
    write_all(options_.descriptor, bytes_of(std::string(kEraseLine) + painted));
    shown_ = true;
  } while (!changed_.wait_for(lock, kBetweenPaintings, ended));
}

void Console::erase_progress() {
  if (shown_) write_all(options_.descriptor, bytes_of(kEraseLine));
  shown_ = false;
}

}  // namespace barrido::cli
