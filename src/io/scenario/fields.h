// One description of each file object serves loading, saving and the schema.
//
// describe functions (describe.h) call the same methods on each of three visitors: FieldReader takes values
// out of JSON, FieldWriter puts them in, FieldSchema writes down what is allowed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"
#include "muster/formation.h"
#include "muster/vec2.h"

namespace muster {

/// What a number may be.
struct NumberRange {
    double minimum = 0.0;
    double maximum = 0.0;
    std::string_view unit = "1";
    bool whole = false;  ///< Only whole numbers.
};

/// Whether a key must be there.
enum class Need { Optional, Required };

/// Takes the fields of one JSON object. The first failure is kept; after it nothing is read.
class FieldReader {
public:
    /// `path` is the JSON path of `object`; `failure` receives the first sentence.
    FieldReader(const Json& object, std::string path, std::string& failure);

    static constexpr bool kReading = true;  ///< Values are being read.
    static constexpr bool kSchema = false;  ///< Not a schema.

    /// `fallback` is what the text is where the key is left out.
    void text(std::string_view key, std::string& value, const char* about, Need need = Need::Optional,
              std::string_view fallback = {});
    void number(std::string_view key, double& value, const NumberRange& range, std::string_view about,
                Need need = Need::Optional);
    /// A number that may be left out: the value stays negative then.
    void optionalNumber(std::string_view key, double& value, const NumberRange& range, const char* about) {
        number(key, value, range, about);
    }
    template <class Whole>
    void whole(std::string_view key, Whole& value, const NumberRange& range, const char*,
               Need need = Need::Optional) {
        double wide = static_cast<double>(value);
        NumberRange bounds = range;
        bounds.whole = true;
        const Json* found = find(key, need);
        if (found == nullptr || !readNumber(*found, key, bounds, wide)) return;
        value = found->isWhole() ? found->whole<Whole>() : static_cast<Whole>(wide);
    }
    void flag(std::string_view key, bool& value, const char* about);
    void point(std::string_view key, Vec2& value, const char* about, Need need = Need::Optional);
    void points(std::string_view key, std::vector<Vec2>& value, std::size_t least, std::size_t most,
                const char* about, Need need = Need::Optional);
    void choice(std::string_view key, std::string& value, const std::vector<std::string>& names,
                const char* about, Need need = Need::Optional);
    /// A word out of a list, or its number.
    void nameOrIndex(std::string_view key, std::int32_t& value, const std::vector<std::string>& names,
                     const char* about, Need need = Need::Optional);
    /// Objects; `describe(visitor, item)` is called for each.
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
    /// One object inside; `describe(visitor)` is called where it is there. True where it was.
    template <class Describe>
    bool object(std::string_view key, const char*, Describe describe, Need need = Need::Optional) {
        const Json* found = find(key, need);
        if (found == nullptr) return false;
        FieldReader child(*found, pathOf(key), *failure_);
        describe(child);
        child.finish();
        return true;
    }
    /// As object(), but a bare word stands for an object with only that `kind`.
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

    /// The value of a key, or null (a failure where it is required).
    const Json* find(std::string_view key, Need need = Need::Optional);
    /// The same, and an array of at most `most`.
    const Json* findArray(std::string_view key, std::size_t most, Need need);
    /// Notes a failure at a key of this object (empty: at the object itself).
    void fail(std::string_view key, const std::string& found, const std::string& expected);
    /// True once anything failed.
    bool failed() const { return !failure_->empty(); }
    /// Complains about keys that nobody asked for.
    void finish();

private:
    std::string pathOf(std::string_view key) const;
    bool readNumber(const Json& value, std::string_view key, const NumberRange& range, double& number);
    bool readPoint(const Json& value, const std::string& path, Vec2& point);
    void failAt(const std::string& path, const std::string& found, const std::string& expected);

    const Json* object_;
    std::string path_;
    std::string* failure_;
    std::vector<std::string_view> known_;  // Keys asked for.
};

/// Puts fields into one JSON object. Empty lists, negative optional numbers, and texts that are empty where
/// leaving them out makes them so, are left out.
class FieldWriter {
public:
    explicit FieldWriter(Json& object) : object_(&object) { *object_ = Json::object(); }

    static constexpr bool kReading = false;  ///< Nothing is read.
    static constexpr bool kSchema = false;   ///< Not a schema.

    void text(std::string_view key, const std::string& value, const char* about, Need need = Need::Optional,
              std::string_view fallback = {});
    void number(std::string_view key, double value, const NumberRange& range, std::string_view about,
                Need need = Need::Optional);
    void optionalNumber(std::string_view key, double value, const NumberRange& range, const char* about);
    template <class Whole>
    void whole(std::string_view key, Whole value, const NumberRange&, const char*, Need = Need::Optional) {
        set(key, value);
    }
    void flag(std::string_view key, bool value, const char* about);
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
    bool object(std::string_view key, const char*, Describe describe, Need = Need::Optional) {
        Json inner;
        FieldWriter child(inner);
        describe(child);
        if (!inner.empty()) set(key, std::move(inner));
        return true;
    }
    template <class Describe>
    bool objectOrKind(std::string_view key, const char* about, Describe describe,
                      Need need = Need::Optional) {
        return object(key, about, describe, need);
    }
    bool failed() const { return false; }  ///< Writing cannot fail.

    /// Sets a key outright.
    template <class Value>
    void set(std::string_view key, Value&& value) {
        (*object_)[key] = Json(std::forward<Value>(value));
    }

private:
    Json* object_;
};

/// Writes down what one JSON object may hold. Defaults are the values given.
class FieldSchema {
public:
    explicit FieldSchema(Json& schema);

    static constexpr bool kReading = false;  ///< Nothing is read.
    static constexpr bool kSchema = true;    ///< A schema.

    void text(std::string_view key, const std::string& value, const char* about, Need need = Need::Optional,
              std::string_view fallback = {});
    void number(std::string_view key, double value, const NumberRange& range, std::string_view about,
                Need need = Need::Optional);
    void optionalNumber(std::string_view key, double value, const NumberRange& range, const char* about);
    template <class Whole>
    void whole(std::string_view key, Whole value, const NumberRange& range, const char* about,
               Need need = Need::Optional) {
        NumberRange bounds = range;
        bounds.whole = true;
        number(key, static_cast<double>(value), bounds, about, need);
    }
    void flag(std::string_view key, bool value, const char* about);
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

    /// Sets the schema of a key outright.
    void set(std::string_view key, Json schema, std::string_view about, Need need);

private:
    Json* schema_;
};

}  // namespace muster
