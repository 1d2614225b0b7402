#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string_view>

#include "plot_gnuplot.hpp"
#include "sigmasweep/errors.hpp"

namespace sigmasweep::plot {
namespace {

// Okabe and Ito's colours, distinct for all kinds of colour vision. Seven colours and eight symbols: 56 pairs.
constexpr auto colours =
    std::to_array<std::string_view>({"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7F6000"});
constexpr auto symbols = std::to_array<int>({6, 4, 8, 12, 10, 2, 14, 1});
constexpr std::size_t longest_key = 24;

std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += std::iscntrl(static_cast<unsigned char>(c)) ? ' ' : c;
  }
  return out + "'";
}

struct Terminal {
  std::string_view options;
  double font_size;  ///< of labels; the key and the note are smaller
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

/// How many characters of enhanced text are seen.
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

/// The user's title, smaller when it is long, and cut when it is a whole story.
std::string title_command(std::string title, Form form) {
  constexpr std::size_t one_line = 62, longest = 110;
  std::size_t length = 0;
  for (std::size_t i = 0; i < title.size(); ++i)
    if ((title[i] & 0xC0) != 0x80 && ++length == longest) title = title.substr(0, i) + "…";
  const double scale = 1.1 * std::min(1.0, static_cast<double>(one_line) / static_cast<double>(length + 1));
  return fmt::format("set title {} noenhanced {}\n", quoted(title), font(form, scale));
}

/// Where the key hides nothing: an empty corner, the middle of an empty side, or outside.
std::string key_place(const Figure& figure, std::size_t entries, std::size_t letters) {
  struct Place {
    const char* name;
    bool right;
    double bottom;  ///< of the room that is left above and below, the part that is below
  };
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
    const bool empty = std::ranges::none_of(
        figure.curves, [&](const Curve& curve) { return std::ranges::any_of(curve.points, covers); });
    if (empty && width < 0.6 && height < 0.7)
      return fmt::format("set key inside {} reverse Left samplen 1.5 spacing 1.2", place.name);
  }
  return "set key outside right top reverse Left samplen 1.5 spacing 1.2";
}

std::string axis_commands(char name, const Axis& axis) {
  std::string out = fmt::format("set {}label {}\n", name, quoted(axis.label));
  if (axis.log) {
    out += fmt::format("set logscale {}\n", name);
    const double decades = std::log10(axis.to / axis.from);
    if (decades > 1.5) out += fmt::format("set format {} '10^{{%L}}'\n", name);
    if (decades > 9.0) out += fmt::format("set {0}tics 100\nset m{0}tics default\n", name);
  }
  return out + fmt::format("set {}range [{:.17g}:{:.17g}]\n", name, axis.from, axis.to);
}

std::string data_block(std::size_t number, const Curve& curve) {
  std::string out = fmt::format("$curve{} << end_of_curve\n", number);
  for (const auto& point : curve.points) fmt::format_to(std::back_inserter(out), "{:.17g} {:.17g}\n", point.x, point.y);
  return out + "end_of_curve\n";
}

}  // namespace

Form form_of(const std::string& path) {
  const auto dot = path.rfind('.');
  const std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
  if (ending == "svg") return Form::svg;
  if (ending == "png") return Form::png;
  if (ending == "pdf") return Form::pdf;
  throw UsageError(fmt::format("'{}': a plot's name ends in .svg, .png or .pdf", path));
}

std::string gnuplot_script(const Figure& figure, Form form) {
  std::size_t entries = 0, letters = 0;
  for (const auto& curve : figure.curves) {
    entries += curve.label.empty() ? 0 : 1;
    letters = std::max(letters, visible_length(curve.label));
  }
  std::string note = figure.note;
  if (entries > longest_key) note += fmt::format("{}{} curves, no room for a key", note.empty() ? "" : "; ", entries);

  const auto [options, size] = terminal(form);
  std::string out = fmt::format("set encoding utf8\nset terminal {} font 'DejaVu Sans,{:.3g}'\n", options, size);
  out += title_command(figure.title, form);
  out += axis_commands('x', figure.x) + axis_commands('y', figure.y);
  out +=
      "set border 3 linecolor '#404040'\nset tics nomirror out\n"
      "set grid xtics ytics linetype 1 linecolor '#E4E4E4' linewidth 0.6\n"
      "set label 1 " +
      quoted(note) + " at screen 0.985,0.025 right " + font(form, 0.75) + " textcolor '#606060'\n";
  if (!note.empty()) out += "set bmargin 4.8\n";
  out += (entries > longest_key ? "unset key" : key_place(figure, entries, letters) + " " + font(form, 0.8)) + "\n";

  for (std::size_t i = 0; i < figure.curves.size(); ++i) out += data_block(i, figure.curves[i]);
  std::string plots;
  std::size_t style = 0;
  const auto add = [&](std::size_t i, const std::string& how) {
    const std::string& label = figure.curves[i].label;
    plots += fmt::format("{} $curve{} using 1:2 {} {}", plots.empty() ? "plot" : ",", i, how,
                         label.empty() ? "notitle" : "title " + quoted(label));
  };
  for (std::size_t i = 0; i < figure.curves.size(); ++i, ++style)
    if (!figure.curves[i].line)
      add(i, fmt::format("with points pointtype {} pointsize 0.8 linewidth 1.3 linecolor '{}'",
                         symbols[style % symbols.size()], colours[style % colours.size()]));
  for (std::size_t i = 0; i < figure.curves.size(); ++i)  // on top of the symbols
    if (figure.curves[i].line) add(i, "with lines dashtype (12,7) linewidth 2 linecolor '#202020'");
  if (plots.empty()) plots = "plot NaN notitle";
  return out + plots + "\n";
}

}  // namespace sigmasweep::plot
