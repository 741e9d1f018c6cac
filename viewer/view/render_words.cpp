#include "viewer/view/render_words.h"

#include <algorithm>

#include "viewer/barrido/render_option_table.h"

namespace barrido::view {
namespace {

bool is_harmless(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || std::string_view("-_./,:=+@%").find(letter) != std::string::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_harmless)) return word;
  std::string text = "'";
  for (const char letter : word) {
    if (letter == '\'') {
      text += "'\\''";
    } else {
      text += letter;
    }
  }
  return text + "'";
}

}  // namespace

std::vector<std::string> words_of(const cli::RenderOptions& options) {
  std::vector<std::string> words;
  for (const cli::RenderOption& row : cli::render_option_table()) {
    if (!row.syntax.is_setting() || !(row.is_given(options) || row.value.is_always_written)) continue;
    for (const std::string& text : row.value.write(options)) {
      words.emplace_back(row.syntax.name);
      if (row.syntax.kind != cli::OptionKind::flag) words.push_back(text);
    }
  }
  return words;
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + quoted(word);
  return line;
}

}  // namespace barrido::view
