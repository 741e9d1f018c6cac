// The options of `barrido render`, a row an option, in the order of the help. All that knows options reads
// these rows: the command line and its help, settings files, the command line that the window copies, its
// panel and keys, and `barrido inspect`. docs/adding.md tells how to add one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/barrido/render_options.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {

struct RenderOption;

/// Bounds of a number, both included.
struct Range {
  double least = -kAnyNumber;
  double most = kAnyNumber;
};

/// How an option is read and written, and what its words are.
struct OptionValue {
  OptionKind kind = OptionKind::value;
  /// Reads a value (empty for a flag) into the options. @throws ValueError.
  void (*read)(const RenderOption& row, RenderOptions& options, std::string_view text) = nullptr;
  /// The values that say what the options hold: none, one, or one for each time the option is repeated. A
  /// flag that is on has one, the empty text. Each reads back as the same bits.
  std::vector<std::string> (*write)(const RenderOptions& options) = nullptr;
  /// Sets the default; null where no widget needs it.
  void (*clear)(RenderOptions& options) = nullptr;
  Range range{};                             ///< Of a number.
  std::span<const std::string_view> names;   ///< Words of which one is the value; empty: no choice.
  std::span<const std::string_view> titles;  ///< The same as the window spells them.
  bool is_number = false;
  bool is_whole = false;
  bool is_optional = false;        ///< Without a value the file decides.
  bool is_always_written = false;  ///< On copied command lines, the default too.
};

/// How the window's panel changes an option.
struct Editor {
  enum class Kind {
    missing,
    none,    ///< Not in the panel; `label` says why.
    widget,  ///< A switch, a list or a slider, as the value asks.
    special  ///< Written by hand: viewer/barrido-view/panel.cpp has it under `heading`.
  };
  Kind kind = Kind::missing;
  std::string_view label{};
  std::string_view heading{};  ///< Part of the panel; empty: the option's section of the help.
  std::string_view without{};  ///< What an optional choice is called that has no value.
  bool beside = false;         ///< Stands on the line of the option before.
  bool inverted = false;       ///< A switch that is on where the flag is not given.
  Range slider{};
  const char* format = "%.2f";  ///< Of the slider's number, as printf takes it.
  float start = 0.0f;           ///< A number that has no value begins here.
  /// A sentence below the widget about what is chosen; null: none.
  std::string_view (*note)(const RenderOptions& options) = nullptr;
};

struct RenderOption {
  OptionSyntax syntax;
  OptionValue value;
  Editor editor;

  /// @throws ValueError.
  void read(RenderOptions& options, std::string_view text) const { value.read(*this, options, text); }
  /// Whether the options hold something else than the default.
  bool is_given(const RenderOptions& options) const;
  /// The default, then `text`; nothing for the default. Only where `clear` is. @throws ValueError.
  void assign(RenderOptions& options, const std::optional<std::string>& text) const;
  /// The place of the chosen word, −1 where an optional one has no value; and another chosen.
  int chosen(const RenderOptions& options) const;
  void choose(RenderOptions& options, int place) const;
  /// The number; none where an optional one has no value.
  std::optional<double> number(const RenderOptions& options) const;
  void set_number(RenderOptions& options, double number) const;

  std::string_view heading() const { return editor.heading.empty() ? syntax.section : editor.heading; }
};

std::span<const RenderOption> render_option_table();

/// @throws std::out_of_range where there is no option of this name.
const RenderOption& render_option(std::string_view name);

/// One step on, or `step` −1 back, round all that the option can be: a flag is switched, a choice goes to its
/// next word (optional ones have no value first), a number grows by `step` within its bounds.
void step_option(RenderOptions& options, std::string_view name, float step);

}  // namespace barrido::cli
