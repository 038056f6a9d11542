// USD text, read back line by line.
#include <doctest.h>

#include <sstream>

#include "base/text_file.h"
#include "files/export/character_look.h"
#include "files/export/crate_tables.h"
#include "files/export/formats.h"
#include "files/export/pretend_take.h"
#include "files/export/scene_mesh.h"
#include "files/export/usd_text.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr std::size_t kUsdFrames = 75;

const std::string& pretendedUsd() {
    static const std::string text = [] {
        const std::string path = (exportFolder() / "pretendedUsd.usda").string();
        const Status status = exportPretendTake(*makeUsdExporter(path), kUsdFrames);
        REQUIRE_MESSAGE(status.ok(), status.message());
        return *readTextFile(path, 1u << 30);
    }();
    return text;
}

/// The text of a prim, including its braces.
std::string prim(const std::string& text, const std::string& head) {
    const std::size_t begin = text.find(head);
    REQUIRE(begin != std::string::npos);
    std::size_t at = text.find('{', begin);
    for (int depth = 0; at < text.size(); ++at) {
        depth += text[at] == '{' ? 1 : text[at] == '}' ? -1 : 0;
        if (depth == 0) break;
    }
    return text.substr(begin, at + 1 - begin);
}

/// The numbers of one time sample of an attribute, without the time code.
std::vector<double> sample(const std::string& text, const std::string& attribute, std::size_t frame) {
    std::istringstream lines(prim(text, attribute + ".timeSamples"));
    std::string line;
    std::getline(lines, line);
    for (std::size_t k = 0; k <= frame; ++k) std::getline(lines, line);
    for (char& c : line)
        if (std::string_view("[](),:").find(c) != std::string_view::npos) c = ' ';
    std::istringstream numbers(line);
    std::vector<double> values;
    for (double value = 0.0; numbers >> value;) values.push_back(value);
    REQUIRE(!values.empty());
    REQUIRE(values.front() == static_cast<double>(frame));
    values.erase(values.begin());
    return values;
}

/// The positions of all joints of a character in the world, computed from the file alone.
std::vector<Vec3> jointsIn(const std::string& text, std::uint32_t id, std::size_t frame) {
    const std::string root = prim(text, "def SkelRoot \"character_000" + std::to_string(id) + "\"");
    const auto place = sample(root, "xformOp:translate", frame),
               turn = sample(root, "xformOp:rotateZ", frame);
    const auto rotations = sample(root, "rotations", frame),
               hips = sample(root, "xformOp:translate:hips", frame);
    REQUIRE(rotations.size() == 4 * kJointCount);
    const auto f = [](double v) { return static_cast<float>(v); };
    const Transform base{yawTurn(turn[0] * kPi / 180.0), {f(place[0]), f(place[1]), f(place[2])}};
    std::vector<Transform> joints;
    std::vector<Vec3> places;
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const double* q = &rotations[4 * j];
        Vec3 place = skeleton()[j].offset;
        if (j == 0) place += Vec3{f(hips[0]), f(hips[1]), f(hips[2])};
        const Transform local{normalized(Quat{f(q[1]), f(q[2]), f(q[3]), f(q[0])}), place};
        const std::int32_t parent = skeleton()[j].parent;
        joints.push_back(parent < 0 ? local : joints[parent] * local);
        places.push_back(base.apply(joints[j].translation * characterSize(id)));
    }
    return places;
}

}  // namespace

TEST_CASE("joints in the USD have Muster's positions") {
    float worst = 0.0f;
    for (const std::size_t frame : {0, 15, 16, 25, 49, 74}) {
        const PretendFrame people = pretendPeople(1, peopleIn(frame),
                                                  1.0 + static_cast<double>(frame) / 30.0);
        for (const ExportCharacter& c : people.characters) {
            const JointTransforms wanted = jointsOf(c);
            const auto found = jointsIn(pretendedUsd(), c.id, frame);
            for (std::size_t j = 0; j < kJointCount; ++j)
                worst = std::max(worst, distance(found[j], wanted[j].translation));
        }
    }
    MESSAGE("measured: joints in the USD differ by at most " << 1000.0f * worst << " mm");
    CHECK(worst < 0.001f);
}

