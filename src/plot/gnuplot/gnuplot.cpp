#include "plot/gnuplot/gnuplot.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "base/atomic_file.hpp"
#include "base/process.hpp"
#include "plot/gnuplot/fonts.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::plot {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using Stream = std::unique_ptr<std::FILE, Close>;

Stream temporary_file() {
  Stream file(std::tmpfile());
  if (!file) throw OutputError(fmt::format("cannot make a temporary file: {}", std::strerror(errno)));
  return file;
}

/// Runs gnuplot with these files as its standard streams. Returns its exit status, -1 after a signal.
int run(const StandardStreams& streams) {
  try {
    return Process({"gnuplot", "-d"}, streams).wait();  // -d: ignores the user's .gnuplot
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::no_such_file_or_directory)
      throw OutputError("gnuplot is not installed (Debian: gnuplot-nox)");
    throw OutputError(fmt::format("cannot start gnuplot: {}", error.code().message()));
  }
}

bool is_empty(const AtomicFile& file) { return ::lseek(file.fd(), 0, SEEK_END) == 0; }

/// The commands as gnuplot can draw them in this form: it takes the characters of bitmaps and PDFs from installed
/// fonts.
std::string drawable(const std::string& script, const std::string& path) {
  if (form_of(path) == Form::svg) return script;
  const auto [text, missing] = with_installed_fonts(script);
  if (!missing.empty())
    fmt::print(stderr, "sigmasweep: {}: no font that is installed has {}; see '?' (an SVG has them)\n", path, missing);
  return text;
}

/// The error message of gnuplot in one line.
std::string error_message(std::FILE* err) {
  std::rewind(err);
  std::string text;
  std::array<char, 300> line{};
  while (text.size() < 500 && std::fgets(line.data(), static_cast<int>(line.size()), err)) text += line.data();
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
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

std::string panels_terminal(Form form, double width, double height) {
  constexpr double png = 1.6, centimetre = 50.0;
  switch (form) {
    case Form::svg:
      return fmt::format("svg size {:.0f},{:.0f} enhanced background '#ffffff' font 'DejaVu Sans,12'", width, height);
    case Form::png:
      return fmt::format("pngcairo size {:.0f},{:.0f} enhanced fontscale 1.45 linewidth 1.5 font 'DejaVu Sans,10'",
                         png * width, png * height);
    case Form::pdf:
      return fmt::format("pdfcairo size {:.1f}cm,{:.1f}cm enhanced font 'DejaVu Sans,9'", width / centimetre,
                         height / centimetre);
  }
  return {};
}

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (std::string_view("\"'`\\").find(c) != std::string_view::npos)
      out += fmt::format("\\{:03o}", c);
    else
      out += std::iscntrl(static_cast<unsigned char>(c)) ? ' ' : c;
  }
  return out + "\"";
}

std::string quoted_markup(std::string_view text) {
  std::string out;
  bool font = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '/' && i > 0 && text[i - 1] == '{')
      font = true;
    else if (c == ' ' || c == '}')
      font = false;
    else if (font && std::isalnum(static_cast<unsigned char>(c)) == 0 &&
             std::string_view("-_.,:=*+").find(c) == std::string_view::npos)
      continue;
    out += c;
  }
  return quoted(out);
}

void run_gnuplot(const std::string& commands, const std::string& path) {
  const std::string script = drawable(commands, path);
  const Stream in = temporary_file(), err = temporary_file();
  if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() || std::fflush(in.get()) != 0)
    throw OutputError(fmt::format("cannot write gnuplot's commands: {}", std::strerror(errno)));
  std::rewind(in.get());
  AtomicFile picture(path, fmt::format(".part{}", ::getpid()));  // several processes may draw the same picture
  const int status = run({.in = ::fileno(in.get()), .out = picture.fd(), .err = ::fileno(err.get())});
  if (status != 0 || is_empty(picture))
    throw OutputError(fmt::format("gnuplot could not draw {} (status {}): {}", path, status, error_message(err.get())));
  picture.publish();
}

}  // namespace sigmasweep::plot
