// What a run leaves behind: pictures of a failure, and the table of all features.
#pragma once

#include <filesystem>

#include "tests/osmesa/compare.h"

namespace barrido::crosscheck {

/// Writes NAME-expected.png, NAME-actual.png and NAME-difference.png (times 16), colours without alpha.
/// @throws std::runtime_error naming the file that cannot be written.
void write_pictures(const std::filesystem::path& folder, const std::string& name, const Picture& expected,
                    const Picture& actual);

/// File name for a feature's name.
std::string slug(const std::string& feature);

/// The table as Markdown. `figures` in the order of `features`. @throws as above.
void write_table(const std::filesystem::path& file, const std::vector<Feature>& features,
                 const std::vector<Figures>& figures, const std::string& reference,
                 const std::string& command);

}  // namespace barrido::crosscheck
