// Links and codes by which others come into the studio.
#include "invitation.h"

#include <doctest.h>

#include <set>
#include <string>

using namespace muster;

TEST_CASE("tokens are 128 random bits in hexadecimal digits") {
    std::set<std::string> seen;
    for (int i = 0; i < 100; ++i) {
        const std::string token = makeToken();
        CHECK(token.size() == 32);
        CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
        seen.insert(token);
    }
    CHECK(seen.size() == 100);
}

TEST_CASE("a link for each address, and the code of the first") {
    const Invitation invitation = makeInvitation({"192.168.1.5", "10.0.0.2"}, 8080, "abc");
    REQUIRE(invitation.links.size() == 2);
    CHECK(invitation.links[0] == "http://192.168.1.5:8080/?token=abc");
    CHECK(invitation.links[1] == "http://10.0.0.2:8080/?token=abc");
    // A QR code is a square with the same mark in three corners: a dark ring of seven, a light one, a dark
    // core.
    const auto& code = invitation.code;
    const std::size_t size = code.size();
    REQUIRE(size >= 21);
    CHECK(size % 4 == 1);
    for (const std::string& row : code) CHECK(row.size() == size);
    const char* finder[] = {"1111111", "1000001", "1011101", "1011101", "1011101", "1000001", "1111111"};
    for (std::size_t y = 0; y < 7; ++y) {
        CHECK(code[y].substr(0, 7) == finder[y]);
        CHECK(code[y].substr(size - 7) == finder[y]);
        CHECK(code[size - 7 + y].substr(0, 7) == finder[y]);
    }
    CHECK(makeInvitation({}, 8080, "abc").code.empty());
}

TEST_CASE("a code as text has its quiet zone, and half a line for each row") {
    const Invitation invitation = makeInvitation({"192.168.1.5"}, 8080, "abc");
    const std::string text = codeText(invitation.code);
    std::size_t lines = 0;
    for (const char c : text) lines += c == '\n' ? 1 : 0;
    CHECK(lines == (invitation.code.size() + 5) / 2);
    CHECK(text.find("█") != std::string::npos);
}

TEST_CASE("the page reads links and code as JSON") {
    CHECK(invitationJson({}) == "{\"links\":[],\"code\":[],\"site\":\"\"}\n");
    const std::string json = invitationJson(makeInvitation({"10.0.0.2"}, 1, "t"));
    CHECK(json.find("http://10.0.0.2:1/?token=t") != std::string::npos);
}
