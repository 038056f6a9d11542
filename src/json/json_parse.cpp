// Reading JSON, and the text of strings and numbers: what the JSON library does for us.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "json/json.h"

namespace muster {
namespace {

constexpr std::size_t kMaxDepth = 64;
// Greatest number of keys of one object: keys are looked up one by one.
constexpr std::size_t kMaxKeys = 1000;

/// Line and column of a byte offset, both from 1.
std::string lineAndColumn(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t newline = before.rfind('\n');
    const std::size_t column = before.size() - (newline == std::string_view::npos ? 0 : newline + 1);
    return std::to_string(line) + ":" + std::to_string(std::max<std::size_t>(1, column));
}

/// Builds the document and notes the first failure, without exceptions.
class Builder : public nlohmann::json_sax<nlohmann::json> {
public:
    explicit Builder(std::string_view text) : text_(text) {}

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(std::int64_t value) override { return put(value); }
    bool number_unsigned(std::uint64_t value) override { return put(value); }
    bool number_float(double value, const std::string&) override { return put(value); }
    bool string(std::string& value) override { return put(std::move(value)); }
    bool binary(nlohmann::json::binary_t&) override { return false; }
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
            root_ = Json(std::forward<T>(value));
            return &root_;
        }
        Json& top = *stack_.back();
        if (top.isArray()) {
            return &top.push(std::forward<T>(value));
        }
        return &(top[key_] = Json(std::forward<T>(value)));
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

}  // namespace

Result<Json> parseJson(std::string_view text, const std::string& sourceName) {
    if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
    Builder builder(text);
    if (nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return std::move(builder.root());
    return Status(StatusCode::ParseError,
                  sourceName + ":" + (builder.error().empty() ? "1:1: not JSON" : builder.error()));
}

std::string jsonText(std::string_view text) {
    constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
    return nlohmann::json(text).dump(-1, ' ', false, kReplace);
}

std::string jsonRealText(double value) {
    if (!std::isfinite(value)) return "null";
    char text[64];
    return {text, nlohmann::detail::to_chars(text, text + sizeof(text), value)};
}

}  // namespace muster
