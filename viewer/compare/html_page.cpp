#include "viewer/compare/html_page.h"

#include "viewer/compare/false_color.h"
#include "viewer/compare/figures_text.h"
#include "viewer/compare/html_assets.h"
#include "viewer/compare/text_reports.h"
#include "viewer/compare/viewer_data.h"

namespace barrido::compare {
namespace {

constexpr Outcome kWorstFirst[] = {Outcome::error, Outcome::different, Outcome::missing,
                                   Outcome::added, Outcome::warning,   Outcome::same};

std::string title_of(const Totals& totals) {
  const std::string pairs = std::to_string(totals.all()) + (totals.all() == 1 ? " pair" : " pairs");
  if (totals.failed() == 0)
    return totals.all() == 1 ? "The pair is the same" : "All " + pairs + " are the same";
  return std::to_string(totals.failed()) + " of " + pairs + " failed";
}

std::string thresholds_text(const Thresholds& thresholds) {
  std::string text = "a pixel fails over " + figure(thresholds.fail);
  if (thresholds.fail_percent > 0.0) text += ", " + figure(thresholds.fail_percent) + "% may";
  if (thresholds.allow_failures > 0) text += ", " + std::to_string(thresholds.allow_failures) + " may";
  if (thresholds.hard_fail < kUnlimited) text += ", none over " + figure(thresholds.hard_fail);
  if (thresholds.fail_flip < kUnlimited) text += ", FLIP at most " + figure(thresholds.fail_flip);
  return text;
}

std::string header(const Run& run, const Totals& totals) {
  return "<header class=\"top\">\n<h1" + std::string(totals.failed() > 0 ? " class=\"failed\"" : "") + ">" +
         title_of(totals) + "</h1>\n<p>expected <code>" + escape_html(run.expected) +
         "</code></p>\n<p>actual <code>" + escape_html(run.actual) + "</code></p>\n<p>" +
         thresholds_text(run.settings.thresholds) + "</p>\n</header>\n";
}

std::string filter_button(const std::string& name, std::size_t count) {
  return "<button data-outcome=\"" + name + "\" aria-pressed=\"false\">" + std::to_string(count) + " " +
         name + "</button>\n";
}

std::string filters(const Totals& totals) {
  std::string html = "<div class=\"filters\" role=\"group\" aria-label=\"Filter\">\n";
  for (const Outcome outcome : kWorstFirst) {
    if (totals[outcome] > 0) html += filter_button(std::string(name_of(outcome)), totals[outcome]);
  }
  return html +
         "<input id=\"search\" type=\"search\" placeholder=\"name\" aria-label=\"Filter by name\">\n</div>\n";
}

std::string cell(const std::string& text) { return "<td class=\"number\">" + text + "</td>"; }

std::string row(const Result& result, std::size_t place) {
  const std::string name(name_of(result.outcome));
  std::string html = "<tr data-pair=\"" + std::to_string(place) +
                     "\" tabindex=\"-1\" aria-selected=\"false\"><td>" + escape_html(result.pair.name) +
                     "<span class=\"outcome " + name + "\">" + name;
  if (!result.note.empty()) html += " <small>" + escape_html(result.note) + "</small>";
  html += "</span></td>";
  const bool known = result.figures.has_value();
  html += cell(result.flip ? short_figure(result.flip->mean) : "");
  html += cell(known ? short_figure(result.figures->max) : "");
  html += cell(known ? short_figure(percent(result.figures->over_fail, result.figures->pixels)) + "%" : "");
  return html + "</tr>\n";
}

std::string table(const Run& run) {
  std::string html =
      "<div class=\"rows\"><table role=\"grid\">\n<thead><tr><th>picture</th><th title=\"mean of FLIP, 0 to "
      "1\">FLIP</th>"
      "<th title=\"greatest difference of a value\">max</th>"
      "<th title=\"pixels over the threshold\">pixels</th></tr></thead>\n<tbody>\n";
  std::size_t place = 0;
  for (const std::size_t index : worst_first(run)) html += row(run.results[index], place++);
  return html + "</tbody></table></div>\n";
}

/// The colours of FLIP's map from 0 to 1, for the legend.
std::string flip_scale() {
  std::string css = ":root { --flip-scale: linear-gradient(to right";
  for (int i = 0; i <= 16; ++i) {
    const auto color = false_color(static_cast<float>(i) / 16.0f);
    css += ", rgb(" + std::to_string(color[0]) + " " + std::to_string(color[1]) + " " +
           std::to_string(color[2]) + ")";
  }
  return css + "); }\n";
}

/// Nothing is fetched, whatever a name holds.
constexpr const char* kPolicy = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

}  // namespace

std::string escape_html(std::string_view text) { return escape_xml(text); }

std::string page_before_pictures(const Run& run) {
  const Totals totals = totals_of(run);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width\">\n<meta "
         "http-equiv=\"Content-Security-Policy\" content=\"" +
         std::string(kPolicy) + "\">\n<title>" + title_of(totals) + " – barrido diff</title>\n<style>\n" +
         std::string(kReportCss) + flip_scale() + "</style>\n</head>\n<body>\n" + header(run, totals) +
         "<div class=\"columns\">\n<nav class=\"list\" aria-label=\"Pairs, worst first\">\n" +
         filters(totals) + table(run) + "</nav>\n" + std::string(kViewerHtml) +
         "</div>\n<noscript>The pictures need JavaScript.</noscript>\n";
}

std::string picture_element(std::string_view name, std::string_view base64_text) {
  return "<script type=\"text/plain\" id=\"" + std::string(name) + "\">" + std::string(base64_text) +
         "</script>\n";
}

std::string page_after_pictures(const Run& run, const std::vector<Shown>& shown) {
  return "<script type=\"application/json\" id=\"data\">" + viewer_data(run, shown) +
         "</script>\n<script>\n" + std::string(kReportJs) + "</script>\n</body>\n</html>\n";
}

}  // namespace barrido::compare
