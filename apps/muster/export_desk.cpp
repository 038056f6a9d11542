#include "export_desk.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "muster/own_clips.h"
#include "zip_file.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

// A folder of this process for files until they are saved.
std::string exportFolder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "muster-exports-XXXXXX").string();
    return mkdtemp(name.data()) != nullptr ? name : std::string();
}

std::string plainName(const std::string& title) {
    std::string name;
    for (const char c : title) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '_';
        if (plain)
            name += c;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (!name.empty() && name.back() == '-') name.pop_back();
    return name.empty() ? "take" : name.substr(0, 60);
}

bool hasBodies(const std::string& format) {
    return format == "glb" || format == "usda" || format == "bvh";
}

}  // namespace

ExportDesk::ExportDesk(LoadClips loadClips)
    : loadClips_(std::move(loadClips)), folder_(exportFolder()), thread_([this] { run(); }) {}

ExportDesk::~ExportDesk() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        for (const auto& job : jobs_) job->cancelled = true;
    }
    changed_.notify_all();
    thread_.join();
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

Result<std::string> ExportDesk::begin(ExportOrder order) {
    const auto format = exportFormat(order.format);
    if (!format.ok()) return format.status();
    if (folder_.empty()) return Status(StatusCode::IoError, "exports: no temporary folder can be made");
    const std::lock_guard lock(mutex_);
    forgetOldest();
    if (jobs_.size() >= kMostKept)
        return Status(StatusCode::LimitExceeded,
                      "exports: " + std::to_string(kMostKept) + " are under way; wait for one, or cancel it");
    auto job = std::make_shared<Job>();
    job->number = std::to_string(++last_);
    const std::string ending = order.format == "bvh" ? "-bvh.zip" : format->ending;
    job->report.fileName = plainName(order.title) + ending;
    job->order = std::move(order);
    jobs_.push_back(job);
    changed_.notify_all();
    return job->number;
}

// Where the desk is full, the file that was made first is dropped.
void ExportDesk::forgetOldest() {
    if (jobs_.size() < kMostKept) return;
    const auto over = std::find_if(jobs_.begin(), jobs_.end(), [](const auto& job) {
        return job->report.state == ExportState::Done || job->report.state == ExportState::Failed;
    });
    if (over == jobs_.end()) return;
    std::error_code ignored;
    if (!(*over)->report.path.empty()) fs::remove((*over)->report.path, ignored);
    jobs_.erase(over);
}

std::shared_ptr<ExportDesk::Job> ExportDesk::find(const std::string& number) const {
    const auto found = std::find_if(jobs_.begin(), jobs_.end(),
                                    [&](const auto& job) { return job->number == number; });
    return found == jobs_.end() ? nullptr : *found;
}

Result<ExportReport> ExportDesk::report(const std::string& number) const {
    const std::lock_guard lock(mutex_);
    const auto job = find(number);
    if (!job) return Status(StatusCode::NotFound, "there is no such export");
    return job->report;
}

Status ExportDesk::cancel(const std::string& number) {
    const std::lock_guard lock(mutex_);
    const auto job = find(number);
    if (!job) return {StatusCode::NotFound, "there is no such export"};
    job->cancelled = true;
    std::error_code ignored;
    if (!job->report.path.empty()) fs::remove(job->report.path, ignored);
    jobs_.remove(job);
    return {};
}

void ExportDesk::run() {
    while (true) {
        std::shared_ptr<Job> next;
        {
            std::unique_lock lock(mutex_);
            const auto waiting = [&] {
                return std::find_if(jobs_.begin(), jobs_.end(), [](const auto& job) {
                    return job->report.state == ExportState::Waiting;
                });
            };
            changed_.wait(lock, [&] { return ending_ || waiting() != jobs_.end(); });
            if (ending_) return;
            next = *waiting();
            next->report.state = ExportState::Running;
        }
        make(next);
    }
}

void ExportDesk::make(const std::shared_ptr<Job>& job) {
    const std::string path = folder_ + "/" + job->number;
    const Status status = write(job, path);
    std::error_code ignored;
    const std::lock_guard lock(mutex_);
    if (job->cancelled) {
        fs::remove(path, ignored);
        return;
    }
    job->report.state = status.ok() ? ExportState::Done : ExportState::Failed;
    if (!status.ok()) {
        job->report.problem = status.message();
        return;
    }
    job->report.share = 1.0;
    job->report.path = path;
    job->report.bytes = fs::file_size(path, ignored);
}

Status ExportDesk::write(const std::shared_ptr<Job>& job, const std::string& path) {
    const ExportOrder& order = job->order;
    const auto take = readTake(order.take);
    if (!take.ok()) return take.status();
    auto clips = loadClips_ ? loadClips_(take->def.name, take->def) : Result<ClipLibrary>(ownClips());
    if (!clips.ok()) clips = ownClips();
    ExportDef def;
    def.from = order.from;
    def.to = order.to;
    def.fps = order.fps;
    if (order.speeds && hasBodies(order.format)) def.speeds = take->about.speeds;
    const auto progress = [&](double share) {
        const std::lock_guard lock(mutex_);
        job->report.share = share;
        return !job->cancelled;
    };
    if (order.format != "bvh") return exportTake(*take, *clips, order.format, path, def, progress);
    const std::string files = path + "-files";
    Status status = exportTake(*take, *clips, order.format, files, def, progress);
    if (status.ok()) status = zipFolder(files, path);
    std::error_code ignored;
    fs::remove_all(files, ignored);
    return status;
}

}  // namespace muster
