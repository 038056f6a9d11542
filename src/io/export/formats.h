// The formats that takes can be exported to.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "io/export/exporter.h"
#include "muster/status.h"

namespace muster {

/// A format by name.
struct ExportFormat {
    const char* name;  ///< "glb", "bvh"...
    /// Of files: ".glb"; of bvh's folder: "-bvh".
    const char* ending;
    const char* about;                                           ///< One line for people.
    std::unique_ptr<Exporter> (*make)(const std::string& path);  ///< An exporter that writes to `path`.
};

/// All formats of this build.
std::span<const ExportFormat> exportFormats();

/// An exporter of that format. Fails with NotFound, naming all formats.
Result<std::unique_ptr<Exporter>> makeExporter(std::string_view format, const std::string& path);

}  // namespace muster
