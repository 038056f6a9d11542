#include "studio/words/tokens.h"

#include <algorithm>
#include <array>
#include <utility>

namespace muster::words {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 26> kNumberWords{
    {{"zero", 0},    {"one", 1},       {"two", 2},       {"three", 3},    {"four", 4},      {"five", 5},
     {"six", 6},     {"seven", 7},     {"eight", 8},     {"nine", 9},     {"ten", 10},      {"eleven", 11},
     {"twelve", 12}, {"thirteen", 13}, {"fourteen", 14}, {"fifteen", 15}, {"sixteen", 16},  {"twenty", 20},
     {"thirty", 30}, {"forty", 40},    {"fifty", 50},    {"sixty", 60},   {"hundred", 100}, {"dozen", 12},
     {"couple", 2},  {"seventeen", 17}}};
constexpr std::size_t kMostDigits = 9;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}
bool isMark(char c) {
    return std::string_view(",.;:?!%()\"/+-").find(c) != std::string_view::npos;
}

class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::vector<Token> all() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (isDigit(c) || (isSign(c) && isDigitAt(at_ + 1)))
                number();
            else if (isLetter(c))
                word();
            else if (isMark(c))
                put(at_ + 1);
            else
                ++at_;
        }
        return std::move(tokens_);
    }

private:
    bool isDigitAt(std::size_t at) const { return at < text_.size() && isDigit(text_[at]); }
    /// A minus belongs to a number unless it joins two, as in "2-3".
    bool isSign(char c) const { return c == '-' && (at_ == 0 || !isDigit(text_[at_ - 1])); }

    void put(std::size_t end) {
        Token token;
        token.from = at_;
        token.end = end;
        for (const char c : text_.substr(at_, end - at_)) token.text += smallLetter(c);
        at_ = end;
        tokens_.push_back(std::move(token));
    }

    void number() {
        std::size_t end = at_ + (text_[at_] == '-' ? 1 : 0);
        double value = 0.0, unit = 1.0;
        std::size_t digits = 0;
        bool behind = false;
        for (; end < text_.size() && digits < kMostDigits; ++end) {
            if (text_[end] == '.' && !behind && isDigitAt(end + 1)) {
                behind = true;
                continue;
            }
            if (!isDigit(text_[end])) break;
            ++digits;
            value = value * 10.0 + (text_[end] - '0');
            if (behind) unit *= 10.0;
        }
        const bool negative = text_[at_] == '-';
        put(end);
        tokens_.back().number = (negative ? -value : value) / unit;
        tokens_.back().digits = true;
    }

    void word() {
        std::size_t end = at_ + 1;
        const auto joins = [&](std::size_t at) {
            return (text_[at] == '-' || text_[at] == '\'') && at + 1 < text_.size() &&
                   isLetter(text_[at + 1]);
        };
        while (end < text_.size() && (isLetter(text_[end]) || joins(end))) ++end;
        put(end);
        Token& token = tokens_.back();
        const auto found = std::find_if(kNumberWords.begin(), kNumberWords.end(),
                                        [&](const auto& entry) { return entry.first == token.text; });
        if (found != kNumberWords.end()) token.number = found->second;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::vector<Token> tokens_;
};

}  // namespace

char smallLetter(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::vector<Token> tokensOf(std::string_view text) {
    return Scanner(text).all();
}

std::vector<std::string> wordsOfName(std::string_view name) {
    std::vector<std::string> words;
    for (Token& token : tokensOf(name)) words.push_back(std::move(token.text));
    return words;
}

// Damerau's distance with neighbours exchanged once, row by row.
std::size_t lettersBetween(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = a[i - 1] == b[j - 1];
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0u : 1u)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

}  // namespace muster::words
