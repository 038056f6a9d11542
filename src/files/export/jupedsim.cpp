#include "files/export/formats.h"

#include <array>
#include <cstdio>
#include <utility>

#include "base/hash.h"
#include "base/maths.h"
#include "base/output_file.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/export/person_facts.h"
#include "files/export/sql_file.h"

namespace muster {
namespace {

constexpr const char* kTables =
    "CREATE TABLE trajectory_data(frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL, pos_y "
    "REAL NOT NULL,"
    " ori_x REAL NOT NULL, ori_y REAL NOT NULL);"
    "CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);"
    "CREATE TABLE geometry(hash INTEGER NOT NULL UNIQUE PRIMARY KEY, wkt TEXT NOT NULL);"
    "CREATE TABLE frame_data(frame INTEGER NOT NULL UNIQUE PRIMARY KEY, geometry_hash INTEGER NOT NULL);"
    // Of Muster alone: JuPedSim and PedPy do not look at it.
    "CREATE TABLE muster_data(frame INTEGER NOT NULL, id INTEGER NOT NULL, group_id INTEGER NOT NULL, "
    "heading "
    "REAL NOT NULL, motion INTEGER NOT NULL, goal INTEGER NOT NULL);";
constexpr const char* kAddFrame = "INSERT INTO frame_data VALUES(?, ?)";
constexpr const char* kAddCharacter = "INSERT INTO trajectory_data VALUES(?, ?, ?, ?, ?, ?)";
constexpr const char* kAddFacts = "INSERT INTO muster_data VALUES(?, ?, ?, ?, ?, ?)";
constexpr const char* kAddMetadata = "INSERT INTO metadata VALUES(?, ?)";
constexpr const char* kAddArea = "INSERT OR IGNORE INTO geometry VALUES(?, ?)";

class JupedsimExporter : public Exporter {
public:
    explicit JupedsimExporter(std::string path) : path_(std::move(path)) {}

    bool wantsPoses() const override { return false; }

    Status begin(const ExportInfo& info) override {
        // SQLite opens the file by name; the output file only reserves the path and removes an unfinished
        // file.
        if (Status s = file_.open(path_); !s.ok()) return s;
        base_ = SqlFile::create(file_.partPath());
        if (!base_)
            return {StatusCode::Unsupported, "the format jupedsim needs SQLite, and this build has none"};
        if (!base_->execute("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; BEGIN;") ||
            !base_->execute(kTables))
            return failed();
        box_ = inspect::environment(*info.world).def().box;
        return metadata("version", "2") && metadata("fps", numberText(info.fps)) ? Status() : failed();
    }

    Status frame(const ExportFrame& frame) override {
        const auto number = static_cast<std::int64_t>(frame.index);
        std::int64_t area = 0;
        if (!addArea(inspect::environment(*frame.world), area) || !insert(kAddFrame, number, area))
            return failed();
        PersonFactsReader reader(frame);
        for (const ExportCharacter& c : frame.characters) {
            const double yaw = c.yaw;
            const auto id = static_cast<std::int64_t>(c.id);
            const PersonFacts facts = reader.of(c.id);
            if (!insert(kAddCharacter, number, id, c.position.x, c.position.y, cosine(yaw), sine(yaw)) ||
                !insert(kAddFacts, number, id, std::int64_t{facts.group}, yaw, std::int64_t{facts.motion},
                        std::int64_t{facts.goal}))
                return failed();
        }
        return {};
    }

    Status finish() override {
        const bool good = metadata("xmin", numberText(box_.min.x)) &&
                          metadata("xmax", numberText(box_.max.x)) &&
                          metadata("ymin", numberText(box_.min.y)) &&
                          metadata("ymax", numberText(box_.max.y)) &&
                          base_->execute("CREATE INDEX frame_id_idx ON trajectory_data(frame, id); COMMIT;");
        if (!good || !base_->close()) return failed();
        base_.reset();
        return file_.commit();
    }

private:
    static std::string numberText(double value) {
        char text[40];
        std::snprintf(text, sizeof(text), "%.9g", value);
        return text;
    }
    template <typename... Values>
    bool insert(const char* statement, const Values&... values) {
        return base_->insert(statement, std::array{SqlValue(values)...});
    }
    bool metadata(const char* key, const std::string& value) {
        return insert(kAddMetadata, std::string(key), value);
    }
    Status failed() const {
        return {StatusCode::IoError, path_ + ": cannot be written: " + base_->trouble()};
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
            if (!insert(kAddArea, area_, text)) return false;
        }
        area = area_;
        return true;
    }

    std::string path_;
    OutputFile file_;
    std::unique_ptr<SqlFile> base_;
    Box box_;
    std::uint64_t version_ = 0;
    std::int64_t area_ = 0;
};

}  // namespace

std::unique_ptr<Exporter> makeJupedsimExporter(const std::string& path) {
    return std::make_unique<JupedsimExporter>(path);
}

}  // namespace muster
