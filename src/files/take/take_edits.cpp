#include "files/take/take_edits.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "files/take/about_words.h"

namespace muster {
namespace {

constexpr double kLongestTake = 1e6;   // [s]
constexpr double kFarthestPin = 1e4;   // [m]
constexpr std::size_t kMostName = 80;  // Bytes of a clip's name.

/// A number without decimals where it has none.
std::string plain(double value) {
    const bool whole = std::fabs(value) < 1e9 && value == std::floor(value);
    return whole ? std::to_string(static_cast<std::int64_t>(value)) : numberText(value);
}

Status bad(const std::string& where, double found, const std::string& expected) {
    return invalidArgument(where + ": found " + plain(found) + ", expected " + expected);
}

Status checkRange(const std::string& where, double found, double low, double high) {
    if (found >= low && found <= high) return {};
    return bad(where, found, plain(low) + " to " + plain(high));
}

std::string at(const std::string& list, std::size_t index) {
    return list + "[" + std::to_string(index) + "]";
}

Status checkCount(const std::string& where, std::size_t found, std::size_t most) {
    if (found <= most) return {};
    return bad(where, static_cast<double>(found), "at most " + std::to_string(most) + " entries");
}

Status checkPeople(const TakeEdit& edit, const std::string& where, std::set<std::uint32_t>& seen) {
    if (edit.people.empty()) return invalidArgument(where + ".people: found nobody, expected somebody");
    for (std::size_t k = 0; k < edit.people.size(); ++k) {
        const std::uint32_t id = edit.people[k];
        if (id == 0 || (k > 0 && id <= edit.people[k - 1]))
            return bad(where + "." + at("people", k), id, "numbers above 0 in ascending order");
        if (!seen.insert(id).second) return bad(where + "." + at("people", k), id, "nobody with two edits");
    }
    return {};
}

Status checkPins(const TakeEdit& edit, const std::string& where) {
    double earliest = 0.0;
    for (std::size_t k = 0; k < edit.pins.size(); ++k) {
        const PathPin& pin = edit.pins[k];
        const std::string name = where + "." + at("pins", k);
        if (Status s = checkRange(name + ".time", pin.time, earliest, kLongestTake); !s.ok()) return s;
        for (const auto& [key, value] : {std::pair(".x", pin.offset.x), {".y", pin.offset.y}})
            if (Status s = checkRange(name + key, value, -kFarthestPin, kFarthestPin); !s.ok()) return s;
        if (Status s = checkRange(name + ".seconds", pin.seconds, 0.2, 60.0); !s.ok()) return s;
        earliest = pin.time + kLeastPinGap;
    }
    return {};
}

Status checkClock(const std::vector<ClockPoint>& clock, const std::string& where) {
    if (clock.size() == 1) return bad(where + ".clock", 1.0, "no points, or two and more");
    double earliest = 0.0;
    for (std::size_t k = 0; k < clock.size(); ++k) {
        const std::string name = where + "." + at("clock", k);
        if (Status s = checkRange(name + ".time", clock[k].time, earliest, kLongestTake); !s.ok()) return s;
        if (Status s = checkRange(name + ".own", clock[k].own, 0.0, kLongestTake); !s.ok()) return s;
        earliest = clock[k].time + kLeastPinGap;
        if (k == 0) continue;
        const double rate = (clock[k].own - clock[k - 1].own) / (clock[k].time - clock[k - 1].time);
        const bool end = k == 1 || k + 1 == clock.size();
        const double least = end ? kSlowestEnd - 1e-9 : 0.0;
        if (!(rate >= least && rate <= kFastestClock))
            return bad(name + ".own", clock[k].own,
                       std::string("a clock that runs ") + (end ? "1/3" : "0") + " to 8 times as fast");
    }
    return {};
}

template <class Part>
Status checkParts(const std::vector<Part>& parts, const std::string& where) {
    double earliest = 0.0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const std::string name = at(where, k);
        if (Status s = checkRange(name + ".from", parts[k].from, earliest, kLongestTake); !s.ok()) return s;
        if (!(parts[k].to > parts[k].from && parts[k].to <= kLongestTake))
            return bad(name + ".to", parts[k].to, "later than from");
        earliest = parts[k].to;
    }
    return {};
}

Status checkNames(const TakeEdit& edit, const std::string& where) {
    for (std::size_t k = 0; k < edit.clips.size(); ++k) {
        const std::string& name = edit.clips[k].name;
        const auto control = [](char c) { return static_cast<unsigned char>(c) < 32; };
        if (name.empty() || name.size() > kMostName || std::any_of(name.begin(), name.end(), control))
            return invalidArgument(where + "." + at("clips", k) + ".name: found " +
                                   std::to_string(name.size()) + " bytes, expected a name of 1 to 80 bytes");
    }
    for (std::size_t k = 0; k < edit.looks.size(); ++k) {
        const LookPart& look = edit.looks[k];
        const std::string name = where + "." + at("looks", k);
        for (const auto& [key, value] : {std::pair(".x", look.point.x), {".y", look.point.y}})
            if (Status s = checkRange(name + key, value, -1e6, 1e6); !s.ok()) return s;
        if (Status s = checkRange(name + ".height", look.height, -10.0, 100.0); !s.ok()) return s;
    }
    return {};
}

Status checkEdit(const TakeEdit& edit, const std::string& where, std::set<std::uint32_t>& seen) {
    for (const auto& [name, size] : {std::pair(".pins", edit.pins.size()),
                                     {".clock", edit.clock.size()},
                                     {".clips", edit.clips.size()},
                                     {".looks", edit.looks.size()}})
        if (Status s = checkCount(where + name, size, TakeEdit::kMaxParts); !s.ok()) return s;
    if (Status s = checkPeople(edit, where, seen); !s.ok()) return s;
    if (Status s = checkPins(edit, where); !s.ok()) return s;
    if (Status s = checkClock(edit.clock, where); !s.ok()) return s;
    if (Status s = checkParts(edit.clips, where + ".clips"); !s.ok()) return s;
    if (Status s = checkParts(edit.looks, where + ".looks"); !s.ok()) return s;
    return checkNames(edit, where);
}

// ---- JSON ----

Status readPerson(const Json& value, const char* key, std::uint32_t& id) {
    const bool fits = value.isWhole() && value.number() >= 0.0 && value.number() <= 4294967295.0;
    if (!fits) return wrongKind(key, value, "the number of a person");
    id = value.whole<std::uint32_t>();
    return {};
}

Status readPart(const Json& entry, PathPin& pin) {
    return readNumbers(
        entry, {{"time", &pin.time}, {"x", &pin.offset.x}, {"y", &pin.offset.y}, {"seconds", &pin.seconds}});
}

Status readPart(const Json& entry, ClockPoint& point) {
    return readNumbers(entry, {{"time", &point.time}, {"own", &point.own}});
}

Status readPart(const Json& entry, ClipPart& part) {
    if (Status s = readNumbers(entry, {{"from", &part.from}, {"to", &part.to}}); !s.ok()) return s;
    const Json* name = entry.find("name");
    if (name == nullptr || !name->isText())
        return {StatusCode::ParseError, "name: found no text, expected the name of a clip"};
    part.name = name->text();
    return {};
}

Status readPart(const Json& entry, LookPart& look) {
    if (Status s = readNumbers(entry, {{"x", &look.point.x},
                                       {"y", &look.point.y},
                                       {"height", &look.height},
                                       {"from", &look.from},
                                       {"to", &look.to}});
        !s.ok())
        return s;
    const Json* person = entry.find("person");
    return person == nullptr ? Status() : readPerson(*person, "person", look.person);
}

template <class Part>
Status readList(const Json& edit, const char* key, std::vector<Part>& parts) {
    const Json* list = edit.find(key);
    if (list == nullptr) return {};
    if (!list->isArray()) return wrongKind(key, *list, "an array");
    for (const Json& entry : list->elements()) {
        const Status s = entry.isObject() ? readPart(entry, parts.emplace_back())
                                          : wrongKind("edits", entry, "objects in it");
        if (!s.ok()) return s.within(key);
    }
    return {};
}

Status readEdit(const Json& value, TakeEdit& edit) {
    if (!value.isObject()) return wrongKind("edits", value, "objects in it");
    const Json* people = value.find("people");
    if (people == nullptr || !people->isArray())
        return {StatusCode::ParseError, "people: found no array, expected the numbers of people"};
    for (const Json& person : people->elements())
        if (Status s = readPerson(person, "people", edit.people.emplace_back()); !s.ok()) return s;
    if (Status s = readList(value, "pins", edit.pins); !s.ok()) return s;
    if (Status s = readList(value, "clock", edit.clock); !s.ok()) return s;
    if (Status s = readList(value, "clips", edit.clips); !s.ok()) return s;
    return readList(value, "looks", edit.looks);
}

Json describeLook(const LookPart& look) {
    Json value = Json::object();
    if (look.person != 0) {
        value["person"] = look.person;
    } else {
        value["x"] = look.point.x;
        value["y"] = look.point.y;
        value["height"] = look.height;
    }
    value["from"] = look.from;
    value["to"] = look.to;
    return value;
}

}  // namespace

