// JSON values, read and written. The only code that includes the JSON library is json_parse.cpp: including it
// costs seconds.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "muster/status.h"

namespace muster {

/// A JSON value. Objects keep the order of their keys. Accessors require the right kind of value.
class Json {
public:
    struct Member;
    /// Kinds of values. Whole numbers keep all 64 bits.
    enum class Kind : std::uint8_t { Null, Boolean, Integer, Unsigned, Real, Text, Array, Object };

    Json() noexcept {}
    Json(std::nullptr_t) noexcept {}
    template <class T, class = std::enable_if_t<std::is_integral_v<T>>>
    Json(T value) noexcept {
        if constexpr (std::is_same_v<T, bool>) {
            kind_ = Kind::Boolean;
            data_.boolean = value;
        } else if constexpr (std::is_signed_v<T>) {
            kind_ = Kind::Integer;
            data_.integer = value;
        } else {
            kind_ = Kind::Unsigned;
            data_.natural = value;
        }
    }
    Json(double value) noexcept : kind_(Kind::Real) { data_.real = value; }
    Json(std::string text);
    Json(std::string_view text);
    Json(const char* text);
    /// An object: `{{"key", value}, ...}`.
    Json(std::initializer_list<Member> members);
    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(Json other) noexcept;
    ~Json();

    static Json array() { return array({}); }             ///< An empty array.
    static Json array(std::initializer_list<Json> list);  ///< An array of the values of a list.
    static Json object() { return Json(std::initializer_list<Member>{}); }  ///< An empty object.
    /// An array of the values of a range.
    template <class Range>
    static Json arrayOf(const Range& range) {
        Json list = array();
        for (const auto& value : range) list.push(value);
        return list;
    }

    bool isNull() const { return kind_ == Kind::Null; }
    bool isBoolean() const { return kind_ == Kind::Boolean; }
    bool isWhole() const { return kind_ == Kind::Integer || kind_ == Kind::Unsigned; }
    bool isNumber() const { return isWhole() || kind_ == Kind::Real; }
    bool isText() const { return kind_ == Kind::Text; }
    bool isArray() const { return kind_ == Kind::Array; }
    bool isObject() const { return kind_ == Kind::Object; }
    Kind kind() const { return kind_; }

    bool boolean() const;
    double number() const;  ///< Any number, as the nearest double.
    /// A whole number; it must fit.
    template <class T>
    T whole() const {
        return kind_ == Kind::Unsigned ? static_cast<T>(data_.natural) : static_cast<T>(data_.integer);
    }
    const std::string& text() const;

    /// Values of an array or members of an object; 0 for null, 1 for any other value.
    std::size_t size() const;
    bool empty() const { return size() == 0; }

    const std::vector<Json>& elements() const;  ///< The elements of an array.
    const Json& operator[](std::size_t index) const { return elements()[index]; }
    Json& operator[](std::size_t index);
    /// Appends to an array; null becomes one. The reference holds until the next call.
    Json& push(Json value);

    const std::vector<Member>& members() const;  ///< The members of an object.
    /// The value of a key; nullptr where there is none, and for values that are no object.
    const Json* find(std::string_view key) const;
    bool contains(std::string_view key) const { return find(key) != nullptr; }
    /// The value of a key of an object, null where the key is new; null becomes an object.
    Json& operator[](std::string_view key);
    /// Removes a key.
    void erase(std::string_view key);

private:
    Kind kind_ = Kind::Null;
    union {
        bool boolean;
        std::int64_t integer;
        std::uint64_t natural;
        double real;
        std::string* text;
        std::vector<Json>* array;
        std::vector<Member>* object;
    } data_ = {.natural = 0};
};

/// A key of an object with its value.
struct Json::Member {
    std::string key;
    Json value;
};

/// Parses strictly: no comments, no repeated keys, at most 64 levels. Errors: `SOURCE:LINE:COLUMN: found X,
/// expected Y`.
Result<Json> parseJson(std::string_view text, const std::string& sourceName);

/// Readable text: short arrays and objects on one line, two spaces per level, at most about 110 columns.
/// Numbers are the shortest that read back to the same bits.
std::string printJson(const Json& value);
/// Text with every value on a line of its own, `indent` spaces per level.
std::string indentedJson(const Json& value, int indent);
/// Text without any blanks.
std::string compactJson(const Json& value);
/// Text in quotes. Bytes that are no UTF-8 are replaced by U+FFFD, here as in the other functions.
std::string jsonText(std::string_view text);

/// A description of a value for messages: `the text "abc"`, `the number 3`, `an array of 4`, `an object`...
std::string describeJson(const Json& value);

/// The shortest text that reads back to the same bits; "null" for numbers that are not finite, which JSON
/// cannot hold.
std::string jsonRealText(double value);

}  // namespace muster
