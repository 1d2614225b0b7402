#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "sigmasweep/model/fields.hpp"

/// Labels of a picture, in gnuplot's enhanced text, with the symbols of the field registry.
namespace sigmasweep::plot {

/// The field's symbol, or its name if it has no symbol.
std::string symbol_of(const Field& field);

/// Label of an axis: the field's quantity or symbol, and its unit.
std::string axis_label(const Field& field);

/// An expression over fields in mathematical notation: symbols for names, "−" for "-", "N t_c" for "N*tc", powers
/// raised.
std::string expression_label(std::string_view expression);

/// Entry of the key: "v_0 = 14 m/s".
std::string value_label(const Field& field, const Row& row);

/// Title of panel `number`, from 0, with the values of the fields `differ`: "(a) MD, s_0 = 0 m".
std::string panel_title(std::size_t number, const Row& row, std::span<const std::string> differ);

/// A number with its power of ten: 2.5×10^{-6}.
std::string pretty(double value);

/// The text with all characters escaped that gnuplot would take for markup.
std::string escape_markup(std::string_view text);

}  // namespace sigmasweep::plot
