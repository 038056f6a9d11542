#include "take_shelf.h"

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/text_file.h"
#include "desk/made_take.h"
#include "temporary_folder.h"

using namespace muster;
using muster::testing::bytesOf;
using muster::testing::madeTake;
namespace fs = std::filesystem;

namespace {

struct Kept : testing::TemporaryFolder {
    TakeShelf shelf{(base / "takes").string()};

    Kept() : TemporaryFolder("take_shelf") {}

    std::string put(const std::string& bytes) {
        const auto name = shelf.put(bytesOf(bytes));
        REQUIRE_MESSAGE(name.ok(), name.status().message());
        return *name;
    }
    fs::path file(const std::string& name) const { return base / "takes" / name; }
};

const std::string kPng = std::string("\x89PNG\r\n\x1a\n", 8) + "picture";

}  // namespace

TEST_CASE("a shelf without a folder is empty, and the folder is made with the first take") {
    Kept kept;
    CHECK(kept.shelf.list().empty());
    CHECK_FALSE(fs::exists(kept.base / "takes"));
    kept.put(madeTake(kept.base, 30));
    CHECK(kept.shelf.list().size() == 1);
}

TEST_CASE("the list tells what a take holds") {
    Kept kept;
    const std::string bytes = madeTake(kept.base, 90, "Harbour at night");
    const std::string name = kept.put(bytes);
    CHECK(name.find("Harbour-at-night-") == 0);
    const auto all = kept.shelf.list();
    REQUIRE(all.size() == 1);
    const ShelvedTake& take = all.front();
    CHECK(take.name == name);
    CHECK(take.scenario == "Harbour at night");
    CHECK(take.characters == 9);
    CHECK(take.steps == 90);
    CHECK(take.stepTime == doctest::Approx(1.0 / 60.0));
    CHECK(take.finished);
    CHECK_FALSE(take.recording);
    CHECK_FALSE(take.picture);
    CHECK(take.bytes == bytes.size());
    CHECK(*kept.shelf.read(name) == bytes);
}

TEST_CASE("the same take is put there once, another one of the same second gets another name") {
    Kept kept;
    const std::string first = madeTake(kept.base, 30), second = madeTake(kept.base, 40);
    const std::string name = kept.put(first);
    CHECK(kept.put(first) == name);
    CHECK(kept.shelf.list().size() == 1);
    CHECK(kept.put(second) != name);
    CHECK(kept.shelf.list().size() == 2);
}

TEST_CASE("bytes that are no take leave nothing on the shelf") {
    Kept kept;
    CHECK_FALSE(kept.shelf.put(bytesOf("no take")).ok());
    CHECK_FALSE(kept.shelf.put({}).ok());
    std::string broken = madeTake(kept.base, 30);
    broken[broken.size() / 2] = static_cast<char>(broken[broken.size() / 2] ^ 0x55);
    CHECK_FALSE(kept.shelf.put(bytesOf(broken)).ok());
    CHECK(kept.shelf.put(bytesOf(madeTake(kept.base, 0))).status().message() ==
          "take: holds no step to replay");
    CHECK(kept.shelf.list().empty());
}

TEST_CASE("a take whose end was torn off is kept up to its last whole record") {
    Kept kept;
    const std::string whole = madeTake(kept.base, 200);
    const std::string name = kept.put(whole.substr(0, whole.size() - 5));
    const auto all = kept.shelf.list();
    REQUIRE(all.size() == 1);
    CHECK_FALSE(all.front().finished);
    const auto bytes = kept.shelf.read(name);
    REQUIRE(bytes.ok());
    const auto take = parseTake(bytesOf(*bytes), name);
    REQUIRE(take.ok());
    CHECK(take->tornBytes == 0);
}

TEST_CASE("names that are none lead nowhere") {
    Kept kept;
    const std::string name = kept.put(madeTake(kept.base, 30));
    REQUIRE(writeTextFile((kept.base / "secret.take").string(), "secret").ok());
    REQUIRE(writeTextFile(kept.file("notes.txt").string(), "notes").ok());
    fs::create_symlink(kept.base / "secret.take", kept.file("link.take"));
    fs::create_directories(kept.file("folder.take"));
    for (const std::string& wrong :
         {std::string("../secret.take"), std::string("link.take"), std::string("folder.take"),
          std::string("notes.txt"), std::string(".take"), std::string(""), name + " ",
          std::string("a/b.take"), std::string("a\0.take", 7), std::string(200, 'a') + ".take"}) {
        CHECK(kept.shelf.read(wrong).status().code() == StatusCode::NotFound);
        CHECK(kept.shelf.pathOf(wrong).status().code() == StatusCode::NotFound);
        CHECK(kept.shelf.edit(wrong, {}).code() == StatusCode::NotFound);
        CHECK(kept.shelf.remove(wrong).code() == StatusCode::NotFound);
        CHECK(kept.shelf.restore(wrong).code() == StatusCode::NotFound);
        CHECK(kept.shelf.putPicture(wrong, bytesOf(kPng)).code() == StatusCode::NotFound);
        CHECK(kept.shelf.pictureOf(wrong).status().code() == StatusCode::NotFound);
    }
    CHECK(kept.shelf.read(name).ok());
}

