#include "udp.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace lockstep {
namespace {

constexpr std::size_t kLongest = 2048;  // Longer datagrams are cut, and then refused.

sockaddr_in loopback(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

muster::Status failure(const std::string& what) {
    return {muster::StatusCode::IoError, what + ": " + std::strerror(errno)};
}

}  // namespace

muster::Result<UdpSocket> UdpSocket::open(std::uint16_t port) {
    UdpSocket made(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    if (made.handle_ < 0) return failure("no UDP socket could be opened");
    const sockaddr_in address = loopback(port);
    if (bind(made.handle_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        return failure("UDP port " + std::to_string(port) + " cannot be used");
    return made;
}

UdpSocket::UdpSocket(UdpSocket&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}

UdpSocket& UdpSocket::operator=(UdpSocket&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
}

UdpSocket::~UdpSocket() {
    if (handle_ >= 0) close(handle_);
}

std::uint16_t UdpSocket::port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    return getsockname(handle_, reinterpret_cast<sockaddr*>(&address), &size) == 0 ? ntohs(address.sin_port)
                                                                                   : std::uint16_t{0};
}

muster::Status UdpSocket::connect(std::uint16_t port) {
    const sockaddr_in address = loopback(port);
    if (::connect(handle_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return {};
    return failure("UDP port " + std::to_string(port) + " cannot be reached");
}

void UdpSocket::send(ByteSpan bytes) {
    // An error says that nobody was there for a datagram before; the time-out decides what that means.
    (void)!::send(handle_, bytes.data(), bytes.size(), 0);
}

std::optional<Bytes> UdpSocket::receive(int milliseconds) {
    // The kernel first tells that nobody was there for what was sent before, and then gives what has come.
    for (int attempt = 0; attempt < 2; ++attempt) {
        pollfd entry{handle_, POLLIN, 0};
        if (poll(&entry, 1, milliseconds) <= 0) return std::nullopt;
        Bytes bytes(kLongest);
        const ssize_t size = recv(handle_, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (size < 0) continue;
        bytes.resize(static_cast<std::size_t>(size));
        return bytes;
    }
    return std::nullopt;
}

}  // namespace lockstep
