#pragma once

#include <string>
#include <vector>

#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {

/// A picture on the page.
struct ReportPicture {
  std::string name;  ///< of the plot; empty: the main one
  std::string svg;   ///< its file; empty: it could not be drawn
  std::string text;  ///< fits, or why it could not be drawn
};

/// All that is to be said of a table on one page of HTML, which needs nothing else: rows by status, errors and times,
/// the pictures, rows without a result with the commands that repeat them, where it was computed, and the spec.
std::string report_page(const StoredSweep& stored, const std::string& table,
                        const std::vector<ReportPicture>& pictures);

}  // namespace sigmasweep
