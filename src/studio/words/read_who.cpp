// Who: groups, shares and numbers of their people, sides, the rest.
#include <algorithm>
#include <utility>

#include "studio/words/reader.h"

namespace muster::words {
namespace {

void addTo(std::vector<GroupId>& groups, const std::vector<GroupId>& more) {
    for (const GroupId group : more)
        if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
}

}  // namespace

std::optional<Who> Reader::readWho() {
    Who who;
    if (isOneOf({"they", "them", "it", "he", "she"}) || takePhrase("this group") ||
        takePhrase("these groups") || takePhrase("the chosen") || takePhrase("the selected")) {
        if (isOneOf({"they", "them", "it", "he", "she"})) ++at_;
        take({"group", "groups", "people"});
        who.sameAgain = true;
        return who;
    }
    const std::size_t before = at_;
    if (takePhrase("all of") || takePhrase("both of")) {
        take({"the"});
        if (readBase(who)) return readExcept(who), who;
        at_ = before;
    }
    if (readAmount(who)) return who;
    at_ = before;
    who = Who{};
    if (!readBase(who)) return std::nullopt;
    readExcept(who);
    return who;
}

bool Reader::readAmount(Who& who) {
    if (readSide(who) || readShare(who) || readCount(who)) return problem_.empty();
    skipArticles();
    if (!isRest(word()) || (word() == "other" && !isOneOf({"half", "people", "ones", "third"}, 1)))
        return false;
    ++at_;
    who.amount = Amount::Rest;
    take({"half", "people", "ones", "third", "two", "groups"});
    if (take({"of"})) {
        skipArticles();
        readBase(who);
    }
    return true;
}

// "the left half of North", "the front 10 of South"
bool Reader::readSide(Who& who) {
    const std::size_t before = at_;
    skipArticles();
    const auto side = isOneOf({"left"})                           ? Side::Left
                      : isOneOf({"right"})                        ? Side::Right
                      : isOneOf({"front", "first", "foremost"})   ? Side::Front
                      : isOneOf({"back", "rear", "last", "hind"}) ? Side::Rear
                                                                  : Side::Any;
    if (side != Side::Any) {
        take({word()});
        take({"hand"});
        if (readShare(who) || readCount(who)) {
            who.side = side;
            return true;
        }
    }
    at_ = before;
    return false;
}

// "half of", "two thirds of", "20 % of", "a quarter of"
bool Reader::readShare(Who& who) {
    const std::size_t before = at_;
    skipArticles();
    take({"another", "one"});
    double parts = 1.0;
    if (number() && shareOf(word(1))) parts = *number(), ++at_;
    if (const auto share = shareOf(word())) {
        who.share = parts * *share;
        ++at_;
    } else if (number() && isOneOf({"%", "percent"}, 1)) {
        who.share = *number() / 100.0;
        at_ += 2;
    } else {
        at_ = before;
        return false;
    }
    who.amount = Amount::Share;
    if (who.share > 1.0 || who.share <= 0.0) fail("A share is more than nothing and at most all of a group.");
    const bool of = take({"of", "from"});
    if (isPeopleWord(word())) ++at_, take({"of", "from", "in"});
    skipArticles();
    if (!readBase(who) && of) failAtWord();
    return true;
}

// "10 of South", "5 people from North", "the 5 people nearest to the fountain", "the nearest 5 people to it"
bool Reader::readCount(Who& who) {
    const std::size_t before = at_;
    skipArticles();
    const bool nearest = take({"nearest", "closest"});
    const auto count = number();
    const bool counts = count && *count >= 1.0 && *count < 1e6;
    const bool couple = word() == "couple";
    if (counts) ++at_;
    const bool of = couple ? take({"of"}) : isOneOf({"of", "from"});
    const bool people = isPeopleWord(word()) || isOneOf({"nearest", "closest"});
    const bool more = isOneOf({"more", "others"}) && ++at_ > 0;
    const bool bare = isOneOf({"to", "go", "leave", "leaves"}) && counts && !couple;  // "10 to the hall"
    if (!counts || (!of && !people && !more && !nearest && !bare)) {
        at_ = before;
        return false;
    }
    who.amount = Amount::Count;
    who.count = *count;
    if (isPeopleWord(word())) ++at_;
    if (nearest && take({"to"})) {
        who.nearest = readSpot();
        if (!who.nearest) failAtWord();
        return true;
    }
    readNearest(who);
    const bool from = take({"of", "from", "in"});
    skipArticles();
    if (!readBase(who) && from) failAtWord();
    readNearest(who);
    return true;
}

bool Reader::readNearest(Who& who) {
    if (!take({"nearest", "closest", "next", "who"})) return false;
    takePhrase("are nearest");
    takePhrase("are closest");
    take({"to"});
    who.nearest = readSpot();
    if (!who.nearest) failAtWord();
    return true;
}

// Groups by their names, all of them, or those of before.
bool Reader::readBase(Who& who) {
    const std::size_t before = at_;
    if (takePhrase("every group") || takePhrase("all groups") || takePhrase("all units") ||
        takePhrase("all people") || takePhrase("the whole crowd") || takePhrase("the crowd") ||
        takePhrase("all of you") || takePhrase("you all") || takePhrase("no one") || isEverybody(word())) {
        if (isEverybody(word())) ++at_;
        if (take({"in", "from", "of"})) {
            skipArticles();
            std::vector<GroupId> groups = readGroup();
            if (!groups.empty()) return who.named = true, addTo(who.groups, groups), true;
            --at_;
        }
        if (take({"else"})) return who.amount = Amount::Rest, true;
        who.named = who.everybody = true;
        return true;
    }
    if (take({"them", "those"})) return who.sameAgain = true, true;
    if (readGroups(who.groups)) return who.named = true, true;
    at_ = before;
    return false;
}

bool Reader::readGroups(std::vector<GroupId>& groups) {
    std::vector<GroupId> first = readGroup();
    if (first.empty()) return false;
    addTo(groups, first);
    while (isOneOf({"and", ",", "&"})) {
        const std::size_t before = at_;
        ++at_;
        take({"and"});
        const std::vector<GroupId> next = readGroup();
        // "North hold, South go" has two subjects, "North, South and East go" has one.
        if (next.empty()) {
            at_ = before;
            break;
        }
        addTo(groups, next);
    }
    return true;
}

// "North", "the south group", "group 2", "the red ones", "reds"
std::vector<GroupId> Reader::readGroup() {
    const std::size_t before = at_;
    skipArticles();
    if (isOneOf({"group", "unit", "team", "squad"}) && number(1)) {
        for (const Named& named : names_.all())
            if (named.kind == NamedKind::Group && static_cast<double>(named.id) == *number(1))
                return at_ += 2, std::vector{GroupId{named.id}};
    }
    take({"group", "team", "unit"});
    const auto found = names_.startOf(rest(), true);
    if (!found.empty()) {
        at_ += found.front()->words.size();
        std::vector<GroupId> groups;
        for (const Named* one : found) groups.push_back(GroupId{one->id});
        while (isGroupWord(word())) ++at_;
        return groups;
    }
    if (const std::vector<GroupId> groups = names_.ofColour(word()); !groups.empty()) {
        ++at_;
        while (isGroupWord(word())) ++at_;
        return groups;
    }
    at_ = before;
    return {};
}

void Reader::readExcept(Who& who) {
    if (!take({"except", "but", "without"})) return;
    take({"for"});
    skipArticles();
    if (!readGroups(who.except)) failAtWord();
}

}  // namespace muster::words
