#include "base/maths.h"
#include "files/export/crate_tables.h"
#include "files/export/usd_file.h"

namespace muster {
namespace {

constexpr std::size_t kHeadBytes = 88;
constexpr std::uint8_t kVersion[] = {0, 8, 0};

// Types that only fields have; numbers as in the format.
constexpr std::uint8_t kDouble = 9, kString = 10, kToken = 11, kTokenListOp = 32, kPathListOp = 34,
                       kReferenceListOp = 35, kTokenVector = 41, kSpecifier = 42, kVariability = 44,
                       kTimeSamples = 46, kDoubleVector = 48, kInt = 3;
constexpr char kExplicitItems = 1 | 2, kPrependedItems = 32;  // The head of a list of changes.

/// A number with 16 bits; what is below its smallest normal one becomes 0.
std::uint16_t halfOf(double value) {
    const auto bits = bitCast<std::uint32_t>(static_cast<float>(value));
    const auto exponent = static_cast<int>(bits >> 23 & 255u) - 112;
    const std::uint32_t sign = bits >> 16 & 0x8000u;
    const std::uint32_t rest = exponent <= 0
                                   ? 0
                                   : static_cast<std::uint32_t>(exponent) << 10 | (bits >> 13 & 1023u);
    return static_cast<std::uint16_t>(sign | rest);
}

void putNumber(const UsdType& type, double value, std::string& out) {
    if (type.bytes == 8)
        crateReal(value, out);
    else if (type.bytes == 2)
        crateWord(halfOf(value), 2, out);
    else if (type.code == kInt)
        crateWord(static_cast<std::uint32_t>(static_cast<std::int32_t>(value)), 4, out);
    else
        crateWord(bitCast<std::uint32_t>(static_cast<float>(value)), 4, out);
}

/// Numbers as the file has them: of rotations w comes last.
void putNumbers(const UsdType& type, std::span<const double> numbers, std::string& out) {
    if (type.numbers != 4) {
        for (const double value : numbers) putNumber(type, value, out);
        return;
    }
    for (std::size_t k = 0; k < numbers.size(); k += 4)
        for (const std::size_t i : {1u, 2u, 3u, 0u}) putNumber(type, numbers[k + i], out);
}

/// True where a value fits into its field.
bool isInline(const UsdType& type) {
    return type.numbers <= 1 && type.bytes == 4;
}

class UsdCrateFile final : public UsdFile {
public:
    Status open(const std::string& path, const UsdPace& pace) override {
        pace_ = pace;
        if (Status s = file_.open(path); !s.ok()) return s;
        if (Status s = file_.write(std::string(kHeadBytes, '\0')); !s.ok()) return s;
        world_ = tables_.path(0, "World", false);
        std::string times;
        crateWord(pace.frames, 8, times);
        for (std::size_t k = 0; k < pace.frames; ++k) crateReal(static_cast<double>(k), times);
        times_ = store(kDoubleVector, times, false);
        return status_;
    }

    Status add(const UsdPrim& prim) override {
        children_.push_back(prim.name);
        std::vector<std::uint32_t> paths;
        addPaths(prim, world_, paths);
        std::size_t next = 0;
        put(prim, paths, next);
        return status_;
    }

    std::size_t tracks() const override { return tracks_.size(); }

    Status sample(std::size_t track, std::span<const double> numbers) override {
        Track& one = tracks_[track];
        return one.samples.add(file_, record(*one.type, one.array, numbers));
    }

    Status words(std::size_t track, const UsdWords& words) override {
        std::string times, list;
        crateWord(words.size(), 8, times);
        crateWord(words.size(), 8, list);
        for (const auto& [frame, word] : words) {
            crateReal(static_cast<double>(frame), times);
            crateWord(crateInline(kToken, tables_.word(word)), 8, list);
        }
        std::string head = samplesHead(store(kDoubleVector, times, false));
        const CrateValue value = store(kTimeSamples, head + list, false);
        const Track& one = tracks_[track];
        attribute(one.path, one.fields, value);
        return status_;
    }

    Status finish() override {
        for (Track& track : tracks_)
            if (Status s = track.samples.flush(file_); !s.ok()) return s;
        putWorld();
        if (!status_.ok()) return status_;
        const auto list = tables_.write(file_);
        if (!list.ok()) return list.status();
        std::string head = "PXR-USDC";
        for (const std::uint8_t part : kVersion) head += static_cast<char>(part);
        head.resize(16, '\0');
        crateWord(*list, 8, head);
        if (Status s = file_.rewrite(0, head); !s.ok()) return s;
        return file_.commit();
    }

private:
    using Fields = std::vector<std::pair<std::string, CrateValue>>;
    struct Track {
        const UsdType* type = nullptr;
        bool array = false;
        UsdSamples samples;
        std::uint32_t path = 0;  ///< Of an attribute of words, whose values come later.
        Fields fields;           ///< As above.
    };

