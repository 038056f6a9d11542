// Rows of the table as text.
#pragma once

#include <span>
#include <string>

#include "scale/case.h"

namespace muster::scale {

/// One JSON object without line feed.
std::string jsonRow(const Row& row);
/// The head of the readable table.
std::string tableHead();
/// A line of it.
std::string tableRow(const Row& row);
/// The head and the rule of the table in Markdown.
std::string markdownHead();
/// A line of it.
std::string markdownRow(const Row& row);

/// How the cost of a step grows.
struct Growth {
    double exponent = 0.0;    ///< Of n, fitted by least squares to the logarithms of p50.
    std::int32_t points = 0;  ///< Rows it was fitted to.
    std::int32_t least = 0;   ///< Smallest n.
    std::int32_t most = 0;    ///< Largest n.
};

/// Of all rows of that regime (and scene, plan, threads): every such series is shifted to its own mean first,
/// so that scenes of different cost do not blur the slope. No points where no series has two sizes.
Growth growthOf(std::span<const Row> rows, Regime regime);

}  // namespace muster::scale
