// The structural tables of binary USD files (crate files), and how their numbers are packed.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/output_file.h"

namespace muster {

/// Bytes in the form of USD's fast compression: LZ4, here as literals only.
std::string crateBytes(std::string_view bytes);
/// Whole numbers as differences with two bits of length each, in that form.
std::string crateNumbers(std::span<const std::uint32_t> numbers);
void crateWord(std::uint64_t value, int bytes, std::string& out);  ///< Least significant byte first.
void crateReal(double value, std::string& out);                    ///< With all its 8 bytes.

/// A value of a field: its type, and it itself or where it lies in the file.
using CrateValue = std::uint64_t;
CrateValue crateInline(std::uint8_t type, std::uint32_t value);
CrateValue crateStored(std::uint8_t type, std::uint64_t offset, bool array);

/// What a path leads to; numbers as in the format.
enum class CrateSpec : std::uint32_t { Attribute = 1, Prim = 6, Root = 7, Relationship = 8 };

/// Collects words, paths, fields and what is at each path.
class CrateTables {
public:
    CrateTables();

    std::uint32_t word(const std::string& text);    ///< Number of a token.
    std::uint32_t string(const std::string& text);  ///< Number of a string.
    /// Adds a path below an earlier one; what lies below a path must follow it at once. Its number.
    std::uint32_t path(std::uint32_t parent, const std::string& element, bool property);
    std::uint32_t find(const std::string& path) const;  ///< Number of a path that was added.
    /// Says what is at a path.
    void spec(std::uint32_t path, CrateSpec kind,
              const std::vector<std::pair<std::string, CrateValue>>& fields);

    /// Appends all tables, and the list of them, whose offset is returned.
    Result<std::uint64_t> write(OutputFile& file) const;

private:
    struct Path {
        std::uint32_t parent = 0;
        std::uint32_t word = 0;
        bool property = false;
    };
    std::string wordTable() const;
    std::string stringTable() const;
    std::string fieldTable() const;
    std::string fieldSetTable() const;
    std::string pathTable() const;
    std::string specTable() const;
    std::vector<std::uint32_t> jumps() const;

    std::vector<std::string> words_;
    std::map<std::string, std::uint32_t> wordNumbers_;
    std::vector<std::uint32_t> strings_;
    std::vector<Path> paths_;
    std::map<std::string, std::uint32_t> pathNumbers_;
    std::vector<std::string> pathTexts_;
    std::vector<std::uint32_t> fieldWords_;
    std::vector<CrateValue> fieldValues_;
    std::map<std::pair<std::uint32_t, CrateValue>, std::uint32_t> fieldNumbers_;
    std::vector<std::uint32_t> fieldSets_;
    std::vector<std::uint32_t> specPaths_, specSets_, specKinds_;
};

}  // namespace muster
