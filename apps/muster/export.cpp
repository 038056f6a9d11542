// muster export
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "folders.h"
#include "muster/export.h"
#include "muster/own_clips.h"
#include "options.h"
#include "people/clips/clip_files.h"
#include "people/motion/clips_for.h"
#include "player_page.h"
#include "report.h"

namespace muster {
namespace {

struct ExportOptions {
    std::string take;
    std::string format;
    std::string out;
    std::string clips;
    std::vector<double> groups;
    std::vector<double> people;  ///< First and last id.
    bool estimate = false;
    double fps = std::numeric_limits<double>::quiet_NaN();  ///< Not a number where it is left out.
    ExportDef part;
};

/// The clips that characters play: a folder of clips, or the folder of the scenario's clip files.
Result<ClipLibrary> clipsOf(const ExportOptions& options, const Take& take) {
    std::error_code ignored;
    if (options.clips.empty()) {
        for (const ClipFacts& facts : take.def.clips) {
            if (facts.file.empty()) continue;
            std::fprintf(
                stderr,
                "muster export: %s moves by %s in the scenario; --clips FOLDER says where that file is\n",
                facts.name.c_str(), facts.file.c_str());
        }
        return ownClips();
    }
    if (!std::filesystem::is_directory(options.clips, ignored))
        return invalidArgument(options.clips + ": is no folder");
    const bool list = std::filesystem::exists(options.clips + "/" + kClipList, ignored);
    if (list) return loadClips(options.clips);
    if (!namesClipFiles(take.def.clips))
        return invalidArgument(options.clips + ": found no " + kClipList +
                               ", and the take's scenario names no clip files");
    return clipsFor(take.def.clips, options.clips);
}

/// The output path: the requested file, or a file in the current folder with the take's name.
std::string outputPath(const ExportOptions& options, const ExportFormat& format) {
    if (!options.out.empty()) return options.out;
    return std::filesystem::path(options.take).stem().string() + format.ending;
}

Result<std::uint32_t> wholeNumber(const char* option, double value) {
    if (value >= 0.0 && value <= 4294967295.0 && value == std::floor(value))
        return static_cast<std::uint32_t>(value);
    char text[120];
    std::snprintf(text, sizeof(text), "%s: found %.6g, expected a whole number that is not negative", option,
                  value);
    return invalidArgument(text);
}

/// Who is exported.
Status choosePeople(const ExportOptions& options, ExportDef& part) {
    for (const double group : options.groups) {
        const auto id = wholeNumber("--groups", group);
        if (!id.ok()) return id.status();
        part.groups.push_back(*id);
    }
    if (options.people.empty()) return {};
    const auto first = wholeNumber("--people", options.people[0]),
               last = wholeNumber("--people", options.people[1]);
    if (!first.ok() || !last.ok()) return first.ok() ? last.status() : first.status();
    part.firstPerson = *first, part.lastPerson = *last;
    return {};
}

/// Bytes with three digits, in the unit that suits.
std::string sizeText(double bytes) {
    const char* units[] = {"bytes", "kB", "MB", "GB"};
    std::size_t unit = 0;
    for (; bytes >= 999.5 && unit < 3; ++unit) bytes /= 1000.0;
    char text[40];
    std::snprintf(text, sizeof(text), "%.3g %s", bytes, units[unit]);
    return text;
}

/// Says how large the export will be, and writes nothing.
int tellSize(const ExportOptions& options, const Take& take, const ExportDef& part,
             const WriteExportPart& write) {
    std::error_code ignored;
    std::string folder = (std::filesystem::temp_directory_path(ignored) / "muster-estimate-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr)
        return reportFailure({StatusCode::IoError, folder + ": cannot be made"});
    const auto known = estimateExport(take, options.format, part, folder + "/part", write);
    std::filesystem::remove_all(folder, ignored);
    if (!known.ok()) return reportFailure(known.status());
    std::printf("about %s: %zu %s, %zu moments\n", sizeText(known->bytes).c_str(), known->people,
                known->people == 1 ? "person" : "people", known->frames);
    return kExitOk;
}

int exportFile(const ExportOptions& options) {
    const auto format = exportOrPageFormat(options.format);
    if (!format.ok()) return reportFailure(format.status());
    const std::string out = outputPath(options, *format);
    if (Status s = differentFiles({options.take}, {out}); !s.ok()) return reportFailure(s);
    const auto take = readTake(options.take);
    if (!take.ok()) return reportFailure(take.status());
    if (take->tornBytes > 0) {
        return reportFailure({StatusCode::Corrupt,
                              options.take + ": its last record is torn; muster replay says what is left"});
    }
    const auto clips = clipsOf(options, *take);
    if (!clips.ok()) return reportFailure(clips.status());
    Progress progress("exporting");
    ExportDef part = options.part;
    part.fps = std::isnan(options.fps) ? usualFps(options.format) : options.fps;
    if (Status s = choosePeople(options, part); !s.ok()) return reportFailure(s);
    const std::string player = pageFolder() + "/player";
    const auto write = [&](const ExportDef& def, const std::string& path) {
        return exportTakeOrPage(*take, *clips, *format, path, def, player, [&](double share) {
            if (!options.estimate) progress.show(share);
            return true;
        });
    };
    if (options.estimate) return tellSize(options, *take, part, write);
    const Status done = write(part, out);
    if (!done.ok()) return reportFailure(done);
    std::printf("wrote %s\n", out.c_str());
    return kExitOk;
}

std::string formatList() {
    std::string text;
    std::vector<ExportFormat> formats(exportFormats().begin(), exportFormats().end());
    formats.insert(formats.end(), {kPlayerPage, kPlayerFolder});
    for (const ExportFormat& format : formats)
        text += std::string("  ") + format.name + ": " + format.about + "\n";
    return text;
}

}  // namespace

void addExportCommand(CommandLine& line) {
    Subcommand command = line.add("export",
                                  "Writes a take for other programs: bodies in motion, or trajectories.");
    auto options = std::make_shared<ExportOptions>();
    command.option("TAKE", options->take, "Take file.").required();
    command.option("--format", options->format, "One of those below.").required();
    command.option(
        "--out", options->out,
        "File to be written, for bvh and player-folder a folder; left out: here, by the take's name.");
    command.option("--from", options->part.from, "Time of the first frame [s].");
    command.option("--to", options->part.to, "Time of the last frame [s]; left out: the end of the take.");
    command.option("--groups", options->groups,
                   "Numbers of groups: only who is in one of them when first seen.");
    command.option("--people", options->people, "First and last number of people.").values(2);
    command.flag("--estimate", options->estimate, "Says how large it will be, and writes nothing.");
    command.option("--fps", options->fps,
                   "Frames a second, 1 to 240; usual are 24, 25, 30 and 60; left out: 30, for players 15.");
    command.option(
        "--clips", options->clips,
        "Folder with a clips.json whose clips are to be used, or the scenario's folder, if it names clip "
        "files; left out: Muster's own clips.");
    command.option("--threads", options->part.threads, "Threads; 0 takes what the machine has.")
        .range(0, 256);
    command.footer("Formats:\n" + formatList() +
                   "The take is simulated again; frames between steps are interpolated. Nothing is left "
                   "behind where it fails.\n"
                   "Examples:\n"
                   "  muster export cars.take --format bvh --out cars --fps 24\n"
                   "  muster export cars.take --format jupedsim --out cars.sqlite --from 2 --to 10\n"
                   "  muster export cars.take --format csv --groups 2 --people 1 40\n"
                   "  muster export cars.take --format usda --estimate\n"
                   "  muster export cars.take --format player-page --out cars.html");
    command.run([options] { return exportFile(*options); });
}

}  // namespace muster
