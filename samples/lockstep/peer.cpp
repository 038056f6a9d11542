#include "peer.h"

#include <algorithm>

namespace lockstep {
namespace {

constexpr std::int32_t kLeads = 32;  // Datagrams over which the lead is averaged.

}  // namespace

Peer::Peer(muster::World world, std::uint32_t number, std::uint32_t steps, Player player)
    : world_(std::move(world)),
      number_(number),
      other_(1 - number),
      steps_(steps),
      player_(std::move(player)) {
    // Before the first decision takes effect there is nothing to be told.
    for (std::uint32_t step = 0; step < kInputDelay; ++step) {
        world_.give(number_, {});
        world_.give(other_, {});
    }
    acknowledged_ = kInputDelay;
}

bool Peer::acceptable(const Datagram& datagram) const {
    // It cannot have what was never sent, nor know a state before its inputs.
    return datagram.received <= world_.known(number_) && datagram.confirmed <= world_.known(number_) &&
           datagram.firstInput <= world_.known(other_) && datagram.now <= world_.now() + kWindow;
}

void Peer::receive(ByteSpan bytes) {
    muster::Result<Datagram> read = decode(bytes, other_);
    if (!read.ok() || !acceptable(*read)) {
        ++counts_.refused;
        lastRefusal_ = read.ok() ? "a datagram speaks of steps that cannot be" : read.status().message();
        return;
    }
    Datagram& datagram = *read;
    acknowledged_ = std::max(acknowledged_, datagram.received);
    otherConfirmed_ = std::max(otherConfirmed_, datagram.confirmed);
    for (std::size_t i = 0; i < datagram.inputs.size(); ++i)
        if (datagram.firstInput + i == world_.known(other_))
            if (!world_.give(other_, std::move(datagram.inputs[i]))) break;
    for (std::size_t i = 0; i < datagram.hashes.size(); ++i) {
        const std::uint32_t step = datagram.firstHash + static_cast<std::uint32_t>(i);
        if (step > equalUpTo_ && step < world_.final() + kWindow)
            theirs_[step % kWindow] = {step, datagram.hashes[i]};
    }
    balance(datagram);
}

/// Both see the other late by the same delay; by how much more one of them does, so much it is ahead. It then
/// waits.
void Peer::balance(const Datagram& datagram) {
    if (datagram.now < otherNow_) return;  // An older datagram that came late.
    otherNow_ = datagram.now;
    ahead_ = static_cast<std::int32_t>(world_.now()) - static_cast<std::int32_t>(otherNow_);
    leadSum_ += ahead_ - std::clamp<std::int32_t>(datagram.ahead, -100, 100);
    if (++leads_ < kLeads) return;
    toWait_ = std::max(0, leadSum_ / (2 * kLeads));
    leadSum_ = leads_ = 0;
}

/// Asks the player, whose commands go to both worlds for the same later step.
void Peer::decide() {
    const std::uint32_t step = world_.known(number_);
    Input input;
    for (muster::CommandBody& body : player_(world_.world())) {
        input.push_back({step, number_, sequence_, std::move(body)});
        // What the engine would refuse, or no datagram can carry, is not sent at all.
        const bool fits = input.size() < 256 && encodedSize(input) <= kMostInputBytes;
        if (fits && muster::validateCommand(input.back()).ok())
            ++sequence_;
        else
            input.pop_back();
    }
    sent_[step % kWindow] = input;
    world_.give(number_, std::move(input));
}

muster::Status Peer::compareHashes() {
    for (std::uint32_t step = equalUpTo_ + 1; step <= world_.final(); ++step) {
        const Hash& theirs = theirs_[step % kWindow];
        if (theirs.step != step) continue;
        if (theirs.value != world_.hash(step))
            return {muster::StatusCode::Corrupt,
                    "the states of the two peers differ after step " + std::to_string(step)};
        ++counts_.compared;
        equalUpTo_ = step;
    }
    return {};
}

muster::Status Peer::tick() {
    if (muster::Status status = world_.correct(); !status.ok()) return status;
    if (muster::Status status = compareHashes(); !status.ok()) return status;
    if (world_.now() == steps_) return {};
    if (!world_.mayStep()) {
        ++counts_.stalls;
        return {};
    }
    if (toWait_ > 0) {
        --toWait_;
        ++counts_.waits;
        return {};
    }
    decide();
    return world_.step();
}

Bytes Peer::datagram() const {
    Datagram datagram;
    datagram.now = world_.now();
    datagram.ahead = ahead_;
    datagram.received = world_.known(other_);
    datagram.confirmed = world_.final();
    const std::uint32_t hashes = std::min<std::uint32_t>(kMostHashes, world_.final());
    datagram.firstHash = world_.final() - hashes + 1;
    for (std::uint32_t i = 0; i < hashes; ++i) datagram.hashes.push_back(world_.hash(datagram.firstHash + i));
    datagram.firstInput = acknowledged_;
    const std::uint32_t end = std::min<std::uint32_t>(world_.known(number_), acknowledged_ + kMostInputs);
    for (std::uint32_t step = acknowledged_; step < end; ++step)
        datagram.inputs.push_back(sent_[step % kWindow]);
    return encode(datagram);
}

}  // namespace lockstep
