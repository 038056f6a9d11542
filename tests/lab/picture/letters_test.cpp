// Names in any language in pictures that support plain letters only.
#include <doctest.h>

#include <string>
#include <vector>

#include "base/random.h"
#include "lab/picture/canvas.h"

using namespace muster;

TEST_CASE(
    "Latin letters lose their diacritics, each other code point and each stray byte becomes one question "
    "mark") {
    CHECK(plainLetters("plain ~ text") == "plain ~ text");
    CHECK(plainLetters("Flu\xc3\x9f \xc3\xbc"
                       "ber Stra\xc3\x9f"
                       "e") == "Flus uber Strase");
    // The ends of both blocks.
    CHECK(plainLetters("\xc3\x80\xc3\xbf\xc4\x80\xc5\xbe\xc5\xbf") == "AyAzs");
    CHECK(plainLetters("\xc5\x81\xc3\xb3"
                       "d\xc5\xba \xc3\x85ngstr\xc3\xb6m") == "Lodz Angstrom");
    // Two code points of three bytes each.
    CHECK(plainLetters("\xe6\xb3\xb3\xe3\x81\x90") == "??");
    CHECK(plainLetters("a\xf0\x9f\x8f\x8a"
                       "b") == "a?b");  // One code point of four bytes.
    CHECK(plainLetters("\t\n\x7f") == "???");
    CHECK(plainLetters("a\xc3") == "a?");
    CHECK(plainLetters("\xe6\xb3z\xffq\x80") == "?z?q?");
    CHECK(plainLetters("") == "");
}

TEST_CASE("for any bytes only letters of the font are drawn, and each has its width") {
    Random random(3);
    for (int round = 0; round < 2000; ++round) {
        std::string words(random.below(300), ' ');
        for (char& c : words) c = static_cast<char>(random.below(256));
        const std::string plain = plainLetters(words);
        CHECK(plain.size() <= words.size());
        for (const char c : plain) CHECK((c >= 32 && c <= 126));
        std::vector<std::vector<Vec2>> loops, again;
        const double width = letterLoops(words, 12.0, loops);
        CHECK(width == letterLoops(plain, 12.0, again));
        CHECK(loops == again);
        for (const auto& loop : loops) {
            for (const Vec2 p : loop)
                CHECK((p.x >= -1.0 && p.x <= width + 12.0 && p.y >= -12.0 && p.y <= 12.0));
        }
    }
    std::vector<std::vector<Vec2>> sharp, plain;
    letterLoops("Flu\xc3\x9f", 12.0, sharp);
    letterLoops("Flus", 12.0, plain);
    CHECK(sharp == plain);
    CHECK(!sharp.empty());
}
