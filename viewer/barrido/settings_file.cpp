#include "viewer/barrido/settings_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <set>

#include <nlohmann/json.hpp>

#include "pipeline/files/write_file.h"
#include "viewer/barrido/text_format.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestFile = 1 << 20;

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw scene::InputError(path, "", "cannot be opened");
  std::string text(kLargestFile + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad() || (file.fail() && !file.eof())) throw scene::InputError(path, "", "cannot be read");
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kLargestFile) throw scene::InputError(path, "", "is no settings file: larger than 1 MiB");
  return text;
}

/// "line 3, column 7" of the byte with this number, from 1.
std::string place_of(const std::string& text, std::size_t byte) {
  const std::size_t end = std::min(byte == 0 ? 0 : byte - 1, text.size());
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  const std::size_t before = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  const std::size_t column = before == std::string::npos ? end + 1 : end - before;
  return "line " + std::to_string(line + 1) + ", column " + std::to_string(column);
}

/// The object of the file; a name that comes twice is refused, where the library would take the last.
Json parse_object(const std::string& path, const std::string& text) {
  std::set<std::string> names;
  const auto callback = [&](int depth, Json::parse_event_t event, Json& value) {
    if (depth > 2) throw scene::InputError(path, "", "is no settings file: values within values");
    if (event == Json::parse_event_t::key && depth == 1 && !names.insert(value.get<std::string>()).second) {
      throw scene::InputError(path, value.get<std::string>(), "is given twice");
    }
    return true;
  };
  try {
    Json json = Json::parse(text, callback);
    if (!json.is_object())
      throw scene::InputError(path, "", "expected a JSON object, {\"option\": value, …}");
    return json;
  } catch (const Json::parse_error& error) {
    throw scene::InputError(path, place_of(text, error.byte), "is not JSON");
  }
}

std::string number_text(const Json& number) {
  if (number.is_number_unsigned()) return std::to_string(number.get<std::uint64_t>());
  if (number.is_number_integer()) return std::to_string(number.get<std::int64_t>());
  return shortest_double(number.get<double>());
}

/// A string or number as the command line would hold it; false for other things.
bool scalar_text(const Json& value, std::string& text) {
  if (value.is_number()) {
    text = number_text(value);
  } else if (value.is_string()) {
    text = value.get<std::string>();
  } else {
    return false;
  }
  return true;
}

std::string joined_text(const std::string& path, const std::string& name, const Json& value) {
  std::string text;
  if (scalar_text(value, text)) return text;
  std::string all;
  const char* const expected = "expected a string, a number or an array of them";
  if (!value.is_array() || value.empty()) throw scene::InputError(path, name, expected);
  for (const Json& element : value) {
    if (!scalar_text(element, text)) throw scene::InputError(path, name, expected);
    all += (all.empty() ? "" : ",") + text;
  }
  return all;
}

/// All times the option is given.
std::vector<std::string> values_of(const std::string& path, const OptionSyntax& option, const Json& value) {
  const std::string name = settings_name(option);
  if (option.kind == OptionKind::flag) {
    if (!value.is_boolean()) throw scene::InputError(path, name, "expected true or false");
    return value.get<bool>() ? std::vector<std::string>{""} : std::vector<std::string>{};
  }
  if (option.kind != OptionKind::repeatable) return {joined_text(path, name, value)};
  std::vector<std::string> values;
  const Json array = value.is_array() ? value : Json::array({value});
  for (const Json& element : array) {
    if (!element.is_string()) throw scene::InputError(path, name, "expected a string or an array of strings");
    values.push_back(element.get<std::string>());
  }
  return values;
}

std::size_t find_setting(const std::string& path, const std::string& name,
                         std::span<const OptionSyntax> syntax) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < syntax.size(); ++i) {
    if (!syntax[i].is_setting()) continue;
    names.push_back(settings_name(syntax[i]));
    if (names.back() == name) return i;
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw scene::InputError(path, name, "is no setting" + did_you_mean(name, views));
}

/// Numbers become numbers, several of them an array, everything else a string.
Json json_of(const std::string& text) {
  Json array = Json::array();
  for (const std::string_view piece : split(text, ',')) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(piece.data(), piece.data() + piece.size(), number);
    const bool whole = error == std::errc{} && end == piece.data() + piece.size() && std::isfinite(number);
    if (!whole) return text;
    const bool is_integer =
        std::floor(number) == number && std::abs(number) < 1e15 && !(number == 0.0 && std::signbit(number));
    array.push_back(is_integer ? Json(static_cast<std::int64_t>(number)) : Json(number));
  }
  return array.size() == 1 ? array[0] : array;
}

}  // namespace

std::string settings_name(const OptionSyntax& option) { return std::string(option.name.substr(2)); }

std::vector<GivenOption> read_settings(const std::string& path, std::span<const OptionSyntax> syntax) {
  const Json json = parse_object(path, read_text(path));
  std::vector<GivenOption> given;
  for (const auto& [name, value] : json.items()) {
    const std::size_t index = find_setting(path, name, syntax);
    for (std::string& text : values_of(path, syntax[index], value)) {
      given.push_back({index, std::move(text), path});
    }
  }
  return given;
}

std::string settings_json(std::span<const OptionSyntax> syntax, std::span<const std::string> words) {
  Json json = Json::object();
  for (const GivenOption& given : parse_arguments(syntax, words).options) {
    const OptionSyntax& option = syntax[given.index];
    if (!option.is_setting()) continue;
    Json& value = json[settings_name(option)];
    if (option.kind == OptionKind::flag) {
      value = true;
    } else if (option.kind == OptionKind::repeatable) {
      value.push_back(given.value);
    } else {
      value = json_of(given.value);
    }
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_settings(const std::string& path, std::span<const OptionSyntax> syntax,
                    std::span<const std::string> words) {
  const std::string text = settings_json(syntax, words);
  scene::write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace barrido::cli
