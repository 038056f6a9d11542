#include "player_page.h"

#include <doctest.h>

#include <unistd.h>

#include <filesystem>

#include "base/text_file.h"

using namespace muster;

namespace {

const PlayerParts kParts{"const a = '</script>';",
                         "<title>{{title}}</title>{{script}}<muster-player src=\"{{source}}\">"};

/// An empty folder that is removed at the end.
struct PlayerFolder {
    std::string path = (std::filesystem::temp_directory_path() /
                        ("muster-player-" + std::to_string(::getpid())))
                           .string();
    PlayerFolder() {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~PlayerFolder() { std::filesystem::remove_all(path); }
};

}  // namespace

TEST_CASE("a page with a player holds title, script and crowd, and nothing of them ends it early") {
    const std::string page = playerPage(kParts, "A <b>\"crowd\"</b> & {{script}}", "abcd");
    CHECK(page ==
          "<title>A &lt;b&gt;&quot;crowd&quot;&lt;/b&gt; &amp; {{script}}</title><script type=\"module\">\n"
          "const a = '<\\/script>';\n    </script><muster-player "
          "src=\"data:application/octet-stream;base64,YWJjZA==\">");
}

TEST_CASE("crowds of any length are written into pages in base 64") {
    // From RFC 4648, section 10.
    for (const auto& [bytes, text] :
         {std::pair{"", ""}, std::pair{"f", "Zg=="}, std::pair{"fo", "Zm8="}, std::pair{"foo", "Zm9v"},
          std::pair{"foob", "Zm9vYg=="}, std::pair{"fooba", "Zm9vYmE="}, std::pair{"foobar", "Zm9vYmFy"}})
        CHECK(playerPage({"", "{{source}}"}, "", bytes) ==
              std::string("data:application/octet-stream;base64,") + text);
    CHECK(playerPage({"", "{{source}}"}, "", std::string("\xff\xfe\x00", 3)).ends_with("base64,//4A"));
}

TEST_CASE("a folder with a player is new, or nothing is written") {
    const PlayerFolder made;
    const std::string& folder = made.path;
    const std::string out = folder + "/talk";
    REQUIRE(writePlayerFolder(kParts, "Talk", std::string("\0crowd", 6), out).ok());
    CHECK(readTextFile(out + "/index.html")->find("src=\"crowd.muster-player\"") != std::string::npos);
    CHECK(readTextFile(out + "/index.html")->find("src=\"muster-player.js\"></script>") != std::string::npos);
    CHECK(*readTextFile(out + "/muster-player.js") == kParts.script);
    CHECK(readTextFile(out + "/crowd.muster-player")->size() == 6);
    const Status again = writePlayerFolder(kParts, "Talk", "crowd", out);
    CHECK(again.code() == StatusCode::InvalidArgument);
    CHECK(again.message() == out + ": exists already; name a new folder");
    CHECK(writePlayerFolder(kParts, "Talk", "crowd", "/proc/nowhere/x").code() == StatusCode::IoError);
}

TEST_CASE("without the built page it is told what is missing") {
    const PlayerFolder made;
    const std::string& folder = made.path;
    const auto none = readPlayerParts(folder);
    CHECK(none.status().code() == StatusCode::NotFound);
    CHECK(none.status().message().find("muster-player.js: is not there") != std::string::npos);
    REQUIRE(writeTextFile(folder + "/muster-player.js", "x").ok());
    CHECK(readPlayerParts(folder).status().message().find("page.html: is not there") != std::string::npos);
    REQUIRE(writeTextFile(folder + "/page.html", "y").ok());
    CHECK(readPlayerParts(folder)->page == "y");
}

TEST_CASE("formats of pages are known beside those of the library") {
    CHECK(exportOrPageFormat("player-page")->ending == std::string(".html"));
    CHECK(exportOrPageFormat("glb").ok());
    const auto none = exportOrPageFormat("doc");
    CHECK(none.status().message().find("pedpy, player, player-page, player-folder") != std::string::npos);
    CHECK(usualFps("player-page") == 15.0);
    CHECK(usualFps("player") == 15.0);
    CHECK(usualFps("glb") == 30.0);
}
