#include "engine/systems/passages/passage_guide.h"

#include <algorithm>

#include "engine/passages/way_number.h"

namespace muster {
namespace {

constexpr double kMargin = 0.05;     // Distance between a body and the end of a gap [m].
constexpr double kHeadBehind = 0.8;  // Distance behind a gap for which characters head [m].
// Distance before a gap for which a character heads that sees no line through [m]...
constexpr double kHeadBefore = 0.4;
constexpr double kHeadFarBefore = 1.0;         // ... and the distance if it does not see that point either.
constexpr double kLeastTargetDistance = 0.05;  // Distance below which a point is no target [m].
// Length of the traced walk to a passage that is out of sight [cells].
constexpr std::int32_t kTraceCells = 24;

}  // namespace

Vec2 PassageGuide::direction(const WorldState& state, const WayFields& fields, std::size_t character) {
    const ChosenWay& chosen = state.characters.chosen[character];
    const Passage& passage = state.passages[passageOf(chosen.way)];
    const Vec2 from = state.characters.position[character];
    const double width = passage.width();
    const double margin = std::min(state.parameters.character.radius + kMargin, 0.5 * width);
    const Vec2 along = (passage.b - passage.a) / width;
    const Vec2 through = perpendicular(along) * static_cast<double>(sideBehind(chosen.way));
    const Vec2 via = passage.a + along * (margin + chosen.share * (width - 2.0 * margin));
    const double behind = fromLeft(chosen.way) ? passage.right : passage.left;
    const double before = fromLeft(chosen.way) ? passage.left : passage.right;
    const auto visible = [&](Vec2 target) {
        return distance(from, target) > kLeastTargetDistance && fields.ground().collisionFree(from, target);
    };
    const Vec2 behindGap = via + through * (behind + kHeadBehind);
    if (visible(behindGap)) return normalized(behindGap - from);
    // A character beside the mouth of the gap first heads for a point with a line through it.
    for (const Vec2 target : {via, via - through * (before + kHeadBefore),
                              passage.middle() - through * (before + kHeadFarBefore)})
        if (visible(target)) return normalized(target - from);
    fields.trace(passageOf(chosen.way), from, kTraceCells, path_);
    Vec2 target = via;
    for (const Vec2 p : path_)
        if (visible(p)) target = p;
    return normalized(target - from, through);
}

}  // namespace muster
