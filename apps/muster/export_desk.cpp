#include "export_desk.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace muster {
namespace {

namespace fs = std::filesystem;

// A folder of this process for files until they are saved.
std::string exportFolder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "muster-exports-XXXXXX").string();
    return mkdtemp(name.data()) != nullptr ? name : std::string();
}

}  // namespace

ExportDesk::ExportDesk(ExportTools tools)
    : tools_(std::move(tools)), folder_(exportFolder()), thread_([this] { run(); }) {}

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
    auto fileName = exportFileName(order);
    if (!fileName.ok()) return fileName.status();
    if (folder_.empty()) return Status(StatusCode::IoError, "exports: no temporary folder can be made");
    const std::lock_guard lock(mutex_);
    forgetOldest();
    if (jobs_.size() >= kMostKept)
        return Status(StatusCode::LimitExceeded,
                      "exports: " + std::to_string(kMostKept) + " are under way; wait for one, or cancel it");
    auto job = std::make_shared<Job>();
    job->number = std::to_string(++last_);
    job->report.fileName = std::move(fileName).value();
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
    const bool made = !job->order.estimate;
    const Status status = made ? write(job, path) : estimate(job, path);
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
    if (!made) return;
    job->report.path = path;
    job->report.bytes = fs::file_size(path, ignored);
}

Status ExportDesk::estimate(const std::shared_ptr<Job>& job, const std::string& path) {
    const auto known = estimateExport(job->order, tools_, path, [&] {
        const std::lock_guard lock(mutex_);
        return !job->cancelled;
    });
    if (!known.ok()) return known.status();
    const std::lock_guard lock(mutex_);
    job->report.bytes = static_cast<std::uint64_t>(known->bytes);
    job->report.people = known->people;
    return {};
}

Status ExportDesk::write(const std::shared_ptr<Job>& job, const std::string& path) {
    return writeExport(job->order, tools_, path, [&](double share) {
        const std::lock_guard lock(mutex_);
        job->report.share = share;
        return !job->cancelled;
    });
}

}  // namespace muster
