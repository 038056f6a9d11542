// Drawings of the report, as SVG: strip plots of one figure for all arms, charts, strips of pictures.
#pragma once

#include <string>
#include <vector>

#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/samples.h"

namespace muster {

/// The values of one arm.
struct StripRow {
    std::string title;           ///< Title above the row.
    std::size_t series = 0;      ///< Number of the row's colour and mark.
    bool hollow = false;         ///< Whether the marks are not filled.
    std::vector<double> values;  ///< Values, one per seed.
    std::size_t missing = 0;     ///< Number of seeds without a value, printed next to the row.
};

/// Definition of a plot.
struct StripPlotDef {
    std::string title;   ///< Words for readers that do not see the plot.
    bool whole = false;  ///< Whether ticks stand at whole numbers only.
    std::vector<StripRow> rows;
};

/// The plot as SVG.
std::string stripPlot(const StripPlotDef& plot);

/// The chart: axes with units, series in the groups' colours and marks, a legend where there are several. Its
/// title is for screen readers; print it above the chart. Points that are not finite, or not > 0 on a
/// logarithmic axis, break the line.
std::string chartSvg(const ChartDef& chart);

/// Number of pictures in a row such that rows are about equally long: 5 pictures with at most 4 in a row
/// become 3 and 2.
std::int32_t stripColumns(std::size_t frames, std::int32_t most = 4);

/// A strip of all pictures, each with its time and caption below, in rows of at most `columns`. Letters are
/// large enough for a strip of four on a page 180 mm wide. Empty for no pictures.
std::string filmStrip(const std::vector<FilmFrame>& film, std::int32_t columns = 4);

}  // namespace muster
