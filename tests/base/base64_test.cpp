// Base64, by the test vectors of RFC 4648.
#include <doctest.h>

#include <string>
#include <vector>

#include "base/base64.h"

using namespace muster;

TEST_CASE("base64 gives the test vectors of its standard") {
    const std::pair<std::string, std::string> vectors[] = {{"", ""},
                                                           {"f", "Zg=="},
                                                           {"fo", "Zm8="},
                                                           {"foo", "Zm9v"},
                                                           {"foob", "Zm9vYg=="},
                                                           {"fooba", "Zm9vYmE="},
                                                           {"foobar", "Zm9vYmFy"}};
    for (const auto& [text, encoded] : vectors)
        CHECK(base64(std::vector<std::uint8_t>(text.begin(), text.end())) == encoded);
    CHECK(base64(std::vector<std::uint8_t>{0xFB, 0xFF, 0xBF}) == "+/+/");
}
