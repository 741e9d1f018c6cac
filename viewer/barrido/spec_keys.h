// The grammar of options that hold several properties: NAME[:KEY=VALUE]…, or KEY=VALUE[:KEY=VALUE]… where
// nothing has a name. The keys of a thing stand in a table; reading, writing and complaints follow from it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/barrido/values.h"

namespace barrido::cli {

template <class Thing>
struct SpecKey {
  std::string_view name;
  unsigned kinds = ~0u;  ///< Kinds of things that have it, as bits.
  /// @throws ValueError.
  void (*read)(Thing& thing, std::string_view text) = nullptr;
  /// Empty: the thing is as it would be without the key.
  std::string (*write)(const Thing& thing) = nullptr;
};

/// Which things a table of keys is about, for messages.
struct SpecWords {
  std::string_view form;  ///< "TYPE:KEY=VALUE:..."
  std::string_view what;  ///< "this light"
};

/// Splits KEY=VALUE. @throws ValueError where there is no '=', or where `given` holds the key already.
std::pair<std::string_view, std::string_view> split_pair(std::string_view pair, const SpecWords& words,
                                                         std::vector<std::string_view>& given);

/// @throws ValueError "'dri' is no key of this light: expected one of dir, pos; did you mean 'dir'?".
[[noreturn]] void complain_unknown_key(std::string_view key, const SpecWords& words,
                                       std::span<const std::string_view> known);

/// Reads the pairs into a thing of this kind. @return the keys that were given.
/// @throws ValueError naming the key.
template <class Thing>
std::vector<std::string_view> read_keys(Thing& thing, std::span<const std::string_view> pairs,
                                        std::span<const SpecKey<Thing>> keys, const SpecWords& words,
                                        unsigned kind = 1) {
  std::vector<std::string_view> given;
  for (const std::string_view pair : pairs) {
    const auto [name, value] = split_pair(pair, words, given);
    const SpecKey<Thing>* found = nullptr;
    std::vector<std::string_view> known;
    for (const SpecKey<Thing>& key : keys) {
      if ((key.kinds & kind) == 0) continue;
      known.push_back(key.name);
      if (key.name == name) found = &key;
    }
    if (found == nullptr) complain_unknown_key(name, words, known);
    try {
      found->read(thing, value);
    } catch (const ValueError& error) {
      throw ValueError(std::string(name) + ": " + error.what());
    }
  }
  return given;
}

/// `name` (empty: none) and the keys that say something of a thing of this kind, in the order of the table.
template <class Thing>
std::string write_keys(std::string_view name, const Thing& thing, std::span<const SpecKey<Thing>> keys,
                       unsigned kind = 1) {
  std::string text(name);
  for (const SpecKey<Thing>& key : keys) {
    const std::string value = (key.kinds & kind) != 0 ? key.write(thing) : std::string();
    if (!value.empty()) text += (text.empty() ? "" : ":") + std::string(key.name) + "=" + value;
  }
  return text;
}

}  // namespace barrido::cli
