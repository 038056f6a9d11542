#include "studio/study/store/store.h"

#include <utility>

#include "studio/study/store/database.h"

#if MUSTER_SQLITE
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#endif

namespace muster {

#if MUSTER_SQLITE
namespace {

using sqlite::Statement;

constexpr std::int64_t kApplication = 0x4D535459;  ///< "MSTY".

constexpr const char* kTables =
    "CREATE TABLE runs(id INTEGER PRIMARY KEY AUTOINCREMENT, kind INTEGER NOT NULL, state INTEGER NOT NULL,"
    " started TEXT NOT NULL, version TEXT NOT NULL, environments INTEGER NOT NULL, operators INTEGER NOT "
    "NULL,"
    " latin_row INTEGER NOT NULL, note TEXT NOT NULL);"
    "CREATE TABLE trials(id INTEGER PRIMARY KEY AUTOINCREMENT, run INTEGER NOT NULL REFERENCES runs(id),"
    " environment TEXT NOT NULL, crowd INTEGER NOT NULL, scheme TEXT NOT NULL, seed INTEGER NOT NULL,"
    " mirrored INTEGER NOT NULL, setting TEXT NOT NULL, practice INTEGER NOT NULL, period INTEGER NOT NULL,"
    " position INTEGER NOT NULL, state INTEGER NOT NULL, done INTEGER NOT NULL, steps INTEGER NOT NULL,"
    " seconds REAL NOT NULL, items INTEGER NOT NULL, collected INTEGER NOT NULL, gestures INTEGER NOT NULL,"
    " commands INTEGER NOT NULL, idle_seconds REAL NOT NULL, hash TEXT NOT NULL, misses INTEGER NOT NULL,"
    " operator_seconds REAL NOT NULL);"
    "CREATE INDEX trials_key ON trials(environment, scheme, crowd, seed, setting);"
    "CREATE INDEX trials_run ON trials(run);"
    "CREATE TABLE inputs(id INTEGER PRIMARY KEY AUTOINCREMENT, trial INTEGER NOT NULL REFERENCES trials(id),"
    " first_step INTEGER NOT NULL, bytes BLOB NOT NULL);"
    "CREATE INDEX inputs_trial ON inputs(trial);"
    "CREATE TABLE decisions(id INTEGER PRIMARY KEY AUTOINCREMENT, trial INTEGER NOT NULL REFERENCES "
    "trials(id),"
    " step INTEGER NOT NULL, kind TEXT NOT NULL, seconds REAL NOT NULL, text TEXT NOT NULL);"
    "CREATE INDEX decisions_trial ON decisions(trial);"
    "CREATE TABLE answers(id INTEGER PRIMARY KEY AUTOINCREMENT, run INTEGER NOT NULL REFERENCES runs(id),"
    " scheme TEXT NOT NULL, instrument TEXT NOT NULL, item TEXT NOT NULL, text TEXT NOT NULL, number REAL);"
    "CREATE INDEX answers_run ON answers(run);";

constexpr const char* kRunColumns = "kind, state, started, version, environments, operators, latin_row, note";
constexpr const char* kTrialColumns =
    "run, environment, crowd, scheme, seed, mirrored, setting, practice, period, position, state, done, "
    "steps,"
    " seconds, items, collected, gestures, commands, idle_seconds, hash, misses, operator_seconds";

std::int64_t whole(std::uint64_t value) {
    return static_cast<std::int64_t>(value);
}

/// SQLite keeps no NaN: such a time is none.
double time(double seconds) {
    return std::isfinite(seconds) ? seconds : 0.0;
}

void bind(Statement& s, const StudyRun& run) {
    s(static_cast<std::int64_t>(run.kind));
    s(static_cast<std::int64_t>(run.state));
    s(run.started);
    s(run.version);
    s(static_cast<std::int64_t>(run.environments));
    s(static_cast<std::int64_t>(run.operators));
    s(static_cast<std::int64_t>(run.order));
    s(run.note);
}

StudyRun readRun(Statement& s) {
    StudyRun run;
    run.id = s.whole();
    run.kind = static_cast<RunKind>(s.whole());
    run.state = static_cast<RunState>(s.whole());
    run.started = s.text();
    run.version = s.text();
    run.environments = static_cast<std::int32_t>(s.whole());
    run.operators = static_cast<std::int32_t>(s.whole());
    run.order = static_cast<std::int32_t>(s.whole());
    run.note = s.text();
    return run;
}

void bind(Statement& s, const TrialResult& result) {
    char hash[17];
    std::snprintf(hash, sizeof(hash), "%016" PRIx64, result.hash);
    s(std::int64_t{result.done});
    s(std::int64_t{result.steps});
    s(time(result.seconds));
    s(std::int64_t{result.items});
    s(std::int64_t{result.collected});
    s(std::int64_t{result.gestures});
    s(std::int64_t{result.commands});
    s(time(result.idleSeconds));
    s(std::string(hash));
}

void bind(Statement& s, const StudyTrial& trial) {
    s(trial.run);
    s(trial.def.environment);
    s(std::int64_t{trial.def.crowd});
    s(trial.def.scheme);
    s(whole(trial.def.seed));
    s(std::int64_t{trial.def.mirrored});
    s(trial.setting);
    s(std::int64_t{trial.practice});
    s(std::int64_t{trial.period});
    s(std::int64_t{trial.position});
    s(static_cast<std::int64_t>(trial.state));
    bind(s, trial.result);
    s(std::int64_t{trial.misses});
    s(time(trial.operatorSeconds));
}

TrialResult readResult(Statement& s) {
    TrialResult result;
    result.done = s.whole() != 0;
    result.steps = static_cast<std::uint32_t>(s.whole());
    result.seconds = s.real();
    result.items = static_cast<std::int32_t>(s.whole());
    result.collected = static_cast<std::int32_t>(s.whole());
    result.gestures = static_cast<std::int32_t>(s.whole());
    result.commands = static_cast<std::int32_t>(s.whole());
    result.idleSeconds = s.real();
    result.hash = std::strtoull(s.text().c_str(), nullptr, 16);
    return result;
}

StudyTrial readTrial(Statement& s) {
    StudyTrial trial;
    trial.id = s.whole();
    trial.run = s.whole();
    trial.def.environment = s.text();
    trial.def.crowd = static_cast<std::int32_t>(s.whole());
    trial.def.scheme = s.text();
    trial.def.seed = static_cast<std::uint64_t>(s.whole());
    trial.def.mirrored = s.whole() != 0;
    trial.setting = s.text();
    trial.practice = s.whole() != 0;
    trial.period = static_cast<std::int32_t>(s.whole());
    trial.position = static_cast<std::int32_t>(s.whole());
    trial.state = static_cast<RunState>(s.whole());
    trial.result = readResult(s);
    trial.misses = static_cast<std::int32_t>(s.whole());
    trial.operatorSeconds = s.real();
    return trial;
}

/// "?, ?, ?" for as many columns as the list names.
std::string marksFor(const std::string& columns) {
    std::string marks = "?";
    for (const char c : columns)
        if (c == ',') marks += ", ?";
    return marks;
}

std::string insertion(const std::string& table, const std::string& columns) {
    return "INSERT INTO " + table + "(" + columns + ") VALUES(" + marksFor(columns) + ")";
}

std::string replacement(const std::string& table, const std::string& columns) {
    return "UPDATE " + table + " SET (" + columns + ") = (" + marksFor(columns) + ") WHERE id = ?";
}

}  // namespace

/// The connection, and what is done by it.
class StudyStore::Base : public sqlite::Database {
public:
    /// Makes or checks the tables.
    Status prepare(bool create);
    /// Runs a statement; returns the id of the row that it added.
    Result<std::int64_t> added(Statement& statement) {
        if (Status s = finish(statement); !s.ok()) return s;
        return lastId();
    }
    Status replaced(Statement& statement, const char* what, std::int64_t id) {
        if (Status s = finish(statement); !s.ok()) return s;
        if (changes() == 1) return {};
        return {StatusCode::NotFound,
                "the database '" + path() + "' has no " + what + " " + std::to_string(id)};
    }
    /// All rows that a statement gives, each read by `read`.
    template <class Read>
    auto rows(Statement& statement, Read read) -> Result<std::vector<decltype(read(statement))>> {
        std::vector<decltype(read(statement))> found;
        int code = statement.step();
        for (; code == SQLITE_ROW; code = statement.step()) found.push_back(read(statement));
        const Status status = code == SQLITE_DONE ? Status() : failed();
        statement.reset();
        if (!status.ok()) return status;
        return found;
    }
    /// Does work in a transaction of its own, or in the batch that is open.
    Status transaction(const std::function<Status()>& work);

private:
    Status makeTables();
    Status checkTables();
    bool open_ = false;  ///< A batch is open.
};

Status StudyStore::Base::prepare(bool create) {
    const auto application = number("PRAGMA application_id");
    if (!application.ok()) return application.status();
    const auto tables = number("SELECT count(*) FROM sqlite_master");
    if (!tables.ok()) return tables.status();
    const bool fresh = *application == 0 && *tables == 0;
    if (!fresh || !create)
        if (Status s = checkTables(); !s.ok()) return s;
    if (Status s = execute("PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; PRAGMA foreign_keys=ON;");
        !s.ok())
        return s;
    return fresh ? makeTables() : Status();
}

Status StudyStore::Base::checkTables() {
    const auto application = number("PRAGMA application_id");
    if (!application.ok()) return application.status();
    if (*application != kApplication)
        return {StatusCode::ParseError, "the database '" + path() + "' is not a database of the study"};
    const auto version = number("PRAGMA user_version");
    if (!version.ok()) return version.status();
    if (*version != kStoreVersion)
        return {StatusCode::Unsupported, "the database '" + path() + "' has version " +
                                             std::to_string(*version) + ", expected " +
                                             std::to_string(kStoreVersion)};
    const auto tables = number(
        "SELECT count(*) FROM sqlite_master WHERE type = 'table'"
        " AND name IN ('runs', 'trials', 'inputs', 'decisions', 'answers')");
    if (!tables.ok()) return tables.status();
    if (*tables != 5)
        return {StatusCode::Corrupt, "the database '" + path() + "' is damaged: tables are missing"};
    return {};
}

Status StudyStore::Base::makeTables() {
    return transaction([this]() -> Status {
        const auto tables = number("SELECT count(*) FROM sqlite_master");
        if (!tables.ok()) return tables.status();
        if (*tables > 0) return checkTables();  // Another process was faster.
        if (Status s = execute(kTables); !s.ok()) return s;
        const std::string marks = "PRAGMA application_id=" + std::to_string(kApplication) +
                                  "; PRAGMA user_version=" + std::to_string(kStoreVersion) + ";";
        return execute(marks.c_str());
    });
}

Status StudyStore::Base::transaction(const std::function<Status()>& work) {
    if (open_) return work();
    if (Status s = execute("BEGIN IMMEDIATE"); !s.ok()) return s;
    open_ = true;
    Status status = work();
    if (status.ok()) status = execute("COMMIT");
    if (!status.ok()) (void)execute("ROLLBACK");
    open_ = false;
    return status;
}

Result<StudyStore> StudyStore::open(const std::string& path, StoreMode mode) {
    auto base = std::make_unique<Base>();
    const bool create = mode == StoreMode::Create;
    if (Status s = base->open(path, create); !s.ok()) return s;
    if (Status s = base->prepare(create); !s.ok()) return s;
    return StudyStore(std::move(base));
}

Result<std::int64_t> StudyStore::addRun(const StudyRun& run) {
    Statement& s = base_->statement(insertion("runs", kRunColumns));
    bind(s, run);
    return base_->added(s);
}

Status StudyStore::updateRun(const StudyRun& run) {
    Statement& s = base_->statement(replacement("runs", kRunColumns));
    bind(s, run);
    s(run.id);
    return base_->replaced(s, "run", run.id);
}

Result<std::int64_t> StudyStore::addTrial(const StudyTrial& trial) {
    Statement& s = base_->statement(insertion("trials", kTrialColumns));
    bind(s, trial);
    return base_->added(s);
}

Status StudyStore::updateTrial(const StudyTrial& trial) {
    Statement& s = base_->statement(replacement("trials", kTrialColumns));
    bind(s, trial);
    s(trial.id);
    return base_->replaced(s, "trial", trial.id);
}

Status StudyStore::addInputs(std::int64_t trial, std::span<const StampedInput> inputs) {
    if (inputs.empty()) return {};
    const std::vector<std::uint8_t> bytes = encodeInputs(inputs);
    Statement& s = base_->statement(insertion("inputs", "trial, first_step, bytes"));
    s(trial);
    s(std::int64_t{inputs.front().step});
    s(std::span<const std::uint8_t>(bytes));
    return base_->finish(s);
}

Status StudyStore::addDecisions(std::int64_t trial, std::span<const StudyDecision> decisions) {
    return base_->transaction([&]() -> Status {
        for (const StudyDecision& decision : decisions) {
            Statement& s = base_->statement(insertion("decisions", "trial, step, kind, seconds, text"));
            s(trial);
            s(std::int64_t{decision.step});
            s(decision.kind);
            s(time(decision.seconds));
            s(decision.text);
            if (Status status = base_->finish(s); !status.ok()) return status;
        }
        return {};
    });
}

Status StudyStore::addAnswers(std::int64_t run, std::span<const StudyAnswer> answers) {
    return base_->transaction([&]() -> Status {
        for (const StudyAnswer& answer : answers) {
            Statement& s = base_->statement(
                insertion("answers", "run, scheme, instrument, item, text, number"));
            s(run);
            s(answer.scheme);
            s(answer.instrument);
            s(answer.item);
            s(answer.text);
            s(answer.number);  // NaN becomes NULL.
            if (Status status = base_->finish(s); !status.ok()) return status;
        }
        return {};
    });
}

Status StudyStore::batch(const std::function<Status()>& work) {
    return base_->transaction(work);
}

Result<std::vector<StudyRun>> StudyStore::runs() {
    Statement& s = base_->statement(std::string("SELECT id, ") + kRunColumns + " FROM runs ORDER BY id");
    return base_->rows(s, readRun);
}

Result<std::vector<StudyTrial>> StudyStore::trials() {
    Statement& s = base_->statement(std::string("SELECT id, ") + kTrialColumns +
                                    " FROM trials ORDER BY run, id");
    return base_->rows(s, readTrial);
}

Result<std::vector<StudyTrial>> StudyStore::trials(std::int64_t run) {
    Statement& s = base_->statement(std::string("SELECT id, ") + kTrialColumns +
                                    " FROM trials WHERE run = ? ORDER BY id");
    s(run);
    return base_->rows(s, readTrial);
}

Result<std::vector<StampedInput>> StudyStore::inputs(std::int64_t trial) {
    Statement& s = base_->statement("SELECT bytes FROM inputs WHERE trial = ? ORDER BY id");
    s(trial);
    const auto chunks = base_->rows(s, [](Statement& row) {
        const std::span<const std::uint8_t> bytes = row.bytes();
        return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
    });
    if (!chunks.ok()) return chunks.status();
    std::vector<StampedInput> inputs;
    for (const std::vector<std::uint8_t>& chunk : *chunks) {
        const auto part = decodeInputs(chunk);
        if (!part.ok()) return part.status().within("inputs of trial " + std::to_string(trial));
        inputs.insert(inputs.end(), part->begin(), part->end());
    }
    return inputs;
}

Result<std::vector<StudyDecision>> StudyStore::decisions(std::int64_t trial) {
    Statement& s = base_->statement(
        "SELECT step, kind, seconds, text FROM decisions WHERE trial = ? ORDER BY id");
    s(trial);
    return base_->rows(s, [](Statement& row) {
        StudyDecision decision;
        decision.step = static_cast<std::uint32_t>(row.whole());
        decision.kind = row.text();
        decision.seconds = row.real();
        decision.text = row.text();
        return decision;
    });
}

Result<std::vector<StudyAnswer>> StudyStore::answers(std::int64_t run) {
    Statement& s = base_->statement(
        "SELECT scheme, instrument, item, text, number FROM answers WHERE run = ? ORDER BY id");
    s(run);
    return base_->rows(s, [](Statement& row) {
        StudyAnswer answer;
        answer.scheme = row.text();
        answer.instrument = row.text();
        answer.item = row.text();
        answer.text = row.text();
        answer.number = row.real();
        return answer;
    });
}

Result<bool> StudyStore::hasTrial(const TrialKey& key) {
    Statement& s = base_->statement(
        "SELECT count(*) FROM trials JOIN runs ON runs.id = trials.run WHERE environment = ? AND scheme = ?"
        " AND crowd = ? AND seed = ? AND setting = ? AND mirrored = ? AND kind = ? AND environments = ?"
        " AND operators = ? AND trials.state = ?");
    s(key.def.environment);
    s(key.def.scheme);
    s(std::int64_t{key.def.crowd});
    s(whole(key.def.seed));
    s(key.setting);
    s(std::int64_t{key.def.mirrored});
    s(static_cast<std::int64_t>(key.kind));
    s(std::int64_t{key.environments});
    s(std::int64_t{key.operators});
    s(static_cast<std::int64_t>(RunState::Complete));
    const auto counts = base_->rows(s, [](Statement& row) { return row.whole(); });
    if (!counts.ok()) return counts.status();
    return counts->front() > 0;
}
#else
namespace {

Status missing() {
    return {StatusCode::Unsupported, "this build of Muster has no SQLite, which the study's database needs"};
}

}  // namespace

class StudyStore::Base {};

Result<StudyStore> StudyStore::open(const std::string& path, StoreMode mode) {
    (void)path;
    (void)mode;
    return missing();
}
Result<std::int64_t> StudyStore::addRun(const StudyRun&) {
    return missing();
}
Status StudyStore::updateRun(const StudyRun&) {
    return missing();
}
Result<std::int64_t> StudyStore::addTrial(const StudyTrial&) {
    return missing();
}
Status StudyStore::updateTrial(const StudyTrial&) {
    return missing();
}
Status StudyStore::addInputs(std::int64_t, std::span<const StampedInput>) {
    return missing();
}
Status StudyStore::addDecisions(std::int64_t, std::span<const StudyDecision>) {
    return missing();
}
Status StudyStore::addAnswers(std::int64_t, std::span<const StudyAnswer>) {
    return missing();
}
Status StudyStore::batch(const std::function<Status()>&) {
    return missing();
}
Result<std::vector<StudyRun>> StudyStore::runs() {
    return missing();
}
Result<std::vector<StudyTrial>> StudyStore::trials() {
    return missing();
}
Result<std::vector<StudyTrial>> StudyStore::trials(std::int64_t) {
    return missing();
}
Result<std::vector<StampedInput>> StudyStore::inputs(std::int64_t) {
    return missing();
}
Result<std::vector<StudyDecision>> StudyStore::decisions(std::int64_t) {
    return missing();
}
Result<std::vector<StudyAnswer>> StudyStore::answers(std::int64_t) {
    return missing();
}
Result<bool> StudyStore::hasTrial(const TrialKey&) {
    return missing();
}
#endif

StudyStore::StudyStore(std::unique_ptr<Base> base) : base_(std::move(base)) {}
StudyStore::StudyStore(StudyStore&&) noexcept = default;
StudyStore& StudyStore::operator=(StudyStore&&) noexcept = default;
StudyStore::~StudyStore() = default;

}  // namespace muster
