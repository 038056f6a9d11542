#include "studio/words/reader.h"

#include <algorithm>
#include <utility>

namespace muster::words {
namespace {

constexpr std::size_t kMostTokens = 160;
constexpr std::size_t kMostClauses = 24;
/// A word that is farther from all others gets no suggestion [letters].
constexpr std::size_t kMostLetters = 2;

}  // namespace

Reading Reader::read() {
    if (tokens_.size() > kMostTokens)
        fail("That is too long: say it in several sentences of at most " + std::to_string(kMostTokens) +
             " words.");
    while (!atEnd() && problem_.empty()) {
        const std::size_t before = at_;
        readOne();
        if (at_ == before && problem_.empty()) failAtWord();
        if (clauses_.size() > kMostClauses) fail("That is too much at once: say it in several sentences.");
    }
    for (Clause& clause : clauses_)
        for (Act& act : clause.acts) settleForm(act);
    return {std::move(clauses_), std::move(problem_)};
}

// The order matters: what is longer or more special comes first.
void Reader::readOne() {
    if (readMark() || !problem_.empty()) return;
    if (readNewWho() || !problem_.empty()) return;
    if (readHow() || !problem_.empty()) return;
    if (readVerb()) return;
    if (isFiller(word())) ++at_;
}

// Where a clause ends, and what comes after another.
bool Reader::readMark() {
    if (takePhrase("after that") || takePhrase("and then") || takePhrase("once there") ||
        take({"then", "afterwards", "afterward", "finally", "later"})) {
        boundary_ = then_ = true;
        return true;
    }
    if (isOneOf({",", ";", ".", ":", "!", "?", "and", "while", "but", "as"})) {
        if (word() == "as" && (formOf(word(1)) || formOf(word(2)))) return false;
        ++at_;
        boundary_ = true;
        return true;
    }
    return take({"\"", "(", ")"});
}

// A clause has one subject; a new one begins behind a mark, or where there is none yet.
bool Reader::readNewWho() {
    const bool open = !clauses_.empty() && !clauses_.back().acts.empty();
    const bool hasWho = !clauses_.empty() && clauses_.back().who.has_value();
    if (!boundary_ && hasWho) return open && take({"them", "it", "they"});  // The same as before.
    if (take({"with", "using"})) {
        if (hasWho) return --at_, false;
    }
    const std::size_t before = at_;
    // "walk north" says where to, although a group may be called North.
    if (open && !boundary_ && headingOf(word()) && isEndOfClause(1)) return false;
    std::optional<Who> who = readWho();
    if (!who) {
        at_ = before;
        return false;
    }
    if (boundary_ && (open || hasWho)) clauses_.emplace_back();
    clause().who = std::move(who);
    boundary_ = false;
    return true;
}

bool Reader::readVerb() {
    std::size_t skip = 0;
    while (isOneOf({"to", "will", "should", "must", "can", "shall", "is", "are", "also"}, skip)) ++skip;
    const VerbFound found = verbAt(rest(skip));
    if (found.verb == Verb::None) return false;
    const bool makes = found.verb == Verb::Form && isOneOf({"make", "makes"}, skip) &&
                       !formOf(word(skip + 1)) && !formOf(word(skip + 2));
    if (makes || (found.verb == Verb::Move && isOneOf({"get", "wants"}, skip))) {
        at_ += skip + found.words;  // It says that somebody is to do something.
        boundary_ = boundary_ || clauses_.empty();
        return true;
    }
    at_ += skip + found.words;
    // "line up" names a shape, "leave" may follow a verb that only leads to it.
    Act& made = newAct(found.verb);
    const Token& last = tokens_[at_ - 1];
    if (found.verb == Verb::Form && found.words == 2 && tokens_[at_ - 2].text.starts_with("line") &&
        last.text == "up")
        made.linesUp = true;
    boundary_ = false;
    readObject(made);
    return true;
}

Clause& Reader::clause() {
    if (clauses_.empty()) clauses_.emplace_back();
    return clauses_.back();
}

Act& Reader::act() {
    if (clause().acts.empty() || (then_ && boundary_)) return newAct(Verb::None);
    return clause().acts.back();
}

Act& Reader::newAct(Verb verb) {
    Act made;
    made.verb = verb;
    made.then = std::exchange(then_, false);
    boundary_ = false;
    std::vector<Act>& acts = clause().acts;
    // "North to the fountain" has no verb until one comes; "get to walk" has one only.
    if (!acts.empty() && !made.then && acts.back().verb == Verb::None) {
        acts.back().verb = verb;
        return acts.back();
    }
    acts.push_back(std::move(made));
    return acts.back();
}

// Ranks of so many are a block; other shapes have none.
void Reader::settleForm(Act& act) {
    if (act.linesUp && !act.form) act.form = FormationKind::Line;
    if (act.files == 0) return;
    using enum FormationKind;
    if (act.form && *act.form != Square && *act.form != Line && *act.form != Column)
        return fail("Only a square, a line or a column has people abreast.");
    act.form = Square;
}

void Reader::failTwice() {
    fail("That is said twice: say it once, or “then” before the second.");
}

void Reader::fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
}

void Reader::failAtWord() {
    if (atEnd())
        return fail("Something is missing at the end: say who, what and where, as “North go to 5, 0”.");
    const Token& token = tokens_[at_];
    const std::string said(text_.substr(token.from, token.end - token.from));
    const std::string other = guess(token);
    if (!other.empty()) return fail("“" + said + "”: did you mean " + other + "?");
    if (token.number) return fail("“" + said + "” of what? Say “" + said + " people”, or “" + said + " m”.");
    const bool known = std::find(allWords().begin(), allWords().end(), token.text) != allWords().end() ||
                       !names_.startOf(rest(), true).empty() || !names_.startOf(rest(), false).empty();
    if (known) return fail("“" + said + "” does not fit here. Say who, what and where: “North go to 5, 0”.");
    fail("I do not know “" + said + "”. Groups and things have their names, as “" +
         (names_.all().empty() ? "North" : names_.all().front().name) + "”.");
}

// Names come before other words where they are as near.
std::string Reader::guess(const Token& token) const {
    if (token.text.size() < 3) return {};
    std::string best;
    std::size_t least = std::min(kMostLetters, (token.text.size() - 1) / 2) + 1;
    const auto look = [&](std::string_view like, const std::string& name) {
        const std::size_t letters = lettersBetween(token.text, like);
        if (letters == 0 || letters >= least) return;
        least = letters;
        best = name;
    };
    for (const Named& named : names_.all())
        for (const std::string& part : named.words)
            if (part.size() > 2) look(part, named.name);
    for (const std::string_view known : allWords())
        if (known.size() > 2) look(known, std::string(known));
    return best;
}

bool Reader::isOneOf(std::initializer_list<std::string_view> words, std::size_t skip) const {
    const std::string_view is = word(skip);
    return !is.empty() && std::find(words.begin(), words.end(), is) != words.end();
}

bool Reader::take(std::initializer_list<std::string_view> words) {
    if (!isOneOf(words)) return false;
    ++at_;
    return true;
}

bool Reader::takePhrase(std::string_view phrase) {
    const std::size_t words = matches(rest(), phrase);
    at_ += words;
    return words > 0;
}

void Reader::skipArticles() {
    while (isOneOf({"the", "a", "an", "their", "its", "some", "that", "this", "those", "these"})) ++at_;
}

bool Reader::isEndOfClause(std::size_t skip) const {
    return at_ + skip >= tokens_.size() ||
           isOneOf({",", ";", ".", ":", "!", "?", "and", "then", "while", "but"}, skip);
}

}  // namespace muster::words
