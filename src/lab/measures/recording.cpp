#include "lab/measures/recording.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "base/text_file.h"
#include "lab/measures/sqlite_recording.h"

namespace muster {
namespace {

constexpr std::size_t kMostBytes = std::size_t{4} << 30;

/// The words of a line, parted by commas, or else by blanks.
std::vector<std::string_view> wordsOf(std::string_view line, bool commas) {
    std::vector<std::string_view> words;
    const auto isGap = [commas](char c) { return commas ? c == ',' : c == ' ' || c == '\t' || c == '\r'; };
    std::size_t at = 0;
    while (at <= line.size()) {
        std::size_t end = at;
        while (end < line.size() && !isGap(line[end])) ++end;
        if (commas || end > at) words.push_back(line.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

bool numberOf(std::string_view word, double& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

/// Calls `each(line, number)` for every line until it fails.
template <class Each>
Status forLines(std::string_view text, const Each& each) {
    std::size_t number = 0;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        if (Status s = each(line, ++number); !s.ok()) return s.within("line " + std::to_string(number));
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    return {};
}

Status unexpected(std::string_view line, const char* expected) {
    return {StatusCode::ParseError,
            "found \"" + std::string(line.substr(0, 40)) + "\", expected " + expected};
}

std::string lower(std::string_view text) {
    std::string low(text);
    for (char& c : low) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return low;
}

/// The frame rate and the unit that the comments of a text name.
struct TextHead {
    double frameRate = 0.0;
    double unit = 1.0;

    void read(std::string_view line) {
        const std::string low = lower(line);
        if (const std::size_t at = low.find("framerate"); at != std::string::npos && frameRate == 0.0) {
            for (const std::string_view word : wordsOf(std::string_view(low).substr(at), false)) {
                const std::string_view bare = word.substr(std::min(word.find(':') + 1, word.size()));
                if (numberOf(word, frameRate) || numberOf(bare, frameRate)) break;
            }
        }
        if (low.find("x/cm") != std::string::npos || low.find("in cm") != std::string::npos) unit = 0.01;
    }
};

Result<Recording> parseText(std::string_view text, double frameRate) {
    TextHead head;
    std::vector<Sighting> all;
    const Status read = forLines(text, [&](std::string_view line, std::size_t) -> Status {
        if (line.empty()) return {};
        if (line[0] == '#') {
            head.read(line);
            return {};
        }
        const auto words = wordsOf(line, false);
        if (words.empty()) return {};
        double id = 0.0, frame = 0.0;
        Vec2 p;
        if (words.size() < 4 || !numberOf(words[0], id) || !numberOf(words[1], frame) ||
            !numberOf(words[2], p.x) || !numberOf(words[3], p.y) || id < 0.0 || id > 4294967295.0 ||
            std::abs(frame) > 2e9)
            return unexpected(line, "id frame x y");
        all.push_back({static_cast<std::int32_t>(frame), static_cast<std::uint32_t>(id), p * head.unit});
        return {};
    });
    if (!read.ok()) return read;
    const double rate = head.frameRate > 0.0 ? head.frameRate : frameRate;
    if (rate <= 0.0) return invalidArgument("found no line \"# framerate: N\", expected one, or --fps");
    auto made = Trajectories::create(rate, std::move(all));
    if (!made.ok()) return made.status();
    return Recording{std::move(made).value(), {}};
}

/// Columns of a CSV by their names.
struct CsvHead {
    std::ptrdiff_t t = -1, id = -1, x = -1, y = -1;

    explicit CsvHead(std::string_view line) {
        const auto names = wordsOf(line, true);
        const auto find = [&](std::string_view name) {
            const auto at = std::find(names.begin(), names.end(), name);
            return at == names.end() ? -1 : at - names.begin();
        };
        t = find("t"), id = find("id"), x = find("x"), y = find("y");
    }
    bool good() const { return t >= 0 && id >= 0 && x >= 0 && y >= 0; }
    std::size_t width() const { return static_cast<std::size_t>(std::max({t, id, x, y})) + 1; }
};

/// Numbers the times of a CSV: the least step between two is that of a frame.
Result<Recording> recordingOf(std::vector<double> times, std::vector<Sighting> all) {
    std::vector<double> steps(times);
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < steps.size(); ++i) least = std::min(least, steps[i] - steps[i - 1]);
    // The times have nine digits; the mean of all steps is better than one of them.
    const double whole = steps.size() > 1 ? std::round((steps.back() - steps.front()) / least) : 1.0;
    const double rate = steps.size() > 1 ? whole / (steps.back() - steps.front()) : 1.0;
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i].frame = static_cast<std::int32_t>(std::llround(times[i] * rate));
    auto made = Trajectories::create(rate, std::move(all));
    if (!made.ok()) return made.status();
    return Recording{std::move(made).value(), {}};
}

Result<Recording> parseCsv(std::string_view text) {
    const CsvHead head(lower(text.substr(0, text.find_first_of("\r\n"))));
    std::vector<double> times;
    std::vector<Sighting> all;
    const Status read = forLines(text, [&](std::string_view line, std::size_t number) -> Status {
        if (number == 1 || line.empty()) return {};
        const auto words = wordsOf(line, true);
        double t = 0.0, id = 0.0;
        Vec2 p;
        if (words.size() < head.width() || !numberOf(words[head.t], t) || !numberOf(words[head.id], id) ||
            !numberOf(words[head.x], p.x) || !numberOf(words[head.y], p.y) || id < 0.0 || id > 4294967295.0)
            return unexpected(line, "numbers for t, id, x and y");
        times.push_back(t);
        all.push_back({0, static_cast<std::uint32_t>(id), p});
        return {};
    });
    if (!read.ok()) return read;
    return recordingOf(std::move(times), std::move(all));
}

}  // namespace

Result<Recording> parseRecording(std::string_view text, double frameRate) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    const std::string first = lower(text.substr(0, text.find_first_of("\r\n")));
    return CsvHead(first).good() ? parseCsv(text) : parseText(text, frameRate);
}

Result<Recording> readRecording(const std::string& path, double frameRate) {
    if (isSqliteFile(path)) {
        auto recording = readSqliteRecording(path);
        return recording.ok() ? std::move(recording) : Result<Recording>(recording.status().within(path));
    }
    const auto text = readTextFile(path, kMostBytes);
    if (!text.ok()) return text.status();
    auto recording = parseRecording(*text, frameRate);
    return recording.ok() ? std::move(recording) : Result<Recording>(recording.status().within(path));
}

}  // namespace muster
