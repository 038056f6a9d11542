#include "files/report/markup.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace muster {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// Number of bytes of the code point that begins there; 0 if it is not UTF-8 or not allowed in XML.
std::size_t codePointLength(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
    };
    const std::uint32_t first = byte(at);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    if (length == 0 || at + length > text.size()) return 0;
    std::uint32_t point = first & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(at + i) & 0xC0u) != 0x80u) return 0;
        point = point << 6 | (byte(at + i) & 0x3Fu);
    }
    constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = point >= 0xD800 && point <= 0xDFFF;
    const bool none = point < kLeast[length] || point > 0x10FFFF || surrogate || (point & 0xFFFEu) == 0xFFFE;
    return none ? 0 : length;
}

void addEscaped(std::string& out, char c) {
    if (c == '<')
        out += "&lt;";
    else if (c == '>')
        out += "&gt;";
    else if (c == '&')
        out += "&amp;";
    else if (c == '"')
        out += "&quot;";
    else if (c == '\n' || c == '\t')
        out += ' ';
    else if (static_cast<unsigned char>(c) >= 32 && c != 127)
        out += c;
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(separator, from), text.size());
        if (end > from) parts.emplace_back(text.substr(from, end - from));
        from = end + 1;
    }
    return parts;
}

std::string printed(double value, int decimals) {
    char buffer[400];
    std::snprintf(buffer, sizeof(buffer), "%.*f", std::clamp(decimals, 0, 17), value);
    return buffer;
}

std::string withCommas(std::string text) {
    const std::size_t from = text.rfind('-', 0) == 0 ? 1 : 0;
    const std::size_t whole = std::min(text.find('.'), text.size());
    if (whole - from <= 4) return text;
    for (std::size_t at = whole; at > from + 3;) text.insert(at -= 3, ",");
    return text;
}

std::string withoutZeros(std::string text) {
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// Number of decimals for that many significant digits.
int decimalsFor(double value, int digits) {
    if (value == 0.0) return 0;
    return std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = codePointLength(text, at);
        if (length == 1)
            addEscaped(out, text[at]);
        else
            out += length == 0 ? kReplacement : text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
    return out;
}

std::string paragraphs(std::string_view text) {
    std::string out;
    for (const std::string& part : split(text, '\n')) {
        if (part.find_first_not_of(" \t\r") != std::string::npos) out += "<p>" + escaped(part) + "</p>\n";
    }
    return out;
}

std::string markdownCell(std::string_view text) {
    std::string out;
    const std::string html = escaped(text);
    for (const char c : html) {
        if (std::string_view("|*_`[]\\~").find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
    return out;
}

std::size_t letters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

std::vector<std::string> wrapped(std::string_view text, std::size_t most) {
    std::vector<std::string> lines;
    for (const std::string& word : split(text, ' ')) {
        if (lines.empty() || letters(lines.back()) + 1 + letters(word) > most)
            lines.push_back(word);
        else
            lines.back() += " " + word;
    }
    return lines;
}

std::string fixedNumber(double value, int decimals) {
    if (std::isnan(value)) return "no value";
    if (std::isinf(value)) return value > 0.0 ? "infinite" : "minus infinite";
    std::string text = printed(value, decimals);
    if (text.find_first_not_of("-0.") == std::string::npos && text[0] == '-') text.erase(0, 1);
    return withCommas(text);
}

std::string plainNumber(double value) {
    if (!std::isfinite(value)) return fixedNumber(value, 0);
    return withoutZeros(fixedNumber(value, decimalsFor(value, 4)));
}

std::string judgedNumber(double value, double threshold) {
    std::string text = plainNumber(value);
    if (!std::isfinite(value) || !std::isfinite(threshold) || value == threshold) return text;
    for (int digits = 5; digits <= 17 && text == plainNumber(threshold); ++digits)
        text = withoutZeros(fixedNumber(value, decimalsFor(value, digits)));
    return text;
}

std::string missingWord(std::string_view unit) {
    return unit == "s" || unit == "ms" || unit == "min" ? "not reached" : "no value";
}

std::string withUnit(const std::string& number, std::string_view unit) {
    return unit.empty() ? number : number + " " + std::string(unit);
}

std::string counted(std::size_t number, std::string_view one, std::string_view several) {
    return std::to_string(number) + " " + std::string(number == 1 ? one : several);
}

std::string svgNumber(double value) {
    if (!std::isfinite(value)) return "0";
    const std::string text = withoutZeros(printed(value, 2));
    return text == "-0" ? "0" : text;
}

std::string lowerCase(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

}  // namespace muster
