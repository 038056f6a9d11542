// How other machines of the network come into the studio: a secret token in a link, as a QR code, too.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "http_answer.h"

namespace muster {

/// Addresses and secret of a studio that other machines may enter.
struct Invitation {
    std::vector<std::string> links;  ///< One for each address of this machine, the likeliest first.
    /// Rows of the QR code of the first link, top down, as texts of '0' (light) and '1' (dark). Empty without
    /// links.
    std::vector<std::string> code;
};

/// A new secret of 128 random bits, as 32 hexadecimal digits.
std::string makeToken();
/// IPv4 addresses of this machine's networks, without those that lead back to itself; the same order each
/// time.
std::vector<std::string> networkAddresses();
/// The links of these addresses, and the code of the first.
Invitation makeInvitation(const std::vector<std::string>& addresses, int port, const std::string& token);
/// A QR code, with the quiet zone that readers need, as lines of text for a terminal with black on white.
std::string codeText(const std::vector<std::string>& code);
/// The invitation as the page reads it: {"links": [...], "code": [...]}.
/// `site`: the address of a site for links that need no studio; empty for none.
std::string invitationJson(const Invitation& invitation, const std::string& site = {});
/// The QR code of a percent-encoded text as {"code": [...]}, or why there is none.
HttpAnswer codeAnswer(std::string_view encoded);

}  // namespace muster
