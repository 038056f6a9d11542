// Visitors for file objects. One description of each object serves loading, saving and the schema.
//
// The functions describe() (described_definitions.h) call the same methods on three visitors: FieldReader
// reads values from JSON, FieldWriter writes them, and FieldSchema writes the JSON schema.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "json/json.h"
#include "muster/order.h"
#include "muster/vec2.h"

namespace muster {

/// Limits of a number.
struct NumberRange {
    double minimum = 0.0;
    double maximum = 0.0;
    std::string_view unit = "1";
    bool whole = false;  ///< True where only whole numbers are allowed.
};

/// Whether a key is required.
enum class Need { Optional, Required };

/// Reads the fields of one JSON object. It keeps the first failure and reads nothing after it.
class FieldReader {
public:
    /// `path` is the JSON path of `object`; `failure` receives the first sentence.
    FieldReader(const Json& object, std::string path, std::string& failure);

    static constexpr bool kReading = true;  ///< This visitor reads values.
    static constexpr bool kSchema = false;  ///< This visitor makes no schema.

    /// `fallback` is the text where the key is left out.
    void text(std::string_view key, std::string& value, const char* about, Need need = Need::Optional,
              std::string_view fallback = {});
    void number(std::string_view key, double& value, const NumberRange& range, std::string_view about,
                Need need = Need::Optional);
    /// An optional number; the value stays negative where it is left out.
    void optionalNumber(std::string_view key, double& value, const NumberRange& range, const char* about) {
        number(key, value, range, about);
    }
    /// A number that may be none; it stays as it is where it is left out.
    void optionalNumber(std::string_view key, std::optional<double>& value, const NumberRange& range,
                        const char* about, Need need) {
        double found = 0.0;
        const bool given = has(key);
        number(key, found, range, about, need);
        if (given) value = found;
    }
    /// A list of numbers.
    template <class Number>
    void numbers(std::string_view key, std::vector<Number>& values, const NumberRange& range,
                 std::size_t most, const char*, Need need = Need::Optional) {
        const Json* found = findArray(key, most, need);
        if (found == nullptr) return;
        NumberRange bounds = range;
        bounds.whole = std::is_integral_v<Number>;
        values.clear();
        for (std::size_t i = 0; i < found->size(); ++i) {
            double value = 0.0;
            if (!readNumber((*found)[i], bounds, value))
                return failNumber(std::string(key) + "[" + std::to_string(i) + "]", (*found)[i], bounds);
            values.push_back(static_cast<Number>(value));
        }
    }
    template <class Whole>
    void whole(std::string_view key, Whole& value, const NumberRange& range, const char*,
               Need need = Need::Optional) {
        double wide = static_cast<double>(value);
        NumberRange bounds = range;
        bounds.whole = true;
        const Json* found = find(key, need);
        if (found == nullptr) return;
        if (!readNumber(*found, bounds, wide)) return failNumber(key, *found, bounds);
        value = found->isWhole() ? found->whole<Whole>() : static_cast<Whole>(wide);
    }
    void flag(std::string_view key, bool& value, const char* about);
    /// A colour as "#rrggbb"; it stays as it is where it is left out.
    void colour(std::string_view key, std::optional<std::uint32_t>& value, const char* about);
    void point(std::string_view key, Vec2& value, const char* about, Need need = Need::Optional);
    void points(std::string_view key, std::vector<Vec2>& value, std::size_t least, std::size_t most,
                const char* about, Need need = Need::Optional);
    void choice(std::string_view key, std::string& value, const std::vector<std::string>& names,
                const char* about, Need need = Need::Optional);
    /// A word from a list; the value is its index.
    void nameOrIndex(std::string_view key, std::int32_t& value, const std::vector<std::string>& names,
                     const char* about, Need need = Need::Optional);
    /// A list of objects; `describe(visitor, item)` is called for each.
    template <class Item, class Describe>
    void list(std::string_view key, std::vector<Item>& items, std::size_t most, const char*,
              Describe describe, Need need = Need::Optional) {
        const Json* found = findArray(key, most, need);
        if (found == nullptr) return;
        items.clear();
        for (std::size_t i = 0; i < found->size() && !failed(); ++i) {
            FieldReader child((*found)[i], pathOf(key) + "[" + std::to_string(i) + "]", *failure_);
            describe(child, items.emplace_back());
            child.finish();
        }
    }
    /// A nested object. `describe(visitor)` is called where it is present; returns true then.
    template <class Describe>
    bool object(std::string_view key, const char*, Describe describe, Need need = Need::Optional) {
        const Json* found = find(key, need);
        if (found == nullptr) return false;
        FieldReader child(*found, pathOf(key), *failure_);
        describe(child);
        child.finish();
        return true;
    }
    /// Like object(), but a bare word stands for an object with only that `kind`.
    template <class Describe>
    bool objectOrKind(std::string_view key, const char*, Describe describe, Need need = Need::Optional) {
        const Json* found = find(key, need);
        if (found == nullptr) return false;
        Json wrapped;
        if (found->isText()) wrapped["kind"] = *found;
        FieldReader child(found->isText() ? wrapped : *found, pathOf(key), *failure_);
        describe(child);
        child.finish();
        return true;
    }

