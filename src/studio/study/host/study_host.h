// All runs of the study that one server hosts: messages in, messages out.
//
// No sockets, threads or clocks. Each run has a world of its own, so that several at once do not mix.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "studio/study/host/hosted_run.h"

namespace muster {

/// What the runs of a server are like.
struct StudyHostDef {
    std::string version;                 ///< Of Muster.
    PeopleSettings settings;             ///< What is compared.
    RunKind kind = RunKind::People;      ///< People or Test.
    std::function<std::string()> now;    ///< The date and time in UTC, "2026-11-24T06:00:00Z".
    std::function<std::string()> token;  ///< A text that nobody can guess, new with each call.
    SessionLimits limits;                ///< Limits of messages.
};

/// Hosts runs. A run begins once consent is given, and belongs to the page that came last with its token. The
/// store must outlive it. Not thread-safe.
class StudyHost {
public:
    StudyHost(StudyStore& store, StudyHostDef def);
    ~StudyHost();

    std::uint32_t connect();                ///< Adds a page and returns its number, which is not reused.
    void disconnect(std::uint32_t client);  ///< Removes a page; its trial pauses.
    /// Takes a page's message. What is malformed or not due gets a Notice and changes nothing.
    void receive(std::uint32_t client, std::span<const std::uint8_t> bytes);
    /// Sends a Notice to one page.
    void notice(std::uint32_t client, bool error, const std::string& code, const std::string& text);
    /// Replaces `messages` by those to send to the page, in order.
    void outgoing(std::uint32_t client, std::vector<MessageBytes>& messages);

    void elapse(double seconds);   ///< Real time passes [s].
    bool stepDue() const;          ///< True where step() has something to do.
    void step();                   ///< Makes one step of each run that is due.
    double untilNextStep() const;  ///< Real time until a step is due [s].
    /// The server ends: runs that are not over are kept as broken off.
    void finish();
    std::size_t runs() const { return runs_.size(); }  ///< How many began.

private:
    struct Client;
    class Handler;

    Status enter(std::uint32_t id, Client& client, const std::string& token);
    Status begin(Client& client, const protocol::AnswerForm& consent);
    HostedRun* runOf(const Client& client);
    void greet(std::uint32_t id, Client& client);
    void sendConsent(Client& client) const;

    StudyStore& store_;
    StudyHostDef def_;
    double realTime_ = 0.0;
    std::uint32_t lastClient_ = 0;
    std::map<std::uint32_t, Client> clients_;
    std::vector<std::unique_ptr<HostedRun>> runs_;
};

}  // namespace muster
