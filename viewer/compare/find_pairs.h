// Which pictures belong together: two files, or the files of two folders by their relative names. Must not
// know: pixels.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace barrido::compare {

/// Two files that should show the same; the path that does not exist is empty.
struct Pair {
  std::string name;  ///< Relative to both folders, with '/' between; of two files the name of the second.
  std::filesystem::path expected;
  std::filesystem::path actual;
  std::filesystem::path target;  ///< Where the expected file is, or would be.
};

enum class MissingExpected { is_an_error, is_empty };

/// Two pictures are one pair. Two folders are walked with all folders below (links to folders are not
/// followed), and files with an extension of a format that is read are matched by relative name, in the order
/// of their names; other files and hidden ones (".…") are passed over.
/// @throws scene::InputError when one does not exist or cannot be read, a folder meets a file, or there is no
/// picture. Where pictures are to be blessed, `expected` need not exist.
std::vector<Pair> find_pairs(const std::filesystem::path& expected, const std::filesystem::path& actual,
                             MissingExpected missing = MissingExpected::is_an_error);

}  // namespace barrido::compare
