// The only file that sees CLI11, which is slow to compile. It sorts words; all values are read elsewhere, so
// that each complaint can name the option, the value and what is allowed.
#include "viewer/barrido/arguments.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "viewer/barrido/spelling.h"

namespace barrido::cli {
namespace {

constexpr const char* kNoValue = "true";  // What CLI11 reports for a flag without a value.

std::string names_for_cli11(const OptionSyntax& option) {
  std::string names(option.name);
  if (!option.short_name.empty()) names = std::string(option.short_name) + "," + names;
  return names;
}

CLI::Option* declare(CLI::App& app, const OptionSyntax& option) {
  const std::string names = names_for_cli11(option);
  if (option.kind == OptionKind::flag || option.kind == OptionKind::optional_value) {
    return app.add_flag(names)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  const auto accept_any = [](const CLI::results_t&) { return true; };
  return app.add_option(names, accept_any)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

const OptionSyntax* find(std::span<const OptionSyntax> syntax, std::string_view name) {
  for (const OptionSyntax& option : syntax) {
    if (option.name == name || (!name.empty() && option.short_name == name)) return &option;
  }
  return nullptr;
}

bool takes_value(const OptionSyntax& option) {
  return option.kind == OptionKind::value || option.kind == OptionKind::repeatable;
}

/// Two spellings that CLI11 reads otherwise than people mean them: `--name=` would take the next word as its
/// value, and `-o=x` would have the value "=x".
std::string normalized(std::span<const OptionSyntax> syntax, const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || word[0] != '-') return word;
  const OptionSyntax* option = find(syntax, word.substr(0, equals));
  if (option == nullptr) return word;
  if (equals + 1 == word.size()) throw UsageError(std::string(option->name) + ": needs a value");
  return std::string(option->name) + word.substr(equals);
}

[[noreturn]] void complain_unknown(std::span<const OptionSyntax> syntax, const std::string& word) {
  std::vector<std::string_view> names;
  for (const OptionSyntax& option : syntax) names.push_back(option.name);
  const std::string name = word.substr(0, word.find('='));
  throw UsageError("unknown option '" + name + "'" + did_you_mean(name, names));
}

/// The words before "--" through CLI11; those it does not know are files or unknown options.
void run(CLI::App& app, std::span<const OptionSyntax> syntax, std::span<const std::string> words) {
  std::vector<std::string> reversed(words.rbegin(), words.rend());  // CLI11 takes them from the back.
  try {
    app.parse(reversed);
  } catch (const CLI::ArgumentMismatch&) {
    // Only the last word can lack its value: everywhere else CLI11 takes the next word.
    const OptionSyntax* option = find(syntax, words.back());
    throw UsageError(std::string(option != nullptr ? option->name : words.back()) + ": needs a value");
  }
}

void add_results(Arguments& arguments, std::size_t index, const OptionSyntax& option,
                 const std::vector<std::string>& results) {
  if (results.size() > 1 && option.kind != OptionKind::repeatable) {
    throw UsageError(std::string(option.name) + ": given more than once");
  }
  for (const std::string& result : results) {
    const bool bare = !takes_value(option) && result == kNoValue;
    if (option.kind == OptionKind::flag && !bare) {
      throw UsageError(std::string(option.name) + ": '" + result + "': takes no value");
    }
    arguments.options.push_back({index, bare ? std::string() : result});
  }
}

}  // namespace

bool Arguments::has(std::size_t index) const {
  return std::any_of(options.begin(), options.end(),
                     [index](const GivenOption& given) { return given.index == index; });
}

Arguments parse_arguments(std::span<const OptionSyntax> syntax, std::span<const std::string> words) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::vector<CLI::Option*> declared;
  for (const OptionSyntax& option : syntax) declared.push_back(declare(app, option));

  const auto end_of_options = std::find(words.begin(), words.end(), "--");
  std::vector<std::string> before;
  for (auto word = words.begin(); word != end_of_options; ++word) before.push_back(normalized(syntax, *word));
  run(app, syntax, before);

  Arguments arguments;
  for (const std::string& word : app.remaining()) {
    if (word.size() > 1 && word[0] == '-') complain_unknown(syntax, word);
    arguments.files.push_back(word);
  }
  if (end_of_options != words.end()) {
    arguments.files.insert(arguments.files.end(), end_of_options + 1, words.end());
  }
  for (std::size_t i = 0; i < syntax.size(); ++i)
    add_results(arguments, i, syntax[i], declared[i]->results());
  return arguments;
}

}  // namespace barrido::cli
