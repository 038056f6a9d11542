// The parts of an HTTP request's target.
#pragma once

#include <string>
#include <string_view>

namespace muster {

/// The path alone.
inline std::string_view withoutQuery(std::string_view target) {
    return target.substr(0, target.find_first_of("?#"));
}

/// The value of "?name=" or "&name="; empty where there is none. Nothing is decoded: names are of letters,
/// digits, - and _.
inline std::string queryName(std::string_view target) {
    const std::string_view query = target.substr(withoutQuery(target).size());
    for (const std::string_view key : {"?name=", "&name="}) {
        const std::size_t at = query.find(key);
        if (at == std::string_view::npos) continue;
        const std::string_view value = query.substr(at + key.size());
        return std::string(value.substr(0, value.find_first_of("&#")));
    }
    return {};
}

}  // namespace muster
