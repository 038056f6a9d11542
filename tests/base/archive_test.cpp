#include "base/archive.h"

#include <doctest.h>

#include "base/random.h"

using namespace muster;

namespace {

enum class Colour : std::uint8_t { Red, Green };

struct Inner {
    std::int32_t number = 0;
    std::vector<Vec2> points;
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, points);
    }
};

struct Outer {
    double value = 0.0;
    bool flag = false;
    Colour colour = Colour::Red;
    std::string text;
    std::vector<Inner> inner;
    std::array<float, 2> pair{};
    std::optional<std::uint64_t> maybe;
    template <class Archive>
    void visit(Archive& archive) {
        archive(value, flag, colour, text, inner, pair, maybe);
    }
};

Outer sample() {
    return {.value = 0.1,
            .flag = true,
            .colour = Colour::Green,
            .text = "places",
            .inner = {{1, {{1, 2}, {3, 4}}}, {-7, {}}},
            .pair = {1.5f, -2.0f},
            .maybe = 1ull << 60};
}

std::vector<std::uint8_t> archived(Outer o) {
    Writer writer;
    writer(o);
    return writer.take();
}

std::uint64_t hashOf(Outer o) {
    Hasher hasher;
    hasher(o);
    return hasher.value();
}

}  // namespace

TEST_CASE("what is written reads back, byte for byte the same again") {
    const auto bytes = archived(sample());
    Reader reader(bytes);
    Outer back;
    reader(back);
    CHECK(reader.ok());
    CHECK(reader.remaining() == 0);
    CHECK(back.text == "places");
    CHECK(back.inner[0].points[1] == Vec2{3, 4});
    CHECK(*back.maybe == 1ull << 60);
    CHECK(archived(back) == bytes);
    CHECK(hashOf(back) == hashOf(sample()));
}

TEST_CASE("any torn prefix is refused and never read beyond") {
    const auto bytes = archived(sample());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Reader reader(std::span<const std::uint8_t>(bytes).first(size));
        Outer back;
        reader(back);
        CHECK_FALSE(reader.ok());
    }
}

TEST_CASE("a length that cannot be true is refused before any memory is asked for") {
    std::vector<std::uint8_t> bytes(64, 0xff);
    Reader reader(bytes);
    std::vector<double> numbers;
    reader(numbers);
    CHECK_FALSE(reader.ok());
    CHECK(numbers.empty());
}

TEST_CASE("each member reaches the hash") {
    const std::uint64_t plain = hashOf(sample());
    const auto changed = [&](auto change) {
        Outer o = sample();
        change(o);
        return hashOf(o) != plain;
    };
    CHECK(changed([](Outer& o) { o.value = 0.2; }));
    CHECK(changed([](Outer& o) { o.flag = false; }));
    CHECK(changed([](Outer& o) { o.colour = Colour::Red; }));
    CHECK(changed([](Outer& o) { o.text = "place"; }));
    CHECK(changed([](Outer& o) { o.inner[1].number = 7; }));
    CHECK(changed([](Outer& o) { o.inner[0].points.pop_back(); }));
    CHECK(changed([](Outer& o) { o.maybe.reset(); }));
}

TEST_CASE("CRC-32 gives the published check value, in one piece or two") {
    const std::string text = "123456789";
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    CHECK(crc32(bytes) == 0xcbf43926u);
    CHECK(crc32(std::span(bytes).subspan(4), crc32(std::span(bytes).first(4))) == 0xcbf43926u);
}

TEST_CASE("both zeros hash alike") {
    Hash a;
    Hash b;
    a.add(0.0);
    b.add(-0.0);
    CHECK(a.value() == b.value());
    CHECK(toHex(0xabcull) == "0000000000000abc");
}

TEST_CASE("a random stream goes on from its saved state, and is even") {
    Random random(7);
    for (int i = 0; i < 10; ++i) random.next();
    Writer writer;
    writer(random);
    Reader reader(writer.bytes());
    Random copy;
    reader(copy);
    CHECK(copy.next() == random.next());
    double sum = 0.0;
    std::array<int, 6> counts{};
    for (int i = 0; i < 60000; ++i) {
        sum += random.uniform();
        ++counts[random.below(6)];
    }
    CHECK(sum / 60000 == doctest::Approx(0.5).epsilon(0.01));
    for (int count : counts) CHECK(count == doctest::Approx(10000).epsilon(0.05));
}
