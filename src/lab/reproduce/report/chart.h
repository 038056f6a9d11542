// Charts as SVG.
#pragma once

#include <string>

#include "lab/reproduce/experiments/experiment.h"

namespace muster {

/// The chart: axes with units, series in the groups' colours and marks, a legend where there are several. Its
/// title is for screen readers; print it above the chart. Points that are not finite, or not > 0 on a
/// logarithmic axis, break the line.
std::string chartSvg(const ChartDef& chart);

}  // namespace muster
