// Export for the web component <muster-player>: one small file with all that is drawn.
#pragma once

#include <memory>
#include <string>

#include "files/export/exporter.h"

namespace muster {

std::unique_ptr<Exporter> makePlayerExporter(const std::string& path);  ///< For formats.cpp.

}  // namespace muster
