#include "plot/gnuplot/script.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "plot/labels.hpp"
#include "plot/palette.hpp"

namespace sigmasweep::plot {
namespace {

constexpr auto curve_dashes = std::to_array<std::string_view>({"(12,7)", "(3,4)", "(14,4,3,4)", "(6,4)"});
constexpr auto guide_dashes = std::to_array<std::string_view>({"(8,6)", "(2,4)", "(10,4,2,4)"});
constexpr std::size_t longest_key = 24;  // entries

struct Terminal {
  std::string_view options;
  double font_size;  ///< of labels; key and note are smaller
};

Terminal terminal(Form form) {
  switch (form) {
    case Form::svg: return {"svg size 900,600 enhanced background '#ffffff'", 15.0};
    case Form::png: return {"pngcairo size 1500,1000 enhanced fontscale 1.75 linewidth 1.6 pointscale 1.6", 13.0};
    case Form::pdf: return {"pdfcairo size 18cm,12cm enhanced pointscale 0.8", 11.0};
  }
  return {};
}

std::string font(Form form, double scale) { return fmt::format("font ',{:.3g}'", scale * terminal(form).font_size); }

/// Number of characters of enhanced text that are visible.
std::size_t visible_length(std::string_view text) {
  constexpr std::string_view italic = "{/:Italic ";
  std::size_t length = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i, italic.size()) == italic)
      i += italic.size() - 1;
    else if (std::string_view("{}_^\\").find(text[i]) == std::string_view::npos && (text[i] & 0xC0) != 0x80)
      ++length;
  }
  return length;
}

/// The command for the user's title. A long title is set smaller, a very long one is cut.
std::string title_command(std::string title, Form form) {
  constexpr std::size_t one_line = 62, longest = 110;
  std::size_t length = 0;
  for (std::size_t i = 0; i < title.size(); ++i)
    if ((title[i] & 0xC0) != 0x80 && ++length == longest) title = title.substr(0, i) + "…";
  const double scale = 1.1 * std::min(1.0, static_cast<double>(one_line) / static_cast<double>(length + 1));
  return fmt::format("set title {} noenhanced {}\n", quoted(title), font(form, scale));
}

/// Points of all curves, fits and guides.
std::vector<Point> all_points(const Figure& figure) {
  std::vector<Point> points;
  const auto add_line = [&](double from, double to, const auto& y) {
    for (int k = 0; k <= 60; ++k) {
      const double x = value_at(figure.x, from + (to - from) * k / 60);
      points.push_back({x, y(x)});
    }
  };
  for (const Curve& curve : figure.curves) {
    points.insert(points.end(), curve.points.begin(), curve.points.end());
    points.insert(points.end(), curve.path.begin(), curve.path.end());
    if (curve.fit) add_line(fraction(figure.x, curve.fit->from), fraction(figure.x, curve.fit->to), *curve.fit);
  }
  for (const Guide& guide : figure.guides) {
    if (guide.path.size() != 2) {
      points.insert(points.end(), guide.path.begin(), guide.path.end());
      continue;
    }
    const auto [from, to] = std::pair(guide.path[0], guide.path[1]);  // a straight line on the picture
    const double x0 = fraction(figure.x, from.x), x1 = fraction(figure.x, to.x);
    const double y0 = fraction(figure.y, from.y), y1 = fraction(figure.y, to.y);
    add_line(x0, x1,
             [&](double x) { return value_at(figure.y, y0 + (y1 - y0) * (fraction(figure.x, x) - x0) / (x1 - x0)); });
  }
  return points;
}

