#include "report.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <ctime>

#include "base/hash.h"
#include "command_line.h"
#include "muster/scenario.h"

namespace muster {

std::string timeText(double seconds) {
    if (seconds < 0.0) return "-";
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.2f", seconds);
    return buffer;
}

namespace {

Json orNull(double value) {
    return value < 0.0 ? Json(nullptr) : Json(value);
}

Json walkJson(const WalkTotals& walk) {
    return {{"sum_m", walk.sum}, {"squares_m2", walk.squares}, {"longest_m", walk.longest}};
}

void printWalk(const char* name, const WalkTotals& walk) {
    std::printf("%-26s sum %.2f m  squares %.2f m^2  longest %.2f m\n", name, walk.sum, walk.squares,
                walk.longest);
}

Json exitsJson(const std::vector<ExitFigures>& exits) {
    Json list = Json::array();
    for (const ExitFigures& exit : exits)
        list.push({{"id", exit.id.value},
                   {"name", exit.name},
                   {"left", exit.left},
                   {"first_s", orNull(exit.first)},
                   {"last_s", orNull(exit.last)},
                   {"flow_per_s", orNull(exit.flow)}});
    return list;
}

Json sourcesJson(const std::vector<SourceFigures>& sources) {
    Json list = Json::array();
    for (const SourceFigures& source : sources)
        list.push({{"id", source.id.value},
                   {"name", source.name},
                   {"entered", source.entered},
                   {"waiting", source.waiting}});
    return list;
}

std::string areaName(const char* kind, AreaId id, const std::string& name) {
    const std::string text = kind + (" " + std::to_string(id.value));
    return name.empty() ? text : text + " \"" + name + "\"";
}

/// Who left and came; nothing where there are no exits and no sources.
void printDepartures(const DepartureFigures& d, std::int32_t inside) {
    if (!d.exits.empty()) {
        std::printf("left                       %u persons, %d still inside\n", d.left, inside);
        std::printf("left_s                     first %s  50 %% %s  95 %% %s  last %s\n",
                    timeText(d.first).c_str(), timeText(d.left50).c_str(), timeText(d.left95).c_str(),
                    timeText(d.last).c_str());
    }
    for (const ExitFigures& exit : d.exits)
        std::printf("%-26s %u left  first_s %s  last_s %s  flow_per_s %s\n",
                    areaName("exit", exit.id, exit.name).c_str(), exit.left, timeText(exit.first).c_str(),
                    timeText(exit.last).c_str(), timeText(exit.flow).c_str());
    for (const SourceFigures& source : d.sources)
        std::printf("%-26s %u entered  %u wait\n", areaName("source", source.id, source.name).c_str(),
                    source.entered, source.waiting);
}

void printEvents(const RunFigures& f) {
    for (std::size_t k = 0; k < f.events.size(); ++k) {
        const auto kind = static_cast<EventKind>(k);
        if (!isOrderEvent(kind) || f.events[k] == 0) continue;
        std::printf("events %-19s %llu", eventKindName(kind), static_cast<unsigned long long>(f.events[k]));
        if (isAboutMany(kind))
            std::printf("  persons %llu", static_cast<unsigned long long>(f.eventPersons[k]));
        std::printf("\n");
    }
}

}  // namespace

Json figuresJson(const RunFigures& f) {
    Json stages = Json::object();
    for (std::size_t s = 0; s < f.stageMean.size(); ++s) stages[stepStages()[s].name.data()] = f.stageMean[s];
    Json events = Json::object(), persons = Json::object();
    for (std::size_t k = 0; k < f.events.size(); ++k) {
        const auto kind = static_cast<EventKind>(k);
        events[eventKindName(kind)] = f.events[k];
        if (isAboutMany(kind)) persons[eventKindName(kind)] = f.eventPersons[k];
    }
    const DepartureFigures& departures = f.departures;
    return {{"characters", f.characters},
            {"steps", f.steps},
            {"hash", toHex(f.hash)},
            {"arrived95_s", orNull(f.arrived95)},
            {"arrived100_s", orNull(f.arrived100)},
            {"left", departures.left},
            {"inside", f.characters},
            {"left_first_s", orNull(departures.first)},
            {"left50_s", orNull(departures.left50)},
            {"left95_s", orNull(departures.left95)},
            {"left_last_s", orNull(departures.last)},
            {"exits", exitsJson(departures.exits)},
            {"sources", sourcesJson(departures.sources)},
            {"stuck", f.stuck},
            {"path_ratio", orNull(f.pathRatio)},
            {"overlap_pairs_max", f.overlapPairsMax},
            {"worst_penetration_pct", 100.0 * f.worstPenetration},
            {"top_speed_ratio", f.topSpeedRatio},
            {"swaps_per_character_per_s", f.swapsPerCharacterPerSecond},
            {"planned", walkJson(f.planned)},
            {"walked", walkJson(f.walked)},
            {"lag_p95_m", f.lagP95},
            {"unmatched", f.unmatched},
            {"collected", f.collected},
            {"events", events},
            {"event_persons", persons},
            {"step_ms", {{"p50", f.stepP50}, {"p95", f.stepP95}, {"max", f.stepMax}, {"stages", stages}}}};
}

void printFigures(const RunFigures& f, bool timings) {
    std::printf("characters                 %d\n", f.characters);
    std::printf("steps                      %u\n", f.steps);
    std::printf("hash                       %s\n", toHex(f.hash).c_str());
    std::printf("arrived95_s                %s\n", timeText(f.arrived95).c_str());
    std::printf("arrived100_s               %s\n", timeText(f.arrived100).c_str());
    printDepartures(f.departures, f.characters);
    std::printf("stuck                      %d\n", f.stuck);
    std::printf("path_ratio                 %s\n", timeText(f.pathRatio).c_str());
    std::printf("overlap_pairs_max          %d\n", f.overlapPairsMax);
    std::printf("worst_penetration_pct      %.2f\n", 100.0 * f.worstPenetration);
    std::printf("top_speed_ratio            %.3f\n", f.topSpeedRatio);
    std::printf("swaps_per_character_per_s  %.4f\n", f.swapsPerCharacterPerSecond);
    printWalk("planned", f.planned);
    printWalk("walked", f.walked);
    std::printf("lag_p95_m                  %.3f\n", f.lagP95);
    std::printf("unmatched                  %d\n", f.unmatched);
    std::printf("collected                  %d\n", f.collected);
    printEvents(f);
    std::printf("step_ms                    p50 %.2f  p95 %.2f  max %.2f\n", f.stepP50, f.stepP95, f.stepMax);
    for (std::size_t s = 0; timings && s < f.stageMean.size(); ++s)
        std::printf("  %-24s mean %.3f\n", stepStages()[s].name.data(), f.stageMean[s]);
}

std::string minuteNow() {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    char text[64];
    std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M UTC", &parts);
    return text;
}

void printJsonValue(const Json& value) {
    std::printf("%s\n", indentedJson(value, 2).c_str());
}

int reportFailure(const Status& status) {
    std::fprintf(stderr, "muster: %s\n", status.message().c_str());
    return kExitFailure;
}

void printWarnings(const WorldDef& def, const std::string& path) {
    constexpr std::size_t kShown = 3, kCounted = 100;
    const auto warnings = scenarioWarnings(def, kCounted);
    for (std::size_t i = 0; i < warnings.size() && i < kShown; ++i)
        std::fprintf(stderr, "muster: %s: warning: %s\n", path.c_str(), warnings[i].c_str());
    if (warnings.size() > kShown)
        std::fprintf(stderr, "muster: %s: warning: and %zu more, which muster check lists\n", path.c_str(),
                     warnings.size() - kShown);
}

Progress::Progress(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (shown_) std::fprintf(stderr, "\r\033[K");
}

void Progress::show(double share, const std::string& detail) {
    const double now = watch_.milliseconds();
    if (!terminal_ || now < 1000.0 || now - last_ < 250.0) return;
    last_ = now;
    shown_ = true;
    std::fprintf(stderr, "\r\033[K%s %3.0f %%%s%s", what_.c_str(), 100.0 * share, detail.empty() ? "" : "  ",
                 detail.c_str());
}

}  // namespace muster
