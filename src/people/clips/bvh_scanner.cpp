#include "people/clips/bvh_scanner.h"

#include <cctype>
#include <cmath>
#include <cstdint>

namespace muster {
namespace {

bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v' || c == '\0';
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isBrace(char c) {
    return c == '{' || c == '}';
}

/// A decimal number: `digits` times ten to the power of `exponent`.
struct Decimal {
    std::uint64_t digits = 0;
    int exponent = 0;
    bool negative = false;
    bool exact = true;  ///< False if digits were dropped.
};

/// Reads digits into `number`; returns their count.
std::size_t readDigits(std::string_view text, std::size_t& at, Decimal& number, bool fraction) {
    const std::size_t begin = at;
    for (; at < text.size() && isDigit(text[at]); ++at) {
        if (number.digits < 100000000000000000ull) {
            number.digits = number.digits * 10 + static_cast<std::uint64_t>(text[at] - '0');
            number.exponent -= fraction ? 1 : 0;
        } else {
            number.exact = false;
            number.exponent += fraction ? 0 : 1;
        }
    }
    return at - begin;
}

/// Reads a decimal number; false if `text` as a whole is not one.
bool readDecimal(std::string_view text, Decimal& number) {
    std::size_t at = 0;
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) number.negative = text[at++] == '-';
    std::size_t digits = readDigits(text, at, number, false);
    if (at < text.size() && text[at] == '.') {
        ++at;
        digits += readDigits(text, at, number, true);
    }
    if (digits == 0) return false;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        bool minus = false;
        if (at < text.size() && (text[at] == '-' || text[at] == '+')) minus = text[at++] == '-';
        int exponent = 0;
        const std::size_t begin = at;
        for (; at < text.size() && isDigit(text[at]); ++at)
            exponent = exponent < 10000 ? exponent * 10 + (text[at] - '0') : exponent;
        if (at == begin) return false;
        number.exponent += minus ? -exponent : exponent;
    }
    return at == text.size();
}

/// The correctly rounded value. One exact multiplication or division is used where that suffices (Clinger
/// 1990), else the C library.
double valueOf(const Decimal& number, std::string_view text) {
    static constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    if (!number.exact || number.digits >= (1ull << 53) || number.exponent < -22 || number.exponent > 22)
        return std::strtod(std::string(text).c_str(), nullptr);
    const auto digits = static_cast<double>(number.digits);
    const double size = number.exponent < 0 ? digits / kPowers[-number.exponent]
                                            : digits * kPowers[number.exponent];
    return number.negative ? -size : size;
}

}  // namespace

std::string lowered(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return small;
}

bool sameWord(std::string_view a, std::string_view b) {
    return lowered(a) == lowered(b);
}

void BvhScanner::skipSpace() {
    for (; at_ < text_.size() && isSpace(text_[at_]); ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
}

std::string_view BvhScanner::word() {
    skipSpace();
    wordLine_ = line_;
    const std::size_t begin = at_;
    if (at_ < text_.size() && isBrace(text_[at_])) {
        ++at_;
    } else {
        while (at_ < text_.size() && !isSpace(text_[at_]) && !isBrace(text_[at_])) ++at_;
    }
    last_ = text_.substr(begin, at_ - begin);
    return last_;
}

std::string_view BvhScanner::keyword() {
    skipSpace();
    wordLine_ = line_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_]))) ++at_;
    if (at_ == begin) return word();
    last_ = text_.substr(begin, at_ - begin);
    return last_;
}

std::string_view BvhScanner::restOfLine() {
    wordLine_ = line_;
    std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r' && !isBrace(text_[at_])) ++at_;
    std::size_t end = at_;
    while (begin < end && (isSpace(text_[begin]) || text_[begin] == ':')) ++begin;
    while (end > begin && isSpace(text_[end - 1])) --end;
    last_ = text_.substr(begin, end - begin);
    return last_;
}

void BvhScanner::skipColons() {
    skipSpace();
    while (at_ < text_.size() && text_[at_] == ':') {
        ++at_;
        skipSpace();
    }
}

bool BvhScanner::number(double& value) {
    Decimal decimal;
    const std::string_view text = word();
    if (!readDecimal(text, decimal)) return false;
    value = valueOf(decimal, text);
    return std::fabs(value) <= 1e9;
}

bool BvhScanner::count(std::size_t& value) {
    double found = 0.0;
    if (!number(found) || found < 0.0 || found != std::floor(found)) return false;
    value = static_cast<std::size_t>(found);
    return true;
}

Status BvhScanner::unexpected(std::string_view expected, std::string_view found) const {
    std::string what(found);
    if (what.empty())
        what = last_.empty() ? "the end of the file"
                             : std::string("\"").append(last_.substr(0, 40)).append("\"");
    for (char& c : what)
        if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
    return {StatusCode::ParseError, source_ + ":" + std::to_string(wordLine_) + ": found " + what +
                                        ", expected " + std::string(expected)};
}

}  // namespace muster