    /// Reads an object that stands somewhere inside the value of a key, `key` with its index.
    template <class Describe>
    void inside(const std::string& key, const Json& object, Describe describe) {
        FieldReader child(object, pathOf(key), *failure_);
        describe(child);
        child.finish();
    }

    /// True where the object has the key; that does not count as reading it.
    bool has(std::string_view key) const { return object_->find(key) != nullptr; }
    /// The value of a key, or null; null is a failure where the key is required.
    const Json* find(std::string_view key, Need need = Need::Optional);
    /// The value of a key that must be an array of at most `most` items.
    const Json* findArray(std::string_view key, std::size_t most, Need need);
    /// Stores a failure at a key of this object; an empty key means the object itself.
    void fail(std::string_view key, const std::string& found, const std::string& expected);
    /// True once anything failed.
    bool failed() const { return !failure_->empty(); }
    /// Fails for keys that no description has read.
    void finish();

private:
    std::string pathOf(std::string_view key) const;
    static bool readNumber(const Json& value, const NumberRange& range, double& number);
    void failNumber(std::string_view key, const Json& found, const NumberRange& range);
    bool readPoint(const Json& value, const std::string& path, Vec2& point);
    void failAt(const std::string& path, const std::string& found, const std::string& expected);

    const Json* object_;
    std::string path_;
    std::string* failure_;
    std::vector<std::string_view> known_;  // The keys that were read.
};

/// Writes fields into one JSON object. It leaves out empty lists, negative optional numbers and empty texts
/// whose key may be left out.
class FieldWriter {
public:
    explicit FieldWriter(Json& object) : object_(&object) { *object_ = Json::object(); }

    static constexpr bool kReading = false;  ///< This visitor reads nothing.
    static constexpr bool kSchema = false;   ///< This visitor makes no schema.

    void text(std::string_view key, const std::string& value, const char* about, Need need = Need::Optional,
              std::string_view fallback = {});
    void number(std::string_view key, double value, const NumberRange& range, std::string_view about,
                Need need = Need::Optional);
    void optionalNumber(std::string_view key, double value, const NumberRange& range, const char* about);
    void optionalNumber(std::string_view key, const std::optional<double>& value, const NumberRange&,
                        const char*, Need) {
        if (value) set(key, *value);
    }
    template <class Number>
    void numbers(std::string_view key, const std::vector<Number>& values, const NumberRange&, std::size_t,
                 const char*, Need need = Need::Optional) {
        if (!values.empty() || need == Need::Required) set(key, Json::arrayOf(values));
    }
    template <class Whole>
    void whole(std::string_view key, Whole value, const NumberRange&, const char*, Need = Need::Optional) {
        set(key, value);
    }
    void flag(std::string_view key, bool value, const char* about);
    void colour(std::string_view key, const std::optional<std::uint32_t>& value, const char* about);
    void point(std::string_view key, Vec2 value, const char* about, Need need = Need::Optional);
    void points(std::string_view key, const std::vector<Vec2>& value, std::size_t least, std::size_t most,
                const char* about, Need need = Need::Optional);
    void choice(std::string_view key, const std::string& value, const std::vector<std::string>& names,
                const char* about, Need need = Need::Optional);
    void nameOrIndex(std::string_view key, std::int32_t value, const std::vector<std::string>& names,
                     const char* about, Need need = Need::Optional);
    template <class Item, class Describe>
    void list(std::string_view key, std::vector<Item>& items, std::size_t, const char*, Describe describe,
              Need need = Need::Optional) {
        if (items.empty() && need == Need::Optional) return;
        Json array = Json::array();
        for (Item& item : items) {
            FieldWriter child(array.push({}));
            describe(child, item);
        }
        set(key, std::move(array));
    }
    template <class Describe>
    bool object(std::string_view key, const char*, Describe describe, Need need = Need::Optional) {
        Json inner;
        FieldWriter child(inner);
        describe(child);
        if (!inner.empty() || need == Need::Required) set(key, std::move(inner));
        return true;
    }
    template <class Describe>
    bool objectOrKind(std::string_view key, const char* about, Describe describe,
                      Need need = Need::Optional) {
        return object(key, about, describe, need);
    }
    bool failed() const { return false; }  ///< Writing cannot fail.

