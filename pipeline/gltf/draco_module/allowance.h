// How much memory a library may take that asks for none. Must not know: which library.
#pragma once

#include <cstddef>

namespace barrido::draco_module {

/// While it lives, `new` on this thread and within this module takes at most so many bytes, and then throws
/// std::bad_alloc. Works where the library is linked into the module, and not under AddressSanitizer, which
/// has a `new` of its own; the process's own limits then remain.
class Allowance {
 public:
  explicit Allowance(std::size_t bytes);
  ~Allowance();
  Allowance(const Allowance&) = delete;
  Allowance& operator=(const Allowance&) = delete;
};

}  // namespace barrido::draco_module
