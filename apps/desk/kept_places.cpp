#include "kept_places.h"

#include <filesystem>

#include "base/output_file.h"
#include "base/text_file.h"
#include "muster/scenario.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostStem = 60;
constexpr std::size_t kMostName = 200;  // Of the scenario that was shown last.

/// Letters and digits of a title, with - between words: "My yard" gives "my-yard".
std::string stemOf(const std::string& title) {
    std::string stem;
    bool gap = false;
    for (const char c : title) {
        const char low = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        const bool plain = (low >= 'a' && low <= 'z') || (low >= '0' && low <= '9');
        if (plain && stem.size() < kMostStem) {
            if (gap && !stem.empty()) stem += '-';
            stem += low;
        }
        gap = !plain;
    }
    return stem.empty() ? "place" : stem;
}

Status replaceFile(const std::string& path, std::string_view text) {
    OutputFile file;
    if (Status s = file.open(path); !s.ok()) return s;
    if (Status s = file.write(text); !s.ok()) return s;
    return file.commit();
}

}  // namespace

std::string KeptPlaces::pathOf(std::string_view stem) const {
    return (fs::path(folder_) / stem).string() + ".json";
}

Result<std::string> KeptPlaces::put(const WorldDef& place) const {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) return Status(StatusCode::IoError, folder_ + ": " + error.message());
    const std::string stem = stemOf(place.name);
    std::string path = pathOf(stem);
    for (int number = 2; fs::exists(path, error); ++number) {
        const auto there = loadScenario(path);
        if (there.ok() && there->name == place.name) break;
        path = pathOf(stem + "-" + std::to_string(number));
    }
    if (Status s = replaceFile(path, writeScenario(place)); !s.ok()) return s;
    return path;
}

void KeptPlaces::remember(const std::string& scenario) const {
    std::error_code error;
    if (!fs::is_directory(folder_, error)) return;
    (void)replaceFile((fs::path(folder_) / "last").string(), scenario);
}

std::string KeptPlaces::last() const {
    const auto text = readTextFile((fs::path(folder_) / "last").string(), kMostName);
    return text.ok() ? *text : std::string();
}

}  // namespace muster
