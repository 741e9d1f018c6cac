// What holds for the whole process, whatever it is doing: how it ends when it is told to, when its time is
// up, and when memory runs out where no error can be told. In each case with one line at most, and without
// the files that were only begun. Knows no command.
#pragma once

#include <cstdint>
#include <exception>
#include <string>

namespace barrido::cli {

/// To be called first in main. SIGINT, SIGTERM and SIGHUP end the process as they always do, but temporary
/// files are removed before; SIGXFSZ is ignored, so that a file that grows too large is an error of its
/// write.
void guard_process();

enum class ClockKind {
  wall,       ///< As people count.
  processor,  ///< Of all processors together: what other programs do does not count.
};

/// From now on the process ends with exit status 2 and the line "barrido: MESSAGE" unless stop_clock or
/// another start_clock comes within `seconds`.
void start_clock(ClockKind kind, double seconds, const std::string& message);
/// The time goes on, but another line will be told.
void rename_clock(const std::string& message);
void stop_clock();

/// The process may hold so many bytes of data; beyond that, allocations fail. Never more than the system
/// allowed when the program began.
void limit_data(std::uint64_t bytes);

/// "not enough memory", and the limit where limit_data was called.
std::string out_of_memory();

/// Whether it was memory that ran out: std::bad_alloc, or what oneTBB says when a thread gets no stack.
bool is_out_of_memory(const std::exception& error);

}  // namespace barrido::cli
