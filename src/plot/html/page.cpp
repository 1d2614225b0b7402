#include "plot/html/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "plot/html/markup.hpp"
#include "plot/html/page_template.hpp"
#include "plot/palette.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sweep/repeat_command.hpp"

namespace sigmasweep::plot {
namespace {

using Json = nlohmann::ordered_json;

/// The rows of a page, by their places among all rows.
class PageRows {
 public:
  explicit PageRows(std::span<const Row> rows) : rows_(rows) {}

  /// The number of a row on the page; null for a point that is of no single row.
  Json number_of(const Point& point) {
    if (point.row == Point::no_row) return nullptr;
    return places_.try_emplace(point.row, places_.size()).first->second;
  }
  /// Puts the fields with their units on the page, with the value of those that are the same in all rows; and the rows
  /// with their values of the other fields, empty where a row has none.
  void put(Json& data) const {
    std::vector<Field> differing;
    data["fields"] = Json::array();
    for (const Field& field : shown()) {
      Json entry = {{"name", field.name}, {"unit", field.unit == "1" ? "" : field.unit}};
      if (const auto value = common(field))
        entry["value"] = *value;
      else
        differing.push_back(field);
      data["fields"].push_back(std::move(entry));
    }
    std::vector<Json> rows(places_.size());
    for (const auto& [place, number] : places_) {
      const Row& row = rows_[place];
      Json values = Json::array();
      for (const Field& field : differing) values.push_back(value_of(field, row));
      rows[number] = {{"index", row.index}, {"values", values}, {"command", repeat_command(row.parameters)}};
    }
    data["rows"] = std::move(rows);
  }

 private:
  /// The parameters and results that some row has.
  std::vector<Field> shown() const {
    std::vector<Field> fields;
    for (const std::span<const Field> some : {parameter_fields(), result_fields()})
      for (const Field& field : some)
        if (std::ranges::any_of(places_,
                                [&](const auto& place) { return applies_to(field, rows_[place.first].parameters); }))
          fields.push_back(field);
    return fields;
  }
  static std::string value_of(const Field& field, const Row& row) {
    return applies_to(field, row.parameters) ? text(field, row) : "";
  }
  std::optional<std::string> common(const Field& field) const {
    if (places_.size() < 2) return std::nullopt;
    const std::string first = value_of(field, rows_[places_.begin()->first]);
    const auto is_first = [&](const auto& place) { return value_of(field, rows_[place.first]) == first; };
    return std::ranges::all_of(places_, is_first) ? std::optional(first) : std::nullopt;
  }

  std::span<const Row> rows_;
  std::map<std::size_t, std::size_t> places_;  ///< place among all rows: number on the page
};

Json points_of(const std::vector<Point>& points, PageRows& rows) {
  Json list = Json::array();
  for (const Point& p : points) list.push_back({p.x, p.y, p.deviation, rows.number_of(p)});
  return list;
}

Json line_of(const std::vector<Point>& points) {
  Json line = Json::array();
  for (const Point& p : points) line.push_back({p.x, p.y});
  return line;
}

Json curves_of(const Figure& figure, PageRows& rows) {
  Json curves = Json::array();
  std::size_t style = 0;
  for (const Curve& curve : figure.curves) {
    const std::size_t own = curve.line ? 0 : style++;
    curves.push_back({{"label", html_of_markup(curve.label)},
                      {"name", curve.name},
                      {"line", curve.line},
                      {"colour", curve.line ? "var(--ink)" : std::string(series_colour(own))},
                      {"symbol", own},
                      {"points", points_of(curve.points, rows)},
                      {"path", points_of(curve.path, rows)},
                      {"fit", line_of(curve.fit ? fitted_line(figure, *curve.fit) : std::vector<Point>{})}});
  }
  return curves;
}

Json axis_of(const PlotAxis& axis, const std::string& name) {
  return {
      {"label", html_of_markup(axis.label)}, {"name", name}, {"log", axis.log}, {"from", axis.from}, {"to", axis.to}};
}

Json guides_of(const Figure& figure) {
  Json guides = Json::array();
  for (const Guide& guide : figure.guides)
    guides.push_back({{"label", html_of_markup(guide.label)}, {"path", line_of(guide.path)}});
  return guides;
}

/// The template with the texts in their places.
std::string filled(std::string_view page, const std::map<std::string_view, std::string>& texts) {
  std::string all;
  while (!page.empty()) {
    const auto next = std::ranges::min_element(texts, {}, [&](const auto& text) { return page.find(text.first); });
    const std::size_t at = std::min(page.find(next->first), page.size());
    all += page.substr(0, at);
    if (at == page.size()) break;
    all += next->second;
    page.remove_prefix(at + next->first.size());
  }
  return all;
}

}  // namespace

std::string html_page(const Figure& figure, std::span<const Row> all_rows, const PlotSpec& spec) {
  PageRows rows(all_rows);
  Json data = {{"x", axis_of(figure.x, spec.x)},
               {"y", axis_of(figure.y, spec.y)},
               {"note", html_of_markup(figure.note)},
               {"curves", curves_of(figure, rows)},
               {"guides", guides_of(figure)}};
  rows.put(data);
  std::string json = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = json.find('<', at)) != json.npos;) json.replace(at, 1, "\\u003c");  // ends no script
  const std::string title = figure.title.empty() ? spec.y + " against " + spec.x : figure.title;
  return filled(page_template(), {{"@TITLE@", escape_html(title)}, {"@DATA@", json}});
}

}  // namespace sigmasweep::plot
