#include <cmath>
#include <utility>

#include "files/scenario/describe_forms.h"
#include "muster/people.h"

namespace muster {
namespace {

constexpr NumberRange kValue{0.0, 1e9};
constexpr const char* kPeople = "Sorts of persons, who also come by sources: one, a list, or \"adults\".";

}  // namespace

bool isPlainNumber(const Distribution& drawn) {
    return drawn == Distribution::constant(drawn.a) && !std::signbit(drawn.b) && !std::signbit(drawn.least);
}

void describeDrawn(FieldReader& v, const char* key, Distribution& drawn, const char* unit,
                   const char* about) {
    const Json* found = v.find(key);
    if (found == nullptr) return;
    if (found->isObject()) {
        drawn = {};
        v.object(key, about, [&](FieldReader& inner) { describe(inner, drawn); });
        return;
    }
    double value = 0.0;
    v.number(key, value, {kValue.minimum, kValue.maximum, unit}, about);
    if (!v.failed()) drawn = Distribution::constant(value);
}

void describeDrawn(FieldWriter& v, const char* key, Distribution& drawn, const char* unit,
                   const char* about) {
    if (!isPlainNumber(drawn)) {
        v.object(key, about, [&](FieldWriter& inner) { describe(inner, drawn); });
    } else if (drawn.a != 0.0 || std::signbit(drawn.a)) {
        v.number(key, drawn.a, {kValue.minimum, kValue.maximum, unit}, about);
    }
}

void describeDrawn(FieldSchema& v, const char* key, Distribution&, const char* unit, const char* about) {
    Json object;
    FieldSchema inner(object);
    Distribution none;
    describe(inner, none);
    Json number = {{"type", "number"}, {"minimum", kValue.minimum}, {"maximum", kValue.maximum}};
    v.set(key, {{"anyOf", Json::array({std::move(number), std::move(object)})}},
          std::string(about) + " 0 stands for the parameter's. [" + unit + "]", Need::Optional);
}

void describePeople(FieldReader& v, std::vector<PeopleDef>& people, Need) {
    const Json* found = v.find("people");
    if (found == nullptr) return;
    const bool list = found->isArray();
    if (list && found->size() > kMaxSorts) return v.fail("people", describeJson(*found), "at most 100 sorts");
    people.clear();
    for (std::size_t i = 0; i < (list ? found->size() : 1) && !v.failed(); ++i) {
        const Json& one = list ? (*found)[i] : *found;
        const std::string key = list ? "people[" + std::to_string(i) + "]" : "people";
        PeopleDef& sort = people.emplace_back();
        if (one.isText()) {
            if (one.text() != kAdultsWord) return v.fail(key, describeJson(one), "\"adults\" or an object");
            sort = adults();
            continue;
        }
        v.inside(key, one, [&](FieldReader& inner) { describe(inner, sort); });
    }
}

void describePeople(FieldWriter& v, std::vector<PeopleDef>& people, Need need) {
    if (people.size() == 1 && people.front() == adults()) return v.set("people", kAdultsWord);
    v.list(
        "people", people, kMaxSorts, kPeople,
        [](FieldWriter& item, PeopleDef& sort) { describe(item, sort); }, need);
}

void describePeople(FieldSchema& v, std::vector<PeopleDef>&, Need) {
    Json sort;
    FieldSchema inner(sort);
    PeopleDef none;
    describe(inner, none);
    const Json word = {{"enum", Json::array({kAdultsWord})}};
    const Json either = {{"anyOf", Json::array({word, sort})}};
    const Json list = {{"type", "array"}, {"maxItems", kMaxSorts}, {"items", either}};
    v.set("people", {{"anyOf", Json::array({word, sort, list})}}, kPeople, Need::Optional);
}

}  // namespace muster