/// The command that puts the key where it covers no data: in a corner, in the middle of a side, or outside.
std::string key_place(const Figure& figure, std::size_t entries, std::size_t letters) {
  struct Place {
    const char* name;
    bool right;
    double bottom;  ///< space below the key, as a fraction of the space above and below it
  };
  const std::vector<Point> drawn = all_points(figure);
  const double width = 0.09 + 0.0108 * static_cast<double>(letters);
  const double height = 0.03 + 0.047 * static_cast<double>(entries);
  for (const Place& place :
       {Place{"right top", true, 1.0}, Place{"left top", false, 1.0}, Place{"right bottom", true, 0.0},
        Place{"left bottom", false, 0.0}, Place{"right center", true, 0.5}, Place{"left center", false, 0.5}}) {
    const double low = place.bottom * (1.0 - height);
    const auto covers = [&](const Point& p) {
      const double x = fraction(figure.x, p.x), y = fraction(figure.y, p.y);
      return (place.right ? x > 1.0 - width : x < width) && y > low && y < low + height;
    };
    const bool empty = std::ranges::none_of(drawn, covers);
    if (empty && width < 0.6 && height < 0.7)
      return fmt::format("set key inside {} reverse Left samplen 1.5 spacing 1.2", place.name);
  }
  return "set key outside right top reverse Left samplen 1.5 spacing 1.2";
}

/// Tics of a logarithmic axis of less than two decades, which would have few labels at powers of ten alone.
std::string short_log_tics(const PlotAxis& axis) {
  std::vector<double> places;
  const auto add = [&](double place) {
    if (place >= axis.from && place <= axis.to) places.push_back(place);
  };
  const double first = std::floor(std::log10(axis.from));
  for (double power = first; power <= std::log10(axis.to); ++power)
    for (const double mantissa : {1.0, 2.0, 5.0}) add(mantissa * std::pow(10.0, power));
  if (places.size() < 3) {  // much less than a decade: evenly spaced, as on a linear axis
    places.clear();
    const double rough = (axis.to - axis.from) / 5.0, unit = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = unit * (rough < 2.0 * unit ? 2.0 : rough < 5.0 * unit ? 5.0 : 10.0);
    for (double k = std::ceil(axis.from / step); k * step <= axis.to; ++k) add(k * step);
  }
  std::string list;
  for (const double place : places)
    list += fmt::format("{}{} {:.17g}", list.empty() ? "" : ", ", quoted(pretty(place)), place);
  return list;
}

std::string axis_commands(char name, const PlotAxis& axis) {
  std::string out = fmt::format("set {}label {}\n", name, quoted_markup(axis.label));
  if (axis.log) {
    out += fmt::format("set logscale {}\n", name);
    const double decades = std::log10(axis.to / axis.from);
    if (decades > 2.0)
      out += fmt::format("set format {} '10^{{%L}}'\n", name);
    else
      out += fmt::format("set {}tics ({})\n", name, short_log_tics(axis));
    if (decades > 9.0) out += fmt::format("set {0}tics 100\nset m{0}tics default\n", name);
  }
  return out + fmt::format("set {}range [{:.17g}:{:.17g}]\n", name, axis.from, axis.to);
}

std::string data_block(std::string_view name, std::size_t number, const std::vector<Point>& points) {
  std::string out = fmt::format("${}{} << end_of_data\n", name, number);
  for (const auto& p : points)
    fmt::format_to(std::back_inserter(out), "{:.17g} {:.17g} {:.17g}\n", p.x, p.y, p.deviation);
  return out + "end_of_data\n";
}

/// The data blocks and the plot command. Joining lines are drawn first, then symbols, then hard spheres and guides.
class Drawing {
 public:
  explicit Drawing(const Figure& figure) {
    std::size_t style = 0;
    for (const Curve& curve : figure.curves)
      if (!curve.line) add_symbols(curve, figure, style++);
    add_front(figure);
    std::size_t rule = 0;
    for (const Curve& curve : figure.curves)
      if (curve.line)
        add(curve.path,
            fmt::format("with lines dashtype {} linewidth 2 linecolor '#202020'",
                        curve_dashes[rule++ % curve_dashes.size()]),
            curve.label);
    for (std::size_t i = 0; i < figure.guides.size(); ++i)
      add(figure.guides[i].path,
          fmt::format("with lines dashtype {} linewidth 1.4 linecolor '#505050'",
                      guide_dashes[i % guide_dashes.size()]),
          figure.guides[i].label);
  }
  std::string script() const { return data_ + (commands_.empty() ? "plot NaN notitle" : commands_) + "\n"; }

