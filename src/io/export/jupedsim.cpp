#include "io/export/jupedsim.h"

#if MUSTER_SQLITE
#include <sqlite3.h>

#include <cstdio>
#include <utility>

#include "base/hash.h"
#include "base/maths.h"
#include "base/output_file.h"
#include "environment/environment.h"
#include "world/inspect.h"
#endif

namespace muster {
namespace {

#if MUSTER_SQLITE
constexpr const char* kTables =
    "CREATE TABLE trajectory_data(frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL, pos_y "
    "REAL NOT NULL,"
    " ori_x REAL NOT NULL, ori_y REAL NOT NULL);"
    "CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);"
    "CREATE TABLE geometry(hash INTEGER NOT NULL UNIQUE PRIMARY KEY, wkt TEXT NOT NULL);"
    "CREATE TABLE frame_data(frame INTEGER NOT NULL UNIQUE PRIMARY KEY, geometry_hash INTEGER NOT NULL);";

/// A prepared SQL statement; values are bound from the left.
class Statement {
public:
    Statement(sqlite3* base, const char* text) { sqlite3_prepare_v2(base, text, -1, &statement_, nullptr); }
    ~Statement() { sqlite3_finalize(statement_); }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    Statement& with(std::int64_t value) { return bound(sqlite3_bind_int64(statement_, ++column_, value)); }
    Statement& with(double value) { return bound(sqlite3_bind_double(statement_, ++column_, value)); }
    Statement& with(const std::string& value) {
        return bound(sqlite3_bind_text(statement_, ++column_, value.c_str(), -1, SQLITE_TRANSIENT));
    }
    /// Executes the statement; returns false where it failed.
    bool run() {
        good_ = good_ && sqlite3_step(statement_) == SQLITE_DONE;
        sqlite3_reset(statement_);
        column_ = 0;
        return std::exchange(good_, true);
    }

private:
    Statement& bound(int code) {
        good_ = good_ && code == SQLITE_OK;
        return *this;
    }
    sqlite3_stmt* statement_ = nullptr;
    int column_ = 0;
    bool good_ = true;
};

struct CloseBase {
    void operator()(sqlite3* base) const { sqlite3_close(base); }
};

class JupedsimExporter : public Exporter {
public:
    explicit JupedsimExporter(std::string path) : path_(std::move(path)) {}

    bool wantsPoses() const override { return false; }

    Status begin(const ExportInfo& info) override {
        // SQLite opens the file by name; the output file only reserves the path and removes an unfinished
        // file.
        if (Status s = file_.open(path_); !s.ok()) return s;
        sqlite3* base = nullptr;
        const int opened = sqlite3_open(file_.partPath().c_str(), &base);
        base_.reset(base);
        if (opened != SQLITE_OK) return failed();
        if (!execute("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; BEGIN;") || !execute(kTables))
            return failed();
        box_ = inspect::environment(*info.world).def().box;
        addFrame_ = std::make_unique<Statement>(base, "INSERT INTO frame_data VALUES(?, ?)");
        addCharacter_ = std::make_unique<Statement>(base,
                                                    "INSERT INTO trajectory_data VALUES(?, ?, ?, ?, ?, ?)");
        return metadata("version", "2") && metadata("fps", numberText(info.fps)) ? Status() : failed();
    }

    Status frame(const ExportFrame& frame) override {
        const auto number = static_cast<std::int64_t>(frame.index);
        std::int64_t area = 0;
        if (!addArea(inspect::environment(*frame.world), area) || !addFrame_->with(number).with(area).run())
            return failed();
        for (const ExportCharacter& c : frame.characters) {
            const double yaw = c.yaw;
            addCharacter_->with(number)
                .with(static_cast<std::int64_t>(c.id))
                .with(c.position.x)
                .with(c.position.y);
            if (!addCharacter_->with(cosine(yaw)).with(sine(yaw)).run()) return failed();
        }
        return {};
    }

    Status finish() override {
        const bool good = metadata("xmin", numberText(box_.min.x)) &&
                          metadata("xmax", numberText(box_.max.x)) &&
                          metadata("ymin", numberText(box_.min.y)) &&
                          metadata("ymax", numberText(box_.max.y)) &&
                          execute("CREATE INDEX frame_id_idx ON trajectory_data(frame, id); COMMIT;");
        if (!good) return failed();
        addFrame_.reset();
        addCharacter_.reset();
        if (sqlite3_close(base_.get()) != SQLITE_OK) return failed();
        base_.release();
        return file_.commit();
    }

private:
    static std::string numberText(double value) {
        char text[40];
        std::snprintf(text, sizeof(text), "%.9g", value);
        return text;
    }
    bool execute(const char* text) {
        return sqlite3_exec(base_.get(), text, nullptr, nullptr, nullptr) == SQLITE_OK;
    }
    bool metadata(const char* key, const std::string& value) {
        return Statement(base_.get(), "INSERT INTO metadata VALUES(?, ?)")
            .with(std::string(key))
            .with(value)
            .run();
    }
    Status failed() const {
        return {StatusCode::IoError, path_ + ": cannot be written: " + sqlite3_errmsg(base_.get())};
    }

    /// The number of the present walkable area; writes the area where it is new.
    bool addArea(const Environment& environment, std::int64_t& area) {
        if (area_ == 0 || version_ != environment.staticVersion()) {
            version_ = environment.staticVersion();
            const std::string text = walkableArea(environment);
            Hash hash;
            hash.add(text);
            // Positive, so that every reader accepts it.
            area_ = static_cast<std::int64_t>(hash.value() >> 1) | 1;
            Statement add(base_.get(), "INSERT OR IGNORE INTO geometry VALUES(?, ?)");
            if (!add.with(area_).with(text).run()) return false;
        }
        area = area_;
        return true;
    }

    std::string path_;
    OutputFile file_;
    std::unique_ptr<sqlite3, CloseBase> base_;
    std::unique_ptr<Statement> addFrame_, addCharacter_;
    Box box_;
    std::uint64_t version_ = 0;
    std::int64_t area_ = 0;
};
#else
class JupedsimExporter : public Exporter {
public:
    explicit JupedsimExporter(std::string) {}
    Status begin(const ExportInfo&) override {
        return {StatusCode::Unsupported, "the format jupedsim needs SQLite, and this build has none"};
    }
    Status frame(const ExportFrame&) override { return {}; }
    Status finish() override { return {}; }
};
#endif

}  // namespace

std::unique_ptr<Exporter> makeJupedsimExporter(const std::string& path) {
    return std::make_unique<JupedsimExporter>(path);
}

}  // namespace muster
