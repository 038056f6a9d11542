// UDP between two ports of the loopback address.
#pragma once

#include <muster/status.h>

#include <cstdint>
#include <optional>

#include "bytes.h"

namespace lockstep {

/// A socket that talks to one other port only; the kernel drops what others send.
class UdpSocket {
public:
    /// Takes a port of 127.0.0.1; 0 for any that is free. Fails with IoError.
    static muster::Result<UdpSocket> open(std::uint16_t port);
    UdpSocket(UdpSocket&& other) noexcept;
    UdpSocket& operator=(UdpSocket&& other) noexcept;
    ~UdpSocket();

    std::uint16_t port() const;
    /// From now on it talks to that port.
    muster::Status connect(std::uint16_t port);
    /// Sends; what cannot be sent is lost, as on any network.
    void send(ByteSpan bytes);
    /// The next datagram; none where none comes within that time [ms].
    std::optional<Bytes> receive(int milliseconds);

private:
    explicit UdpSocket(int handle) : handle_(handle) {}
    int handle_ = -1;
};

}  // namespace lockstep
