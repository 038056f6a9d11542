// Reads a text into clauses by recursive descent.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "studio/words/clauses.h"
#include "studio/words/known_names.h"
#include "studio/words/lexicon.h"
#include "studio/words/tokens.h"

namespace muster::words {

/// What a text says, or what is not understood of it.
struct Reading {
    std::vector<Clause> clauses;
    std::string problem;
};

class Reader {
public:
    Reader(std::string_view text, const KnownNames& names)
        : text_(text), names_(names), tokens_(tokensOf(text)) {}

    Reading read();

private:
    // The text (reader.cpp).
    void readOne();
    bool readMark();
    bool readNewWho();
    bool readVerb();
    Clause& clause();
    Act& act();
    Act& newAct(Verb verb);
    void fail(std::string problem);
    void failAtWord();
    void failTwice();
    void settleForm(Act& act);
    std::string guess(const Token& token) const;

    // Cursor.
    bool atEnd() const { return at_ >= tokens_.size(); }
    std::span<const Token> rest(std::size_t skip = 0) const {
        return std::span(tokens_).subspan(std::min(tokens_.size(), at_ + skip));
    }
    std::string_view word(std::size_t skip = 0) const {
        return at_ + skip < tokens_.size() ? std::string_view(tokens_[at_ + skip].text) : std::string_view();
    }
    std::optional<double> number(std::size_t skip = 0) const {
        return at_ + skip < tokens_.size() ? tokens_[at_ + skip].number : std::nullopt;
    }
    bool isOneOf(std::initializer_list<std::string_view> words, std::size_t skip = 0) const;
    /// Goes past the word where it is one of these.
    bool take(std::initializer_list<std::string_view> words);
    /// Goes past several words in a row.
    bool takePhrase(std::string_view phrase);
    void skipArticles();
    bool isEndOfClause(std::size_t skip = 0) const;

    // Who (read_who.cpp).
    std::optional<Who> readWho();
    bool readAmount(Who& who);
    bool readShare(Who& who);
    bool readCount(Who& who);
    bool readSide(Who& who);
    bool readBase(Who& who);
    bool readGroups(std::vector<GroupId>& groups);
    std::vector<GroupId> readGroup();
    bool readNearest(Who& who);
    void readExcept(Who& who);

    // Where (read_spot.cpp).
    /// `named`: where a group is called North, “north” is the group.
    std::optional<Spot> readSpot(bool named = false);
    bool isGroupHere() const;
    bool isThingHere() const;
    std::optional<Spot> readNamed();
    std::optional<Spot> readPoint();
    std::optional<Spot> readShift();
    std::optional<Spot> readEdge();
    std::optional<Spot> readThing();
    std::optional<Spot> readBetween();
    std::optional<Facing> readFacing();
    std::optional<Heading> readHeading();

    // What (read_acts.cpp).
    void readObject(Act& act);
    void readTarget(Act& act);
    void readCrossed(Act& act);
    void readParts();
    void readName(Act& act);
    void readAdded(Act& act);
    bool readHow();
    bool readForm();
    bool readSpacing();
    bool readPace();
    bool readVia();
    bool readDuration();
    std::optional<bool> readOfVerb();
    bool readPreposition();

    std::string_view text_;
    const KnownNames& names_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    std::vector<Clause> clauses_;
    bool boundary_ = true;  // A new clause may begin here.
    bool then_ = false;     // What follows comes after what was said.
    std::string problem_;
};

}  // namespace muster::words
