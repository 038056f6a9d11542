// The replay of one trial for the pages that watch it: messages in, messages out.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "studio/session/inbox/pacer.h"
#include "studio/study/host/trial_screen.h"
#include "studio/study/store/records.h"
#include "studio/study/trial/trial_replay.h"

namespace muster {

/// What is replayed.
struct ReplayHostDef {
    std::string version;             ///< Of Muster.
    StudyTrial trial;                ///< As it is stored.
    RunKind kind = RunKind::People;  ///< Of its run.
    SessionLimits limits;            ///< Limits of messages.
};

/// Plays a trial from its inputs, for all pages alike. No sockets, threads or clocks.
class ReplayHost {
public:
    ReplayHost(TrialReplay replay, ReplayHostDef def);
    ~ReplayHost();

    std::uint32_t connect();                ///< Adds a page and returns its number, which is not reused.
    void disconnect(std::uint32_t client);  ///< Removes a page.
    /// Takes a page's message: play, pause, from the start, speed.
    void receive(std::uint32_t client, std::span<const std::uint8_t> bytes);
    /// Sends a Notice to one page.
    void notice(std::uint32_t client, bool error, const std::string& code, const std::string& text);
    /// Replaces `messages` by those to send to the page, in order.
    void outgoing(std::uint32_t client, std::vector<MessageBytes>& messages);

    void elapse(double seconds);   ///< Real time passes [s].
    bool stepDue() const;          ///< True where step() has something to do.
    void step();                   ///< Makes the steps of a sixtieth of a second.
    double untilNextStep() const;  ///< Real time until a step is due [s].
    void finish() {}               ///< The server ends.

    const TrialReplay& replay() const { return replay_; }  ///< What is replayed.

private:
    struct Client;
    class Handler;

    void setPlaying(bool playing);
    Status restart();
    void stepOnce();
    void sendAll(const MessageBytes& message);
    protocol::StudyState state() const;

    TrialReplay replay_;
    ReplayHostDef def_;
    TrialScreen screen_;
    Pacer pacer_;
    double realTime_ = 0.0;
    double speed_ = 1.0;
    bool playing_ = true;
    std::uint32_t lastClient_ = 0;
    std::map<std::uint32_t, Client> clients_;
};

}  // namespace muster
