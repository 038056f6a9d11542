#include "wire.h"

#include <cstdio>
#include <thread>

namespace lockstep {
namespace {

enum Kind : std::uint8_t { kDatagram, kTick, kGoodbye };  // The first byte of what is really sent.

constexpr int
    kResend = 50;  // The other may not have been there yet: the tick is sent again after so long [ms].
constexpr std::chrono::milliseconds kMostLate{250};

}  // namespace

Wire::Wire(UdpSocket socket, const LinkDef& link, bool byClock, double patience)
    : socket_(std::move(socket)),
      link_(link),
      byClock_(byClock),
      patience_(patience),
      start_(Clock::now()),
      heard_(start_) {}

void Wire::sendTick(std::uint32_t tick) {
    Bytes bytes{kTick};
    put(bytes, tick);
    socket_.send(bytes);
}

/// Takes one frame. False where none comes within that time.
bool Wire::take(int milliseconds, const std::function<void(ByteSpan)>& receive) {
    const std::optional<Bytes> bytes = socket_.receive(milliseconds);
    if (!bytes) return false;
    ByteReader reader(*bytes);
    const std::uint8_t kind = reader.get<std::uint8_t>();
    if (!reader.ok()) return true;
    heard_ = Clock::now();
    if (kind == kDatagram) receive(ByteSpan(*bytes).subspan(1));
    if (kind == kGoodbye) otherLeft_ = true;
    if (kind == kTick) {
        const std::uint32_t tick = reader.get<std::uint32_t>();
        if (reader.ok() && tick + 1 > otherTicks_) otherTicks_ = tick + 1;
    }
    return true;
}

void Wire::sleepUntil(std::uint32_t tick) {
    const auto due = start_ + std::chrono::duration_cast<Clock::duration>(
                                  std::chrono::duration<double, std::milli>(tick * kTickMilliseconds));
    const auto now = Clock::now();
    if (now > due + kMostLate) start_ += now - due;  // Time that cannot be caught up with is dropped.
    std::this_thread::sleep_until(due);
}

muster::Status Wire::silence() const {
    if (otherLeft_ || Clock::now() - heard_ < patience_) return {};
    char text[80];
    std::snprintf(text, sizeof text, "the other peer has sent nothing for %g s", patience_.count());
    return {muster::StatusCode::IoError, text};
}

muster::Status Wire::begin(std::uint32_t tick, const std::function<void(ByteSpan)>& receive) {
    if (byClock_) sleepUntil(tick);
    for (const Bytes& datagram : link_.arrivals(tick)) {
        Bytes bytes{kDatagram};
        put(bytes, datagram);
        socket_.send(bytes);
    }
    if (!byClock_) {
        sendTick(tick);
        while (otherTicks_ <= tick && !otherLeft_) {
            if (take(kResend, receive)) continue;
            if (muster::Status status = silence(); !status.ok()) return status;
            sendTick(tick);
        }
        return {};
    }
    while (take(0, receive)) {
    }
    return silence();
}

void Wire::sayGoodbye() {
    for (int i = 0; i < 3; ++i) socket_.send(Bytes{kGoodbye});
}

}  // namespace lockstep
