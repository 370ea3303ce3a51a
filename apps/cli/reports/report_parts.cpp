// SPDX-License-Identifier: Apache-2.0
// Parts that pages of recordings and of sweeps share.
#include "reports/report_parts.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string_view>

#include "avo_io/recording.h"
#include "lab_page/lab_page.h"
#include "report_page.h"
#include "reports/html.h"
#include "reports/report_replay.h"

namespace avo_cli {

std::string shell_word(const std::string& word) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_./=,:+@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string set_options(const std::vector<std::string>& overrides) {
  std::string options;
  for (const std::string& override : overrides) options += " --set " + shell_word(override);
  return options;
}

std::string page_section(const std::string& heading, const std::string& html) {
  return fmt::format("<h2>{}</h2>\n{}\n", as_html(heading), html);
}

std::string page_text(const std::string& heading, const std::string& text) {
  return page_section(heading, "<pre>" + as_html(text) + "</pre>");
}

std::string page_figures(const std::string& heading, const std::string& images) {
  return page_section(heading, "<div class=\"figures\">" + images + "</div>");
}

std::string page_replay(const std::string& heading, const avo_io::RecordedRun& run,
                        std::size_t views) {
  return page_section(heading, filled(kReportReplay, {{"drawing", drawing_of(run, views)},
                                                      {"data", data_of(run)}}));
}

// Only a quote ends an attribute, so the page can be inside it verbatim, except for two characters.
std::string page_lab(const std::string& heading, const std::string& input) {
  std::string frame = "<iframe class=\"lab\" title=\"" + as_html(heading) + "\" srcdoc=\"";
  for (const char c : lab_page_with(input)) {
    if (c == '&')
      frame += "&amp;";
    else if (c == '"')
      frame += "&quot;";
    else
      frame += c;
  }
  return page_section(heading, frame + "\"></iframe>");
}

std::string page_lab_of(const std::string& recording, std::int64_t robots) {
  const std::string name = std::filesystem::path(recording).filename().string();
  const std::string bytes = avo_io::recording_bytes(recording, most_frames(robots));
  return page_lab("Replay", recording_input(name, bytes, nullptr, true));
}

std::string page_of(const std::string& title, const std::string& subtitle,
                    const std::vector<std::string>& sections) {
  return filled(kReportPage, {{"title", as_html(title)},
                              {"subtitle", as_html(subtitle)},
                              {"sections", fmt::format("{}", fmt::join(sections, ""))}});
}

}  // namespace avo_cli
