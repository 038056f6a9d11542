#include "zip_file.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "base/hash.h"
#include "base/output_file.h"
#include "base/text_file.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 65'000;
constexpr std::uint64_t kMostBytes = 0xff000000;  // Offsets have 32 bits.
constexpr std::size_t kMostOfOne = 0x7f000000;    // [bytes]
constexpr std::uint16_t kVersion = 20;            // Of the format: 2.0.
constexpr std::uint16_t kNamesAreUtf8 = 0x0800;
constexpr std::uint32_t kFirstDay = 0x00210000;  // 1980-01-01 00:00, as DOS has it.

/// A file in the archive.
struct Entry {
    std::string name;
    std::uint32_t crc = 0;
    std::uint32_t bytes = 0;
    std::uint32_t offset = 0;
};

class Bytes {
public:
    Bytes& half(std::uint16_t value) { return put(value, 2); }
    Bytes& word(std::uint32_t value) { return put(value, 4); }
    Bytes& text(const std::string& value) {
        text_ += value;
        return *this;
    }
    const std::string& str() const { return text_; }

private:
    Bytes& put(std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i) text_ += static_cast<char>(value >> (8 * i) & 255u);
        return *this;
    }
    std::string text_;
};

// The fields that both headers of a file have.
void common(Bytes& out, const Entry& entry) {
    out.half(kVersion).half(kNamesAreUtf8).half(0).word(kFirstDay);
    out.word(entry.crc).word(entry.bytes).word(entry.bytes);
    out.half(static_cast<std::uint16_t>(entry.name.size())).half(0);
}

Status tooLarge(const std::string& path) {
    return {StatusCode::LimitExceeded, path + ": an archive holds at most 65,000 files and 4 GB"};
}

Status add(OutputFile& out, const fs::path& file, std::vector<Entry>& entries) {
    const auto text = readTextFile(file.string(), kMostOfOne);
    if (!text.ok()) return text.status();
    if (out.size() + text->size() > kMostBytes) return tooLarge(file.string());
    Entry entry{.name = file.filename().string(),
                .crc = crc32({reinterpret_cast<const std::uint8_t*>(text->data()), text->size()}),
                .bytes = static_cast<std::uint32_t>(text->size()),
                .offset = static_cast<std::uint32_t>(out.size())};
    Bytes head;
    head.word(0x04034b50);
    common(head, entry);
    head.text(entry.name);
    entries.push_back(entry);
    if (Status s = out.write(head.str()); !s.ok()) return s;
    return out.write(*text);
}

Status close(OutputFile& out, const std::vector<Entry>& entries) {
    const auto begin = static_cast<std::uint32_t>(out.size());
    Bytes end;
    for (const Entry& entry : entries) {
        end.word(0x02014b50).half(kVersion);
        common(end, entry);
        end.half(0).half(0).half(0).word(0).word(entry.offset).text(entry.name);
    }
    const auto size = static_cast<std::uint32_t>(end.str().size());
    const auto count = static_cast<std::uint16_t>(entries.size());
    end.word(0x06054b50).half(0).half(0).half(count).half(count).word(size).word(begin).half(0);
    if (Status s = out.write(end.str()); !s.ok()) return s;
    return out.commit();
}

}  // namespace

Status zipFolder(const std::string& folder, const std::string& path) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (entry.is_regular_file(error)) files.push_back(entry.path());
    if (error) return {StatusCode::IoError, folder + ": cannot be read: " + error.message()};
    if (files.size() > kMostFiles) return tooLarge(folder);
    std::sort(files.begin(), files.end());
    OutputFile out;
    if (Status s = out.open(path); !s.ok()) return s;
    std::vector<Entry> entries;
    for (const fs::path& file : files)
        if (Status s = add(out, file, entries); !s.ok()) return s;
    return close(out, entries);
}

}  // namespace muster
