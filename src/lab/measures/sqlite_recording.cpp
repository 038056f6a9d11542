#include "lab/measures/sqlite_recording.h"

#include <cstdlib>
#include <fstream>
#include <memory>
#include <string_view>

#if MUSTER_SQLITE && !defined(__EMSCRIPTEN__)
#include <sqlite3.h>
#endif

namespace muster {

bool isSqliteFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    char head[16] = "";
    file.read(head, sizeof(head));
    return std::string_view(head, sizeof(head)) == std::string_view("SQLite format 3\0", 16);
}

#if MUSTER_SQLITE && !defined(__EMSCRIPTEN__)

namespace {

struct CloseBase {
    void operator()(sqlite3* base) const { sqlite3_close(base); }
};
using Base = std::unique_ptr<sqlite3, CloseBase>;

/// Calls `each(row)` for the rows of a query; false where it fails.
template <class Each>
bool forRows(sqlite3* base, const char* query, const Each& each) {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(base, query, -1, &statement, nullptr) != SQLITE_OK) return false;
    int code = SQLITE_ROW;
    while ((code = sqlite3_step(statement)) == SQLITE_ROW) each(statement);
    sqlite3_finalize(statement);
    return code == SQLITE_DONE;
}

std::string textOf(sqlite3_stmt* row, int column) {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
    return text != nullptr ? text : "";
}

Status missing(const char* what) {
    return {StatusCode::ParseError, std::string("found no ") + what + ", expected a file of JuPedSim"};
}

}  // namespace

Result<Recording> readSqliteRecording(const std::string& path) {
    sqlite3* opened = nullptr;
    const int code = sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
    const Base base(opened);
    if (code != SQLITE_OK) return Status(StatusCode::IoError, "cannot be read");
    std::vector<Sighting> all;
    if (!forRows(opened, "SELECT frame, id, pos_x, pos_y FROM trajectory_data", [&](sqlite3_stmt* row) {
            all.push_back({sqlite3_column_int(row, 0),
                           static_cast<std::uint32_t>(sqlite3_column_int64(row, 1)),
                           {sqlite3_column_double(row, 2), sqlite3_column_double(row, 3)}});
        }))
        return missing("table trajectory_data");
    double rate = 0.0;
    forRows(opened, "SELECT value FROM metadata WHERE key = 'fps'",
            [&](sqlite3_stmt* row) { rate = std::atof(textOf(row, 0).c_str()); });
    if (rate <= 0.0) return missing("frame rate");
    auto made = Trajectories::create(rate, std::move(all));
    if (!made.ok()) return made.status();
    Recording recording{std::move(made).value(), {}};
    std::vector<std::string> grounds;
    forRows(opened, "SELECT wkt FROM geometry",
            [&](sqlite3_stmt* row) { grounds.push_back(textOf(row, 0)); });
    if (grounds.size() == 1) {
        auto ground = Region::parse(grounds[0]);
        if (!ground.ok()) return ground.status();
        recording.walkable = std::move(ground).value();
    }
    return recording;
}

#else

Result<Recording> readSqliteRecording(const std::string&) {
    return Status(StatusCode::Unsupported, "SQLite files need SQLite, and this build has none");
}

#endif

}  // namespace muster
