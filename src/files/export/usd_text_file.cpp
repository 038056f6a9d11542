#include <cstdio>

#include "base/maths.h"
#include "files/export/usd_file.h"
#include "files/export/usd_text.h"

namespace muster {
namespace {

constexpr std::size_t kMostChanges = 8;   // Largest number of changes of a word in the file.
constexpr std::size_t kChangeWidth = 32;  // Number of bytes per change.

/// Writes numbers, either with seven digits or in fixed columns.
class ValueText {
public:
    ValueText(const UsdType& type, bool fixed) : type_(type), fixed_(fixed) {}

    std::string of(std::span<const double> numbers, bool array) {
        text_.clear();
        if (array) text_ += '[';
        for (std::size_t k = 0; k < numbers.size(); k += type_.numbers) {
            if (k > 0) text_ += fixed_ ? "," : ", ";
            element(numbers.subspan(k, type_.numbers));
        }
        if (array) text_ += ']';
        return text_;
    }

private:
    void element(std::span<const double> numbers) {
        if (numbers.size() == 1) return number(numbers[0]);
        const std::size_t row = numbers.size() == 16 ? 4 : numbers.size();
        if (row < numbers.size()) text_ += "( ";
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            if (k % row == 0)
                text_ += k == 0 ? "(" : ", (";
            else
                text_ += fixed_ ? "," : ", ";
            number(numbers[k]);
            if (k % row == row - 1) text_ += ')';
        }
        if (row < numbers.size()) text_ += " )";
    }
    void number(double value) {
        if (fixed_)
            usdFixed(value, type_.width, type_.decimals, text_);
        else
            text_ += usdNumber(value);
    }

    const UsdType& type_;
    bool fixed_;
    std::string text_;
};

std::string quoted(const std::vector<std::string>& words, bool array) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + "\"";
    return array ? "[" + text + "]" : text;
}

std::string lineOf(std::size_t frame, const std::string& type, std::span<const double> numbers) {
    char start[24];
    std::snprintf(start, sizeof(start), "%10zu: ", frame);
    return start + ValueText(usdType(type), true).of(numbers, isUsdArray(type)) + ",\n";
}

class UsdTextFile final : public UsdFile {
public:
    Status open(const std::string& path, const UsdPace& pace) override {
        pace_ = pace;
        if (Status s = file_.open(path); !s.ok()) return s;
        const std::string fps = usdNumber(pace.fps);
        return file_.write(
            "#usda 1.0\n(\n    defaultPrim = \"World\"\n    doc = \"Written by Muster\"\n"
            "    endTimeCode = " +
            std::to_string(pace.frames - 1) + "\n    framesPerSecond = " + fps +
            "\n    metersPerUnit = 1\n    startTimeCode = 0\n    timeCodesPerSecond = " + fps +
            "\n    upAxis = \"Z\"\n)\n\ndef Xform \"World\"\n{\n");
    }

    Status add(const UsdPrim& prim) override {
        if (Status s = put(prim, "    "); !s.ok()) return s;
        return flush();
    }

    std::size_t tracks() const override { return tracks_.size(); }

    Status sample(std::size_t track, std::span<const double> numbers) override {
        Track& one = tracks_[track];
        return one.samples.add(file_, lineOf(one.filled++, one.type, numbers));
    }

    Status words(std::size_t track, const UsdWords& words) override {
        std::string text;
        for (const auto& [frame, word] : words) {
            if (text.size() == kMostChanges * kChangeWidth) break;
            char line[kChangeWidth + 1];
            std::snprintf(line, sizeof(line), "%12zu: \"%s\",", frame, word);
            text += line;
            text += '\n';
        }
        return file_.rewrite(tracks_[track].samples.begin(), text);
    }

    Status finish() override {
        for (Track& track : tracks_)
            if (Status s = track.samples.flush(file_); !s.ok()) return s;
        if (Status s = file_.write("}\n"); !s.ok()) return s;
        return file_.commit();
    }

private:
    struct Track {
        std::string type;
        UsdSamples samples;
        std::size_t filled = 0;
    };

