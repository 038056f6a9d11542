// Writing JSON.
#include "json/json.h"

namespace muster {
namespace {

constexpr std::size_t kLineWidth = 110;

void appendScalar(const Json& value, std::string& out) {
    switch (value.kind()) {
        case Json::Kind::Boolean:
            out += value.boolean() ? "true" : "false";
            break;
        case Json::Kind::Integer:
            out += std::to_string(value.whole<std::int64_t>());
            break;
        case Json::Kind::Unsigned:
            out += std::to_string(value.whole<std::uint64_t>());
            break;
        case Json::Kind::Real:
            out += jsonRealText(value.number());
            break;
        case Json::Kind::Text:
            out += jsonText(value.text());
            break;
        default:
            out += "null";
    }
}

/// Calls `append(key or nullptr, value)` for the values of an array or object.
template <class Append>
void forEach(const Json& value, const Append& append) {
    if (value.isArray())
        for (const Json& element : value.elements()) append(nullptr, element);
    if (value.isObject())
        for (const Json::Member& member : value.members()) append(&member.key, member.value);
}

bool isStructured(const Json& value) {
    return value.isArray() || value.isObject();
}

/// Layout of values.
struct Spacing {
    int indent = 0;       ///< Spaces per level; only where `lines`.
    bool lines = false;   ///< True if each value has a line of its own.
    bool blanks = false;  ///< True for a blank after each colon, and after each comma unless `lines`.
};

void append(const Json& value, const Spacing& spacing, int level, std::string& out) {
    if (!isStructured(value)) return appendScalar(value, out);
    const auto newLine = [&](int depth) {
        if (spacing.lines && !value.empty()) out.append("\n").append(depth * spacing.indent, ' ');
    };
    bool first = true;
    out += value.isObject() ? '{' : '[';
    forEach(value, [&](const std::string* key, const Json& item) {
        if (!first) out += spacing.blanks && !spacing.lines ? ", " : ",";
        first = false;
        newLine(level + 1);
        if (key != nullptr) {
            out += jsonText(*key);
            out += spacing.blanks ? ": " : ":";
        }
        append(item, spacing, level + 1, out);
    });
    newLine(level);
    out += value.isObject() ? '}' : ']';
}

void printFlat(const Json& value, std::string& out) {
    append(value, {.blanks = true}, 0, out);
}

/// True where the value may stand on one line: small, and not a list of objects.
bool compact(const Json& value, std::size_t room) {
    if (!isStructured(value)) return true;
    std::string line;
    if (value.size() > 40) return false;
    printFlat(value, line);
    return line.size() <= room;
}

void print(const Json& value, std::size_t indent, std::size_t used, std::string& out);

/// Scalars and short arrays fill lines, as points of a polygon do.
void printArray(const Json& value, std::size_t indent, std::string& out) {
    const std::string margin(indent + 2, ' ');
    std::string line = margin;
    out += "[\n";
    for (std::size_t i = 0; i < value.size(); ++i) {
        const bool last = i + 1 == value.size();
        std::string item;
        if (value[i].isObject() || !compact(value[i], kLineWidth - margin.size())) {
            if (line.size() > margin.size()) out += line + "\n";
            line = margin;
            print(value[i], indent + 2, margin.size(), item);
            out += margin + item + (last ? "\n" : ",\n");
            continue;
        }
        printFlat(value[i], item);
        if (!last) item += ',';
        if (line.size() > margin.size() && line.size() + item.size() + 1 > kLineWidth) {
            out += line + "\n";
            line = margin;
        }
        if (line.size() > margin.size()) line += ' ';
        line += item;
    }
    if (line.size() > margin.size()) out += line + "\n";
    out += std::string(indent, ' ') + "]";
}

void print(const Json& value, std::size_t indent, std::size_t used, std::string& out) {
    if (compact(value, used < kLineWidth ? kLineWidth - used : 0)) return printFlat(value, out);
    if (value.isArray()) return printArray(value, indent, out);
    out += "{\n";
    std::size_t left = value.size();
    for (const auto& [name, item] : value.members()) {
        const std::string key = std::string(indent + 2, ' ') + jsonText(name) + ": ";
        out += key;
        print(item, indent + 2, key.size(), out);
        out += --left > 0 ? ",\n" : "\n";
    }
    out += std::string(indent, ' ') + "}";
}

}  // namespace

std::string printJson(const Json& value) {
    std::string out;
    print(value, 0, 0, out);
    out += '\n';
    return out;
}

std::string indentedJson(const Json& value, int indent) {
    std::string out;
    append(value, {indent, true, true}, 0, out);
    return out;
}

std::string compactJson(const Json& value) {
    std::string out;
    append(value, {}, 0, out);
    return out;
}

std::string describeJson(const Json& value) {
    if (value.isObject()) return "an object";
    if (value.isArray()) return "an array of " + std::to_string(value.size());
    if (value.isNull()) return "null";
    std::string text = compactJson(value);
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    if (value.isText()) return "the text " + text;
    return value.isBoolean() ? text : "the number " + text;
}

}  // namespace muster
