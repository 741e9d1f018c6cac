#include "viewer/compare/text_reports.h"

#include "viewer/compare/figures_text.h"
#include "viewer/compare/text_encoding.h"

namespace barrido::compare {
namespace {

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + escape_xml(value) + "\"";
}

/// A CI system shows the path's folders as the class, the file as the test.
std::string case_start(const Result& result) {
  const std::filesystem::path name = result.pair.name;
  const std::string folder = name.parent_path().generic_string();
  return "    <testcase" +
         attribute("classname", folder.empty() ? "barrido.diff" : "barrido.diff/" + folder) +
         attribute("name", name.filename().string());
}

std::string case_of(const Result& result, const Thresholds& thresholds) {
  const std::string figures = figures_text(result, thresholds);
  if (result.outcome == Outcome::same) return case_start(result) + "/>\n";
  if (result.outcome == Outcome::warning) {
    return case_start(result) + ">\n      <system-out>" + escape_xml("warning\n" + figures) +
           "</system-out>\n    </testcase>\n";
  }
  const std::string_view element = result.outcome == Outcome::error ? "error" : "failure";
  return case_start(result) + ">\n      <" + std::string(element) + attribute("message", headline(result)) +
         attribute("type", name_of(result.outcome)) + ">" + escape_xml(figures) + "</" +
         std::string(element) + ">\n    </testcase>\n";
}

}  // namespace

std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\t':
        escaped += "&#9;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? "\xef\xbf\xbd" : std::string(1, c);
    }
  }
  return escaped;
}

std::string junit_report(const Run& run) {
  const Totals totals = totals_of(run);
  const std::string counts = attribute("tests", std::to_string(totals.all())) +
                             attribute("failures", std::to_string(totals.failed() - totals[Outcome::error])) +
                             attribute("errors", std::to_string(totals[Outcome::error]));
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts + ">\n  <testsuite" +
                    attribute("name", "barrido diff " + run.expected + " " + run.actual) + counts +
                    attribute("skipped", "0") + ">\n";
  for (const Result& result : run.results) xml += case_of(result, run.settings.thresholds);
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace barrido::compare
