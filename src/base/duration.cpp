#include "base/duration.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <vector>

namespace sigmasweep {
namespace {

template <class Number>
std::optional<Number> parse_whole(std::string_view text) {
  Number number{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "1:2:3" as its numbers.
std::optional<std::vector<double>> parse_parts(std::string_view text) {
  std::vector<double> parts;
  for (;;) {
    const std::size_t colon = text.find(':');
    const auto part = parse_whole<unsigned>(text.substr(0, colon));
    if (!part) return std::nullopt;
    parts.push_back(*part);
    if (colon == text.npos) return parts;
    text.remove_prefix(colon + 1);
  }
}

}  // namespace

std::optional<double> parse_duration(std::string_view text) {
  if (const auto seconds = parse_whole<double>(text))
    return std::isfinite(*seconds) && *seconds >= 0.0 ? seconds : std::nullopt;
  const std::size_t dash = text.find('-');
  const auto days = dash == text.npos ? std::optional(0u) : parse_whole<unsigned>(text.substr(0, dash));
  auto parts = parse_parts(dash == text.npos ? text : text.substr(dash + 1));
  if (!days || !parts || parts->size() > 3) return std::nullopt;
  if (dash != text.npos)
    parts->resize(3);  // D-HH:MM: hours come first
  else if (parts->size() == 2)
    parts->insert(parts->begin(), 0.0);  // MM:SS: seconds come last
  return ((24.0 * *days + (*parts)[0]) * 60.0 + (*parts)[1]) * 60.0 + (*parts)[2];
}

std::string readable_duration(double seconds) {
  if (!std::isfinite(seconds)) return "?";
  if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
  if (seconds < 1.0) return fmt::format("{:.3g} ms", seconds * 1e3);
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
  const auto whole = std::llround(seconds);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  const auto minutes = std::llround(seconds / 60.0);
  if (minutes < 48 * 60) return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
  return fmt::format("{} d {} h", minutes / 1440, minutes % 1440 / 60);
}

}  // namespace sigmasweep
