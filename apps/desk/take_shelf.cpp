#include "take_shelf.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>

#include "base/output_file.h"
#include "base/text_file.h"
#include "files/take/take_encoder.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".take";
constexpr const char* kRemoved = "/removed";
constexpr std::size_t kMostNameBytes = 100;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Status failed(const std::string& path) {
    return {StatusCode::IoError, path + ": cannot be written: " + std::strerror(errno)};
}

bool plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

// The only names that lead to a file: plain letters and one ending.
bool isName(const std::string& name) {
    const std::string ending = kEnding;
    if (name.size() <= ending.size() || name.size() > kMostNameBytes) return false;
    const std::size_t stem = name.size() - ending.size();
    return name.compare(stem, ending.size(), ending) == 0 &&
           std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(stem), plain);
}

std::string pictureName(const std::string& name) {
    return name.substr(0, name.size() - std::strlen(kEnding)) + ".png";
}

std::string plainText(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += plain(c) ? c : '-';
    return safe.empty() ? "take" : safe.substr(0, 60);
}

std::string stampNow() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    localtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &parts);
    return text;
}

std::int64_t changedAt(const fs::path& path) {
    struct stat found {};
    return ::stat(path.c_str(), &found) == 0 ? static_cast<std::int64_t>(found.st_mtime) : 0;
}

Status notThere(const std::string& name) {
    return {StatusCode::NotFound, "no take is called '" + name.substr(0, 60) + "'"};
}

std::span<const std::uint8_t> bytesOf(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string_view textOf(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Status replaceFile(const std::string& path, std::string_view first, std::string_view second) {
    OutputFile file;
    if (Status s = file.open(path); !s.ok()) return s;
    if (Status s = file.write(first); !s.ok()) return s;
    if (Status s = file.write(second); !s.ok()) return s;
    return file.commit();
}

/// The most characters that are there at a time, in the part that is shown; those of the start where no frame
/// says it.
std::uint32_t mostCharacters(const Take& take) {
    const std::uint32_t first = take.about.firstStep(take.steps()), last = take.about.lastStep(take.steps());
    std::size_t most = 0;
    for (const TakeFrame& frame : take.frames)
        if (frame.step >= first && frame.step <= last) most = std::max(most, frame.ids.size());
    if (most > 0) return static_cast<std::uint32_t>(most);
    std::uint32_t start = 0;
    for (const GroupDef& group : take.def.groups)
        start += static_cast<std::uint32_t>(std::max(0, group.count));
    return start;
}

/// Reads what the list tells of a take; false where the file is none.
bool learn(const std::string& path, ShelvedTake& shelved) {
    const auto text = readTextFile(path, TakeShelf::kMostTakeBytes);
    if (!text.ok()) return false;
    const auto take = parseTake(bytesOf(*text), shelved.name);
    if (!take.ok() || take->steps() == 0) return false;
    shelved.about = take->about;
    shelved.scenario = take->def.name;
    shelved.characters = mostCharacters(*take);
    shelved.steps = take->steps();
    shelved.stepTime = take->def.parameters.stepTime;
    shelved.finished = take->finished;
    return true;
}

}  // namespace

/// A recording that runs. Its file is on the shelf from the first byte.
class TakeShelf::Recording : public TakeSink {
public:
    Recording(TakeShelf& shelf, File file, std::string name)
        : shelf_(shelf), file_(std::move(file)), name_(std::move(name)) {}
    ~Recording() override { shelf_.ended(name_); }
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    Status append(std::span<const std::uint8_t> bytes) override {
        const bool wrote = std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
        return wrote && std::fflush(file_.get()) == 0 ? Status{} : failed(shelf_.path(name_));
    }
    Status finish() override {
        const bool synced = fsync(fileno(file_.get())) == 0 || errno == EINVAL || errno == ENOTSUP;
        const bool closed = std::fclose(file_.release()) == 0;
        return synced && closed ? Status{} : failed(shelf_.path(name_));
    }
    Status discard() override {
        file_.reset();
        return std::remove(shelf_.path(name_).c_str()) == 0 ? Status{} : failed(shelf_.path(name_));
    }
    std::string name() const override { return name_; }

private:
    TakeShelf& shelf_;
    File file_;
    std::string name_;
};

Result<std::unique_ptr<TakeSink>> TakeShelf::record(const std::string& scenario) {
    const std::lock_guard lock(mutex_);
    std::error_code error;
    fs::create_directories(folder_, error);
    const std::string stem = plainText(scenario) + "-" + stampNow();
    for (int attempt = 1; attempt < 100; ++attempt) {
        const std::string name = stem + (attempt == 1 ? "" : "-" + std::to_string(attempt)) + kEnding;
        if (File file{std::fopen(path(name).c_str(), "wbxe")}) {
            recording_.insert(name);
            return std::unique_ptr<TakeSink>(new Recording(*this, std::move(file), name));
        }
        if (errno != EEXIST) return failed(path(name));
    }
    return failed(path(stem));
}

void TakeShelf::ended(const std::string& name) {
    const std::lock_guard lock(mutex_);
    recording_.erase(name);
}

std::vector<ShelvedTake> TakeShelf::list() {
    const std::lock_guard lock(mutex_);
    std::vector<ShelvedTake> all;
    std::map<std::string, ShelvedTake> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        std::error_code ignored;
        if (!isName(name) || !entry.is_regular_file(ignored)) continue;
        ShelvedTake take;
        take.name = name;
        take.changed = changedAt(entry.path());
        take.bytes = entry.file_size(ignored);
        const auto known = known_.find(name);
        const bool same = known != known_.end() && known->second.changed == take.changed &&
                          known->second.bytes == take.bytes;
        if (same)
            take = known->second;
        else if (!learn(entry.path().string(), take))
            continue;
        take.recording = recording_.contains(name);
        take.picture = fs::exists(path(pictureName(name)), ignored);
        found[name] = take;
        all.push_back(std::move(take));
    }
    known_.swap(found);
    std::sort(all.begin(), all.end(), [](const ShelvedTake& a, const ShelvedTake& b) {
        return a.changed != b.changed ? a.changed > b.changed : a.name > b.name;
    });
    return all;
}

