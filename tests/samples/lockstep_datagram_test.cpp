// Datagrams of the lockstep sample: what is written is read, and nothing else is.
#include <doctest.h>

#include "lockstep/datagram.h"
#include "lockstep/lockstep_random.h"

using namespace lockstep;
using muster::Command;
using muster::StatusCode;

namespace {

constexpr std::uint32_t kPlayer = 1;

Datagram busyDatagram() {
    Datagram datagram;
    datagram.now = 1234;
    datagram.ahead = -3;
    datagram.received = 1230;
    datagram.confirmed = 1228;
    datagram.firstHash = 1227;
    datagram.hashes = {0x0123456789abcdefu, ~0ull};
    datagram.firstInput = 1232;
    datagram.inputs.resize(5);
    const muster::Vec2 corner{-1.5, 2.0};
    datagram.inputs[1] = {
        Command{1233, kPlayer, 7, muster::Touch{muster::TouchPhase::Down, 1, corner, 20.5, {2}}},
        Command{1233, kPlayer, 8, muster::GiveOrder{{2}, {}, 0, muster::Order::go(corner)}}};
    datagram.inputs[4] = {Command{1236, kPlayer, 9, muster::TransferCharacters{{3, 5, 8}, {}}}};
    return datagram;
}

/// The checksum once more, from its definition (FNV-1a, 64 bits).
void seal(Bytes& bytes) {
    std::uint64_t sum = 14695981039346656037u;
    for (std::size_t i = 0; i + 8 < bytes.size(); ++i) {
        sum ^= bytes[i];
        sum *= 1099511628211u;
    }
    for (std::size_t i = 0; i < 8; ++i) bytes[bytes.size() - 8 + i] = static_cast<std::uint8_t>(sum >> 8 * i);
}

}  // namespace

TEST_CASE("a datagram comes back as it was written") {
    const Datagram sent = busyDatagram();
    const Bytes bytes = encode(sent);
    const auto read = decode(bytes, kPlayer);
    REQUIRE(read.ok());
    CHECK(read->now == sent.now);
    CHECK(read->ahead == sent.ahead);
    CHECK(read->received == sent.received);
    CHECK(read->confirmed == sent.confirmed);
    CHECK(read->firstHash == sent.firstHash);
    CHECK(read->hashes == sent.hashes);
    CHECK(read->firstInput == sent.firstInput);
    REQUIRE(read->inputs.size() == 5);
    REQUIRE(read->inputs[1].size() == 2);
    CHECK(std::get<muster::Touch>(read->inputs[1][0].body).position == muster::Vec2{-1.5, 2.0});
    CHECK(read->inputs[1][1].sequence == 8);
    CHECK(std::get<muster::TransferCharacters>(read->inputs[4][0].body).ids ==
          std::vector<std::uint32_t>{3, 5, 8});
    CHECK(encode(*read) == bytes);
}

TEST_CASE("inputs that do not fit are left out, the latest first") {
    Datagram datagram;
    datagram.firstInput = 50;
    muster::TransferCharacters many;
    for (std::uint32_t id = 1; id <= 100; ++id) many.ids.push_back(id);
    for (std::uint32_t step = 50; step < 60; ++step)
        datagram.inputs.push_back({Command{step, 0, step, many}});
    const Bytes bytes = encode(datagram);
    CHECK(bytes.size() <= kMostBytes);
    const auto read = decode(bytes, 0);
    REQUIRE(read.ok());
    // Of 1200 bytes each takes a little more than 400.
    REQUIRE(read->inputs.size() == 2);
    CHECK(read->inputs[0][0].step == 50);
    CHECK(read->inputs[1][0].step == 51);
    CHECK(encodedSize(datagram.inputs[0]) > 400);
}

TEST_CASE("whatever is cut short, damaged or of another player is refused") {
    const Bytes bytes = encode(busyDatagram());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        CHECK(decode(ByteSpan(bytes).first(size), kPlayer).status().code() == StatusCode::ParseError);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        Bytes damaged = bytes;
        damaged[i] ^= 0x40;
        CHECK(decode(damaged, kPlayer).status().code() == StatusCode::ParseError);
    }
    CHECK(decode(bytes, 0).status().message() == "a datagram holds a command of another step or player");
    CHECK(decode(Bytes(5000), kPlayer).status().message() == "a datagram is too long");
}

TEST_CASE("forged datagrams with a right checksum are read as what encode() writes, or refused") {
    Random random(11);
    const Bytes bytes = encode(busyDatagram());
    int accepted = 0;
    for (int round = 0; round < 20'000; ++round) {
        Bytes forged = bytes;
        if (random.chance(0.3)) forged.resize(8 + random.below(static_cast<std::uint32_t>(bytes.size()) - 8));
        for (std::uint32_t k = 1 + random.below(4); k > 0; --k)
            forged[random.below(static_cast<std::uint32_t>(forged.size()))] = static_cast<std::uint8_t>(
                random.below(256));
        seal(forged);
        const auto read = decode(forged, kPlayer);
        if (!read.ok()) {
            CHECK(read.status().code() == StatusCode::ParseError);
            continue;
        }
        ++accepted;
        for (const Input& input : read->inputs)
            for (const Command& command : input) CHECK(muster::validateCommand(command).ok());
    }
    // Some changes only make other numbers of it.
    CHECK(accepted > 100);
    CHECK(accepted < 15'000);
}