TEST_CASE("all brackets close, every line of samples exists, and no name occurs twice") {
    const std::string& text = pretendedUsd();
    std::vector<char> open;
    bool quoted = false;
    for (const char c : text) {
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '(' || c == '[' || c == '{') open.push_back(c);
        if (c != ')' && c != ']' && c != '}') continue;
        REQUIRE(!open.empty());
        REQUIRE(open.back() == (c == ')' ? '(' : c == ']' ? '[' : '{'));
        open.pop_back();
    }
    CHECK(open.empty());
    CHECK(!quoted);
    CHECK(text.find("endTimeCode = 74\n") != std::string::npos);
    std::vector<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("    def ", 0) == 0 || line.rfind("    class ", 0) == 0)
            names.push_back(line.substr(line.find('"')));
    std::sort(names.begin(), names.end());
    CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
    CHECK(names.size() == 2 + 5 + 4 + 1);
}

TEST_CASE("who has a chosen colour wears it, in a material of their own") {
    WorldDef def = furnishedWorld();
    def.groups[0].colour = 0xFF8000;
    const auto world = World::create(def);
    REQUIRE(world.ok());
    const CharacterLook look = characterLook(2, 0, *world);
    CHECK(regionColour(BodyRegion::Shirt, look).colour == 0xFF8000u);
    CHECK(regionColour(BodyRegion::Shirt, look).name == "shirt ff8000");
    const std::string path = (exportFolder() / "coloured.usda").string();
    const auto exporter = makeUsdExporter(path);
    REQUIRE(exporter->begin({"Coloured", 30.0, 1.0, 1, &*world}).ok());
    const PretendFrame frame = pretendPeople(2, 3, 1.0);
    REQUIRE(exporter->frame({0, 1.0, frame.characters, &*world}).ok());
    REQUIRE(exporter->finish().ok());
    const std::string text = *readTextFile(path, 1u << 30);
    const std::string person = prim(text, "def SkelRoot \"character_0002\"");
    const std::string shirt = prim(person, "def Material \"shirt_ff8000\"");
    CHECK(person.find("material:binding = </World/character_0002/shirt_ff8000>") != std::string::npos);
    CHECK(shirt.find("</World/character_0002/shirt_ff8000/Surface.outputs:surface>") != std::string::npos);
    const Vec3 colour = linearColour(0xFF8000);
    CHECK(shirt.find("diffuseColor = (1, " + usdNumber(static_cast<double>(colour.y)) + ", 0)") !=
          std::string::npos);
}

TEST_CASE("rotations continue without jumps") {
    const std::string root = prim(pretendedUsd(), "def SkelRoot \"character_0002\"");
    for (std::size_t k = 1; k < kUsdFrames; ++k)
        CHECK(std::fabs(sample(root, "xformOp:rotateZ", k)[0] - sample(root, "xformOp:rotateZ", k - 1)[0]) <
              5.0);
}

TEST_CASE("a character that appears late and leaves early is invisible while absent") {
    const std::string late = prim(prim(pretendedUsd(), "def SkelRoot \"character_0004\""),
                                  "visibility.timeSamples");
    CHECK(late.find(" 0: \"invisible\"") != std::string::npos);
    CHECK(late.find(" 20: \"inherited\"") != std::string::npos);
    CHECK(late.find(" 50: \"invisible\"") != std::string::npos);
    const std::string always = prim(prim(pretendedUsd(), "def SkelRoot \"character_0001\""),
                                    "visibility.timeSamples");
    CHECK(always.find("invisible") == std::string::npos);
}

TEST_CASE("numbers keep their columns at any size") {
    for (const double value : {0.0, -1.0, 0.123456789, 12345.678, -99999.5, 1e9, -1e12}) {
        std::string text;
        usdFixed(value, 10, 5, text);
        CHECK(text.size() == 10);
    }
    std::string text;
    usdFixed(-1.25, 9, 6, text);
    CHECK(text == "-1.250000");
}

