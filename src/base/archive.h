// Archives: one description of a type serves saving, loading and hashing.
//
// A type takes part by a member
//     template <class Archive> void visit(Archive& archive) { archive(first_, second_); }
// The order of the members is the format. Numbers are little-endian, lengths have 32 bits.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/as_mutable.h"
#include "base/hash.h"
#include "muster/vec2.h"

namespace muster {

/// Numbers, flags and enumerations, which are written as their bytes.
template <class T>
concept ArchiveScalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Version of the commands and definitions that takes hold. Fields that came later are archived by since().
inline constexpr std::uint32_t kArchiveVersion = 10;

/// Appends values to a byte vector.
class Writer {
public:
    static constexpr bool kReading = false;  ///< Types may branch on this.

    Writer() = default;
    /// `forHash`: the bytes are to be hashed, not to be read. As in a Hasher, missing values of
    /// optionalSince() are left out.
    explicit Writer(bool forHash) : forHash_(forHash) {}

    /// Writes each value in turn.
    template <class... T>
    void operator()(T&... values) {
        (write(values), ...);
    }
    /// Writes values that the format has since a version.
    template <class... T>
    void since(std::uint32_t /*version*/, T&... values) {
        (write(values), ...);
    }
    /// Writes a value that the format has since a version, and that may be none.
    template <class T>
    void optionalSince(std::uint32_t /*version*/, std::optional<T>& value) {
        if (value || !forHash_) write(value);
    }
    /// The same of a flag: false stands for none.
    void optionalSince(std::uint32_t /*version*/, bool& value) {
        if (value || !forHash_) write(value);
    }
    /// The bytes so far.
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }
    /// Moves the bytes out.
    std::vector<std::uint8_t> take() { return std::move(bytes_); }
    /// Empties the buffer and keeps its memory.
    void clear() { bytes_.clear(); }

private:
    void raw(const void* data, std::size_t size) {
        const auto* from = static_cast<const std::uint8_t*>(data);
        bytes_.insert(bytes_.end(), from, from + size);
    }
    template <class T>
    void write(T& value);
    void length(std::size_t count) {
        const auto n = static_cast<std::uint32_t>(count);
        raw(&n, 4);
    }

    std::vector<std::uint8_t> bytes_;
    bool forHash_ = false;
};

/// Reads values from bytes. After an overrun or an impossible length ok() is false, and all values read are
/// zero or empty.
class Reader {
public:
    static constexpr bool kReading = true;  ///< Types may branch on this.

    /// Reads `bytes`, which must outlive it and are of the given version of the format.
    explicit Reader(std::span<const std::uint8_t> bytes, std::uint32_t version = kArchiveVersion)
        : bytes_(bytes), version_(version) {}

    /// Reads each value in turn.
    template <class... T>
    void operator()(T&... values) {
        (read(values), ...);
    }
    /// Reads values that the format has since a version; leaves them as they are where the bytes are older.
    template <class... T>
    void since(std::uint32_t version, T&... values) {
        if (version_ >= version) (read(values), ...);
    }
    /// Reads a value that the format has since a version, and that may be none.
    template <class T>
    void optionalSince(std::uint32_t version, std::optional<T>& value) {
        if (version_ >= version) read(value);
    }
    void optionalSince(std::uint32_t version, bool& value) {
        since(version, value);
    }  ///< The same of a flag.
    /// False after any error.
    bool ok() const { return ok_; }
    /// Reports an error: for types that find a value out of range.
    void fail() { ok_ = false; }
    /// Bytes not read yet.
    std::size_t remaining() const { return bytes_.size() - position_; }

private:
    void raw(void* data, std::size_t size) {
        if (!ok_ || size > remaining()) {
            ok_ = false;
            if (size > 0) std::memset(data, 0, size);
            return;
        }
        if (size == 0) return;  // An empty vector has no address.
        std::memcpy(data, bytes_.data() + position_, size);
        position_ += size;
    }
    template <class T>
    void read(T& value);
    std::uint32_t length(std::size_t bytesEach) {
        std::uint32_t n = 0;
        raw(&n, 4);
        if (ok_ && static_cast<std::uint64_t>(n) * bytesEach > remaining()) ok_ = false;
        return ok_ ? n : 0;
    }

    std::span<const std::uint8_t> bytes_;
    std::uint32_t version_;
    std::size_t position_ = 0;
    bool ok_ = true;
};

/// Hashes values.
class Hasher {
public:
    static constexpr bool kReading = false;  ///< Types may branch on this.

