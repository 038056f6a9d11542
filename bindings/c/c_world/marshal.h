// Both directions between structs of the C API and those of the engine. A function `fields(m, c, p)` per pair
// lists the fields once; `m` is a FromC, which reads `c`, or a ToC, which fills it.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "bindings/c/c_world/generated/struct_versions.h"
#include "bindings/c/c_world/memory.h"
#include "muster/id.h"
#include "muster/status.h"

namespace muster::c_api {

/// The C struct and the engine's struct, as a direction sees them.
template <class M, class T>
using C = typename M::template CSide<T>;
template <class M, class T>
using P = typename M::template EngineSide<T>;

/// Reads C structs. The first fault is kept; what follows it is not read.
class FromC {
public:
    template <class T>
    using CSide = const T;
    template <class T>
    using EngineSide = T;
    static constexpr bool kReads = true;

    const Status& status() const { return status_; }
    /// Keeps the first fault.
    void fail(const std::string& sentence) {
        if (status_.ok()) status_ = invalidArgument(path_ + sentence);
    }
    void fail(const Status& status) {
        if (status_.ok()) status_ = Status(status.code(), path_ + status.message());
    }

    template <class T>
    void version(const std::uint32_t& found) {
        if (found != StructVersion<T>::kValue)
            fail("found structVersion " + std::to_string(found) + ", expected " +
                 std::to_string(StructVersion<T>::kValue) + " as " + StructVersion<T>::kMaker + "() sets it");
    }
    template <class A, class B>
    void plain(const A& c, B& p) {
        static_assert(sizeof(A) == sizeof(B) && std::is_trivially_copyable_v<B>);
        if constexpr (std::is_same_v<B, bool>) {
            unsigned char byte = 0;
            std::memcpy(&byte, &c, 1);
            p = byte != 0;
        } else {
            std::memcpy(static_cast<void*>(&p), &c, sizeof(B));
        }
    }
    template <class Tag>
    void id(const std::uint32_t& c, Id<Tag>& p) {
        p.value = c;
    }
    template <class Enum>
    void choice(const std::uint8_t& c, Enum& p, Enum last, const char* name) {
        if (c > static_cast<std::uint8_t>(last))
            return fail(std::string(name) + ": found " + std::to_string(c) + ", expected 0 to " +
                        std::to_string(static_cast<int>(last)));
        p = static_cast<Enum>(c);
    }
    void text(const char* c, std::string& p) { p = c == nullptr ? "" : c; }
    template <class A, class B>
    void optional(const bool& has, const A& c, std::optional<B>& p) {
        bool given = false;
        plain(has, given);
        p.reset();
        if (given) p = c;
    }
    template <class Enum>
    void optionalChoice(const bool& has, const std::uint8_t& c, std::optional<Enum>& p, Enum last,
                        const char* name) {
        bool given = false;
        plain(has, given);
        p.reset();
        if (given) choice(c, p.emplace(), last, name);
    }
    /// True where a value that may be left out is given, which is then read into `p`.
    template <class B>
    bool given(const bool& has, std::optional<B>& p) {
        bool is = false;
        plain(has, is);
        p.reset();
        if (is) p.emplace();
        return is;
    }
    template <class A, class Container>
    void list(const A* c, std::int32_t count, Container& p, const char* name) {
        using B = typename Container::value_type;
        static_assert(sizeof(A) == sizeof(B) && std::is_trivially_copyable_v<B>);
        p.clear();
        if (!counts(c, count, name) || count == 0) return;
        p.resize(static_cast<std::size_t>(count));
        std::memcpy(static_cast<void*>(p.data()), c, p.size() * sizeof(B));
    }
    template <class A, class B>
    void items(const A* c, std::int32_t count, std::vector<B>& p, const char* name) {
        p.clear();
        if (!counts(c, count, name)) return;
        for (std::int32_t i = 0; i < count && status_.ok(); ++i)
            part(c[i], p.emplace_back(), (std::string(name) + "[" + std::to_string(i) + "]").c_str());
    }
    template <class A, class B>
    void part(const A& c, B& p, const char* name) {
        if (!status_.ok()) return;
        const std::size_t length = path_.size();
        path_ += std::string(name) + ": ";
        fields(*this, c, p);
        path_.resize(length);
    }
    template <class A, class B>
    void optionalPart(const A* c, std::optional<B>& p, const char* name) {
        p.reset();
        if (c != nullptr) part(*c, p.emplace(), name);
    }

private:
    bool counts(const void* data, std::int32_t count, const char* name) {
        if (!status_.ok()) return false;
        if (count < 0)
            fail(std::string(name) + ": found a count of " + std::to_string(count) + ", expected 0 or more");
        else if (count > 0 && data == nullptr)
            fail(std::string(name) + ": found null for " + std::to_string(count) +
                 " entries, expected a pointer");
        return status_.ok();
    }