Status checkEdits(const std::vector<TakeEdit>& edits) {
    if (Status s = checkCount("edits", edits.size(), TakeAbout::kMaxEdits); !s.ok()) return s;
    std::set<std::uint32_t> seen;
    for (std::size_t k = 0; k < edits.size(); ++k)
        if (Status s = checkEdit(edits[k], at("edits", k), seen); !s.ok()) return s;
    if (seen.size() <= TakeAbout::kMaxEdited) return {};
    return bad("edits", static_cast<double>(seen.size()),
               "at most " + std::to_string(TakeAbout::kMaxEdited) + " people");
}

Status checkClips(const std::vector<TakeEdit>& edits, const std::vector<std::string>& names) {
    for (const TakeEdit& edit : edits)
        for (const ClipPart& part : edit.clips) {
            if (std::find(names.begin(), names.end(), part.name) != names.end()) continue;
            std::string known;
            for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
            return invalidArgument("there is no clip \"" + part.name + "\"; there are " + known);
        }
    return {};
}

Json describeEdits(const std::vector<TakeEdit>& edits) {
    Json list = Json::array();
    for (const TakeEdit& edit : edits) {
        Json value = Json::object();
        value["people"] = Json::array();
        for (const std::uint32_t id : edit.people) value["people"].push(Json(id));
        for (const PathPin& pin : edit.pins)
            value["pins"].push(
                {{"time", pin.time}, {"x", pin.offset.x}, {"y", pin.offset.y}, {"seconds", pin.seconds}});
        for (const ClockPoint& point : edit.clock)
            value["clock"].push({{"time", point.time}, {"own", point.own}});
        for (const ClipPart& part : edit.clips)
            value["clips"].push({{"name", part.name}, {"from", part.from}, {"to", part.to}});
        for (const LookPart& look : edit.looks) value["looks"].push(describeLook(look));
        list.push(std::move(value));
    }
    return list;
}

Status readEdits(const Json& list, std::vector<TakeEdit>& edits) {
    if (!list.isArray()) return wrongKind("edits", list, "an array");
    edits.clear();
    for (const Json& entry : list.elements())
        if (Status s = readEdit(entry, edits.emplace_back()); !s.ok()) return s;
    return {};
}

}  // namespace muster
