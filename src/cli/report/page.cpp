#include "cli/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <span>
#include <string_view>

#include "engine/report/row_source.hpp"
#include "engine/report/summary.hpp"
#include "plot/html/markup.hpp"
#include "sigmasweep/model/names.hpp"
#include "sweep/repeat_command.hpp"

namespace sigmasweep {
namespace {

using plot::escape_html;

constexpr std::string_view style = R"css(
:root { color-scheme: light dark; --ink: #1a1a1a; --soft: #5c5c5c; --line: #d8d8d8; --paper: #ffffff; --panel: #f5f5f5; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #ececec; --soft: #a8a8a8; --line: #454545; --paper: #17191c; --panel: #24272b; }
}
body { margin: 0 auto; max-width: 62rem; padding: 1rem; background: var(--paper); color: var(--ink);
       font: 15px/1.5 "DejaVu Sans", system-ui, sans-serif; }
h1 { font-size: 1.4rem; font-weight: normal; } h2 { font-size: 1.1rem; margin-top: 2rem; }
table { border-collapse: collapse; } td, th { text-align: left; padding: .1rem 1rem .1rem 0; vertical-align: top; }
tr { border-bottom: 1px solid var(--line); }
figure { margin: 1rem 0; } img { width: 100%; height: auto; background: #ffffff; border-radius: 4px; }
pre, code { background: var(--panel); border-radius: 4px; font-size: .85rem; }
pre { padding: .6rem; overflow-x: auto; } .soft { color: var(--soft); }
)css";

/// Text between tags, escaped.
std::string element(std::string_view tag, std::string_view text) {
  return fmt::format("<{0}>{1}</{0}>", tag, escape_html(text));
}

/// Text of several lines; escape_html() makes a space of each end of a line.
std::string lines_of(std::string_view text) {
  std::string html;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    html += escape_html(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return html;
}

std::string line_of(std::string_view name, std::string_view value) {
  return "<tr>" + element("th", name) + element("td", value) + "</tr>\n";
}

/// An SVG as the address of an image, which cannot run scripts.
std::string image_of(std::string_view svg) {
  std::string address = "data:image/svg+xml,";
  for (const char c : svg) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("-._~/:=,;() ").find(c) != svg.npos)
      address += c;
    else
      fmt::format_to(std::back_inserter(address), "%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return address;
}

std::string rows_of(const StoredSweep& stored) {
  std::string text = "<h2>Rows</h2>\n<table>\n";
  text += line_of("rows", stored.complete ? fmt::format("{}", stored.total)
                                          : fmt::format("{} of {} so far", stored.table.rows.size(), stored.total));
  for (const auto& [name, count] : count_by_status(std::span<const Row>(stored.table.rows)))
    text += line_of(name, fmt::format("{}", count));
  text +=
      "</table>\n<table>\n<tr><th></th><th>half of the rows at most</th><th>90 %</th><th>99 %</th><th>all</th></tr>\n";
  for (const auto& [name, values] : overview(RowSource(stored.table.rows)).quantiles) {
    text += "<tr>" + element("th", name);
    for (const double value : values) text += element("td", fmt::format("{:.3g}", value));
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string pictures_of(const std::vector<ReportPicture>& pictures) {
  std::string text;
  for (const ReportPicture& picture : pictures) {
    text += "<figure>\n";
    if (!picture.svg.empty())
      text += fmt::format("<img alt=\"{}\" src=\"{}\">\n",
                          escape_html(picture.name.empty() ? "the plot" : "the plot " + picture.name),
                          image_of(picture.svg));
    if (!picture.text.empty()) text += "<pre>" + lines_of(picture.text) + "</pre>\n";
    text += "</figure>\n";
  }
  return text;
}

/// The first rows without a result, with the commands that repeat them.
std::string failed_of(const StoredSweep& stored) {
  constexpr std::size_t most = 50;
  std::vector<const Row*> failed;
  for (const Row& row : stored.table.rows)
    if (!is_success(row.result.status)) failed.push_back(&row);
  if (failed.empty()) return {};
  std::string text = "<h2>Rows without a result</h2>\n<table>\n";
  for (const Row* row : std::span(failed).first(std::min(most, failed.size())))
    text += "<tr>" + element("th", fmt::format("{}", row->index)) + element("td", name_of(row->result.status)) +
            "<td>" + element("code", repeat_command(row->parameters)) + "</td></tr>\n";
  text += "</table>\n";
  if (failed.size() > most) text += element("p", fmt::format("... and {} more", failed.size() - most)) + "\n";
  return text;
}

std::string origin_of(const StoredSweep& stored, const std::string& table) {
  const TableInfo& info = stored.table.info;
  std::string text = "<h2>Where it comes from</h2>\n<table>\n";
  text += line_of("table", std::filesystem::path(table).filename().string());
  text += line_of("computed", fmt::format("{} on {}, {} {}", info.start, info.host, info.ranks,
                                          info.ranks == 1 ? "rank" : "ranks"));
  text += line_of("program", info.build);
  text += line_of("physics version", fmt::format("{}", info.physics_version));
  text += line_of("hash of the spec", fmt::format("{:016x}", info.spec_hash));
  return text + "</table>\n";
}

}  // namespace

std::string report_page(const StoredSweep& stored, const std::string& table,
                        const std::vector<ReportPicture>& pictures) {
  const std::string title = stored.table.info.title.empty() ? table : stored.table.info.title;
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
             "img-src data:\">\n<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n",
             escape_html(title), style) +
         pictures_of(pictures) + rows_of(stored) + failed_of(stored) + origin_of(stored, table) +
         "<h2>The spec</h2>\n<pre>" + lines_of(stored.table.info.spec_text) + "</pre>\n</body>\n</html>\n";
}

}  // namespace sigmasweep
