// The text of the report around its pictures. Must not know: files, pixels.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viewer/compare/viewer_data.h"

namespace barrido::compare {

/// Everything before the pictures: style, totals, the table with a row a pair, worst first, and the viewer.
std::string page_before_pictures(const Run& run);

/// A picture as an element that shows nothing by itself.
std::string picture_element(std::string_view name, std::string_view base64_text);

/// The data for the viewer, the viewer's program and the end. `shown` stands beside the results.
std::string page_after_pictures(const Run& run, const std::vector<Shown>& shown);

/// For text and for values of attributes.
std::string escape_html(std::string_view text);

}  // namespace barrido::compare
