#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "sigmasweep/model/fields.hpp"

/// The paper's symbols for our names, in gnuplot's enhanced text.
namespace sigmasweep::plot {

/// The paper's symbol; the name where it has none.
std::string symbol_of(const Field& field);

/// For an axis: symbol, meaning where it is a definition, and unit.
std::string axis_label(const Field& field);

/// An expression over fields as people write it: symbols for names, "−" for "-", "N t_c" for "N*tc", powers raised.
std::string expression_label(std::string_view expression);

/// For the key: "v_0 = 14 m/s".
std::string value_label(const Field& field, const Row& row);

/// For one of several panels: "(a) MD, s_0 = 0 m", `differ` the fields to name.
std::string panel_title(std::size_t number, const Row& row, std::span<const std::string> differ);

/// A number as people write it: 2.5x10^{-6}.
std::string pretty(double value);

/// Text in which gnuplot finds no markup.
std::string escape_markup(std::string_view text);

}  // namespace sigmasweep::plot
