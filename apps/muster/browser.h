// Opens the desktop's browser.
#pragma once

#include <string>

namespace muster {

/// Opens that address in the desktop's browser; does nothing where there is no desktop. The browser outlives
/// this process: it has a session of its own and none of this process's files.
void openBrowser(const std::string& address);

}  // namespace muster
