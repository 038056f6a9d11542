#include "studio/study/store/database.h"

#if MUSTER_SQLITE
#include <limits>

namespace muster::sqlite {

int Statement::step() {
    column_ = 0;
    if (statement_ == nullptr) return SQLITE_ERROR;
    return code_ == SQLITE_OK ? sqlite3_step(statement_) : code_;
}

void Statement::reset() {
    if (statement_ != nullptr) sqlite3_reset(statement_);
    place_ = 0;
    column_ = 0;
    code_ = SQLITE_OK;
}

double Statement::real() {
    const int column = column_++;
    if (sqlite3_column_type(statement_, column) == SQLITE_NULL)
        return std::numeric_limits<double>::quiet_NaN();
    return sqlite3_column_double(statement_, column);
}

std::string Statement::text() {
    const int column = column_++;
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    return text == nullptr
               ? std::string()
               : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)));
}

std::span<const std::uint8_t> Statement::bytes() {
    const int column = column_++;
    const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_, column));
    if (data == nullptr) return {};
    return {data, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

Status Database::open(const std::string& path, bool create) {
    path_ = path;
    sqlite3* base = nullptr;
    const int flags = SQLITE_OPEN_READWRITE | (create ? SQLITE_OPEN_CREATE : 0);
    const int code = sqlite3_open_v2(path.c_str(), &base, flags, nullptr);
    base_.reset(base);
    if (code != SQLITE_OK) return failed();
    sqlite3_busy_timeout(base, 10000);
    return {};
}

Status Database::execute(const char* text) {
    return sqlite3_exec(base_.get(), text, nullptr, nullptr, nullptr) == SQLITE_OK ? Status() : failed();
}

Statement& Database::statement(const std::string& text) {
    std::unique_ptr<Statement>& kept = statements_[text];
    if (!kept) kept = std::make_unique<Statement>(base_.get(), text);
    kept->reset();
    return *kept;
}

Status Database::finish(Statement& statement) {
    const int code = statement.step();
    const Status status = code == SQLITE_DONE ? Status() : failed();
    statement.reset();
    return status;
}

Result<std::int64_t> Database::number(const char* text) {
    Statement query(base_.get(), text);
    if (query.step() != SQLITE_ROW) return failed();
    return query.whole();
}

Status Database::failed() const {
    const int code = base_ ? sqlite3_errcode(base_.get()) : SQLITE_NOMEM;
    const std::string file = "the database '" + path_ + "' ";
    if (code == SQLITE_NOTADB) return {StatusCode::ParseError, file + "is not a database of the study"};
    if (code == SQLITE_CORRUPT) return {StatusCode::Corrupt, file + "is damaged"};
    if (code == SQLITE_CANTOPEN) return {StatusCode::IoError, file + "cannot be opened"};
    const char* reason = base_ ? sqlite3_errmsg(base_.get()) : "out of memory";
    return {StatusCode::IoError, file + "cannot be used: " + reason};
}

}  // namespace muster::sqlite
#endif
