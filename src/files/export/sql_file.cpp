#include "files/export/sql_file.h"

#include <utility>

#if defined(__EMSCRIPTEN__)
#include <emscripten.h>
#elif MUSTER_SQLITE
#include <sqlite3.h>

#include <map>
#endif

namespace muster {

#if defined(__EMSCRIPTEN__)

namespace {

// The page's SQLite (sql.js) is a module of its own. What it says of a failure is kept in `said`.
// clang-format off
EM_JS(int, musterSqlOpen, (), { return Module["sql"] ? Module["sql"]["open"]() : 0; });
EM_JS(int, musterSqlExecute, (const char* text), { return Module["sql"]["execute"](UTF8ToString(text)); });
EM_JS(void, musterSqlNumber, (double value), { Module["sql"]["bind"](value); });
EM_JS(void, musterSqlText, (const char* value), { Module["sql"]["bind"](UTF8ToString(value)); });
EM_JS(int, musterSqlRun, (const char* text), { return Module["sql"]["run"](UTF8ToString(text)); });
EM_JS(int, musterSqlClose, (const char* path), {
    const bytes = Module["sql"]["close"]();
    if (bytes) FS.writeFile(UTF8ToString(path), bytes);
    return bytes ? 1 : 0;
});
EM_JS(void, musterSqlTrouble, (char* into, int size), { stringToUTF8(Module["sql"]["trouble"], into, size); });
// clang-format on

class BrowserSqlFile : public SqlFile {
public:
    explicit BrowserSqlFile(std::string path) : path_(std::move(path)) {}

    bool execute(const char* statements) override { return musterSqlExecute(statements) != 0; }
    bool insert(const char* statement, std::span<const SqlValue> values) override {
        for (const SqlValue& value : values) {
            // JavaScript's numbers do not hold all integers; SQLite takes them from texts.
            if (const auto* real = std::get_if<double>(&value))
                musterSqlNumber(*real);
            else if (const auto* whole = std::get_if<std::int64_t>(&value))
                musterSqlText(std::to_string(*whole).c_str());
            else
                musterSqlText(std::get<std::string>(value).c_str());
        }
        return musterSqlRun(statement) != 0;
    }
    bool close() override { return musterSqlClose(path_.c_str()) != 0; }
    std::string trouble() const override {
        char words[400] = "";
        musterSqlTrouble(words, sizeof(words));
        return words;
    }

private:
    std::string path_;
};

}  // namespace

std::unique_ptr<SqlFile> SqlFile::create(const std::string& path) {
    return musterSqlOpen() != 0 ? std::make_unique<BrowserSqlFile>(path) : nullptr;
}

#elif MUSTER_SQLITE

namespace {

class LibrarySqlFile : public SqlFile {
public:
    explicit LibrarySqlFile(const std::string& path) { sqlite3_open(path.c_str(), &base_); }
    ~LibrarySqlFile() override { close(); }
    LibrarySqlFile(const LibrarySqlFile&) = delete;
    LibrarySqlFile& operator=(const LibrarySqlFile&) = delete;

    bool execute(const char* statements) override {
        return sqlite3_exec(base_, statements, nullptr, nullptr, nullptr) == SQLITE_OK;
    }
    bool insert(const char* statement, std::span<const SqlValue> values) override {
        sqlite3_stmt*& prepared = prepared_[statement];
        if (!prepared && sqlite3_prepare_v2(base_, statement, -1, &prepared, nullptr) != SQLITE_OK)
            return false;
        int column = 0;
        bool good = true;
        for (const SqlValue& value : values) good = bind(prepared, ++column, value) == SQLITE_OK && good;
        good = good && sqlite3_step(prepared) == SQLITE_DONE;
        sqlite3_reset(prepared);
        return good;
    }
    bool close() override {
        for (const auto& [text, prepared] : prepared_) sqlite3_finalize(prepared);
        prepared_.clear();
        // One that cannot be closed stays, to say why.
        if (sqlite3_close(base_) != SQLITE_OK) return false;
        base_ = nullptr;
        return true;
    }
    std::string trouble() const override { return sqlite3_errmsg(base_); }

private:
    static int bind(sqlite3_stmt* prepared, int column, const SqlValue& value) {
        if (const auto* whole = std::get_if<std::int64_t>(&value))
            return sqlite3_bind_int64(prepared, column, *whole);
        if (const auto* real = std::get_if<double>(&value))
            return sqlite3_bind_double(prepared, column, *real);
        return sqlite3_bind_text(prepared, column, std::get<std::string>(value).c_str(), -1,
                                 SQLITE_TRANSIENT);
    }

    sqlite3* base_ = nullptr;
    std::map<const char*, sqlite3_stmt*> prepared_;
};

}  // namespace

std::unique_ptr<SqlFile> SqlFile::create(const std::string& path) {
    return std::make_unique<LibrarySqlFile>(path);
}

#else

std::unique_ptr<SqlFile> SqlFile::create(const std::string&) {
    return nullptr;
}

#endif

}  // namespace muster
