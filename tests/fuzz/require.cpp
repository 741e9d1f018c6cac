#include <cstdio>
#include <cstdlib>

#include "targets.h"

namespace barrido::fuzz {

void require(bool holds, const std::string& message) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: %s\n", message.c_str());
  std::abort();
}

}  // namespace barrido::fuzz