    /// Sets a key directly.
    template <class Value>
    void set(std::string_view key, Value&& value) {
        (*object_)[key] = Json(std::forward<Value>(value));
    }

private:
    Json* object_;
};

/// Writes the schema of one JSON object. The given values are the defaults.
class FieldSchema {
public:
    explicit FieldSchema(Json& schema);

    static constexpr bool kReading = false;  ///< This visitor reads nothing.
    static constexpr bool kSchema = true;    ///< This visitor makes a schema.

    void text(std::string_view key, const std::string& value, const char* about, Need need = Need::Optional,
              std::string_view fallback = {});
    void number(std::string_view key, double value, const NumberRange& range, std::string_view about,
                Need need = Need::Optional);
    void optionalNumber(std::string_view key, double value, const NumberRange& range, const char* about);
    /// A number that may be none.
    void optionalNumber(std::string_view key, const std::optional<double>&, const NumberRange& range,
                        const char* about, Need) {
        optionalNumber(key, 0.0, range, about);
    }
    template <class Number>
    void numbers(std::string_view key, const std::vector<Number>&, const NumberRange& range, std::size_t most,
                 const char* about, Need need = Need::Optional) {
        const Json items = itemSchema(range, std::is_integral_v<Number>);
        set(key, {{"type", "array"}, {"maxItems", most}, {"items", items}}, about, need);
    }
    template <class Whole>
    void whole(std::string_view key, Whole value, const NumberRange& range, const char* about,
               Need need = Need::Optional) {
        NumberRange bounds = range;
        bounds.whole = true;
        number(key, static_cast<double>(value), bounds, about, need);
    }
    void flag(std::string_view key, bool value, const char* about);
    void colour(std::string_view key, const std::optional<std::uint32_t>& value, const char* about);
    void point(std::string_view key, Vec2 value, const char* about, Need need = Need::Optional);
    void points(std::string_view key, const std::vector<Vec2>& value, std::size_t least, std::size_t most,
                const char* about, Need need = Need::Optional);
    void choice(std::string_view key, const std::string& value, const std::vector<std::string>& names,
                const char* about, Need need = Need::Optional);
    void nameOrIndex(std::string_view key, std::int32_t value, const std::vector<std::string>& names,
                     const char* about, Need need = Need::Optional);
    template <class Item, class Describe>
    void list(std::string_view key, std::vector<Item>&, std::size_t most, const char* about,
              Describe describe, Need need = Need::Optional) {
        Json items;
        FieldSchema child(items);
        Item item{};
        describe(child, item);
        set(key, {{"type", "array"}, {"maxItems", most}, {"items", std::move(items)}}, about, need);
    }
    template <class Describe>
    bool object(std::string_view key, const char* about, Describe describe, Need need = Need::Optional) {
        Json inner;
        FieldSchema child(inner);
        describe(child);
        set(key, std::move(inner), about, need);
        return true;
    }
    template <class Describe>
    bool objectOrKind(std::string_view key, const char* about, Describe describe,
                      Need need = Need::Optional) {
        Json inner;
        FieldSchema child(inner);
        describe(child);
        Json either = Json::array({inner["properties"]["kind"], inner});
        either[0].erase("description");
        set(key, {{"anyOf", std::move(either)}}, about, need);
        return true;
    }
    bool failed() const { return false; }  ///< Writing cannot fail.
    /// A key that is left out stands for no value.
    void eraseDefault(std::string_view key) { (*schema_)["properties"][key].erase("default"); }

    /// Sets the schema of a key directly.
    void set(std::string_view key, const Json& schema, std::string_view about, Need need);

private:
    static Json itemSchema(const NumberRange& range, bool whole);

    Json* schema_;
};

/// The text of a whole schema.
std::string titledSchema(const char* title, const Json& body);

}  // namespace muster
