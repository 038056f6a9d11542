#include "engine/systems/passages/passage_guide.h"

#include <algorithm>

#include "engine/passages/way_number.h"

namespace muster {
namespace {

constexpr double kMargin = 0.05;    // Between a body and the end of a gap [m].
constexpr double kBeyond = 0.8;     // Characters head for points this far behind a gap [m].
constexpr double kBefore = 0.4;     // Who sees no way through heads for points this far before it [m]...
constexpr double kFarBefore = 1.0;  // ... or this far.
constexpr double kNear = 0.05;      // Nearer points are no target [m].
constexpr std::int32_t kTraceCells = 24;  // Of the way to a passage that is out of sight.

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
        return distance(from, target) > kNear && fields.ground().collisionFree(from, target);
    };
    const Vec2 behindGap = via + through * (behind + kBeyond);
    if (visible(behindGap)) return normalized(behindGap - from);
    // Beside the mouth of the gap first to where one sees through.
    for (const Vec2 target :
         {via, via - through * (before + kBefore), passage.middle() - through * (before + kFarBefore)})
        if (visible(target)) return normalized(target - from);
    fields.trace(passageOf(chosen.way), from, kTraceCells, path_);
    Vec2 target = via;
    for (const Vec2 p : path_)
        if (visible(p)) target = p;
    return normalized(target - from, through);
}

}  // namespace muster
