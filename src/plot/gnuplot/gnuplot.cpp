#include "plot/gnuplot/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "sigmasweep/base/errors.hpp"

extern char** environ;

namespace sigmasweep::plot {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

File temporary_file() {
  File file(std::tmpfile());
  if (!file) throw OutputError(fmt::format("cannot make a temporary file: {}", std::strerror(errno)));
  return file;
}

/// A file that goes away again unless it is kept.
class Draft {
 public:
  explicit Draft(const std::string& path) : path_(path), part_(fmt::format("{}.part{}", path, ::getpid())) {
    file_.reset(std::fopen(part_.c_str(), "wb"));
    if (!file_) throw OutputError(fmt::format("cannot create {}: {}", path_, std::strerror(errno)));
  }
  ~Draft() {
    if (!kept_) std::remove(part_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  int descriptor() const { return ::fileno(file_.get()); }
  bool empty() const { return ::lseek(descriptor(), 0, SEEK_END) == 0; }
  void keep() {
    if (std::rename(part_.c_str(), path_.c_str()) != 0)
      throw OutputError(fmt::format("cannot create {}: {}", path_, std::strerror(errno)));
    kept_ = true;
  }

 private:
  std::string path_, part_;
  File file_;
  bool kept_ = false;
};

/// Runs gnuplot with these files as its standard input, output and error; its exit status, -1 after a signal.
int spawn_gnuplot(int in, int out, int err) {
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) throw OutputError("cannot start gnuplot: out of memory");
  const std::unique_ptr<posix_spawn_file_actions_t, int (*)(posix_spawn_file_actions_t*)> owner(
      &actions, posix_spawn_file_actions_destroy);
  if (posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO) != 0 ||
      posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO) != 0 ||
      posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO) != 0)
    throw OutputError("cannot start gnuplot: out of memory");
  std::array<char, 8> name{"gnuplot"};
  std::array<char, 3> defaults{"-d"};  // no .gnuplot of the user's
  const std::array<char*, 3> arguments{name.data(), defaults.data(), nullptr};
  pid_t child = -1;
  const int failure = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  if (failure == ENOENT) throw OutputError("gnuplot is not installed (Debian: gnuplot-nox)");
  if (failure != 0) throw OutputError(fmt::format("cannot start gnuplot: {}", std::strerror(failure)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw OutputError(fmt::format("lost gnuplot: {}", std::strerror(errno)));
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Its complaint in one line.
std::string complaint(std::FILE* err) {
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
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += std::iscntrl(static_cast<unsigned char>(c)) ? ' ' : c;
  }
  return out + "'";
}

void run_gnuplot(const std::string& script, const std::string& path) {
  const File in = temporary_file(), err = temporary_file();
  if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() || std::fflush(in.get()) != 0)
    throw OutputError(fmt::format("cannot write gnuplot's commands: {}", std::strerror(errno)));
  std::rewind(in.get());
  Draft picture(path);
  const int status = spawn_gnuplot(::fileno(in.get()), picture.descriptor(), ::fileno(err.get()));
  if (status != 0 || picture.empty())
    throw OutputError(fmt::format("gnuplot could not draw {} (status {}): {}", path, status, complaint(err.get())));
  picture.keep();
}

}  // namespace sigmasweep::plot