    CrateValue store(std::uint8_t type, std::string_view bytes, bool array) {
        // Offsets are whole multiples of 8, as readers that map files like them.
        const std::size_t blank = (8 - file_.size() % 8) % 8;
        if (blank > 0) keep(file_.write(std::string(blank, '\0')));
        const std::uint64_t offset = file_.size();
        keep(file_.write(bytes));
        return crateStored(type, offset, array);
    }
    void keep(const Status& status) {
        if (status_.ok()) status_ = status;
    }
    CrateValue token(const std::string& text) { return crateInline(kToken, tables_.word(text)); }

    CrateValue tokens(std::uint8_t type, const std::vector<std::string>& words, bool array) {
        std::string bytes;
        crateWord(words.size(), 8, bytes);
        for (const std::string& word : words) crateWord(tables_.word(word), 4, bytes);
        return store(type, bytes, array);
    }
    CrateValue listOf(std::uint8_t type, char head, std::uint32_t number, const std::string& rest = {}) {
        std::string bytes(1, head);
        crateWord(1, 8, bytes);
        crateWord(number, 4, bytes);
        return store(type, bytes + rest, false);
    }
    CrateValue reference(const std::string& path) {
        // In this file, at the same times, with nothing said about it.
        std::string bytes(1, kPrependedItems);
        crateWord(1, 8, bytes);
        crateWord(tables_.string(""), 4, bytes);
        crateWord(tables_.find(path), 4, bytes);
        for (const double number : {0.0, 1.0}) crateReal(number, bytes);
        crateWord(0, 8, bytes);
        return store(kReferenceListOp, bytes, false);
    }
    CrateValue real(double value) {
        const auto narrow = static_cast<float>(value);
        if (static_cast<double>(narrow) == value) return crateInline(kDouble, bitCast<std::uint32_t>(narrow));
        std::string bytes;
        crateReal(value, bytes);
        return store(kDouble, bytes, false);
    }
    CrateValue valueOf(const UsdValue& value) {
        const UsdType& type = usdType(value.type);
        const bool array = isUsdArray(value.type);
        if (!value.words.empty()) return array ? tokens(kToken, value.words, true) : token(value.words[0]);
        std::string bytes;
        if (array) crateWord(value.numbers.size() / type.numbers, 8, bytes);
        putNumbers(type, value.numbers, bytes);
        if (array || !isInline(type)) return store(type.code, bytes, array);
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < 4; ++i)
            word |= std::uint32_t{static_cast<std::uint8_t>(bytes[i])} << (8 * i);
        return crateInline(type.code, word);
    }

    void addPaths(const UsdPrim& prim, std::uint32_t parent, std::vector<std::uint32_t>& paths) {
        const std::uint32_t own = tables_.path(parent, prim.name, false);
        paths.push_back(own);
        for (const UsdProperty& property : prim.properties)
            paths.push_back(tables_.path(own, property.name, true));
        for (const UsdPrim& child : prim.children) addPaths(child, own, paths);
    }

    void put(const UsdPrim& prim, const std::vector<std::uint32_t>& paths, std::size_t& next) {
        Fields fields{{"specifier", crateInline(kSpecifier, static_cast<std::uint32_t>(prim.specifier))}};
        if (!prim.type.empty()) fields.emplace_back("typeName", token(prim.type));
        if (!prim.schema.empty())
            fields.emplace_back("apiSchemas",
                                listOf(kTokenListOp, kPrependedItems, tables_.word(prim.schema)));
        if (!prim.reference.empty()) fields.emplace_back("references", reference(prim.reference));
        std::vector<std::string> names;
        for (const UsdProperty& property : prim.properties) names.push_back(property.name);
        if (!names.empty()) fields.emplace_back("properties", tokens(kTokenVector, names, false));
        names.clear();
        for (const UsdPrim& child : prim.children) names.push_back(child.name);
        if (!names.empty()) fields.emplace_back("primChildren", tokens(kTokenVector, names, false));
        tables_.spec(paths[next++], CrateSpec::Prim, fields);
        for (const UsdProperty& property : prim.properties) put(property, paths[next++]);
        for (const UsdPrim& child : prim.children) put(child, paths, next);
    }

