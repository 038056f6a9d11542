#include "io/scenario/json.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace muster {
namespace {

constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxKeys = 1000;  // Of one object: keys are looked up one by one.
constexpr std::size_t kLineWidth = 110;

/// Line and column of a byte offset, both from 1.
std::string lineAndColumn(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t newline = before.rfind('\n');
    const std::size_t column = before.size() - (newline == std::string_view::npos ? 0 : newline + 1);
    return std::to_string(line) + ":" + std::to_string(std::max<std::size_t>(1, column));
}

/// Builds the document and notes the first failure, without exceptions.
class Builder : public nlohmann::json_sax<Json> {
public:
    explicit Builder(std::string_view text) : text_(text) {}

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(std::int64_t value) override { return put(value); }
    bool number_unsigned(std::uint64_t value) override { return put(value); }
    bool number_float(double value, const std::string&) override { return put(value); }
    bool string(std::string& value) override { return put(std::move(value)); }
    bool binary(Json::binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(std::string& name) override {
        if (stack_.back()->size() >= kMaxKeys) return fail("an object has more than 1000 keys");
        if (stack_.back()->contains(name)) return fail("the key \"" + name + "\" stands twice in one object");
        key_ = name;
        return true;
    }
    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::detail::exception& e) override {
        const std::string what = e.what();
        const std::size_t expected = what.rfind("expected ");
        std::string found = token.empty() || token == "<end of input>" ? "the end"
                                                                       : "`" + token.substr(0, 40) + "`";
        if (position > text_.size()) found = "the end";
        error_ = lineAndColumn(text_, position) + ": found " + found + ", expected " +
                 (expected == std::string::npos ? "valid JSON" : what.substr(expected + 9));
        return false;
    }

    Json& root() { return root_; }
    const std::string& error() const { return error_; }

private:
    template <class T>
    Json* add(T&& value) {
        if (stack_.empty()) {
            root_ = std::forward<T>(value);
            return &root_;
        }
        Json& top = *stack_.back();
        if (top.is_array()) {
            top.push_back(std::forward<T>(value));
            return &top.back();
        }
        return &(top[key_] = std::forward<T>(value));
    }
    template <class T>
    bool put(T&& value) {
        add(std::forward<T>(value));
        return true;
    }
    bool open(Json container) {
        if (stack_.size() >= kMaxDepth) return fail("more than 64 levels of nesting");
        stack_.push_back(add(std::move(container)));
        return true;
    }
    bool close() {
        stack_.pop_back();
        return true;
    }
    bool fail(std::string message) {
        error_ = std::move(message);
        return false;
    }

    std::string_view text_;
    Json root_;
    std::vector<Json*> stack_;  // Parents stay put while a child is open.
    std::string key_;
    std::string error_;
};

std::string flat(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// One line, with blanks after commas and colons.
void printFlat(const Json& value, std::string& out) {
    if (!value.is_structured()) {
        out += flat(value);
        return;
    }
    const bool object = value.is_object();
    out += object ? '{' : '[';
    bool first = true;
    for (auto item = value.begin(); item != value.end(); ++item) {
        if (!first) out += ", ";
        first = false;
        if (object) out += flat(Json(item.key())) + ": ";
        printFlat(*item, out);
    }
    out += object ? '}' : ']';
}

/// True where the value may stand on one line: small, and not a list of objects.
bool compact(const Json& value, std::size_t room) {
    if (!value.is_structured()) return true;
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
        if (value[i].is_object() || !compact(value[i], kLineWidth - margin.size())) {
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
    if (value.is_array()) return printArray(value, indent, out);
    out += "{\n";
    std::size_t left = value.size();
    for (auto item = value.begin(); item != value.end(); ++item) {
        const std::string key = std::string(indent + 2, ' ') + flat(Json(item.key())) + ": ";
        out += key;
        print(*item, indent + 2, key.size(), out);
        out += --left > 0 ? ",\n" : "\n";
    }
    out += std::string(indent, ' ') + "}";
}

}  // namespace

Result<Json> parseJson(std::string_view text, const std::string& sourceName) {
    if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
    Builder builder(text);
    if (Json::sax_parse(text.begin(), text.end(), &builder)) return std::move(builder.root());
    return Status(StatusCode::ParseError,
                  sourceName + ":" + (builder.error().empty() ? "1:1: not JSON" : builder.error()));
}

std::string printJson(const Json& value) {
    std::string out;
    print(value, 0, 0, out);
    out += '\n';
    return out;
}

std::string describeJson(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array of " + std::to_string(value.size());
    if (value.is_null()) return "null";
    std::string text = flat(value);
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    if (value.is_string()) return "the text " + text;
    return value.is_boolean() ? text : "the number " + text;
}

}  // namespace muster
