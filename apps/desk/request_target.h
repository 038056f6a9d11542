// The parts of an HTTP request's target.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace muster {

/// The path alone.
inline std::string_view withoutQuery(std::string_view target) {
    return target.substr(0, target.find_first_of("?#"));
}

/// The value of "?key=" or "&key="; empty where there is none.
inline std::string_view queryValue(std::string_view target, std::string_view key) {
    std::string_view query = target.substr(withoutQuery(target).size());
    while (!query.empty() && query.front() != '#') {
        query.remove_prefix(1);
        const std::string_view pair = query.substr(0, query.find_first_of("&#"));
        if (pair.size() > key.size() && pair.starts_with(key) && pair[key.size()] == '=')
            return pair.substr(key.size() + 1);
        query.remove_prefix(pair.size());
    }
    return {};
}

/// The same as a number; 0 where there is none.
inline std::uint64_t queryCount(std::string_view target, std::string_view key) {
    const std::string_view text = queryValue(target, key);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

/// The value of "?name=" or "&name="; empty where there is none. Nothing is decoded: names are of letters,
/// digits, - and _.
inline std::string queryName(std::string_view target) {
    return std::string(queryValue(target, "name"));
}

/// Who asks, by "?by=", as Welcome calls them; 0 for somebody.
inline std::uint32_t queryDirector(std::string_view target) {
    return static_cast<std::uint32_t>(queryCount(target, "by"));
}

}  // namespace muster
