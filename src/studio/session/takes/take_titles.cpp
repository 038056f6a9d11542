#include "studio/session/takes/take_titles.h"

#include <algorithm>
#include <charconv>

namespace muster {
namespace {

constexpr std::size_t kMostDigits = 6;

/// The number behind the last ", " of a title; 0 for none.
unsigned numberOf(const std::string& title, std::size_t comma) {
    if (comma == std::string::npos || comma == 0) return 0;
    const char* begin = title.data() + comma + 2;
    const char* end = title.data() + title.size();
    unsigned number = 0;
    const bool fits = begin != end && end - begin <= static_cast<std::ptrdiff_t>(kMostDigits);
    return fits && std::from_chars(begin, end, number).ptr == end ? number : 0;
}

}  // namespace

std::string nextTitle(const std::string& title, const std::vector<std::string>& taken) {
    const std::size_t comma = title.rfind(", ");
    unsigned number = numberOf(title, comma);
    const std::string base = number > 0 ? title.substr(0, comma) : title;
    std::string next;
    do {
        number = std::max(number, 1u) + 1;
        next = base + ", " + std::to_string(number);
    } while (std::find(taken.begin(), taken.end(), next) != taken.end());
    return next;
}

}  // namespace muster
