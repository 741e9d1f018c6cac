// What a row of the options does to options: the same for the command line, the window's widgets and keys.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "viewer/barrido/render_option_table.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {

bool RenderOption::is_given(const RenderOptions& options) const {
  static const RenderOptions kDefaults;
  return value.write(options) != value.write(kDefaults);
}

void RenderOption::assign(RenderOptions& options, const std::optional<std::string>& text) const {
  value.clear(options);
  if (text) read(options, *text);
}

int RenderOption::chosen(const RenderOptions& options) const {
  const std::vector<std::string> texts = value.write(options);
  const auto found = std::find(value.names.begin(), value.names.end(), texts.empty() ? "" : texts.front());
  return found == value.names.end() ? -1 : static_cast<int>(found - value.names.begin());
}

void RenderOption::choose(RenderOptions& options, int place) const {
  if (place < 0) return assign(options, std::nullopt);
  assign(options, std::string(value.names[static_cast<std::size_t>(place)]));
}

std::optional<double> RenderOption::number(const RenderOptions& options) const {
  const std::vector<std::string> texts = value.write(options);
  if (texts.empty()) return std::nullopt;
  double number = 0.0;
  std::from_chars(texts[0].data(), texts[0].data() + texts[0].size(), number);
  return number;
}

void RenderOption::set_number(RenderOptions& options, double number) const {
  number = std::clamp(number, value.range.least, value.range.most);
  assign(options, value.is_whole ? std::to_string(std::lround(number)) : shortest_double(number));
}

void step_option(RenderOptions& options, std::string_view name, float step) {
  const RenderOption& row = render_option(name);
  if (row.value.kind == OptionKind::flag) {
    const bool on = !row.value.write(options).empty();
    row.assign(options, on ? std::nullopt : std::optional<std::string>(""));
  } else if (!row.value.names.empty()) {
    const int first = row.value.is_optional ? -1 : 0;
    const int count = static_cast<int>(row.value.names.size()) - first;
    const int place = row.chosen(options) - first + static_cast<int>(step);
    row.choose(options, (place + count) % count + first);
  } else {
    row.set_number(options, row.number(options).value_or(0.0) + static_cast<double>(step));
  }
}

}  // namespace barrido::cli
