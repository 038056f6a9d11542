// What descriptions of fields are made of: words of enumerations, ids, lists, and when a field is left out.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/generated/enumeration_words.h"
#include "engine/state/validation.h"
#include "files/scenario/fields.h"
#include "muster/id.h"

namespace muster {

inline constexpr NumberRange kId{0.0, 4294967295.0};
inline constexpr NumberRange kCoordinate{-1e6, 1e6, "m"};
inline constexpr NumberRange kAngle{-1e6, 1e6, "rad"};
inline constexpr NumberRange kTime{0.0, 1e9, "s"};

/// A value of an enumeration, as one of its words.
template <class Visitor, class Value, std::size_t N>
void describeWord(Visitor& v, const char* key, Value& value, const std::array<const char*, N>& words,
                  const char* about, Need need = Need::Optional) {
    const std::vector<std::string> names(words.begin(), words.end());
    std::string word = names[static_cast<std::size_t>(value)];
    v.choice(key, word, names, about, need);
    if constexpr (Visitor::kReading) {
        for (std::size_t i = 0; i < N; ++i)
            if (names[i] == word) value = static_cast<Value>(i);
    }
}

/// The same for a value that may be none, which is left out.
template <class Visitor, class Value, std::size_t N>
void describeWord(Visitor& v, const char* key, std::optional<Value>& value,
                  const std::array<const char*, N>& words, const char* about) {
    if constexpr (Visitor::kReading && !Visitor::kSchema) {
        if (!v.has(key)) return;
    }
    if (!Visitor::kReading && !Visitor::kSchema && !value) return;
    Value word = value.value_or(Value{});
    describeWord(v, key, word, words, about);
    if constexpr (Visitor::kReading) value = word;
}

/// True where a field takes part: in files it is read wherever it stands, and written where it says
/// something.
template <class Visitor>
bool takesPart(bool says) {
    return Visitor::kReading || Visitor::kSchema || says;
}

/// True for numbers that differ in any bit from 0.
inline bool isSet(double value) {
    return value != 0.0 || std::signbit(value);
}

/// True for points that differ in any bit from (0, 0).
inline bool isSet(Vec2 p) {
    return isSet(p.x) || isSet(p.y);
}

/// A list of ids.
template <class Visitor, class Tag>
void describeIds(Visitor& v, const char* key, std::vector<Id<Tag>>& list, std::size_t most, const char* about,
                 Need need = Need::Optional) {
    std::vector<std::uint32_t> numbers;
    for (const Id<Tag> id : list) numbers.push_back(id.value);
    v.numbers(key, numbers, kId, most, about, need);
    list.clear();
    for (const std::uint32_t number : numbers) list.push_back({number});
}

/// A list of definitions.
template <class Visitor, class Item>
void describeList(Visitor& v, const char* key, std::vector<Item>& items, std::size_t most, const char* about,
                  Need need = Need::Optional) {
    v.list(
        key, items, most, about, [](auto& inner, Item& item) { describe(inner, item); }, need);
}

/// A definition in an object of its own.
template <class Visitor, class Definition>
void describeObject(Visitor& v, const char* key, Definition& d, const char* about) {
    v.object(key, about, [&](auto& inner) { describe(inner, d); });
}

}  // namespace muster
