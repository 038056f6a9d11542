// The study's database: one SQLite file with runs, trials, inputs, decisions and answers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "muster/status.h"
#include "studio/study/store/records.h"

namespace muster {

/// Version of the tables; other versions are refused by name.
inline constexpr std::int32_t kStoreVersion = 1;

/// What is done where there is no file.
enum class StoreMode : std::uint8_t {
    Existing,  ///< Opening fails.
    Create,    ///< It is made.
};

/// By what a trial of models is found again, to go on where a study was cut off.
struct TrialKey {
    RunKind kind = RunKind::Models;  ///< Kind of its run.
    std::int32_t environments = 0;   ///< Version of the environments of its run.
    std::int32_t operators = 0;      ///< Version of the operators of its run.
    TrialDef def;                    ///< What it is of.
    std::string setting;             ///< Settings of the operator.
};

/// An open database. Several processes may write one file, each in its own transactions: one waits up to ten
/// seconds for another. An object belongs to one thread at a time. Every call that writes is one durable
/// transaction, but within a batch. What a killed process has written remains, its run in state Running.
class StudyStore {
public:
    /// Opens a file, or makes it. Fails where it is no database of the study, damaged or of another version;
    /// such a file is never changed. Fails with Unsupported where Muster was built without SQLite.
    static Result<StudyStore> open(const std::string& path, StoreMode mode);
    StudyStore(StudyStore&&) noexcept;
    StudyStore& operator=(StudyStore&&) noexcept;
    ~StudyStore();

    /// Adds a run and returns its id; the given id is not read.
    Result<std::int64_t> addRun(const StudyRun& run);
    /// Replaces a run. Fails with NotFound where there is none of its id.
    Status updateRun(const StudyRun& run);
    /// Adds a trial of a run that is there and returns its id; the given id is not read.
    Result<std::int64_t> addTrial(const StudyTrial& trial);
    /// Replaces a trial. Fails with NotFound where there is none of its id.
    Status updateTrial(const StudyTrial& trial);
    /// Appends inputs to those of a trial; none are none.
    Status addInputs(std::int64_t trial, std::span<const StampedInput> inputs);
    /// Appends decisions to those of a trial.
    Status addDecisions(std::int64_t trial, std::span<const StudyDecision> decisions);
    /// Appends answers to those of a run.
    Status addAnswers(std::int64_t run, std::span<const StudyAnswer> answers);
    /// Does all that `work` does in one transaction, or nothing where it fails. Batches do not nest.
    Status batch(const std::function<Status()>& work);

    /// All runs, by id.
    Result<std::vector<StudyRun>> runs();
    /// All trials, by run and id.
    Result<std::vector<StudyTrial>> trials();
    /// The trials of a run, by id.
    Result<std::vector<StudyTrial>> trials(std::int64_t run);
    /// All inputs of a trial, as they were appended.
    Result<std::vector<StampedInput>> inputs(std::int64_t trial);
    /// All decisions of a trial, as they were appended.
    Result<std::vector<StudyDecision>> decisions(std::int64_t trial);
    /// All answers of a run, as they were appended.
    Result<std::vector<StudyAnswer>> answers(std::int64_t run);
    /// True where a trial of this kind is there and complete.
    Result<bool> hasTrial(const TrialKey& key);

private:
    class Base;
    explicit StudyStore(std::unique_ptr<Base> base);

    std::unique_ptr<Base> base_;
};

}  // namespace muster
