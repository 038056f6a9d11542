// A bad network inside the sender: it loses datagrams and holds back the others.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "bytes.h"
#include "lockstep_random.h"

namespace lockstep {

inline constexpr double kTickMilliseconds = 1000.0 / 60.0;

struct LinkDef {
    double delay = 100.0;  ///< Mean time of one way [ms].
    double jitter = 30.0;  ///< Each datagram takes up to so much more or less [ms]; they may overtake each
                           ///< other.
    double loss = 0.05;    ///< Share of the datagrams that get lost.
    double garbage = 0.0;  ///< Bad datagrams per good one: random bytes, and copies with wrong bytes.
    std::uint64_t seed = 1;
};

/// Time counts in ticks, so that a run without a clock meets the same network.
class LossyLink {
public:
    explicit LossyLink(const LinkDef& def) : def_(def), random_(def.seed) {}

    /// Takes a datagram that is sent at this tick.
    void send(std::uint32_t tick, const Bytes& bytes);
    /// What arrives at this tick, or was to arrive before, in the order of arrival.
    std::vector<Bytes> arrivals(std::uint32_t tick);

    std::uint32_t sent() const { return sent_; }
    std::uint32_t lost() const { return lost_; }
    std::uint64_t sentBytes() const { return sentBytes_; }

private:
    void hold(std::uint32_t tick, Bytes bytes);
    Bytes garbage(const Bytes& bytes);

    LinkDef def_;
    Random random_;
    std::multimap<double, Bytes> held_;  // By time of arrival [ms].
    std::uint32_t sent_ = 0, lost_ = 0;
    std::uint64_t sentBytes_ = 0;
};

}  // namespace lockstep
