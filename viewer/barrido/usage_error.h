// A command line that cannot be obeyed, as a value: what() is the whole message on one line, without the
// program's name in front.
#pragma once

#include <stdexcept>
#include <string>

namespace barrido::cli {

/// "--resolution: '0,5': expected W,H, two whole numbers in 1..16384".
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Why a value is refused; the parser of the command line puts the option and the value in front.
class ValueError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace barrido::cli
