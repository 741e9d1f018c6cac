// Every key with what it does and how the help names it: one table for the window and for the help. Knows no
// window; keys are numbered here.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "viewer/view/viewer.h"

namespace barrido::view {

/// Printable keys are their character, letters upper case; the others follow.
enum class Key : int {
  none = 0,
  escape = 256,
  enter,
  tab,
  space,
  up,
  left,
  right,
  f12,
};

constexpr Key key_of(char character) { return static_cast<Key>(character); }

enum Modifiers : unsigned { kPlain = 0, kShift = 1, kControl = 2 };

/// What a key does: a function, or a step of an option.
struct KeyAction {
  void (*run)(Viewer& viewer) = nullptr;
  std::string_view option{};
  float step = 0.0f;

  constexpr KeyAction() = default;
  constexpr KeyAction(void (*function)(Viewer&), std::string_view name, float by)
      : run(function), option(name), step(by) {}
  /// A function, or a lambda that is one.
  template <class Function>
  constexpr KeyAction(Function function) : run(function) {}

  explicit operator bool() const { return run != nullptr || !option.empty(); }
  void operator()(Viewer& viewer) const;
};

struct KeyBinding {
  std::string_view section;  ///< Heading of the help
  Key key = Key::none;       ///< none: a line of the help about the mouse
  unsigned modifiers = kPlain;
  std::string_view name;  ///< "Shift+S"
  std::string_view help;
  KeyAction action{};
};

std::span<const KeyBinding> key_table();

/// Runs what is bound to the key. @return whether something is.
bool press(Viewer& viewer, Key key, unsigned modifiers);

/// The table as text, one line a key.
std::string keys_help();

}  // namespace barrido::view
