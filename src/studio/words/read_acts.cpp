// What: the objects of verbs, and how things are done.
#include <utility>

#include "studio/words/reader.h"

namespace muster::words {
namespace {

/// How much wider "wider" is.
constexpr double kWider = 1.5;
constexpr double kDensest = 0.3, kSparsest = 20.0;

}  // namespace

/// What a verb is followed by, where that is not read like anything else.
void Reader::readObject(Act& act) {
    switch (act.verb) {
        case Verb::Face:
            // “Turn South around” turns a group, “turn south” says where to.
            if (const auto found = names_.startOf(rest(), true);
                !found.empty() && !clause().who && !isEndOfClause(found.front()->words.size()))
                return;
            if (auto facing = readFacing()) act.facing = std::move(facing);
            return;
        case Verb::Follow:
        case Verb::Guard:
            return readTarget(act);
        case Verb::Cross:
            return readCrossed(act);
        case Verb::Merge:
        case Verb::Split:
            return readParts();
        case Verb::Name:
            return readName(act);
        case Verb::Add:
            return readAdded(act);
        case Verb::Space: {
            const Token& verb = tokens_[at_ - 1];
            const std::string& first = tokens_[at_ > 1 ? at_ - 2 : 0].text;
            const bool narrow = verb.text.starts_with("tight") || first.starts_with("tight") ||
                                verb.text == "squash" || verb.text.starts_with("squeeze") ||
                                first == "squeeze" || first.starts_with("close") || first == "bunch" ||
                                verb.text == "narrow" || verb.text == "closer" || verb.text == "together";
            act.spread = narrow ? 1.0 / kWider : kWider;
            while (take({"up", "out"})) {
            }
            return;
        }
        case Verb::Pace: {
            const std::string& last = tokens_[at_ - 2 < tokens_.size() ? at_ - 2 : 0].text;
            act.number = last == "double" ? 2.0 : last == "half" ? 0.5 : last == "slow" ? 0.25 : 1.0;
            if (number()) act.number = *number(), ++at_;
            take({"x", "times"});
            return;
        }
        default:
            return;
    }
}

// "follow South", "guard the fountain"
void Reader::readTarget(Act& act) {
    skipArticles();
    if (act.verb == Verb::Guard)
        act.to = readSpot(true);
    else
        act.others = readGroup();
}

// "climb the wall", "swim across the pool", "crawl under the net"
void Reader::readCrossed(Act& act) {
    act.verb = Verb::Move;
    take({"across", "over", "under", "underneath", "through"});
    auto spot = readSpot(true);
    if (!spot) return;
    spot->crossed = spot->kind == SpotKind::Thing && spot->beside == Beside::At;
    if (spot->crossed)
        act.via.push_back(std::move(*spot));
    else
        act.to = std::move(spot);
}

// "split North into three", "merge South into North", "split 10 people off North"
void Reader::readParts() {
    if (clause().who) {
        readHow();
        return;
    }
    take({"up"});
    clause().who = readWho();
}

// What it is called stands in the text as it is typed.
void Reader::readName(Act& act) {
    if (!clause().who) {
        take({"the", "group"});
        const std::size_t before = at_;
        auto who = readWho();
        if (!who) {
            at_ = before;
            who = Who{};
        }
        clause().who = std::move(who);
    }
    take({"to", "as", "it", "them"});
    take({"to", "as"});
    take({"\""});
    if (atEnd()) return fail("What name? Say “rename North to Choir”.");
    const std::size_t from = tokens_[at_].from;
    std::size_t end = from;
    while (!atEnd() && !isOneOf({"\"", ",", ";", ".", "!", "?"})) end = tokens_[at_++].end;
    act.name = std::string(text_.substr(from, end - from));
    take({"\""});
}

// "add 10 people to North"
void Reader::readAdded(Act& act) {
    if (!number()) return fail("How many people? Say “add 10 people to North”.");
    act.number = *number();
    ++at_;
    take({"more"});
    if (isPeopleWord(word())) ++at_;
    take({"to", "in", "into"});
    clause().who = readWho();
}

/// How, where and in which shape.
bool Reader::readHow() {
    return readForm() || readSpacing() || readPace() || readVia() || readDuration() || readPreposition();
}

// "in a ring", "as a wedge", "a line", "8 abreast", "ring formation"
bool Reader::readForm() {
    const std::size_t before = at_;
    if (number() && isOneOf({"abreast", "files", "wide"}, 1)) {
        Act& how = act();
        if (how.files > 0) return failTwice(), true;
        how.files = static_cast<std::int32_t>(*number());
        if (how.verb == Verb::None && !how.to && how.via.empty()) how.verb = Verb::Form;
        at_ += 2;
        return true;
    }
    take({"in", "into", "as", "to"});
    take({"form"});
    skipArticles();
    const double spread = isOneOf({"big", "wide"})      ? kWider
                          : isOneOf({"small", "tight"}) ? 1.0 / kWider
                                                        : 1.0;
    take({"big", "small", "single", "nice", "neat", "straight", "tight", "wide", "full", "closed"});
    const auto form = formOf(word());
    const auto named = names_.startOf(rest(), false);
    if (!form || !named.empty()) return at_ = before, false;
    ++at_;
    take({"formation", "shape"});
    const bool verbless = clause().acts.empty();
    Act& how = verbless ? newAct(Verb::Form) : act();
    if (how.verb == Verb::None && !how.to && how.via.empty()) how.verb = Verb::Form;
    if (how.form) return failTwice(), true;
    how.form = form;
    if (spread != 1.0 && (how.spacing || how.spread != 1.0)) return failTwice(), true;
    how.spread *= spread;
    if (isOneOf({"around", "round", "about"}))
        if (auto spot = readSpot()) {
            if (how.to) return failTwice(), true;
            how.to = std::move(spot);
        }
    return true;
}

// "2 m apart", "at 1.5 m spacing", "with a spacing of 2 m", "wider", "closer together"
bool Reader::readSpacing() {
    const std::size_t before = at_;
    std::optional<double> metres;
    take({"to", "at", "with", "of"});
    take({"a"});
    if (number() && metresOf(word(1)) && isOneOf({"apart", "spacing", "between"}, 2)) {
        metres = *number() * *metresOf(word(1));
        at_ += 3;
    } else if (isOneOf({"spacing", "spaced"})) {
        ++at_;
        take({"of", "to", "at"});
        if (number()) {
            metres = *number();
            ++at_;
            if (metresOf(word())) *metres *= *metresOf(word()), ++at_;
            take({"apart"});
        }
    }
    if (metres) {
        if (*metres < kDensest || *metres > kSparsest) return fail("Say a spacing of 0.3 to 20 m."), true;
        if (act().spacing) return failTwice(), true;
        act().spacing = metres;
        if (act().spread != 1.0 && act().verb != Verb::Space) return failTwice(), true;
        if (act().verb == Verb::None) act().verb = Verb::Space;
        return true;
    }
    at_ = before;
    const bool wider = isOneOf({"wider", "looser"}),
               closer = isOneOf({"narrower", "tighter", "denser", "closer"});
    if ((!wider && !closer) || (closer && word(1) == "to")) return false;
    ++at_;
    take({"together", "apart"});
    Act& how = act();
    const bool otherwise = how.spread != 1.0 && (how.spread > 1.0) != wider;
    if (how.spacing || otherwise) return failTwice(), true;
    how.spread = wider ? kWider : 1.0 / kWider;
    if (how.verb == Verb::None) how.verb = Verb::Space;
    return true;
}

// "slowly", "at 1 m/s", "each by the shortest way"
bool Reader::readPace() {
    const std::size_t before = at_;
    if (take({"slowly", "calmly", "quietly"}) || takePhrase("at walking pace"))
        return act().haste = 0.5, true;
    if (take({"freely", "individually", "separately"}) || takePhrase("by the shortest way") ||
        takePhrase("each on their own") || takePhrase("on their own"))
        return act().freely = true, true;
    take({"at", "with"});
    if (number() && isOneOf({"m", "metres", "meters", "metre", "meter"}, 1) &&
        (word(2) == "/" || isOneOf({"per", "a"}, 2)) && isOneOf({"s", "second", "sec"}, 3)) {
        const double pace = *number();
        at_ += 4;
        if (pace < 0.05 || pace > 10.0) return fail("Say a pace of 0.05 to 10 m/s."), true;
        if (act().pace) return failTwice(), true;
        act().pace = pace;
        return true;
    }
    at_ = before;
    return false;
}

// "by way of the fountain", "via 5, 3", "through the gate", "past the well"
bool Reader::readVia() {
    const std::size_t before = at_;
    if (!takePhrase("by way of") && !takePhrase("by the way of") && !takePhrase("passing by") &&
        !take({"via", "through", "past", "passing"}))
        return false;
    auto spot = readSpot();
    if (!spot) return at_ = before, false;
    const bool exit = spot->kind == SpotKind::Thing && spot->things.front().kind == NamedKind::Area;
    Act& how = act();
    if (exit && how.verb == Verb::Leave && how.to) return failTwice(), true;
    if (exit && how.verb == Verb::Leave)
        how.to = std::move(spot);
    else
        how.via.push_back(std::move(*spot));
    return true;
}

// "for 20 seconds"
bool Reader::readDuration() {
    const std::size_t before = at_;
    const bool later = take({"in", "after"});
    if (!later) take({"for"});
    if (at_ == before || !number()) return at_ = before, false;
    const bool seconds = isOneOf({"s", "second", "seconds", "sec"}, 1);
    const bool minutes = isOneOf({"minute", "minutes", "min"}, 1);
    if (!seconds && !minutes) return at_ = before, false;
    if (later) return fail("I cannot start something later: say “then” behind what comes before it."), true;
    if (act().seconds > 0.0) return failTwice(), true;
    act().seconds = *number() * (minutes ? 60.0 : 1.0);
    at_ += 2;
    return true;
}

// What only the verb before it can be followed by: whether it has been read; none where it is read like
// anything else.
std::optional<bool> Reader::readOfVerb() {
    Act* const last = clause().acts.empty() ? nullptr : &clause().acts.back();
    const Verb verb = last != nullptr && !(boundary_ && then_) ? last->verb : Verb::None;
    if (verb == Verb::Face && !last->facing)
        if (auto facing = readFacing()) return last->facing = std::move(facing), true;
    if (verb == Verb::Split && take({"in", "into"})) {
        skipArticles();
        const auto share = shareOf(word());
        const auto count = number() ? number() : share ? std::optional(1.0 / *share) : std::nullopt;
        if (!count) return failAtWord(), true;
        if (last->number) return failTwice(), true;
        last->number = count;
        ++at_;
        take({"parts", "groups", "pieces", "teams", "halves", "equal"});
        return take({"parts", "groups", "teams"}), true;
    }
    if (verb == Verb::Merge && take({"into", "with", "to"})) {
        skipArticles();
        if (!last->others.empty()) return failTwice(), true;
        last->others = readGroup();
        if (last->others.empty()) failAtWord();
        return true;
    }
    if (verb == Verb::Merge && last->others.empty())
        if (auto groups = readGroup(); !groups.empty()) return last->others = std::move(groups), true;
    if (verb == Verb::Split && take({"off", "from"})) return true;
    if ((verb == Verb::Colour || verb == Verb::None) && colourOf(word()) && clause().who) {
        (last != nullptr ? *last : newAct(Verb::Colour)).verb = Verb::Colour;
        if (clause().acts.back().colour) return failTwice(), true;
        clause().acts.back().colour = colourOf(word());
        return ++at_, true;
    }
    if (verb == Verb::Space && take({"out", "up", "apart", "together", "more", "a", "bit", "ranks"}))
        return true;
    if (verb == Verb::Swap && take({"places", "positions", "sides", "with", "spots"})) return true;
    if (verb == Verb::Swap)
        if (auto groups = readGroup(); !groups.empty()) return last->others = std::move(groups), true;
    if (verb == Verb::Hold || verb == Verb::Stop)
        if (takePhrase("where they are") || takePhrase("where it is") || takePhrase("where you are") ||
            take({"moving", "walking", "position", "ground", "put", "there", "here", "fire", "going"}))
            return true;
    if (verb == Verb::Patrol && take({"between", "from"})) {
        auto from = readSpot();
        if (!from) return failAtWord(), true;
        last->via.push_back(std::move(*from));
        while (take({"and", "to", ",", "then"})) {
            auto next = readSpot();
            if (!next) return failAtWord(), true;
            last->via.push_back(std::move(*next));
        }
        return true;
    }
    if (verb == Verb::Leave && take({"by", "through", "at", "via", "from", "using"})) {
        if (last->to) return failTwice(), true;
        last->to = readSpot();
        if (!last->to) failAtWord();
        return true;
    }
    return std::nullopt;
}

// "to the fountain", "at 5, 3", "5 m east", "into North", "into three", "facing north", "red"
bool Reader::readPreposition() {
    const std::size_t before = at_;
    if (take({"facing", "looking"})) {
        auto facing = readFacing();
        if (!facing) return at_ = before, false;
        Act& how = act();
        if (how.verb == Verb::None) how.verb = how.to ? Verb::Move : Verb::Face;
        if (how.facing) return failTwice(), true;
        how.facing = std::move(facing);
        return true;
    }
    if (const auto read = readOfVerb()) return *read;
    if (take({"home"}))
        return fail("I do not know where home is: say a place, as “the middle” or “5, 3”."), true;
    auto spot = readSpot();
    if (!spot) return at_ = before, false;
    Act& how = act();
    if (how.to) {  // A second place is the next one.
        Act& next = newAct(Verb::Move);
        next.to = std::move(spot);
        next.then = true;
        return true;
    }
    how.to = std::move(spot);
    if (how.verb == Verb::None) how.verb = Verb::Move;
    return true;
}

}  // namespace muster::words
