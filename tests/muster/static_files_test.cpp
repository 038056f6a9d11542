#include "static_files.h"

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "server_policy.h"
#include "temporary_folder.h"

using namespace muster;
namespace fs = std::filesystem;

namespace {

/// A page's folder with a file for each test, and a secret outside of it.
struct Site : testing::TemporaryFolder {
    Site() : TemporaryFolder("static_files") {
        put("secret.txt", "secret");
        put("page/index.html", "<p>home");
        put("page/sub/index.html", "<p>sub");
        put("page/a.js", "js");
        put("page/assets/b-1a2b.wasm", std::string("\0asm", 4));
        put("page/data.bin", std::string(300000, '\xFE'));
        put("page/.hidden", "hidden");
        fs::create_symlink(base / "secret.txt", base / "page/out.txt");
        fs::create_directory_symlink(base, base / "page/up");
        fs::create_symlink(base / "page/a.js", base / "page/in.js");
    }
    auto read(const std::string& target) const { return readStaticFile((base / "page").string(), target); }
};

}  // namespace

TEST_CASE("plain paths pass without their query, folders become their index") {
    CHECK(plainPath("/") == "/index.html");
    CHECK(plainPath("/sub/") == "/sub/index.html");
    CHECK(plainPath("/a-b_C.9.js") == "/a-b_C.9.js");
    CHECK(plainPath("/a.js?x=../..&y=%00") == "/a.js");
    CHECK(plainPath("/a.js#top") == "/a.js");
    CHECK(plainPath("/?q") == "/index.html");
    for (const std::string bad :
         {"", "a.js", "?q", "#", "//a.js", "/a//b", "/../secret.txt", "/a/../b", "/.hidden", "/a/.git/x",
          "/..", "/%2e%2e/x", "/a\\b", "/a b", "http://x/", "*", "/a:b", "/~x", "/\xC3\xA4"}) {
        CAPTURE(bad);
        CHECK(!plainPath(bad).has_value());
    }
    CHECK(!plainPath(std::string_view("/a\0b", 4)).has_value());
}

