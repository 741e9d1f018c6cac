// The module's side of a C interface: whatever its library throws becomes a line of text. Must not know:
// anything of Barrido but the interface.
#pragma once

#include <algorithm>
#include <cstring>
#include <exception>
#include <string>

#include "pipeline/files/module_interface.h"

namespace barrido::module {

inline void set_error(BarridoModuleError* error, std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  if (text.empty()) text = "unknown error";
  const std::size_t length = std::min(text.size(), sizeof(error->text) - 1);
  std::memcpy(error->text, text.data(), length);
  error->text[length] = '\0';
}

/// Runs `body`, which returns a value that converts to bool; an exception becomes a failure.
template <class Body>
auto guarded(BarridoModuleError* error, Body body) -> decltype(body()) {
  try {
    return body();
  } catch (const std::exception& exception) {
    set_error(error, exception.what());
  } catch (...) {
    set_error(error, "unknown exception");
  }
  return {};
}

}  // namespace barrido::module
