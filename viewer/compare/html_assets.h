// The report's style, program and viewer, from viewer/compare/report/; the build puts them into the program.
#pragma once

#include <string_view>

namespace barrido::compare {

extern const std::string_view kReportCss;
extern const std::string_view kReportJs;
extern const std::string_view kViewerHtml;

}  // namespace barrido::compare