TEST_CASE("names become valid USD names") {
    CHECK(usdName("North stand") == "North_stand");
    CHECK(usdName("2nd") == "_2nd");
    CHECK(usdName("") == "_");
    CHECK(usdName("Stra\xc3\x9f"
                  "e") == "Stra__e");
}

namespace {

std::uint32_t wordAt(const std::string& bytes, std::size_t at, std::size_t width) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < width; ++i)
        value |= std::uint32_t{static_cast<std::uint8_t>(bytes.at(at + i))} << (8 * i);
    return value;
}

/// Reads literals of LZ4 behind the number of blocks.
std::string unpacked(const std::string& bytes) {
    REQUIRE(bytes.at(0) == 0);
    std::size_t at = 2, length = static_cast<std::uint8_t>(bytes.at(1)) >> 4;
    CHECK((bytes[1] & 15) == 0);
    for (std::uint8_t more = length == 15 ? 255 : 0; more == 255; length += more)
        more = static_cast<std::uint8_t>(bytes.at(at++));
    CHECK(bytes.size() == at + length);
    return bytes.substr(at);
}

std::vector<std::uint32_t> numbersIn(const std::string& packed, std::size_t count) {
    const std::string bytes = unpacked(packed);
    std::vector<std::uint32_t> numbers;
    std::size_t at = 4 + (count * 2 + 7) / 8;
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const int code = bytes.at(4 + i / 4) >> (2 * (i % 4)) & 3;
        const std::size_t width = code == 3 ? 4 : static_cast<std::size_t>(code);
        std::uint32_t step = wordAt(bytes, width == 0 ? 0 : at, width == 0 ? 4 : width);
        if (width == 1) step = static_cast<std::uint32_t>(static_cast<std::int8_t>(step));
        if (width == 2) step = static_cast<std::uint32_t>(static_cast<std::int16_t>(step));
        at += width;
        numbers.push_back(number += step);
    }
    CHECK(at == bytes.size());
    return numbers;
}

}  // namespace

TEST_CASE("numbers of binary USD are packed by their differences") {
    for (const std::size_t size : {0, 3, 14, 15, 269, 270, 600})
        CHECK(unpacked(crateBytes(std::string(size, 'x'))) == std::string(size, 'x'));
    const std::vector<std::uint32_t> numbers{0,     1, 2,           3, 4, 100,         99,
                                             40000, 5, 0xffffffffu, 7, 8, 0x80000000u, 6};
    CHECK(numbersIn(crateNumbers(numbers), numbers.size()) == numbers);
}

TEST_CASE("binary USD has the head of its format, and grows by at most half as much as the text") {
    const auto made = [](auto make, std::size_t frames) {
        const std::string path = (exportFolder() / "pretended.usd").string();
        REQUIRE(exportPretendTake(*make(path), frames).ok());
        return *readTextFile(path, 1u << 30);
    };
    const std::string bytes = made(makeUsdCrateExporter, kUsdFrames);
    CHECK(bytes.substr(0, 11) == std::string("PXR-USDC\0\10\0", 11));
    const std::size_t list = wordAt(bytes, 16, 4);
    REQUIRE(wordAt(bytes, list, 4) == 6);
    std::size_t next = wordAt(bytes, list + 8 + 16, 4);
    for (std::size_t k = 0; k < 6; ++k) {
        const std::size_t entry = list + 8 + 32 * k;
        CHECK(wordAt(bytes, entry + 16, 4) == next);
        next += wordAt(bytes, entry + 24, 4);
    }
    CHECK(next == list);
    CHECK(bytes.size() == list + 8 + 6 * 32);
    const std::size_t binary = bytes.size() - made(makeUsdCrateExporter, 25).size();
    const std::size_t text = pretendedUsd().size() - made(makeUsdExporter, 25).size();
    MESSAGE("measured: 50 frames take " << binary << " bytes in USDC, " << text << " in USDA");
    CHECK(2 * binary < text);
}
