// Archives of every kind of value, as bytes and back.
#include <doctest.h>

#include <cmath>
#include <limits>

#include "base/archive.h"
#include "muster/id.h"

using namespace muster;

namespace {

enum class Small : std::int8_t { Minus = -3 };
enum class Large : std::uint64_t { Most = 0xfedcba9876543210ull };
enum Plain { kOne = 1, kMany = 70000 };

template <class T>
[[gnu::noinline]] void writeTo(Writer& writer, T& value) {  // Inlined, g++ 12 warns of what cannot be.
    writer(value);
}

template <class T>
std::vector<std::uint8_t> encoded(T value) {
    Writer writer;
    writeTo(writer, value);
    return writer.take();
}

/// Reads back what it writes, and writes the same again.
template <class T>
T roundTrip(T value) {
    const auto bytes = encoded(value);
    Reader reader(bytes);
    T back{};
    reader(back);
    CHECK(reader.ok());
    CHECK(reader.remaining() == 0);
    CHECK(encoded(back) == bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Reader torn{std::span<const std::uint8_t>(bytes).first(size)};
        T rest{};
        torn(rest);
        CHECK_FALSE(torn.ok());
    }
    return back;
}

template <class T>
void roundTripLimits() {
    for (const T value : {std::numeric_limits<T>::min(), std::numeric_limits<T>::lowest(), T{0}, T{1},
                          std::numeric_limits<T>::max()}) {
        CHECK(roundTrip(value) == value);
        CHECK(encoded(value).size() == sizeof(T));
    }
}

struct Node {
    std::string name;
    std::vector<Node> children;
    std::optional<std::vector<Vec2>> points;
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, children, points);
    }
    friend bool operator==(const Node&, const Node&) = default;
};

/// Refuses what it reads where the number is odd.
struct Even {
    std::int32_t number = 0;
    template <class Archive>
    void visit(Archive& archive) {
        archive(number);
        if constexpr (Archive::kReading) {
            if (number % 2 != 0) archive.fail();
        }
    }
};

}  // namespace

TEST_CASE("numbers of every width come back, at their limits too") {
    roundTripLimits<std::int8_t>();
    roundTripLimits<std::uint8_t>();
    roundTripLimits<std::int16_t>();
    roundTripLimits<std::uint16_t>();
    roundTripLimits<std::int32_t>();
    roundTripLimits<std::uint32_t>();
    roundTripLimits<std::int64_t>();
    roundTripLimits<std::uint64_t>();
    roundTripLimits<float>();
    roundTripLimits<double>();
    CHECK(roundTrip(true));
    CHECK_FALSE(roundTrip(false));
    CHECK(roundTrip(Small::Minus) == Small::Minus);
    CHECK(roundTrip(Large::Most) == Large::Most);
    CHECK(roundTrip(kMany) == kMany);
}

TEST_CASE("numbers that are none come back bit for bit") {
    CHECK(std::isnan(roundTrip(std::numeric_limits<double>::quiet_NaN())));
    CHECK(roundTrip(-std::numeric_limits<double>::infinity()) == -INFINITY);
    CHECK(std::signbit(roundTrip(-0.0)));
    CHECK(roundTrip(std::numeric_limits<float>::denorm_min()) == std::numeric_limits<float>::denorm_min());
}

TEST_CASE("the bytes are little-endian with lengths of 32 bits") {
    CHECK(encoded(std::uint32_t{0x01020304}) == std::vector<std::uint8_t>{4, 3, 2, 1});
    CHECK(encoded(std::string("hi")) == std::vector<std::uint8_t>{2, 0, 0, 0, 'h', 'i'});
    CHECK(encoded(std::vector<std::int16_t>{-2}) == std::vector<std::uint8_t>{1, 0, 0, 0, 0xfe, 0xff});
    CHECK(encoded(true) == std::vector<std::uint8_t>{1});
    CHECK(encoded(1.0) == std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0xf0, 0x3f});
    CHECK(encoded(std::optional<std::uint8_t>{9}) == std::vector<std::uint8_t>{1, 9});
    CHECK(encoded(std::optional<std::uint8_t>{}) == std::vector<std::uint8_t>{0});
    CHECK(encoded(std::array<std::uint8_t, 3>{1, 2, 3}) == std::vector<std::uint8_t>{1, 2, 3});
    CHECK(encoded(GroupId{258}) == std::vector<std::uint8_t>{2, 1, 0, 0});
}

