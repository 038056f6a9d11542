// The desktop's browser.
#pragma once

#include <string>

namespace muster {

/// Shows that address in the desktop's browser; does nothing where there is no desktop. The browser outlives
/// us: it has a session of its own and none of our files.
void openBrowser(const std::string& address);

}  // namespace muster
