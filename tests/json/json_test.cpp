// JSON values, read and written.
#include "json/json.h"

#include <doctest.h>

#include <cmath>

using namespace muster;

namespace {

std::string failureOf(const char* text) {
    const auto json = parseJson(text, "file");
    return json.ok() ? std::string() : json.status().message();
}

}  // namespace

TEST_CASE("printed JSON reads back the same, and keeps to lines") {
    Json value = {{"points", Json::array()}, {"text", "a\"b"}, {"nested", {{"deep", {{"deeper", 1.5}}}}}};
    for (int i = 0; i < 200; ++i) value["points"].push(Json::array({i * 0.1, -i / 3.0}));
    const std::string text = printJson(value);
    CHECK(compactJson(*parseJson(text, "printed")) == compactJson(value));
    CHECK(compactJson(*parseJson(indentedJson(value, 2), "printed")) == compactJson(value));
    std::size_t start = 0;
    while (start < text.size()) {
        const std::size_t end = text.find('\n', start);
        CHECK(end - start <= 120);
        start = end + 1;
    }
}

TEST_CASE("objects keep the order of keys; null becomes what is added to it") {
    Json value;
    value["b"] = 1;
    value["a"].push("x");
    value["a"].push(nullptr);
    CHECK(compactJson(value) == "{\"b\":1,\"a\":[\"x\",null]}");
    CHECK(value.find("c") == nullptr);
    CHECK(Json(3).find("c") == nullptr);
    value.erase("b");
    CHECK(value.size() == 1);
    const Json copy = value;
    value["a"].push(true);
    CHECK(copy.find("a")->size() == 2);
}

TEST_CASE("numbers are the shortest that read back to the same bits") {
    CHECK(compactJson(Json::array({0.1, 1.0, -0.0, 1e300, 1.0 / 3.0})) ==
          "[0.1,1.0,-0.0,1e+300,0.3333333333333333]");
    CHECK(compactJson(Json(std::nan(""))) == "null");
    CHECK(compactJson(Json(~std::uint64_t{0})) == "18446744073709551615");
    CHECK(parseJson("18446744073709551615", "file")->whole<std::uint64_t>() == ~std::uint64_t{0});
    CHECK(parseJson("-3", "file")->number() == -3.0);
}

TEST_CASE("texts are escaped, and what is no UTF-8 is replaced") {
    CHECK(jsonText("a\"\\\n\x01") == "\"a\\\"\\\\\\n\\u0001\"");
    CHECK(jsonText("\xc3\xa9") == "\"\xc3\xa9\"");
    CHECK(jsonText("\xff") == "\"\xef\xbf\xbd\"");
    CHECK(jsonText("\xe2\x82") == "\"\xef\xbf\xbd\"");
    CHECK(jsonText("\xed\xa0\x80") == "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\"");
}

TEST_CASE("parsing is strict, and errors name line and column") {
    CHECK(failureOf("{\"a\": 1,\n \"a\": 2}").find("the key \"a\" stands twice in one object") !=
          std::string::npos);
    CHECK(failureOf("[1,\n 2,]").rfind("file:2:", 0) == 0);
    CHECK(failureOf("// no\n[]") != "");
    CHECK(failureOf(std::string(65, '[').c_str()).find("64 levels") != std::string::npos);
    CHECK(describeJson(*parseJson("[1, 2]", "file")) == "an array of 2");
    CHECK(describeJson(Json("abc")) == "the text \"abc\"");
}