 private:
  void add_symbols(const Curve& curve, const Figure& figure, std::size_t style) {
    const std::string colour = fmt::format("linecolor '{}'", series_colour(style));
    if (curve.fit) add(fitted_line(figure, *curve.fit), "with lines linewidth 0.9 " + colour, "");
    if (!curve.path.empty()) add(curve.path, "with lines linewidth 1 " + colour, "");
    std::vector<Point> bars;
    std::ranges::copy_if(curve.points, std::back_inserter(bars), [](const Point& p) { return p.deviation > 0.0; });
    const std::string_view bottom = figure.y.log ? "($2>$3?$2-$3:1e-300)" : "($2-$3)";
    if (!bars.empty())
      add(bars, "with yerrorbars pointtype 0 linewidth 1 " + colour, "", fmt::format("1:2:{}:($2+$3)", bottom));
    add(curve.points, symbols(style), curve.label);
  }

  /// Symbols in front of others, on white discs.
  void add_front(const Figure& figure) {
    for (const Curve& curve : figure.curves)
      add(curve.front, "with points pointtype 7 pointsize 0.9 linecolor '#ffffff'", "");
    std::size_t style = 0;
    for (const Curve& curve : figure.curves)
      if (!curve.line) add(curve.front, symbols(style++), "");
  }

  static std::string symbols(std::size_t style) {
    return fmt::format("with points pointtype {} pointsize 0.8 linewidth 1.3 linecolor '{}'", series_symbol(style),
                       series_colour(style));
  }

  void add(const std::vector<Point>& points, const std::string& how, const std::string& label,
           const std::string& columns = "1:2") {
    if (points.empty()) return;
    data_ += data_block("data", count_, points);
    commands_ += fmt::format("{} $data{} using {} {} {}", commands_.empty() ? "plot" : ",", count_++, columns, how,
                             label.empty() ? "notitle" : "title " + quoted_markup(label));
  }

  std::string data_, commands_;
  std::size_t count_ = 0;
};

}  // namespace

std::string gnuplot_script(const Figure& figure, Form form) {
  std::size_t entries = 0, letters = 0;
  const auto count = [&](const std::string& label) {
    entries += label.empty() ? 0 : 1;
    letters = std::max(letters, visible_length(label));
  };
  for (const auto& curve : figure.curves) count(curve.label);
  for (const auto& guide : figure.guides) count(guide.label);
  std::string note = figure.note;
  if (entries > longest_key) note += fmt::format("{}{} curves, no room for a key", note.empty() ? "" : "; ", entries);

  const auto [options, size] = terminal(form);
  std::string out = fmt::format("set encoding utf8\nset terminal {} font 'DejaVu Sans,{:.3g}'\n", options, size);
  out += title_command(figure.title, form);
  out += axis_commands('x', figure.x) + axis_commands('y', figure.y);
  out +=
      "set clip two\nset border 3 linecolor '#404040'\nset tics nomirror out\n"
      "set grid xtics ytics linetype 1 linecolor '#E4E4E4' linewidth 0.6\n"
      "set label 1 " +
      quoted_markup(note) + " at screen 0.985,0.025 right " + font(form, 0.75) + " textcolor '#606060'\n";
  if (!note.empty()) out += "set bmargin 4.8\n";
  out += (entries > longest_key ? "unset key" : key_place(figure, entries, letters) + " " + font(form, 0.8)) + "\n";

  return out + Drawing(figure).script();
}

}  // namespace sigmasweep::plot
