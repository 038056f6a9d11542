// A connection to SQLite with statements that are kept.
#pragma once

#if MUSTER_SQLITE
#include <sqlite3.h>

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "muster/status.h"

namespace muster::sqlite {

/// A prepared statement. Values are bound from the left, columns are read from the left.
class Statement {
public:
    Statement(sqlite3* base, const std::string& text) {
        sqlite3_prepare_v2(base, text.c_str(), -1, &statement_, nullptr);
    }
    ~Statement() { sqlite3_finalize(statement_); }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    void operator()(std::int64_t value) { note(sqlite3_bind_int64(statement_, ++place_, value)); }
    void operator()(double value) { note(sqlite3_bind_double(statement_, ++place_, value)); }
    void operator()(const std::string& value) {
        note(sqlite3_bind_text(statement_, ++place_, value.data(), static_cast<int>(value.size()),
                               SQLITE_TRANSIENT));
    }
    void operator()(std::span<const std::uint8_t> bytes) {
        note(sqlite3_bind_blob64(statement_, ++place_, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
    }

    /// Makes a step: SQLITE_ROW, SQLITE_DONE or an error.
    int step();
    /// Makes it ready for other values.
    void reset();

    std::int64_t whole() { return sqlite3_column_int64(statement_, column_++); }  ///< The next column.
    double real();                          ///< The next column; NaN where it is NULL.
    std::string text();                     ///< The next column.
    std::span<const std::uint8_t> bytes();  ///< The next column, until the next step.

private:
    void note(int code) {
        if (code != SQLITE_OK && code_ == SQLITE_OK) code_ = code;
    }
    sqlite3_stmt* statement_ = nullptr;
    int place_ = 0;
    int column_ = 0;
    int code_ = SQLITE_OK;
};

struct Close {
    void operator()(sqlite3* base) const { sqlite3_close(base); }
};

/// A connection.
class Database {
public:
    /// Opens the file, made where `create` says so and it is missing.
    Status open(const std::string& path, bool create);
    /// Executes statements without values or rows.
    Status execute(const char* text);
    /// The statement of that text, ready for values.
    Statement& statement(const std::string& text);
    /// Runs a statement that gives no rows.
    Status finish(Statement& statement);
    /// The first number that a query without values gives.
    Result<std::int64_t> number(const char* text);
    /// What went wrong last, in one sentence that names the file.
    Status failed() const;

    std::int64_t lastId() const {
        return sqlite3_last_insert_rowid(base_.get());
    }                                                             ///< Of the last row added.
    int changes() const { return sqlite3_changes(base_.get()); }  ///< Rows changed by the last statement.
    const std::string& path() const { return path_; }             ///< The file.

private:
    std::string path_;
    std::unique_ptr<sqlite3, Close> base_;
    std::map<std::string, std::unique_ptr<Statement>> statements_;
};

}  // namespace muster::sqlite
#endif
