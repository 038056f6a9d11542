#include "invitation.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <qrcodegen/qrcodegen.hpp>
#include <random>
#include <utility>

#include "http_answers.h"
#include "json/json.h"

namespace muster {
namespace {

constexpr int kQuietZone = 2;  // Modules round a code; terminals have more of their own.

// Home and office networks come before others.
int rank(const std::string& address) {
    if (address.starts_with("192.168.")) return 0;
    if (address.starts_with("10.")) return 1;
    return address.starts_with("169.254.") ? 3 : 2;
}

// Two rows of modules share a line: the upper and the lower half of each character.
const char* halves(bool upper, bool lower) {
    if (upper) return lower ? "█" : "▀";
    return lower ? "▄" : " ";
}

/// Rows of a QR code, top down.
std::vector<std::string> rowsOf(const qrcodegen::QrCode& code) {
    std::vector<std::string> rows;
    for (int y = 0; y < code.getSize(); ++y) {
        std::string row;
        for (int x = 0; x < code.getSize(); ++x) row += code.getModule(x, y) ? '1' : '0';
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Bytes of a percent-encoded text; what is no such code stays.
std::string decoded(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned value = 0;
        const char* digits = text.data() + i + 1;
        if (text[i] == '%' && i + 2 < text.size() &&
            std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
            plain += static_cast<char>(value);
            i += 2;
        } else {
            plain += text[i];
        }
    }
    return plain;
}

}  // namespace

std::string makeToken() {
    std::random_device device;
    std::string token;
    for (int i = 0; i < 4; ++i) {
        std::array<char, 9> digits{};
        std::snprintf(digits.data(), digits.size(), "%08x", static_cast<unsigned>(device()));
        token += digits.data();
    }
    return token;
}

std::vector<std::string> networkAddresses() {
    std::vector<std::string> addresses;
    ifaddrs* all = nullptr;
    if (getifaddrs(&all) != 0) return addresses;
    for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
        if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
        if ((one->ifa_flags & IFF_UP) == 0 || (one->ifa_flags & IFF_LOOPBACK) != 0) continue;
        std::array<char, INET_ADDRSTRLEN> text{};
        const auto* in = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
        if (inet_ntop(AF_INET, &in->sin_addr, text.data(), text.size()) != nullptr)
            addresses.emplace_back(text.data());
    }
    freeifaddrs(all);
    std::sort(addresses.begin(), addresses.end(), [](const std::string& a, const std::string& b) {
        return std::pair(rank(a), a) < std::pair(rank(b), b);
    });
    addresses.erase(std::unique(addresses.begin(), addresses.end()), addresses.end());
    return addresses;
}

Invitation makeInvitation(const std::vector<std::string>& addresses, int port, const std::string& token) {
    Invitation invitation;
    for (const std::string& address : addresses)
        invitation.links.push_back("http://" + address + ":" + std::to_string(port) + "/?token=" + token);
    if (invitation.links.empty()) return invitation;
    using qrcodegen::QrCode;
    invitation.code = rowsOf(QrCode::encodeText(invitation.links.front().c_str(), QrCode::Ecc::MEDIUM));
    return invitation;
}

std::string codeText(const std::vector<std::string>& code) {
    const int size = static_cast<int>(code.size());
    const auto dark = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < size && y < size && code[y][x] == '1';
    };
    std::string text;
    for (int y = -kQuietZone; y < size + kQuietZone; y += 2) {
        text += "\033[30;107m";
        for (int x = -kQuietZone; x < size + kQuietZone; ++x) text += halves(dark(x, y), dark(x, y + 1));
        text += "\033[0m\n";
    }
    return text;
}

std::string invitationJson(const Invitation& invitation, const std::string& site) {
    return compactJson({{"links", Json::arrayOf(invitation.links)},
                        {"code", Json::arrayOf(invitation.code)},
                        {"site", site}}) +
           "\n";
}

HttpAnswer codeAnswer(std::string_view encoded) {
    using qrcodegen::QrCode;
    try {
        const QrCode code = QrCode::encodeText(decoded(encoded).c_str(), QrCode::Ecc::LOW);
        return jsonAnswer({{"code", Json::arrayOf(rowsOf(code))}});
    } catch (const qrcodegen::data_too_long&) {
        return sentence(413, "The link is too long for a QR code.");
    }
}

}  // namespace muster
