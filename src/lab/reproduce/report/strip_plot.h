// Strip plot of one figure for all arms: a mark per seed, a bar at the median.
#pragma once

#include <string>
#include <vector>

namespace muster {

/// The values of one arm.
struct StripRow {
    std::string title;           ///< Above its row.
    std::size_t series = 0;      ///< Its colour and mark.
    bool hollow = false;         ///< Marks not filled.
    std::vector<double> values;  ///< One per seed.
    std::size_t missing = 0;     ///< Seeds without a value; printed next to the row.
};

/// Definition of a plot.
struct StripPlotDef {
    std::string title;   ///< For those who do not see it.
    bool whole = false;  ///< Ticks at whole numbers only.
    std::vector<StripRow> rows;
};

/// The plot as SVG.
std::string stripPlot(const StripPlotDef& plot);

}  // namespace muster
