#include "files/export/crate_tables.h"

#include <algorithm>
#include <array>

#include "base/maths.h"

namespace muster {
namespace {

constexpr std::uint32_t kEndOfSet = 0xffffffffu;
constexpr std::int32_t kOnlyChild = -1, kLeaf = -2;  // What follows a path in the list.

std::string packed(std::span<const std::uint32_t> numbers) {
    std::string out;
    const std::string bytes = crateNumbers(numbers);
    crateWord(bytes.size(), 8, out);
    return out + bytes;
}

}  // namespace

void crateWord(std::uint64_t value, int bytes, std::string& out) {
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 255u);
}

void crateReal(double value, std::string& out) {
    crateWord(bitCast<std::uint64_t>(value), 8, out);
}

std::string crateBytes(std::string_view bytes) {
    std::string out(1, '\0');  // One block.
    if (bytes.size() < 15) {
        out += static_cast<char>(bytes.size() << 4);
    } else {
        out += static_cast<char>(0xf0);
        std::size_t left = bytes.size() - 15;
        for (; left >= 255; left -= 255) out += static_cast<char>(255);
        out += static_cast<char>(left);
    }
    return out.append(bytes);
}

std::string crateNumbers(std::span<const std::uint32_t> numbers) {
    std::vector<std::int32_t> steps;
    std::map<std::int32_t, std::size_t> counts;
    std::uint32_t before = 0;
    for (const std::uint32_t number : numbers) {
        steps.push_back(static_cast<std::int32_t>(number - before));
        ++counts[steps.back()];
        before = number;
    }
    if (steps.empty()) return crateBytes({});
    const std::int32_t common = std::max_element(counts.begin(), counts.end(), [](auto& a, auto& b) {
                                    return a.second < b.second;
                                })->first;
    std::string codes((steps.size() * 2 + 7) / 8, '\0'), values, out;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::int32_t step = steps[i];
        const int code = step == common                            ? 0
                         : step == static_cast<std::int8_t>(step)  ? 1
                         : step == static_cast<std::int16_t>(step) ? 2
                                                                   : 3;
        codes[i / 4] = static_cast<char>(codes[i / 4] | code << (2 * (i % 4)));
        constexpr std::array kBytes{0, 1, 2, 4};
        crateWord(static_cast<std::uint32_t>(step), kBytes[static_cast<std::size_t>(code)], values);
    }
    crateWord(static_cast<std::uint32_t>(common), 4, out);
    return crateBytes(out + codes + values);
}

CrateValue crateInline(std::uint8_t type, std::uint32_t value) {
    return std::uint64_t{1} << 62 | std::uint64_t{type} << 48 | value;
}

CrateValue crateStored(std::uint8_t type, std::uint64_t offset, bool array) {
    return (array ? std::uint64_t{1} << 63 : 0) | std::uint64_t{type} << 48 | offset;
}

CrateTables::CrateTables() {
    word("");  // A property's word is written as a negative number, so none has the number 0.
    paths_.push_back({});
    pathTexts_.push_back("");
    pathNumbers_["/"] = 0;
}

std::uint32_t CrateTables::word(const std::string& text) {
    const auto [found, fresh] = wordNumbers_.try_emplace(text, static_cast<std::uint32_t>(words_.size()));
    if (fresh) words_.push_back(text);
    return found->second;
}

std::uint32_t CrateTables::string(const std::string& text) {
    strings_.push_back(word(text));
    return static_cast<std::uint32_t>(strings_.size() - 1);
}

std::uint32_t CrateTables::path(std::uint32_t parent, const std::string& element, bool property) {
    const auto number = static_cast<std::uint32_t>(paths_.size());
    paths_.push_back({parent, word(element), property});
    pathTexts_.push_back(pathTexts_[parent] + (property ? "." : "/") + element);
    pathNumbers_[pathTexts_.back()] = number;
    return number;
}

std::uint32_t CrateTables::find(const std::string& path) const {
    const auto found = pathNumbers_.find(path);
    MUSTER_ASSERT(found != pathNumbers_.end());
    return found->second;
}