    /// Adds each value in turn.
    template <class... T>
    void operator()(T&... values) {
        (add(values), ...);
    }
    /// Adds values that the format has since a version.
    template <class... T>
    void since(std::uint32_t /*version*/, T&... values) {
        (add(values), ...);
    }
    /// Adds a value that the format has since a version. An empty one adds nothing, so that the hash is the
    /// same as without the value.
    template <class T>
    void optionalSince(std::uint32_t /*version*/, std::optional<T>& value) {
        if (value) add(value);
    }
    /// The same of a flag: false stands for none.
    void optionalSince(std::uint32_t /*version*/, bool& value) {
        if (value) add(value);
    }
    /// The hash so far.
    std::uint64_t value() const { return hash_.value(); }

private:
    template <class T>
    void add(T& value);

    Hash hash_;
};

namespace detail {
template <class T>
struct IsVector : std::false_type {};  // True for std::vector.
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};  // True for std::optional.
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsArray : std::false_type {};  // True for std::array.
template <class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};
}  // namespace detail

template <class T>
void Writer::write(T& value) {
    using Plain = std::remove_const_t<T>;
    if constexpr (std::is_same_v<Plain, bool>) {
        const std::uint8_t byte = value ? 1 : 0;
        raw(&byte, 1);
    } else if constexpr (ArchiveScalar<Plain>) {
        static_assert(!std::is_same_v<Plain, long double>);
        raw(&value, sizeof(value));
    } else if constexpr (std::is_same_v<Plain, Vec2>) {
        raw(&value, sizeof(Vec2));
    } else if constexpr (std::is_same_v<Plain, std::string>) {
        length(value.size());
        raw(value.data(), value.size());
    } else if constexpr (detail::IsVector<Plain>::value) {
        using Item = typename Plain::value_type;
        length(value.size());
        if constexpr (ArchiveScalar<Item> && !std::is_same_v<Item, bool>) {
            raw(value.data(), value.size() * sizeof(Item));
        } else if constexpr (std::is_same_v<Item, bool>) {
            static_assert(!std::is_same_v<Item, bool>, "use std::vector<std::uint8_t>");
        } else {
            for (auto& item : value) write(item);
        }
    } else if constexpr (detail::IsArray<Plain>::value) {
        for (auto& item : value) write(item);
    } else if constexpr (detail::IsOptional<Plain>::value) {
        const std::uint8_t present = value.has_value() ? 1 : 0;
        raw(&present, 1);
        if (value) write(*value);
    } else {
        asMutable(value).visit(*this);
    }
}

template <class T>
void Reader::read(T& value) {  // The inverse of Writer::write().
    if constexpr (std::is_same_v<T, bool>) {
        std::uint8_t byte = 0;
        raw(&byte, 1);
        if (byte > 1) ok_ = false;
        value = byte == 1;
    } else if constexpr (ArchiveScalar<T>) {
        raw(&value, sizeof(value));
    } else if constexpr (std::is_same_v<T, Vec2>) {
        raw(&value, sizeof(Vec2));
    } else if constexpr (std::is_same_v<T, std::string>) {
        value.resize(length(1));
        raw(value.data(), value.size());
    } else if constexpr (detail::IsVector<T>::value) {
        using Item = typename T::value_type;
        if constexpr (ArchiveScalar<Item>) {
            value.resize(length(sizeof(Item)));
            raw(value.data(), value.size() * sizeof(Item));
        } else {
            const std::uint32_t count = length(1);
            value.clear();
            for (std::uint32_t i = 0; i < count && ok_; ++i) read(value.emplace_back());
        }
    } else if constexpr (detail::IsArray<T>::value) {
        for (auto& item : value) read(item);
    } else if constexpr (detail::IsOptional<T>::value) {
        std::uint8_t present = 0;
        raw(&present, 1);
        value.reset();
        if (present == 1) read(value.emplace());
        if (present > 1) ok_ = false;
    } else {
        value.visit(*this);
    }
}

template <class T>
void Hasher::add(T& value) {  // The order is that of Writer::write().
    using Plain = std::remove_const_t<T>;
    if constexpr (std::is_same_v<Plain, bool> || std::is_same_v<Plain, double> ||
                  std::is_same_v<Plain, float> || std::is_same_v<Plain, std::string>) {
        hash_.add(value);
    } else if constexpr (ArchiveScalar<Plain>) {
        hash_.addWord(static_cast<std::uint64_t>(value));
    } else if constexpr (std::is_same_v<Plain, Vec2>) {
        hash_.add(value.x);
        hash_.add(value.y);
    } else if constexpr (detail::IsVector<Plain>::value) {
        hash_.add(static_cast<std::uint32_t>(value.size()));
        for (auto& item : value) add(item);
    } else if constexpr (detail::IsArray<Plain>::value) {
        for (auto& item : value) add(item);
    } else if constexpr (detail::IsOptional<Plain>::value) {
        hash_.add(value.has_value());
        if (value) add(*value);
    } else {
        asMutable(value).visit(*this);
    }
}

}  // namespace muster
