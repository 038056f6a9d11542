#include "files/export/formats.h"

#include <array>

namespace muster {

namespace {

constexpr std::array kFormats{
    ExportFormat{"glb", ".glb", "one binary glTF file: bodies in motion on their ground, and a camera"},
    ExportFormat{"usda", ".usda", "one USD text file with the same"},
    ExportFormat{"usdc", ".usdc", "the same as binary USD, less than half as large"},
    ExportFormat{"bvh", "-bvh", "a folder with one BVH file per character"},
    ExportFormat{"joints", "-joints.json", "where all joints are, as JSON"},
    ExportFormat{"csv", ".csv", "a table: who was where, how fast and in which motion"},
    ExportFormat{"jupedsim", ".sqlite", "trajectories as JuPedSim's SQLite file"},
    ExportFormat{"pedpy", ".txt", "trajectories as text for PedPy"},
    ExportFormat{"player", ".muster-player", "one small file that <muster-player> plays in any web page"},
};

/// Functions that make an exporter for a path, in the order of kFormats.
using MakeExporter = std::unique_ptr<Exporter> (*)(const std::string&);
constexpr std::array<MakeExporter, kFormats.size()> kMakers{
    makeGltfExporter, makeUsdExporter,      makeUsdCrateExporter, makeBvhExporter,    makeJointListExporter,
    makeCsvExporter,  makeJupedsimExporter, makePedpyExporter,    makePlayerExporter,
};

}  // namespace

std::span<const ExportFormat> exportFormats() {
    return kFormats;
}

Result<ExportFormat> exportFormat(std::string_view name) {
    std::string names;
    for (const ExportFormat& format : kFormats) {
        if (name == format.name) return format;
        names += (names.empty() ? "" : ", ") + std::string(format.name);
    }
    return Status(StatusCode::NotFound,
                  "format: found \"" + std::string(name.substr(0, 40)) + "\", expected one of " + names);
}

Result<std::unique_ptr<Exporter>> makeExporter(std::string_view format, const std::string& path) {
    for (std::size_t i = 0; i < kFormats.size(); ++i)
        if (format == kFormats[i].name) return kMakers[i](path);
    return exportFormat(format).status();
}

Status exportTake(const Take& take, const ClipLibrary& library, std::string_view format,
                  const std::string& path, const ExportDef& def, const ExportProgress& progress) {
    const auto exportFrom = [&](ReplayFrom from) {
        const auto exporter = makeExporter(format, path);
        return exporter.ok() ? exportTake(take, library, def, **exporter, progress, from) : exporter.status();
    };
    Status status = exportFrom(ReplayFrom::Simulation);
    // The take is of another version.
    if (status.code() == StatusCode::Corrupt && !take.frames.empty()) status = exportFrom(ReplayFrom::Frames);
    return status;
}

}  // namespace muster
