// Building blocks of USD text.
#pragma once

#include <string>
#include <string_view>

namespace muster {

/// A valid USD name: letters, digits and underscores, not beginning with a digit.
std::string usdName(std::string_view name);
std::string usdNumber(double value);  ///< Formats with seven digits.
/// A number in exactly `width` columns, with `decimals` where they fit.
void usdFixed(double value, int width, int decimals, std::string& text);

}  // namespace muster
