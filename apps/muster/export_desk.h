// Exports of takes, one after the other on a thread of its own.
#pragma once

#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "export_order.h"

namespace muster {

/// What becomes of an export.
enum class ExportState { Waiting, Running, Done, Failed };

/// How far an export is.
struct ExportReport {
    ExportState state = ExportState::Waiting;
    double share = 0.0;       ///< Done, 0 to 1.
    std::string problem;      ///< Why it failed.
    std::string fileName;     ///< For saving.
    std::string path;         ///< Of the finished file.
    std::uint64_t bytes = 0;  ///< Of the file, or what an estimate says.
    std::size_t people = 0;   ///< What an estimate says.
};

/// Makes exports in a folder of its own, which is removed at the end. Any thread may call.
class ExportDesk {
public:
    explicit ExportDesk(ExportTools tools);
    ~ExportDesk();
    ExportDesk(const ExportDesk&) = delete;
    ExportDesk& operator=(const ExportDesk&) = delete;

    static constexpr std::size_t kMostKept = 12;  ///< Exports that wait, run or are kept.

    /// Takes an order and returns its number. Fails with NotFound for an unknown format, with LimitExceeded
    /// where too many wait.
    Result<std::string> begin(ExportOrder order);
    /// How far it is. Fails with NotFound.
    Result<ExportReport> report(const std::string& number) const;
    /// Ends and forgets it, with its file. Fails with NotFound.
    Status cancel(const std::string& number);

private:
    struct Job {
        std::string number;
        ExportOrder order;
        ExportReport report;
        bool cancelled = false;
    };
    void run();
    void make(const std::shared_ptr<Job>& job);
    Status write(const std::shared_ptr<Job>& job, const std::string& path);
    Status estimate(const std::shared_ptr<Job>& job, const std::string& path);
    std::shared_ptr<Job> find(const std::string& number) const;
    void forgetOldest();

    ExportTools tools_;
    std::string folder_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::list<std::shared_ptr<Job>> jobs_;  // In the order of their numbers.
    std::uint32_t last_ = 0;
    bool ending_ = false;
    std::thread thread_;  // The last member, because the thread uses the others.
};

}  // namespace muster
