// Files that exist as a whole or not at all.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "muster/status.h"

namespace muster {

/// A file that is written beside its place, as PATH.part, and moved there by commit(); else removed. Never
/// overwrites before that.
class OutputFile {
public:
    OutputFile();  ///< A file that is not open.
    ~OutputFile();
    OutputFile(OutputFile&&) noexcept;             ///< Moves the file.
    OutputFile& operator=(OutputFile&&) noexcept;  ///< Moves the file; removes the one that was here.

    /// Begins to write. Fails with IoError, naming the path, where that cannot be or `path` is a folder.
    Status open(const std::string& path);
    /// Adds bytes. Fails with IoError where they cannot all be written.
    Status write(std::string_view bytes);
    /// Writes over bytes at `offset` from the front, then goes on at the end.
    Status rewrite(std::uint64_t offset, std::string_view bytes);
    /// Bytes written so far.
    std::uint64_t size() const { return size_; }
    /// The path to which it is written until commit(); for libraries that write by name.
    std::string partPath() const { return path_ + ".part"; }
    /// Closes it and puts it in its place. Fails with IoError.
    Status commit();

private:
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    Status failed() const;
    void remove();

    std::unique_ptr<std::FILE, CloseFile> file_;
    std::string path_;  ///< Empty where there is nothing to remove.
    std::uint64_t size_ = 0;
};

}  // namespace muster
