// An SQLite file that is being written.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>

namespace muster {

/// A value of a row: INTEGER, REAL or TEXT.
using SqlValue = std::variant<std::int64_t, double, std::string>;

/// A new SQLite file, written by one thread: by SQLite's library, or in browsers by what
/// the module was given as `sql` (bindings/javascript/src/sql_files.ts).
class SqlFile {
public:
    /// Begins a file; nullptr where this build has no SQLite. A file that cannot be opened fails at the first
    /// statement.
    static std::unique_ptr<SqlFile> create(const std::string& path);
    virtual ~SqlFile() = default;

    /// Executes statements without values; false where one failed.
    virtual bool execute(const char* statements) = 0;
    /// Executes a statement with a value for each "?"; false where it failed. Statements are prepared once
    /// and told apart by their addresses, as literals are.
    virtual bool insert(const char* statement, std::span<const SqlValue> values) = 0;
    /// Ends the file; false where it could not be written to its end. Nothing else may be called afterwards.
    virtual bool close() = 0;
    /// What went wrong last, in SQLite's words.
    virtual std::string trouble() const = 0;
};

}  // namespace muster
