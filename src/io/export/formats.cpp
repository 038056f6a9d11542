#include "io/export/formats.h"

#include <array>

#include "io/export/bvh_export.h"
#include "io/export/gltf_export.h"
#include "io/export/joint_list.h"
#include "io/export/jupedsim.h"
#include "io/export/trajectory_text.h"
#include "io/export/usd_export.h"

namespace muster {

std::span<const ExportFormat> exportFormats() {
    static constexpr std::array kFormats{
        ExportFormat{"glb", ".glb", "one binary glTF file: bodies in motion on their ground, and a camera",
                     makeGltfExporter},
        ExportFormat{"usda", ".usda", "one USD text file with the same", makeUsdExporter},
        ExportFormat{"bvh", "-bvh", "a folder with one BVH file per character", makeBvhExporter},
        ExportFormat{"joints", "-joints.json", "where all joints are, as JSON", makeJointListExporter},
        ExportFormat{"jupedsim", ".sqlite", "trajectories as JuPedSim's SQLite file", makeJupedsimExporter},
        ExportFormat{"pedpy", ".txt", "trajectories as text for PedPy", makePedpyExporter},
    };
    return kFormats;
}

Result<std::unique_ptr<Exporter>> makeExporter(std::string_view format, const std::string& path) {
    std::string names;
    for (const ExportFormat& known : exportFormats()) {
        if (format == known.name) return known.make(path);
        names += (names.empty() ? "" : ", ") + std::string(known.name);
    }
    return Status(StatusCode::NotFound,
                  "format: found \"" + std::string(format.substr(0, 40)) + "\", expected one of " + names);
}

}  // namespace muster