std::vector<std::string> TakeShelf::titles() {
    std::vector<std::string> titles;
    for (const ShelvedTake& take : list()) titles.push_back(take.about.title);
    return titles;
}

Result<std::string> TakeShelf::put(std::span<const std::uint8_t> bytes) {
    const auto take = parseTake(bytes, "take");
    if (!take.ok()) return take.status();
    if (take->steps() == 0) return invalidArgument("take: holds no step to replay");
    if (const std::string same = sameFile(bytes); !same.empty()) return same;
    auto sink = record(take->about.title.empty() ? take->def.name : take->about.title);
    if (!sink.ok()) return sink.status();
    Status status = (*sink)->append(bytes.first(bytes.size() - take->tornBytes));
    if (status.ok()) status = (*sink)->finish();
    if (!status.ok()) {
        (void)(*sink)->discard();
        return status;
    }
    return (*sink)->name();
}

std::string TakeShelf::sameFile(std::span<const std::uint8_t> bytes) {
    for (const ShelvedTake& take : list()) {
        if (take.bytes != bytes.size() || take.recording) continue;
        const auto text = readTextFile(path(take.name), kMostTakeBytes);
        if (text.ok() && *text == textOf(bytes)) return take.name;
    }
    return {};
}

Result<std::string> TakeShelf::pathOf(const std::string& name) const {
    std::error_code error;
    if (!isName(name) || !fs::is_regular_file(path(name), error) || fs::is_symlink(path(name), error))
        return notThere(name);
    return path(name);
}

Result<std::string> TakeShelf::read(const std::string& name) const {
    const auto at = pathOf(name);
    if (!at.ok()) return at.status();
    return readTextFile(*at, kMostTakeBytes);
}

Status TakeShelf::untouched(const std::string& name) const {
    const auto at = pathOf(name);
    if (!at.ok()) return at.status();
    if (!recording_.contains(name)) return {};
    return {StatusCode::Unsupported, name + ": is being recorded; stop the recording first"};
}

Status TakeShelf::edit(const std::string& name, const TakeAbout& about, bool whole) {
    if (Status s = about.check(); !s.ok()) return s;
    const std::lock_guard lock(mutex_);
    if (Status s = untouched(name); !s.ok()) return s;
    const auto text = readTextFile(path(name), kMostTakeBytes);
    if (!text.ok()) return text.status();
    const auto take = parseTake(bytesOf(*text), name);
    if (!take.ok()) return take.status();
    TakeAbout said = about;
    if (!whole) said.camera = take->about.camera, said.edits = take->about.edits;
    const auto record = TakeEncoder::about(said);
    return replaceFile(path(name), std::string_view(*text).substr(0, text->size() - take->tornBytes),
                       textOf(record));
}

Status TakeShelf::replace(const std::string& name, std::span<const std::uint8_t> bytes) {
    const std::lock_guard lock(mutex_);
    if (Status s = untouched(name); !s.ok()) return s;
    return replaceFile(path(name), textOf(bytes), {});
}

Status TakeShelf::putPicture(const std::string& name, std::span<const std::uint8_t> png) {
    static constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    const bool isPng = png.size() > sizeof kSignature &&
                       std::equal(std::begin(kSignature), std::end(kSignature), png.begin());
    if (!isPng) return invalidArgument("picture: found no PNG, expected one");
    if (png.size() > kMostPictureBytes)
        return {StatusCode::LimitExceeded, "picture: found " + std::to_string(png.size()) +
                                               " bytes, expected at most " +
                                               std::to_string(kMostPictureBytes)};
    const auto at = pathOf(name);
    if (!at.ok()) return at.status();
    return replaceFile(path(pictureName(name)), textOf(png), {});
}

Result<std::string> TakeShelf::pictureOf(const std::string& name) const {
    const auto at = pathOf(name);
    if (!at.ok()) return at.status();
    std::error_code error;
    const std::string picture = path(pictureName(name));
    if (!fs::is_regular_file(picture, error) || fs::is_symlink(picture, error))
        return Status(StatusCode::NotFound, name + ": has no picture");
    return picture;
}

Status TakeShelf::move(const std::string& from, const std::string& to, const std::string& name) const {
    std::error_code error;
    fs::create_directories(to, error);
    if (fs::exists(to + "/" + name, error))
        return {StatusCode::IoError, name + ": there is another one of this name"};
    fs::rename(from + "/" + name, to + "/" + name, error);
    if (error) return {StatusCode::IoError, name + ": cannot be moved: " + error.message()};
    std::error_code ignored;
    fs::rename(from + "/" + pictureName(name), to + "/" + pictureName(name), ignored);
    return {};
}

Status TakeShelf::remove(const std::string& name) {
    const std::lock_guard lock(mutex_);
    if (Status s = untouched(name); !s.ok()) return s;
    return move(folder_, folder_ + kRemoved, name);
}

Status TakeShelf::restore(const std::string& name) {
    const std::lock_guard lock(mutex_);
    std::error_code error;
    if (!isName(name) || !fs::is_regular_file(folder_ + kRemoved + "/" + name, error)) return notThere(name);
    return move(folder_ + kRemoved, folder_, name);
}

}  // namespace muster
