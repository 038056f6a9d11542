#include "lockstep_session.h"

#include <algorithm>
#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <memory>

#include "battlefield.h"
#include "peer.h"
#include "script.h"
#include "wire.h"

namespace lockstep {
namespace {

constexpr double kStepsPerSecond = 60.0;
constexpr std::uint32_t kFarewell = 60;  // Ticks for which a peer that is done goes on to tell the other.

/// Lines on the screen, and in a file where there is one.
class Log {
public:
    Log(const Options& options, std::uint32_t number) : name_(number == 0 ? "West" : "East") {
        if (options.folder.empty()) return;
        const std::string path = options.folder + "/lockstep-" + (number == 0 ? "west" : "east") + ".log";
        file_.reset(std::fopen(path.c_str(), "w"));
        if (!file_) std::fprintf(stderr, "%s cannot be written\n", path.c_str());
    }
    [[gnu::format(printf, 2, 3)]] void line(const char* format, ...) {
        char text[512];
        va_list values;
        va_start(values, format);
        std::vsnprintf(text, sizeof text, format, values);
        va_end(values);
        std::printf("%s  %s\n", name_, text);
        std::fflush(stdout);
        if (!file_) return;
        std::fprintf(file_.get(), "%s\n", text);
        std::fflush(file_.get());
    }

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    const char* name_;
    std::unique_ptr<std::FILE, Close> file_;
};

void tellProgress(Log& log, const Peer& peer, const Wire& wire) {
    const RollbackWorld& world = peer.world();
    const RollbackCounts& back = world.counts();
    log.line(
        "%6.1f s  step %6u  rollbacks %5u (longest %u)  stalls %u  waits %u  lost %u of %u datagrams  "
        "malformed %u  people %3zu in %zu groups  equal up to step %u",
        world.now() / kStepsPerSecond, world.now(), back.rollbacks, back.longest, peer.counts().stalls,
        peer.counts().waits, wire.link().lost(), wire.link().sent(), peer.counts().refused,
        world.world().characters().size(), world.world().groupCount(), peer.equalUpTo());
}

void tellEnd(Log& log, const Peer& peer, const LossyLink& link, double seconds) {
    const RollbackWorld& world = peer.world();
    const RollbackCounts& back = world.counts();
    log.line("done: %u steps in %.1f s, %u of their states compared and all equal, the last is %016llx",
             world.now(), seconds, peer.counts().compared,
             static_cast<unsigned long long>(world.hash(world.now())));
    log.line("      %u rollbacks, the longest %u, repeated %u steps, %.1f %%; the world refused %u commands",
             back.rollbacks, back.longest, back.repeated, 100.0 * back.repeated / world.now(), back.refused);
    log.line("      stalls %u, waits %u, lost %u of %u datagrams of %.0f bytes on average",
             peer.counts().stalls, peer.counts().waits, link.lost(), link.sent(),
             static_cast<double>(link.sentBytes()) / std::max(link.sent(), 1u));
    if (peer.counts().refused > 0)
        log.line("      %u datagrams were malformed; the last: %s", peer.counts().refused,
                 peer.lastRefusal().c_str());
}

/// Ticks until both are done. The outcome, and one sentence about it where it is not well.
int play(Peer& peer, Wire& wire, Log& log, double every) {
    const auto linesEvery = static_cast<std::uint32_t>(every * kStepsPerSecond);
    std::uint32_t told = 0, farewell = 0;
    for (std::uint32_t tick = 0; farewell < kFarewell; ++tick) {
        const muster::Status heard = wire.begin(tick, [&](ByteSpan bytes) { peer.receive(bytes); });
        if (!heard.ok()) {
            log.line("gone at step %u: %s", peer.world().now(), heard.message().c_str());
            return kAlone;
        }
        if (const muster::Status status = peer.tick(); !status.ok()) {
            log.line("failed at step %u: %s", peer.world().now(), status.message().c_str());
            return kDiffer;
        }
        if (peer.world().now() / linesEvery > told) {
            told = peer.world().now() / linesEvery;
            tellProgress(log, peer, wire);
        }
        wire.send(tick, peer.datagram());
        if (peer.done()) {
            ++farewell;
        } else if (wire.otherLeft()) {
            log.line("gone at step %u: the other peer has left before the end", peer.world().now());
            return kAlone;
        }
    }
    return kEqual;
}

}  // namespace

int runPeer(const Options& options, std::uint32_t number, UdpSocket socket) {
    Log log(options, number);
    muster::Result<muster::World> world = makeBattlefield(options.people);
    if (!world.ok()) {
        log.line("%s", world.status().message().c_str());
        return kUsage;
    }
    LinkDef link = options.link;
    link.seed = 2 * options.link.seed + number;  // Each direction has losses of its own.
    Script script(number, options.people, options.link.seed);
    Peer peer(std::move(*world), number, static_cast<std::uint32_t>(options.seconds * kStepsPerSecond),
              [&](const muster::World& seen) { return script.commands(seen); });
    Wire wire(std::move(socket), link, options.real, options.patience);
    const auto began = std::chrono::steady_clock::now();
    const int outcome = play(peer, wire, log, options.every);
    wire.sayGoodbye();
    if (outcome == kEqual)
        tellEnd(log, peer, wire.link(),
                std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
    return outcome;
}

}  // namespace lockstep
