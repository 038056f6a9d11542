#include "engine/state/draw_person.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/hash.h"

namespace muster {
namespace {

// What is drawn is checked between this share and 1 without it.
constexpr double kLeastShare = 1e-9;

// What the member of that index is without its sort.
Body givenBody(const GroupDef& def, std::size_t index) {
    if (def.bodies.empty()) return {};
    return def.bodies[std::min(index, def.bodies.size() - 1)];
}

bool isDrawn(const Distribution& drawn) {
    return drawn.spread != Spread::Constant || drawn.a != 0.0;
}

double sumOfShares(const std::vector<PeopleDef>& people) {
    double sum = 0.0;
    for (const PeopleDef& sort : people) sum += sort.share;
    return sum;
}

// How many of `count` are of each sort, by largest remainders.
std::vector<std::size_t> quotas(const std::vector<PeopleDef>& people, std::size_t count) {
    const double sum = sumOfShares(people);
    std::vector<std::size_t> quota(people.size()), order(people.size());
    std::vector<double> rest(people.size());
    std::size_t given = 0;
    for (std::size_t k = 0; k < people.size(); ++k) {
        const double exact = static_cast<double>(count) * (people[k].share / sum);
        quota[k] = std::min(count - given, static_cast<std::size_t>(std::floor(exact)));
        rest[k] = exact - static_cast<double>(quota[k]);
        given += quota[k];
    }
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return rest[a] > rest[b]; });
    for (std::size_t k = 0; given < count; ++k, ++given) ++quota[order[k % order.size()]];
    return quota;
}

}  // namespace

double randomShare(std::uint64_t seed, std::uint32_t character, Drawn what) {
    Hash hash;
    hash.add(seed);
    hash.add(character);
    hash.add(static_cast<std::uint32_t>(what));
    return hash.randomShare();
}

Body drawPerson(const PeopleDef& sort, Body body, std::uint64_t seed, std::uint32_t character) {
    const auto draw = [&](const Distribution& drawn, Drawn what, double& number) {
        if (!isDrawn(drawn)) return false;
        number = drawn.quantile(
            std::clamp(randomShare(seed, character, what), kLeastShare, 1.0 - kLeastShare));
        return true;
    };
    draw(sort.speed, Drawn::Speed, body.maxSpeed);
    draw(sort.radius, Drawn::Radius, body.radius);
    draw(sort.headway, Drawn::Headway, body.headway);
    draw(sort.premovement, Drawn::Premovement, body.premovement);
    double age = 0.0;
    if (draw(sort.age, Drawn::Age, age)) body.maxSpeed = walkingSpeedAtAge(age);
    if (sort.unitClass != 0) body.unitClass = sort.unitClass;
    if (sort.upstairs != 0.0) body.upstairs = sort.upstairs;
    if (sort.downstairs != 0.0) body.downstairs = sort.downstairs;
    return body;
}

Body drawMember(const GroupDef& def, std::size_t index, std::uint64_t seed, std::uint32_t character) {
    const Body body = givenBody(def, index);
    if (def.people.empty()) return body;
    double left = randomShare(seed, character, Drawn::Sort) * sumOfShares(def.people);
    std::size_t sort = 0;
    while (sort + 1 < def.people.size() && left >= def.people[sort].share) left -= def.people[sort++].share;
    return drawPerson(def.people[sort], body, seed, character);
}

std::vector<Body> drawMembers(const GroupDef& def, std::uint64_t seed, std::uint32_t first) {
    const auto count = static_cast<std::size_t>(def.count);
    std::vector<Body> bodies(count);
    std::vector<std::uint32_t> ids(count);
    std::iota(ids.begin(), ids.end(), first);
    for (std::size_t k = 0; k < count; ++k) bodies[k] = givenBody(def, k);
    drawAll(def.people, seed, ids, bodies);
    return bodies;
}

void drawAll(const std::vector<PeopleDef>& people, std::uint64_t seed, std::span<const std::uint32_t> ids,
             std::span<Body> bodies) {
    if (people.empty()) return;
    // The ranks in a random order: those of the first sort, those of the second, and so on.
    std::vector<std::pair<double, std::size_t>> ranks(ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k) ranks[k] = {randomShare(seed, ids[k], Drawn::Sort), k};
    std::sort(ranks.begin(), ranks.end());
    const std::vector<std::size_t> quota = quotas(people, ids.size());
    auto at = ranks.begin();
    for (std::size_t sort = 0; sort < quota.size(); ++sort)
        for (std::size_t n = 0; n < quota[sort]; ++n, ++at)
            bodies[at->second] = drawPerson(people[sort], bodies[at->second], seed, ids[at->second]);
}

Body withoutSorts(const GroupDef& def, std::size_t index, Body body) {
    const Body given = givenBody(def, index);
    for (const PeopleDef& sort : def.people) {
        const auto giveBack = [](const Distribution& drawn, double& number, double before) {
            if (isDrawn(drawn)) number = before;
        };
        giveBack(sort.speed, body.maxSpeed, given.maxSpeed);
        giveBack(sort.age, body.maxSpeed, given.maxSpeed);
        giveBack(sort.radius, body.radius, given.radius);
        giveBack(sort.headway, body.headway, given.headway);
        giveBack(sort.premovement, body.premovement, given.premovement);
        if (sort.unitClass != 0) body.unitClass = given.unitClass;
        if (sort.upstairs != 0.0) body.upstairs = given.upstairs;
        if (sort.downstairs != 0.0) body.downstairs = given.downstairs;
    }
    return body;
}

}  // namespace muster
