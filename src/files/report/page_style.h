// The style sheet of reports.
#pragma once

#include <string>

namespace muster {

/// The studio's colours and letters, for screens, phones, dark surroundings and A4.
std::string pageStyle();

}  // namespace muster
