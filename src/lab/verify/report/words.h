// Words and drawings of the report.
#pragma once

#include <string>

#include "lab/verify/verify.h"

namespace muster {

/// Text such as "26 to 34 s", "at most 1.33 /s", or "-" for a value that is only shown.
std::string limitsText(const VerifyCheck& check);
/// Text such as "30.1 s" or "no value".
std::string valueText(const VerifyCheck& check);
/// The check that decides a row, in one line: the first one that fails, else the first one.
std::string decisiveText(const RowResult& row);
/// The plot as SVG, with class `chart` of the page's style.
std::string plotSvg(const VerifyPlot& plot);

}  // namespace muster
