// The text of numbers in JSON.
#pragma once

#include <string>

namespace muster {

/// The shortest text that reads back to the same bits; "null" for what is not finite, which JSON cannot hold.
std::string jsonRealText(double value);

}  // namespace muster