    Status put(const UsdPrim& prim, const std::string& indent) {
        constexpr const char* kSpecifiers[] = {"def", "over", "class"};
        text_ += indent + kSpecifiers[static_cast<int>(prim.specifier)] + " " + prim.type +
                 (prim.type.empty() ? "\"" : " \"") + prim.name + "\"";
        if (!prim.reference.empty() || !prim.schema.empty()) {
            text_ += " (\n";
            if (!prim.schema.empty())
                text_ += indent + "    prepend apiSchemas = [\"" + prim.schema + "\"]\n";
            if (!prim.reference.empty())
                text_ += indent + "    prepend references = <" + prim.reference + ">\n";
            text_ += indent + ")";
        }
        text_ += "\n" + indent + "{\n";
        for (const UsdProperty& property : prim.properties)
            if (Status s = put(property, indent + "    "); !s.ok()) return s;
        for (const UsdPrim& child : prim.children)
            if (Status s = put(child, indent + "    "); !s.ok()) return s;
        text_ += indent + "}\n";
        return {};
    }

    Status put(const UsdProperty& property, const std::string& indent) {
        const UsdValue& value = property.value;
        text_ += indent + (property.uniform ? "uniform " : "") + (value.type.empty() ? "rel" : value.type) +
                 " " + property.name;
        if (property.sampled) return reserve(value, indent);
        if (!property.target.empty())
            text_ += (value.type.empty() ? " = <" : ".connect = <") + property.target + ">";
        const bool array = isUsdArray(value.type);
        if (!value.words.empty()) text_ += " = " + quoted(value.words, array);
        if (!value.numbers.empty())
            text_ += " = " + ValueText(usdType(value.type), false).of(value.numbers, array);
        if (property.elementSize > 0)
            text_ += " (\n" + indent + "    elementSize = " + std::to_string(property.elementSize) + "\n" +
                     indent + "    interpolation = \"" + property.interpolation + "\"\n" + indent + ")";
        else if (!property.interpolation.empty())
            text_ += " (interpolation = \"" + property.interpolation + "\")";
        text_ += '\n';
        return {};
    }

    /// Leaves room for samples.
    Status reserve(const UsdValue& value, const std::string& indent) {
        text_ += ".timeSamples = {\n";
        if (Status s = flush(); !s.ok()) return s;
        const bool words = !value.words.empty();
        const std::size_t width = words ? kChangeWidth : lineOf(0, value.type, value.numbers).size();
        tracks_.push_back({value.type, UsdSamples(words ? kMostChanges : pace_.frames, width)});
        if (Status s = tracks_.back().samples.reserve(file_); !s.ok()) return s;
        text_ += (words ? "\n" : "") + indent + "}\n";
        return {};
    }

    Status flush() {
        const Status s = file_.write(text_);
        text_.clear();
        return s;
    }

    OutputFile file_;
    UsdPace pace_;
    std::string text_;  ///< Not yet written.
    std::vector<Track> tracks_;
};

}  // namespace

std::unique_ptr<UsdFile> makeUsdTextFile() {
    return std::make_unique<UsdTextFile>();
}

std::string usdName(std::string_view name) {
    std::string text;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        text += plain ? c : '_';
    }
    if (text.empty() || (text[0] >= '0' && text[0] <= '9')) text.insert(text.begin(), '_');
    return text;
}

std::string usdNumber(double value) {
    char text[40];
    std::snprintf(text, sizeof(text), "%.7g", value == 0.0 ? 0.0 : value);
    return text;
}

void usdFixed(double value, int width, int decimals, std::string& text) {
    char number[64];
    for (; decimals >= 0; --decimals)
        if (std::snprintf(number, sizeof(number), "%*.*f", width, decimals, value) == width) break;
    if (decimals < 0) std::snprintf(number, sizeof(number), "%*d", width, 0);
    text += number;
}

}  // namespace muster
