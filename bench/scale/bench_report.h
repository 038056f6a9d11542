// Rows of the table as text.
#pragma once

#include <span>
#include <string>

#include "scale/case.h"

namespace muster::scale {

/// One JSON object without line feed.
std::string jsonRow(const Row& row);
/// The head of the plain-text table.
std::string tableHead();
/// The line of a row in it.
std::string tableRow(const Row& row);
/// The head and the rule of the table in Markdown.
std::string markdownHead();
/// The line of a row in it.
std::string markdownRow(const Row& row);

/// Growth of the step time with the number of characters n.
struct Growth {
    double exponent = 0.0;    ///< Exponent of n, by a least-squares fit to the logarithms of p50.
    std::int32_t points = 0;  ///< Number of rows in the fit.
    std::int32_t least = 0;   ///< Smallest n.
    std::int32_t most = 0;    ///< Largest n.
};

/// Fits all rows of a regime. Each series of equal scene, plan and threads is first shifted to its mean, so
/// that scenes of different cost do not change the slope. No points where no series has two sizes.
Growth growthOf(std::span<const Row> rows, Regime regime);

}  // namespace muster::scale
