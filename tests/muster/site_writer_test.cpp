#include "site_writer.h"

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/text_file.h"
#include "json/json.h"
#include "temporary_folder.h"

using namespace muster;
namespace fs = std::filesystem;

namespace {

const std::string kOpen = R"({"format":"muster-scenario","version":1,"name":"Open","box":[[-8,-8],[8,8]],)"
                          R"("groups":[{"count":4}]})";

/// Folders with a page, an engine and two scenarios, as small as can be.
struct Parts : testing::TemporaryFolder {
    SiteDef def;

    Parts() : TemporaryFolder("site") {
        put("page/index.html", "<!doctype html>\n<html lang=\"en\"><head></head><body></body></html>\n");
        put("page/assets/main-1.js", "page();");
        put("page/site/service_worker.js", "const kCache = 'muster-VERSION'; const kFiles = FILES;");
        put("page/site/manifest.webmanifest", "{}");
        for (const char* name : {"muster-engine.js", "muster-engine.wasm.xz"})
            put(std::string("engine/") + name, name);
        put("engine/muster-engine-rest.wasm", std::string("\0asm", 4));
        put("scenarios/open.json", kOpen);
        put("scenarios/more/harbour.json", kOpen);
        put("scenarios/gestures/open.json", R"({"format":"muster-gestures","version":1,"events":[]})");
        put("scenarios/schema/scenario.schema.json", "{}");
        def = {(base / "page").string(), (base / "engine").string(), (base / "scenarios").string(), "open",
               (base / "out").string()};
    }
    std::string refusal() const {
        const auto report = writeSite(def);
        return report.ok() ? "" : report.status().message();
    }
};

std::string without(std::string text, const std::string& part) {
    const std::size_t at = text.find(part);
    return at == std::string::npos ? text : text.erase(at, part.size());
}

}  // namespace

TEST_CASE("a site has the page, its engine and all scenarios") {
    const Parts parts;
    const auto report = writeSite(parts.def);
    REQUIRE_MESSAGE(report.ok(), report.status().message());
    CHECK(report->scenarios == 2);
    CHECK(parts.read("out/index.html")
              .find("<html data-engine=\"engine/\" data-scenario=\"open\" lang=\"en\">") !=
          std::string::npos);
    CHECK(parts.read("out/index.html").find("<link rel=\"manifest\" href=\"manifest.webmanifest\" />") !=
          std::string::npos);
    CHECK(parts.read("out/assets/main-1.js") == "page();");
    CHECK(parts.read("out/engine/muster-engine-rest.wasm") == std::string("\0asm", 4));
    const auto scenarios = parseJson(parts.read("out/engine/scenarios.json"), "scenarios.json");
    REQUIRE(scenarios.ok());
    REQUIRE(scenarios->find("open.json") != nullptr);
    CHECK(scenarios->find("open.json")->text() == kOpen);
    CHECK(scenarios->find("more/harbour.json") != nullptr);
    CHECK(scenarios->find("gestures/open.json") == nullptr);
    const auto gestures = parseJson(parts.read("out/engine/gestures.json"), "gestures.json");
    REQUIRE(gestures.ok());
    CHECK(gestures->find("gestures/open.json") != nullptr);
    CHECK(scenarios->find("schema/scenario.schema.json") == nullptr);
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(parts.base / "out"))
        files += entry.is_regular_file() ? 1 : 0;
    CHECK(files == report->files);
}

TEST_CASE("modules for isolated pages come where they are built") {
    const Parts parts;
    for (const char* name :
         {"muster-engine-threads.js", "muster-engine-threads.worker.js", "muster-engine-threads.wasm"}) {
        REQUIRE(writeSite(parts.def).ok());
        CHECK_FALSE(fs::exists(parts.base / "out/engine/muster-engine-threads.js"));
        CHECK(parts.read("out/index.html").find("data-threads") == std::string::npos);
        parts.put(std::string("engine/") + name, name);
    }
    REQUIRE(writeSite(parts.def).ok());
    CHECK(parts.read("out/engine/muster-engine-threads.worker.js") == "muster-engine-threads.worker.js");
    CHECK(parts.read("out/index.html").find("<html data-threads data-engine=") != std::string::npos);
    CHECK(parts.read("out/service_worker.js").find("engine/muster-engine-threads.wasm") != std::string::npos);
}

TEST_CASE("the service worker knows every file, and another content is another version") {
    const Parts parts;
    REQUIRE(writeSite(parts.def).ok());
    const std::string first = parts.read("out/service_worker.js");
    for (const char* path : {"\"./\"", "\"index.html\"", "\"assets/main-1.js\"", "\"engine/scenarios.json\"",
                             "\"engine/muster-engine.wasm.xz\"", "\"manifest.webmanifest\""})
        CHECK_MESSAGE(first.find(path) != std::string::npos, path);
    CHECK(first.find("FILES") == std::string::npos);
    CHECK(first.find("VERSION") == std::string::npos);
    REQUIRE(writeSite(parts.def).ok());
    CHECK(parts.read("out/service_worker.js") == first);
    parts.put("page/assets/main-1.js", "page(2);");
    REQUIRE(writeSite(parts.def).ok());
    CHECK(parts.read("out/service_worker.js") != first);
}

TEST_CASE("an older site is replaced, and nothing else is") {
    const Parts parts;
    REQUIRE(writeSite(parts.def).ok());
    parts.put("out/assets/old.js", "old");
    REQUIRE(writeSite(parts.def).ok());
    CHECK_FALSE(fs::exists(parts.base / "out/assets/old.js"));
    fs::remove(parts.base / "out/muster-site.json");
    CHECK(parts.refusal() == parts.def.output + ": holds files that are no site; name an empty folder");
    CHECK(fs::exists(parts.base / "out/index.html"));
}

TEST_CASE("what is missing is named, and nothing is written") {
    Parts parts;
    SUBCASE("engine") {
        fs::remove(parts.base / "engine/muster-engine.wasm.xz");
        CHECK(without(parts.refusal(), parts.base.string()) ==
              "/engine/muster-engine.wasm.xz: the engine for browsers is not built; ./run -- site builds it");
    }
    SUBCASE("page") {
        fs::remove(parts.base / "page/index.html");
        CHECK(without(parts.refusal(), parts.base.string()) ==
              "/page: found no index.html; build the page first");
    }
    SUBCASE("a page without a head") {
        parts.put("page/index.html", "<p>");
        CHECK(parts.refusal() == "index.html: found no \"<html \"");
    }
    SUBCASE("scenario") {
        parts.def.scenario = "harbour";
        CHECK(without(parts.refusal(), parts.base.string()) == "/scenarios: no scenario is called 'harbour'");
    }
    SUBCASE("a bad scenario") {
        parts.put("scenarios/bad.json", "{");
        CHECK(parts.refusal().find("bad.json") != std::string::npos);
    }
    SUBCASE("a file in the place of the folder") {
        parts.put("out", "a file");
        CHECK(parts.refusal() == parts.def.output + ": is a file, expected a folder");
        return;
    }
    CHECK_FALSE(fs::exists(parts.base / "out"));
}
