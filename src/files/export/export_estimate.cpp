// How large an export will be: small ones are made, and the rest follows from who was there when.
#include <algorithm>
#include <filesystem>
#include <set>
#include <span>

#include "files/export/chosen_people.h"
#include "muster/export.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

/// Records (characters in all frames together) of a sample that is made.
constexpr double kFewRecords = 4000.0;    ///< Of formats that write each in the same number of bytes.
constexpr double kManyRecords = 40000.0;  ///< Of formats whose records differ.
constexpr double kMostMoves = 200000.0;   ///< Characters in all simulated steps together, of one sample.

/// How the size of a file grows.
struct Growth {
    bool waits = false;   ///< A character has a record in every frame, also while it is away.
    bool uneven = false;  ///< Records differ: of what has changed, or in pages of a database.
};

Growth growthOf(std::string_view format) {
    const bool bodies = format == "glb" || format == "usda" || format == "usdc" || format == "bvh";
    return {bodies, format.starts_with("player") || format == "jupedsim"};
}

/// Who is exported, and in how many frames.
struct Attendance {
    std::vector<std::uint32_t> start;  ///< Ids of those who are there before the first step.
    double people = 0.0;               ///< Of the whole part.
    double records = 0.0;              ///< Characters that have a record, in all its frames together.
};

/// Counts the chosen characters by the stored frames of a take.
class AttendanceCount {
public:
    AttendanceCount(const ExportDef& def, const World& world) : chosen_(def), start_(chosen_.idsIn(world)) {
        const CharactersView view = world.characters();
        newest_ = view.size() > 0 ? view.id.back() : 0;
        // Of those who come later nobody knows the group.
        if (!def.groups.empty() && view.size() > 0)
            later_ = static_cast<double>(start_.size()) / static_cast<double>(view.size());
    }

    Attendance of(const Take& take, std::span<const double> times) {
        Attendance all{start_, static_cast<double>(start_.size()), 0.0};
        if (take.frames.empty()) {
            all.records = all.people * static_cast<double>(times.size());
            return all;
        }
        std::set<std::uint32_t> seen;
        std::size_t frame = 0;
        double now = count(take.frames[0], seen);
        for (const double time : times) {
            const double step = time / take.def.parameters.stepTime + 0.5;
            for (; frame + 1 < take.frames.size() && take.frames[frame + 1].step <= step; now = -1.0) ++frame;
            if (now < 0.0) now = count(take.frames[frame], seen);
            all.records += now;
        }
        all.people = weight(seen);
        return all;
    }

private:
    double count(const TakeFrame& frame, std::set<std::uint32_t>& seen) const {
        seen.insert(frame.ids.begin(), frame.ids.end());
        return weight(frame.ids);
    }
    template <class Ids>
    double weight(const Ids& ids) const {
        double sum = 0.0;
        for (const std::uint32_t id : ids) sum += weightOf(id);
        return sum;
    }
    double weightOf(std::uint32_t id) const {
        if (!chosen_.inRange(id)) return 0.0;
        if (id > newest_) return later_;
        return std::binary_search(start_.begin(), start_.end(), id) ? 1.0 : 0.0;
    }

    ChosenPeople chosen_;
    std::vector<std::uint32_t> start_;
    std::uint32_t newest_ = 0;
    double later_ = 1.0;
};

/// Bytes of a file, or of all files in a folder.
double bytesOf(const fs::path& path) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) return static_cast<double>(fs::file_size(path, ignored));
    double sum = 0.0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path, ignored))
        if (entry.is_regular_file(ignored)) sum += static_cast<double>(entry.file_size(ignored));
    return sum;
}

/// Makes small exports and measures them.
class Sampler {
public:
    Sampler(const ExportDef& def, std::string path, const WriteExportPart& write)
        : def_(def), path_(std::move(path)), write_(write) {}

    /// The size of an export, which is removed again.
    Result<double> measure(const ExportDef& def) const {
        Status status = write_(def, path_);
        const double bytes = status.ok() ? bytesOf(path_) : 0.0;
        std::error_code ignored;
        fs::remove_all(path_, ignored);
        if (!status.ok()) return status;
        return bytes;
    }
    /// The first frames of the take with the chosen up to that id.
    Result<double> measure(std::size_t frames, std::uint32_t last) const {
        ExportDef part = def_;
        part.from = 0.0;
        part.to = static_cast<double>(frames - 1) / part.fps;
        part.speeds.clear();
        part.lastPerson = std::min(part.lastPerson, last);
        return measure(part);
    }

private:
    const ExportDef& def_;
    std::string path_;
    const WriteExportPart& write_;
};

/// From samples with one and with `frames` frames, with all and with some of those who are there at the
/// start. A size is a + b people + c frames + d records.
Result<double> extrapolated(const Sampler& sampler, const Attendance& who, Growth growth, std::size_t frames,
                            std::size_t allFrames) {
    const double many = static_cast<double>(who.start.size()), extra = static_cast<double>(frames - 1);
    const auto one = sampler.measure(1, who.start.back()), more = sampler.measure(frames, who.start.back());
    if (!one.ok() || !more.ok()) return one.ok() ? more : one;
    if (!growth.waits || who.start.size() < 2) {
        const double record = (*more - *one) / (extra * many);
        return *one + record * (who.records - many);
    }
    const std::size_t few = who.start.size() / 2;
    const auto fewOne = sampler.measure(1, who.start[few - 1]),
               fewMore = sampler.measure(frames, who.start[few - 1]);
    if (!fewOne.ok() || !fewMore.ok()) return fewOne.ok() ? fewMore : fewOne;
    const double others = many - static_cast<double>(few);
    const double record = ((*more - *one) - (*fewMore - *fewOne)) / (extra * others);
    const double frame = (*more - *one) / extra - record * many;
    const double person = (*one - *fewOne) / others - record;
    const double base = *one - person * many - frame - record * many;
    const double length = static_cast<double>(allFrames);
    return base + person * who.people + frame * length + record * who.people * length;
}

}  // namespace

Result<ExportEstimate> estimateExport(const Take& take, std::string_view format, const ExportDef& def,
                                      const std::string& path, const WriteExportPart& write) {
    ExportDef part = def;
    const auto times = exportTimes(take, part);
    if (!times.ok()) return times.status();
    const auto start = World::create(take.def, part.threads);
    if (!start.ok()) return start.status();
    const Growth growth = growthOf(format);
    Attendance who = AttendanceCount(part, *start).of(take, *times);
    if (growth.waits) who.records = who.people * static_cast<double>(times->size());
    const Sampler sampler(part, path, write);
    const double most = growth.uneven ? kManyRecords : kFewRecords;
    const double whole = static_cast<double>(take.steps()) * take.def.parameters.stepTime * part.fps;
    const auto frames = static_cast<std::size_t>(
        std::clamp(most / std::max<double>(1.0, static_cast<double>(who.start.size())), 2.0, whole + 1.0));
    ExportEstimate estimate{0.0, static_cast<std::size_t>(who.people + 0.5), times->size()};
    // A small export is made as it is, and so is one of people who all come later.
    const double moves = who.people * part.to / take.def.parameters.stepTime;
    const bool small = (who.records <= 2.0 * most && moves <= kMostMoves) || who.start.empty() || frames < 2;
    const auto bytes = small ? sampler.measure(part)
                             : extrapolated(sampler, who, growth, frames, times->size());
    if (!bytes.ok()) return bytes.status();
    estimate.bytes = std::max(*bytes, 0.0);
    return estimate;
}

}  // namespace muster
