// Modules: shared objects that hold a library which most processes never need, so that only those that need
// it pay for it. Finds and loads them, and asks each for its table of functions. Must not know: what they do.
#pragma once

#include <cstdint>
#include <string>

namespace barrido::scene {

/// A module, loaded by the constructor; what wants its functions keeps one in a static variable, so that the
/// first need loads it and it stays.
class Module {
 public:
  /// `file`: "barrido_oiio.so". It is looked for in this order: the folders of the environment variable
  /// BARRIDO_MODULE_PATH (separated by colons), beside the program or library that holds this code,
  /// ../lib/barrido from there, the build tree when the program runs inside it, and the folder given by the
  /// installation. `entry`: the C function without arguments that returns the table of functions, which
  /// begins with an int32_t that must be `version`.
  Module(std::string file, const char* entry, std::int32_t version);

  /// The table; null where the module could not be loaded.
  template <class Functions>
  const Functions* functions() const {
    return static_cast<const Functions*>(functions_);
  }

  /// Why there is no table: "reading EXR needs the module barrido_oiio.so, which …", for `purpose` "reading
  /// EXR".
  std::string problem(const std::string& purpose) const;

 private:
  std::string file_;
  const void* functions_ = nullptr;
  std::string problem_;
};

}  // namespace barrido::scene
