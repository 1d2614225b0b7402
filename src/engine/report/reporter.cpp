#include "engine/report/reporter.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "base/standard_error.hpp"

namespace sigmasweep {
namespace {

/// The stream remembers what could not be written.
void print_on_stdout(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

}  // namespace

Reporter::Reporter(Print print, bool quiet, std::optional<Terminal> terminal, Print print_document)
    : print_(std::move(print)),
      print_document_(print_document ? std::move(print_document) : print_on_stdout),
      quiet_(quiet),
      terminal_(terminal) {}

Reporter Reporter::on_stderr(bool quiet) { return Reporter(print_on_stderr, quiet, terminal_of_stderr()); }

void Reporter::say(std::string_view message) const {
  if (!quiet_) warn(message);
}

void Reporter::warn(std::string_view message) const { print_(fmt::format("sigmasweep: {}\n", message)); }

void Reporter::document(std::string_view text) const { print_document_(text); }

void Reporter::show(std::string_view text) const {
  if (!quiet_) print_(text);
}

}  // namespace sigmasweep