TEST_CASE("every byte but letters, digits and four signs makes a path that is not plain") {
    for (int c = 0; c < 256; ++c) {
        if (c == '?' || c == '#') continue;  // They end the path.
        const bool plain = c < 128 && (std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.' || c == '/');
        const std::string target = std::string("/a") + static_cast<char>(c) + "b";
        CAPTURE(c);
        CHECK(plainPath(target).has_value() == plain);
    }
}

TEST_CASE("files are served whole with their type; only hashed ones may be cached") {
    const Site site;
    const auto home = site.read("/");
    REQUIRE(home.has_value());
    CHECK(home->body == "<p>home");
    CHECK(home->type == "text/html; charset=utf-8");
    CHECK(home->cache == "no-cache");
    CHECK(site.read("/sub/")->body == "<p>sub");
    CHECK(site.read("/a.js?v=2")->type == "text/javascript; charset=utf-8");
    const auto wasm = site.read("/assets/b-1a2b.wasm");
    REQUIRE(wasm.has_value());
    CHECK(wasm->type == "application/wasm");
    CHECK(wasm->cache.find("immutable") != std::string::npos);
    CHECK(wasm->body == std::string("\0asm", 4));
    const auto data = site.read("/data.bin");
    REQUIRE(data.has_value());
    CHECK(data->type == "application/octet-stream");
    CHECK(data->body == std::string(300000, '\xFE'));
}

TEST_CASE("nothing outside the folder is served, not by a link either, and no folder as a file") {
    const Site site;
    for (const std::string target : {"/out.txt", "/up/secret.txt", "/../secret.txt", "/.hidden", "/sub",
                                     "/assets", "/none.txt", "/assets/", "/a.js/", "/a.js/x"}) {
        CAPTURE(target);
        CHECK(!site.read(target).has_value());
    }
    // A link that stays inside is a file as others.
    CHECK(site.read("/in.js")->body == "js");
    CHECK(site.read("/up/page/a.js")->body == "js");
    CHECK(!readStaticFile("/nowhere", "/").has_value());
}

TEST_CASE("hosts and origins are those of this machine at this port, letter by letter") {
    for (const int port : {1, 8080, 65535}) {
        const Doorway door{"127.0.0.1", port, ""};
        const std::string number = std::to_string(port);
        for (const std::string name : {"127.0.0.1", "localhost"}) {
            CHECK(isOwnHost(name + ":" + number, door));
            CHECK(isOwnOrigin("http://" + name + ":" + number, door));
            CHECK(!isOwnHost(name, door));
            CHECK(!isOwnHost(name + ":" + number + "0", door));
            CHECK(!isOwnHost(name + ":" + number + " ", door));
            CHECK(!isOwnHost(name + ".evil.example:" + number, door));
            CHECK(!isOwnHost("evil." + name + ":" + number, door));
            CHECK(!isOwnHost("evil@" + name + ":" + number, door));
            CHECK(!isOwnOrigin("https://" + name + ":" + number, door));
            CHECK(!isOwnOrigin("http://" + name + ":" + number + "/", door));
            CHECK(!isOwnOrigin(name + ":" + number, door));
        }
        for (const std::string& bad :
             std::vector<std::string>{"", "null", "http://", "0.0.0.0:" + number, "[::1]:" + number}) {
            CHECK(!isOwnHost(bad, door));
            CHECK(!isOwnOrigin("http://" + bad, door));
            CHECK(!isOwnOrigin(bad, door));
        }
    }
}

TEST_CASE("guests name the address that they came to, and no other") {
    const Doorway door{"192.168.1.5", 8080, "secret"};
    CHECK(isOwnHost("192.168.1.5:8080", door));
    CHECK(isOwnOrigin("http://192.168.1.5:8080", door));
    for (const std::string name : {"localhost", "127.0.0.1", "192.168.1.50", "evil.example"})
        CHECK(!isOwnHost(name + ":8080", door));
    CHECK(!door.atDesk());
}

TEST_CASE("a token is known from a link and from a cookie, whole and exact") {
    const Doorway door{"192.168.1.5", 8080, "abcdef"};
    CHECK(linkHasToken("/?token=abcdef", door));
    for (const std::string bad : {"/", "/?token=", "/?token=abcde", "/?token=abcdefg", "/?token=abcdeF",
                                  "/x?token=abcdef", "/?token=abcdef&x=1"})
        CHECK_MESSAGE(!linkHasToken(bad, door), bad);
    CHECK(cookieHasToken("muster-8080=abcdef", door));
    CHECK(cookieHasToken("a=b; muster-8080=abcdef; c=d", door));
    for (const std::string bad : {"", "muster-8080=", "muster-8080=abcdefg", "muster-8081=abcdef",
                                  "xmuster-8080=abcdef", "muster-8080 =abcdef", "muster-8080=abcde;f"})
        CHECK_MESSAGE(!cookieHasToken(bad, door), bad);
    CHECK(tokenCookie(door).starts_with("muster-8080=abcdef;"));
    // Nobody passes where there is no token.
    const Doorway closed{"192.168.1.5", 8080, ""};
    CHECK(!linkHasToken("/?token=", closed));
    CHECK(!cookieHasToken("muster-8080=", closed));
}

TEST_CASE("the security policy lets sockets go to this address and port alone") {
    for (const std::string address : {"127.0.0.1", "192.168.1.5"}) {
        const Doorway door{address, 4321, "t"};
        std::string policy;
        for (const auto& [name, value] : securityFields(door))
            if (std::string(name) == "Content-Security-Policy") policy = value;
        const auto has = [&](const std::string& words) { return policy.find(words) != std::string::npos; };
        for (const std::string words : {std::string("default-src 'self'"), "ws://" + address + ":4321",
                                        std::string("frame-ancestors 'none'"), std::string("base-uri 'none'"),
                                        std::string("form-action 'none'")})
            CHECK_MESSAGE(has(words), words);
        CHECK(has("ws://localhost:4321") == door.atDesk());
        CHECK(!has("*"));
        CHECK(!has("'unsafe-eval'"));
        // Each source that is a socket names this address and port.
        for (std::size_t at = policy.find("ws:"); at != std::string::npos; at = policy.find("ws:", at + 1)) {
            const std::string source = policy.substr(at, policy.find_first_of(" ;", at) - at);
            CHECK(isOwnHost(source.substr(5), door));
        }
    }
}