    void put(const UsdProperty& property, std::uint32_t path) {
        const UsdValue& value = property.value;
        Fields fields;
        if (property.uniform || value.type.empty())
            fields.emplace_back("variability", crateInline(kVariability, 1));
        if (value.type.empty()) {
            fields.emplace_back("targetPaths",
                                listOf(kPathListOp, kExplicitItems, tables_.find(property.target)));
            return tables_.spec(path, CrateSpec::Relationship, fields);
        }
        fields.emplace_back("typeName", token(value.type));
        if (!property.interpolation.empty())
            fields.emplace_back("interpolation", token(property.interpolation));
        if (property.elementSize > 0)
            fields.emplace_back("elementSize",
                                crateInline(kInt, static_cast<std::uint32_t>(property.elementSize)));
        if (!property.target.empty())
            fields.emplace_back("connectionPaths",
                                listOf(kPathListOp, kExplicitItems, tables_.find(property.target)));
        if (property.sampled) return track(value, path, std::move(fields));
        if (!value.words.empty() || !value.numbers.empty()) fields.emplace_back("default", valueOf(value));
        tables_.spec(path, CrateSpec::Attribute, fields);
    }

    void attribute(std::uint32_t path, Fields fields, CrateValue samples) {
        fields.emplace_back("timeSamples", samples);
        tables_.spec(path, CrateSpec::Attribute, fields);
    }

    /// What comes before the values of samples: where the times and the values are, from there on.
    static std::string samplesHead(CrateValue times) {
        std::string bytes;
        crateWord(8, 8, bytes);
        crateWord(times, 8, bytes);
        crateWord(8, 8, bytes);
        return bytes;
    }

    /// A frame's value as it lies in the file.
    static std::string record(const UsdType& type, bool array, std::span<const double> numbers) {
        std::string bytes;
        if (array) crateWord(numbers.size() / type.numbers, 8, bytes);
        putNumbers(type, numbers, bytes);
        if (!array && isInline(type)) crateWord(crateInline(type.code, 0) >> 32, 4, bytes);
        bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
        return bytes;
    }

    /// Leaves room for the values of all frames.
    void track(const UsdValue& value, std::uint32_t path, Fields fields) {
        const UsdType& type = usdType(value.type);
        const bool array = isUsdArray(value.type);
        if (!value.words.empty()) {
            tracks_.push_back({&type, array, UsdSamples(0, 1), path, std::move(fields)});
            return;
        }
        const std::size_t width = record(type, array, value.numbers).size();
        Track made{&type, array, UsdSamples(pace_.frames, width), path, {}};
        const bool within = !array && isInline(type);
        std::string head = samplesHead(times_);
        crateWord(pace_.frames, 8, head);
        if (!within) {
            store(0, {}, false);  // Fills up to a whole multiple of 8.
            keep(made.samples.reserve(file_));
            for (std::size_t k = 0; k < pace_.frames; ++k)
                crateWord(crateStored(type.code, made.samples.begin() + k * width, array), 8, head);
        }
        attribute(path, std::move(fields), store(kTimeSamples, head, false));
        if (within) keep(made.samples.reserve(file_));
        tracks_.push_back(std::move(made));
    }

    void putWorld() {
        tables_.spec(world_, CrateSpec::Prim,
                     {{"specifier", crateInline(kSpecifier, 0)},
                      {"typeName", token("Xform")},
                      {"primChildren", tokens(kTokenVector, children_, false)}});
        const CrateValue fps = real(pace_.fps);
        tables_.spec(0, CrateSpec::Root,
                     {{"defaultPrim", token("World")},
                      {"documentation", crateInline(kString, tables_.string("Written by Muster"))},
                      {"startTimeCode", real(0.0)},
                      {"endTimeCode", real(static_cast<double>(pace_.frames - 1))},
                      {"framesPerSecond", fps},
                      {"timeCodesPerSecond", fps},
                      {"metersPerUnit", real(1.0)},
                      {"upAxis", token("Z")},
                      {"primChildren", tokens(kTokenVector, {"World"}, false)}});
    }

    OutputFile file_;
    UsdPace pace_;
    CrateTables tables_;
    CrateValue times_ = 0;  ///< Those of all frames.
    std::uint32_t world_ = 0;
    std::vector<std::string> children_;  ///< Below the world.
    std::vector<Track> tracks_;
    Status status_;  ///< The first failure.
};

}  // namespace

std::unique_ptr<UsdFile> makeUsdCrateFile() {
    return std::make_unique<UsdCrateFile>();
}

}  // namespace muster
