// Text and numbers of the report.
#include "files/report/markup.h"

#include <doctest.h>

#include <limits>

#include "lab/reproduce/fake.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("text is escaped, and made UTF-8 where it is none") {
    CHECK(escaped("a < b && \"c\" > 'd'") == "a &lt; b &amp;&amp; &quot;c&quot; &gt; 'd'");
    CHECK(escaped("m² → 20°, Ünï") == "m² → 20°, Ünï");
    CHECK(escaped(std::string_view("a\0b\x01\x7f\tc\nd", 9)) == "ab c d");
    const std::string bad = "\xEF\xBF\xBD";
    CHECK(escaped("\xff") == bad);
    CHECK(escaped("\xc3") == bad);                      // Cut short.
    CHECK(escaped("\xc0\xbc") == bad + bad);            // "<" in too many bytes.
    CHECK(escaped("\xed\xa0\x80") == bad + bad + bad);  // A surrogate.
    CHECK(escaped("\xef\xbf\xbe") == bad + bad + bad);  // XML has no U+FFFE.
    CHECK(escaped("\xf0\x9f\x98\x80") == "\xf0\x9f\x98\x80");
}

TEST_CASE("paragraphs end with line breaks") {
    CHECK(paragraphs("one\ntwo <b>\n\n  \nthree") == "<p>one</p>\n<p>two &lt;b&gt;</p>\n<p>three</p>\n");
    CHECK(paragraphs("").empty());
}

TEST_CASE("cells of Markdown stay cells") {
    CHECK(markdownCell("a | b\n*c* `d` [e] <f>") == "a \\| b \\*c\\* \\`d\\` \\[e\\] &lt;f&gt;");
}

TEST_CASE("words are wrapped by letters, not bytes") {
    CHECK(wrapped("the quick brown fox", 9) == std::vector<std::string>{"the quick", "brown fox"});
    CHECK(wrapped("üüü üüü", 7) == std::vector<std::string>{"üüü üüü"});
    CHECK(wrapped("an unbreakable word", 5) == std::vector<std::string>{"an", "unbreakable", "word"});
    CHECK(wrapped("", 5).empty());
    CHECK(letters("m²…") == 3);
}

TEST_CASE("numbers with a fixed number of decimals") {
    CHECK(fixedNumber(1.005, 1) == "1.0");
    CHECK(fixedNumber(-0.001, 2) == "0.00");
    CHECK(fixedNumber(-1.5, 0) == "-2");
    CHECK(fixedNumber(1234.5, 1) == "1234.5");
    CHECK(fixedNumber(12345.5, 1) == "12,345.5");
    CHECK(fixedNumber(-1234567.0, 0) == "-1,234,567");
    CHECK(fixedNumber(kNone, 2) == "no value");
    CHECK(fixedNumber(kEndless, 2) == "infinite");
    CHECK(fixedNumber(-kEndless, 2) == "minus infinite");
    CHECK(fixedNumber(1e300, 17).size() > 300);
}

TEST_CASE("numbers as short as four digits allow") {
    CHECK(plainNumber(36.0) == "36");
    CHECK(plainNumber(0.0) == "0");
    CHECK(plainNumber(0.5) == "0.5");
    CHECK(plainNumber(0.0123456) == "0.01235");
    CHECK(plainNumber(12345.678) == "12,346");
    CHECK(plainNumber(-2.0) == "-2");
    CHECK(plainNumber(100.0) == "100");
}

TEST_CASE("a value beside its threshold is not shown as the threshold") {
    CHECK(judgedNumber(5.0, 5.0) == "5");
    CHECK(judgedNumber(4.99996, 5.0) == "4.99996");
    CHECK(judgedNumber(1.0 + 1e-9, 1.0) == "1.000000001");
    CHECK(judgedNumber(4.2, 5.0) == "4.2");
    CHECK(judgedNumber(kNone, 5.0) == "no value");
}

TEST_CASE("units and counts") {
    CHECK(withUnit("12", "s") == "12 s");
    CHECK(withUnit("12", "") == "12");
    CHECK(missingWord("s") == "not reached");
    CHECK(missingWord("m") == "no value");
    CHECK(counted(1, "seed", "seeds") == "1 seed");
    CHECK(counted(0, "seed", "seeds") == "0 seeds");
    CHECK(svgNumber(1.0 / 3.0) == "0.33");
    CHECK(svgNumber(-0.001) == "0");
    CHECK(svgNumber(kNone) == "0");
}
