// Bad input as a value: which file, which place in it, and why.
#pragma once

#include <stdexcept>
#include <string>

namespace barrido::scene {

/// Thrown at the border of loaders and writers; what() is the whole message on one line:
/// "model.gltf: accessors[3]: byteOffset 96 reaches past the end of bufferViews[1]".
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, const std::string& place, const std::string& reason)
      : std::runtime_error(place.empty() ? file + ": " + reason : file + ": " + place + ": " + reason) {}
};

/// The input asks for more memory or time than it may take. Whoever goes on after other problems ends here.
class LimitError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace barrido::scene
