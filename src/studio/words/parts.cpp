// No part of a sentence is lost: it is done, or the sentence is refused.
#include <array>
#include <utility>

#include "studio/words/planner.h"

namespace muster::words {
namespace {

struct PartWord {
    Part part;
    const char* words;
};
constexpr std::array kPartWords{
    PartWord{kTo, "A place"},
    PartWord{kVia, "A way"},
    PartWord{kForm, "A shape"},
    PartWord{kSpacing, "A spacing"},
    PartWord{kFacing, "A direction to face"},
    PartWord{kPace, "A pace"},
    PartWord{kFreely, "A way for each"},
    PartWord{kTime, "A time"},
    PartWord{kOthers, "Another group"},
    PartWord{kNumber, "A number"},
    PartWord{kName, "A name"},
    PartWord{kColour, "A colour"},
};

}  // namespace

unsigned partsOf(const Act& act) {
    unsigned parts = kNone;
    const auto add = [&](bool said, Part part) { parts |= said ? part : kNone; };
    add(act.to.has_value(), kTo);
    add(!act.via.empty(), kVia);
    add(act.form || act.files > 0, kForm);
    add(act.spacing || act.spread != 1.0, kSpacing);
    add(act.facing.has_value(), kFacing);
    add(act.pace || act.haste != 1.0, kPace);
    add(act.freely, kFreely);
    add(act.seconds > 0.0, kTime);
    add(!act.others.empty(), kOthers);
    add(act.number.has_value(), kNumber);
    add(!act.name.empty(), kName);
    add(act.colour.has_value(), kColour);
    return parts;
}

bool Planner::does(const Act& act, const char* verb, unsigned parts) {
    const unsigned left = partsOf(act) & ~parts;
    for (const PartWord& one : kPartWords)
        if ((left & one.part) != 0) {
            fail(std::string(one.words) + " cannot be said with “" + verb +
                 "”: leave it out, or say it in a sentence of its own.");
            return false;
        }
    return result_.problem.empty();
}

// What is no order happens at once: it cannot wait for an order that came before.
bool Planner::doesNow(const Act& act, const char* verb, unsigned parts) {
    if (act.then && (fresh_ || !ordered_.empty())) {
        fail("“" + std::string(verb) +
             "” cannot come later: say it in a sentence of its own when it is time.");
        return false;
    }
    return does(act, verb, parts);
}

}  // namespace muster::words