TEST_CASE("containers in containers come back") {
    const std::string odd("a\0b\xff", 4);
    CHECK(roundTrip(odd) == odd);
    CHECK(roundTrip(std::vector<std::string>{"", odd, "c"}) == std::vector<std::string>{"", odd, "c"});
    using Lists = std::vector<std::vector<double>>;
    CHECK(roundTrip(Lists{{}, {1, 2}, {3}}) == Lists{{}, {1, 2}, {3}});
    CHECK(roundTrip(std::vector<Vec2>{{1, 2}, {-3, 4}}) == std::vector<Vec2>{{1, 2}, {-3, 4}});
    using Pairs = std::array<std::vector<std::int32_t>, 2>;
    CHECK(roundTrip(Pairs{{{1}, {2, 3}}}) == Pairs{{{1}, {2, 3}}});
    using Maybes = std::vector<std::optional<std::string>>;
    CHECK(roundTrip(Maybes{{}, "x", {}}) == Maybes{{}, "x", {}});
    const Node tree{"root", {{"leaf", {}, {}}, {"twig", {{"bud", {}, {}}}, std::vector<Vec2>{{1, 1}}}}, {}};
    CHECK(roundTrip(tree) == tree);
}

TEST_CASE("reading replaces what stood there before") {
    const auto bytes = encoded(Node{"new", {}, {}});
    Node node{"old", {{"child", {}, {}}}, std::vector<Vec2>{{1, 2}}};
    Reader reader(bytes);
    reader(node);
    CHECK(node == Node{"new", {}, {}});
}

TEST_CASE("flags other than 0 and 1 are refused, as is what a type itself refuses") {
    const std::vector<std::uint8_t> two{2, 0, 0, 0, 0};
    bool flag = false;
    Reader flags(two);
    flags(flag);
    CHECK_FALSE(flags.ok());
    std::optional<std::uint8_t> maybe;
    Reader maybes(two);
    maybes(maybe);
    CHECK_FALSE(maybes.ok());
    CHECK_FALSE(maybe.has_value());
    const auto odd = encoded(std::vector<std::int32_t>{2, 3, 4});
    std::vector<Even> evens;
    Reader reader(odd);
    reader(evens);
    CHECK_FALSE(reader.ok());
    CHECK(evens.size() == 2);  // It stops where it fails.
}

TEST_CASE("after a failure everything reads as zero") {
    const std::vector<std::uint8_t> bytes(3, 0xff);
    Reader reader(bytes);
    std::uint32_t number = 7;
    std::uint8_t byte = 7;
    Vec2 point{7, 7};
    std::string text = "seven";
    reader(number, byte, point, text);
    CHECK_FALSE(reader.ok());
    CHECK(number == 0);
    CHECK(byte == 0);  // Its bytes are there, but the reader has lost its way.
    CHECK(point == Vec2{0, 0});
    CHECK(text.empty());
}

TEST_CASE("a count of things without bytes to hold them ends the reading, not the memory") {
    for (const std::uint32_t count : {0xffffffffu, 0x10000000u, 5u}) {
        auto bytes = encoded(count);
        bytes.resize(8);
        std::vector<Node> nodes;
        Reader reader(bytes);
        reader(nodes);
        CHECK_FALSE(reader.ok());
        CHECK(nodes.size() <= 4);
    }
}