    Status status_;
    std::string path_;
};

/// Fills C structs. They point into the engine's, and into an arena where the layouts differ.
class ToC {
public:
    template <class T>
    using CSide = T;
    template <class T>
    using EngineSide = const T;
    static constexpr bool kReads = false;

    explicit ToC(Arena& arena) : arena_(arena) {}
    Arena& arena() { return arena_; }

    template <class T>
    void version(std::uint32_t& c) {
        c = StructVersion<T>::kValue;
    }
    template <class A, class B>
    void plain(A& c, const B& p) {
        static_assert(sizeof(A) == sizeof(B) && std::is_trivially_copyable_v<A>);
        std::memcpy(&c, &p, sizeof(A));
    }
    template <class Tag>
    void id(std::uint32_t& c, const Id<Tag>& p) {
        c = p.value;
    }
    template <class Enum>
    void choice(std::uint8_t& c, const Enum& p, Enum, const char*) {
        c = static_cast<std::uint8_t>(p);
    }
    void text(const char*& c, const std::string& p) { c = p.c_str(); }
    /// The name of a definition, which ends with a zero byte.
    void text(const char*& c, std::string_view p) { c = p.data(); }
    template <class A, class B>
    void optional(bool& has, A& c, const std::optional<B>& p) {
        has = p.has_value();
        c = p.value_or(B{});
    }
    template <class Enum>
    void optionalChoice(bool& has, std::uint8_t& c, const std::optional<Enum>& p, Enum, const char*) {
        has = p.has_value();
        c = static_cast<std::uint8_t>(p.value_or(Enum{}));
    }
    template <class B>
    bool given(bool& has, const std::optional<B>& p) {
        has = p.has_value();
        return has;
    }
    template <class A, class Container>
    void list(const A*& c, std::int32_t& count, const Container& p, const char*) {
        using B = typename Container::value_type;
        static_assert(sizeof(A) == sizeof(B));
        static_assert(alignof(A) == alignof(B));
        count = static_cast<std::int32_t>(p.size());
        c = p.empty() ? nullptr : reinterpret_cast<const A*>(p.data());
    }
    template <class A, class Container>
    void items(const A*& c, std::int32_t& count, const Container& p, const char* name) {
        count = static_cast<std::int32_t>(p.size());
        A* const made = arena_.make<A>(p.size());
        for (std::size_t i = 0; i < p.size(); ++i) part(made[i], p[i], name);
        c = made;
    }
    template <class A, class B>
    void part(A& c, const B& p, const char*) {
        fields(*this, c, p);
    }
    template <class A, class B>
    void optionalPart(const A*& c, const std::optional<B>& p, const char* name) {
        c = nullptr;
        if (!p) return;
        A* const made = arena_.make<A>(1);
        part(*made, *p, name);
        c = made;
    }

private:
    Arena& arena_;
};

/// Reads one C struct; `name` is what messages call it.
template <class A, class B>
Status readC(const A* c, B& p, const char* name) {
    if (c == nullptr) return invalidArgument(std::string(name) + ": found null, expected a pointer");
    FromC reader;
    reader.part(*c, p, name);
    return reader.status();
}
/// A C struct that points to the engine's, and to the arena.
template <class A, class B>
A writeC(const B& p, Arena& arena) {
    A made{};
    ToC writer(arena);
    writer.part(made, p, "");
    return made;
}
/// An array of C structs in the arena.
template <class A, class Container>
const A* writeAll(const Container& p, Arena& arena, std::int32_t& count) {
    const A* made = nullptr;
    ToC writer(arena);
    writer.items(made, count, p, "");
    return made;
}

}  // namespace muster::c_api