TEST_CASE("what is said about a take is in its file, and the newest word counts") {
    Kept kept;
    const std::string name = kept.put(madeTake(kept.base, 90));
    TakeAbout about;
    for (const char* title : {"First", "Second"}) {
        about.title = title;
        about.from = 10;
        about.to = 60;
        REQUIRE(kept.shelf.edit(name, about).ok());
    }
    TakeShelf other((kept.base / "takes").string());
    const auto all = other.list();
    REQUIRE(all.size() == 1);
    CHECK(all.front().about.title == "Second");
    CHECK(all.front().about.firstStep(all.front().steps) == 10);
    CHECK(all.front().about.lastStep(all.front().steps) == 60);
    about.title = std::string(TakeAbout::kMaxTitleBytes + 1, 'a');
    CHECK_FALSE(kept.shelf.edit(name, about).ok());
    CHECK(kept.shelf.list().front().about.title == "Second");
}

TEST_CASE("another name leaves the camera of a take alone, and other bytes take its place") {
    Kept kept;
    const std::string name = kept.put(madeTake(kept.base, 90));
    const std::string first = *kept.shelf.read(name);
    REQUIRE(kept.shelf.edit(name, {.camera = {{.step = 7, .cut = true}}}).ok());
    REQUIRE(kept.shelf.edit(name, {.title = "Named"}, false).ok());
    CHECK(kept.shelf.list().front().about.camera.size() == 1);
    REQUIRE(kept.shelf.replace(name, bytesOf(first)).ok());
    CHECK(*kept.shelf.read(name) == first);
    CHECK(kept.shelf.replace("other.take", bytesOf(first)).code() == StatusCode::NotFound);
}

TEST_CASE("a take is moved away with its picture and back, once") {
    Kept kept;
    const std::string name = kept.put(madeTake(kept.base, 30));
    REQUIRE(kept.shelf.putPicture(name, bytesOf(kPng)).ok());
    CHECK(kept.shelf.list().front().picture);
    REQUIRE(kept.shelf.remove(name).ok());
    CHECK(kept.shelf.list().empty());
    CHECK_FALSE(kept.shelf.pictureOf(name).ok());
    CHECK(kept.shelf.remove(name).code() == StatusCode::NotFound);
    REQUIRE(kept.shelf.restore(name).ok());
    CHECK(kept.shelf.list().front().picture);
    CHECK(*readTextFile(*kept.shelf.pictureOf(name)) == kPng);
    CHECK(kept.shelf.restore(name).code() == StatusCode::NotFound);
}

TEST_CASE("a removed take does not replace one that has its name by now") {
    Kept kept;
    const std::string first = madeTake(kept.base, 30), second = madeTake(kept.base, 40);
    const std::string name = kept.put(first);
    REQUIRE(kept.shelf.remove(name).ok());
    REQUIRE(writeTextFile(kept.file(name).string(), second).ok());
    CHECK(kept.shelf.restore(name).message() == name + ": there is another one of this name");
    CHECK(*kept.shelf.read(name) == second);
}

TEST_CASE("pictures are PNG files of at most half a megabyte") {
    Kept kept;
    const std::string name = kept.put(madeTake(kept.base, 30));
    CHECK(kept.shelf.pictureOf(name).status().message() == name + ": has no picture");
    CHECK(kept.shelf.putPicture(name, bytesOf("GIF89a")).message() == "picture: found no PNG, expected one");
    CHECK(kept.shelf.putPicture(name, {}).message() == "picture: found no PNG, expected one");
    const std::string large = kPng + std::string(TakeShelf::kMostPictureBytes, ' ');
    CHECK(kept.shelf.putPicture(name, bytesOf(large)).code() == StatusCode::LimitExceeded);
    CHECK(kept.shelf.putPicture(name, bytesOf(large.substr(0, TakeShelf::kMostPictureBytes))).ok());
}

TEST_CASE("a take that is being recorded is shown as such and stays as it is") {
    Kept kept;
    auto sink = kept.shelf.record("Market square");
    REQUIRE(sink.ok());
    const std::string name = (*sink)->name();
    CHECK(name.find("Market-square-") == 0);
    const std::string bytes = madeTake(kept.base, 30);
    REQUIRE((*sink)->append(bytesOf(bytes)).ok());
    REQUIRE(kept.shelf.list().size() == 1);
    CHECK(kept.shelf.list().front().recording);
    CHECK(kept.shelf.edit(name, {}).message() == name + ": is being recorded; stop the recording first");
    CHECK(kept.shelf.remove(name).code() == StatusCode::Unsupported);
    REQUIRE((*sink)->finish().ok());
    sink->reset();
    CHECK_FALSE(kept.shelf.list().front().recording);
    CHECK(kept.shelf.remove(name).ok());
}

TEST_CASE("recordings of the same second have files of their own, and a discarded one is gone") {
    Kept kept;
    auto first = kept.shelf.record("a"), second = kept.shelf.record("a");
    REQUIRE(first.ok());
    REQUIRE(second.ok());
    CHECK((*first)->name() != (*second)->name());
    const fs::path file = kept.file((*second)->name());
    CHECK(fs::exists(file));
    CHECK((*second)->discard().ok());
    CHECK_FALSE(fs::exists(file));
    CHECK(fs::exists(kept.file((*first)->name())));
}
