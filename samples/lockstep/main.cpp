// Lockstep with rollback: two processes play one world over UDP; each tells the other its commands only.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "lockstep_options.h"
#include "lockstep_session.h"
#include "udp.h"

namespace {

using namespace lockstep;

int complain(const muster::Status& status) {
    std::fprintf(stderr, "lockstep: %s\n", status.message().c_str());
    return kUsage;
}

/// One of two programs that were started by themselves. Who has the lower port is player 0.
int runOne(const Options& options) {
    muster::Result<UdpSocket> socket = UdpSocket::open(options.port);
    if (!socket.ok()) return complain(socket.status());
    if (const muster::Status status = socket->connect(options.peer); !status.ok()) return complain(status);
    return runPeer(options, options.port < options.peer ? 0 : 1, std::move(*socket));
}

/// Both peers, each in a process of its own.
int runBoth(const Options& options) {
    muster::Result<UdpSocket> west = UdpSocket::open(0), east = UdpSocket::open(0);
    if (!west.ok()) return complain(west.status());
    if (!east.ok()) return complain(east.status());
    if (const muster::Status status = west->connect(east->port()); !status.ok()) return complain(status);
    if (const muster::Status status = east->connect(west->port()); !status.ok()) return complain(status);
    const pid_t child = fork();
    if (child < 0) return complain({muster::StatusCode::IoError, "no second process could be started"});
    if (child == 0) {
        { const UdpSocket mine = std::move(*west); }  // The other process keeps it open.
        return runPeer(options, 1, std::move(*east));
    }
    { const UdpSocket theirs = std::move(*east); }
    const int outcome = runPeer(options, 0, std::move(*west));
    int status = 0;
    waitpid(child, &status, 0);
    return std::max(outcome, WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(kAlone));
}

}  // namespace

int main(int count, char** arguments) {
    const muster::Result<Options> options = readOptions(count, arguments);
    if (!options.ok()) {
        complain(options.status());
        std::fputs(usage(), stderr);
        return kUsage;
    }
    return options->port != 0 ? runOne(*options) : runBoth(*options);
}