void CrateTables::spec(std::uint32_t path, CrateSpec kind,
                       const std::vector<std::pair<std::string, CrateValue>>& fields) {
    specPaths_.push_back(path);
    specSets_.push_back(static_cast<std::uint32_t>(fieldSets_.size()));
    specKinds_.push_back(static_cast<std::uint32_t>(kind));
    for (const auto& [name, value] : fields) {
        const std::uint32_t number = word(name);
        const auto [found, fresh] = fieldNumbers_.try_emplace({number, value},
                                                              static_cast<std::uint32_t>(fieldWords_.size()));
        if (fresh) fieldWords_.push_back(number), fieldValues_.push_back(value);
        fieldSets_.push_back(found->second);
    }
    fieldSets_.push_back(kEndOfSet);
}

std::string CrateTables::wordTable() const {
    std::string text, out;
    for (const std::string& word : words_) text.append(word.c_str(), word.size() + 1);
    const std::string bytes = crateBytes(text);
    crateWord(words_.size(), 8, out);
    crateWord(text.size(), 8, out);
    crateWord(bytes.size(), 8, out);
    return out + bytes;
}

std::string CrateTables::stringTable() const {
    std::string out;
    crateWord(strings_.size(), 8, out);
    for (const std::uint32_t number : strings_) crateWord(number, 4, out);
    return out;
}

std::string CrateTables::fieldTable() const {
    std::string values, out;
    for (const CrateValue value : fieldValues_) crateWord(value, 8, values);
    const std::string bytes = crateBytes(values);
    crateWord(fieldWords_.size(), 8, out);
    out += packed(fieldWords_);
    crateWord(bytes.size(), 8, out);
    return out + bytes;
}

std::string CrateTables::fieldSetTable() const {
    std::string out;
    crateWord(fieldSets_.size(), 8, out);
    return out + packed(fieldSets_);
}

/// Of each path: whether the next one lies below it, and how far on the next one beside it is.
std::vector<std::uint32_t> CrateTables::jumps() const {
    std::vector<std::int32_t> jumps(paths_.size(), kLeaf);
    std::vector<std::uint32_t> newest(paths_.size(), 0);  // Of the paths below each.
    for (std::uint32_t i = 1; i < paths_.size(); ++i) {
        const std::uint32_t parent = paths_[i].parent, before = newest[parent];
        newest[parent] = i;
        if (before == 0)
            jumps[parent] = kOnlyChild;
        else
            jumps[before] = newest[before] == 0 ? 0 : static_cast<std::int32_t>(i - before);
    }
    // A path with something below and something beside it has got the distance.
    return {jumps.begin(), jumps.end()};
}

std::string CrateTables::pathTable() const {
    std::vector<std::uint32_t> numbers, elements;
    for (std::uint32_t i = 0; i < paths_.size(); ++i) {
        numbers.push_back(i);
        elements.push_back(paths_[i].property ? 0u - paths_[i].word : paths_[i].word);
    }
    std::string out;
    for (int twice = 0; twice < 2; ++twice) crateWord(paths_.size(), 8, out);
    return out + packed(numbers) + packed(elements) + packed(jumps());
}

std::string CrateTables::specTable() const {
    std::string out;
    crateWord(specPaths_.size(), 8, out);
    return out + packed(specPaths_) + packed(specSets_) + packed(specKinds_);
}

Result<std::uint64_t> CrateTables::write(OutputFile& file) const {
    std::string list;
    const std::pair<const char*, std::string> tables[] = {
        {"TOKENS", wordTable()},        {"STRINGS", stringTable()}, {"FIELDS", fieldTable()},
        {"FIELDSETS", fieldSetTable()}, {"PATHS", pathTable()},     {"SPECS", specTable()}};
    crateWord(std::size(tables), 8, list);
    for (const auto& [name, bytes] : tables) {
        std::string title = name;
        title.resize(16, '\0');
        list += title;
        crateWord(file.size(), 8, list);
        crateWord(bytes.size(), 8, list);
        if (Status s = file.write(bytes); !s.ok()) return s;
    }
    const std::uint64_t offset = file.size();
    if (Status s = file.write(list); !s.ok()) return s;
    return offset;
}

}  // namespace muster
