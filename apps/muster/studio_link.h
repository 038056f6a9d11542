// A connection to a running studio, as one of its directors.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "muster/status.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// Where a studio is reached.
struct StudioAddress {
    std::string host = "127.0.0.1";
    std::string port = "8080";

    /// From "ws://127.0.0.1:8080", with or without the beginning and the port.
    static Result<StudioAddress> read(std::string text);
};

/// Sends messages and waits for what answers them. It connects when something is sent first, and again where
/// the studio was lost meanwhile.
class StudioLink {
public:
    StudioLink(StudioAddress address, std::string name);
    ~StudioLink();
    StudioLink(const StudioLink&) = delete;
    StudioLink& operator=(const StudioLink&) = delete;

    /// Fails, naming the address, where no studio answers.
    Status send(std::vector<std::uint8_t> bytes);
    /// Gives each message that has come and that comes to `take` until it returns true. False where the time
    /// is over before that, or the studio is gone.
    bool await(std::chrono::milliseconds most,
               const std::function<bool(const protocol::ServerMessage&)>& take);
    /// Forgets what has come so far.
    void forget();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
