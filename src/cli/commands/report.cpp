#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/output/place.hpp"
#include "cli/command.hpp"
#include "cli/read_sweep.hpp"
#include "cli/report/page.hpp"
#include "cli/report/picture.hpp"
#include "engine/run_options.hpp"
#include "plot/named.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string table, output;
};

/// A directory for pictures that are on their way to the page.
class WorkDirectory {
 public:
  WorkDirectory() {
    std::string pattern = (fs::temp_directory_path() / "sigmasweep-report-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw OutputError(fmt::format("cannot make a directory {}", pattern));
    path_ = pattern;
  }
  ~WorkDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkDirectory(const WorkDirectory&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A plot that cannot be drawn, such as one of films that are not there, is said and left out.
ReportPicture picture_of(const StoredSweep& stored, const std::string& table, const PlotSpec& spec) {
  const WorkDirectory directory;
  const std::string file = directory.file("plot.svg");
  try {
    const std::string fits = draw_picture(stored, table, spec, file);
    return {spec.name, text_of(file), fits};
  } catch (const Error& error) {
    return {spec.name, "",
            fmt::format("The plot {}could not be drawn: {}", spec.name.empty() ? "" : spec.name + " ", error.what())};
  }
}

int report(const ReportOptions& options) {
  const std::string own_name = fs::path(options.table).filename().string();
  const std::string output = options.output.empty() ? named_after(own_name, "-report.html") : options.output;
  require_other_file(output, std::array{options.table});
  const StoredSweep stored = read_sweep(options.table);
  if (stored.table.rows.empty()) throw InputNotFound(fmt::format("report: {} has no row yet", options.table));
  std::vector<ReportPicture> pictures;
  for (const PlotSpec& spec : stored.sweep ? stored.sweep->plots() : std::vector<PlotSpec>(1))
    pictures.push_back(picture_of(stored, options.table, spec));
  write_text_file(output, report_page(stored, options.table, pictures));
  fmt::print("{}\n", output);
  return 0;
}

void declare(OptionSet& set, ReportOptions& options) {
  set.add({"table", "A table that 'run' wrote, or will write", "TABLE.h5"}, options.table);
  set.add({"-o,--output", "The page; default: TABLE-report.html, in this directory", "FILE.html"}, options.output);
}

}  // namespace

Command report_command() {
  return make_command("report", "Tell all of a table on one page of HTML",
                      "\nThe page has the plots of the spec, rows by status, errors, rows without a result with the\n"
                      "commands that repeat them, where it was computed, and the spec. It works offline.\n\n"
                      "  sigmasweep report fig2a.h5 -o fig2a.html",
                      declare, report);
}

}  // namespace sigmasweep
