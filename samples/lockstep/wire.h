// What carries the datagrams of a peer: the emulated network, a real UDP socket, and the pace.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

#include "lossy_link.h"
#include "udp.h"

namespace lockstep {

/// By the clock, a tick lasts a sixtieth of a second. Else both peers wait for each other in every tick, so
/// that the emulated network counts the same ticks on both sides, however long they take.
class Wire {
public:
    Wire(UdpSocket socket, const LinkDef& link, bool byClock, double patience);

    /// Begins a tick: puts on the wire what leaves the emulated network now, waits, and hands over what has
    /// come. Fails where the other has been silent for too long.
    muster::Status begin(std::uint32_t tick, const std::function<void(ByteSpan)>& receive);
    /// Gives a datagram to the emulated network.
    void send(std::uint32_t tick, const Bytes& datagram) { link_.send(tick, datagram); }
    /// Tells the other that nothing more will come.
    void sayGoodbye();
    /// The other has said so.
    bool otherLeft() const { return otherLeft_; }
    const LossyLink& link() const { return link_; }

private:
    using Clock = std::chrono::steady_clock;

    void sendTick(std::uint32_t tick);
    bool take(int milliseconds, const std::function<void(ByteSpan)>& receive);
    void sleepUntil(std::uint32_t tick);
    muster::Status silence() const;

    UdpSocket socket_;
    LossyLink link_;
    bool byClock_;
    std::chrono::duration<double> patience_;
    Clock::time_point start_, heard_;
    std::uint32_t otherTicks_ = 0;  // Ticks that the other has begun.
    bool otherLeft_ = false;
};

}  // namespace lockstep
