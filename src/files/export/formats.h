// Exporters by the name of their format.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "files/export/exporter.h"

namespace muster {

/// An exporter that writes to `path`. Fails as exportFormat() does.
Result<std::unique_ptr<Exporter>> makeExporter(std::string_view format, const std::string& path);

}  // namespace muster
