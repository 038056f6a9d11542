#include "files/export/player/crowd_track.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/maths.h"
#include "files/export/character_look.h"
#include "files/export/player/player_format.h"

namespace muster {
namespace {

constexpr double kFadeTime = 0.2;  // A clip before fades out within this time [s].
constexpr double kFadeSlack = 0.02;
constexpr std::uint32_t kChosenColour = 0x1000000u;
// A body of another radius is drawn larger by this power of the ratio, as in the studio.
constexpr double kScalePower = 0.7, kScaleLeast = 0.6, kScaleMost = 4.0;

/// `value` less whole turns, from -turn / 2 on.
std::int32_t wrapped(std::int32_t value, std::int32_t turn) {
    const std::int32_t half = turn / 2;
    const std::int32_t rest = (value + half) % turn;
    return (rest < 0 ? rest + turn : rest) - half;
}

std::int32_t headingUnits(double yaw) {
    return wrapped(unitsOf(yaw / (2.0 * kPi), 1.0 / kTurn), kTurn);
}

std::size_t stirOf(std::int32_t difference) {
    return difference == 0 ? 0 : 1;
}

/// How much larger than the usual body one of that radius is drawn, in percent.
std::int32_t scalePercent(const World& world, std::size_t index) {
    const double own = world.characters().body[index].radius, usual = world.parameters().character.radius;
    if (!(own > 0.0) || own == usual) return 100;
    const double scale = std::clamp(power(own / usual, kScalePower), kScaleLeast, kScaleMost);
    return unitsOf(scale, 0.01);
}

}  // namespace

std::uint32_t CrowdTrack::clipNumber(std::uint16_t index) {
    const auto [found, fresh] = clipNumbers_.try_emplace(index, static_cast<std::uint32_t>(clips_.size()));
    if (fresh) {
        const Clip& clip = library_.clips[index];
        clips_.push_back({index, std::max(1, unitsOf(clip.duration(), 1.0 / kClipSecond)), clip.cyclic});
    }
    return found->second;
}

void CrowdTrack::findColours(const World& world) {
    groupColours_.clear();
    for (std::uint32_t g = 0; g < world.groupCount(); ++g) {
        const CharacterLook look = characterLook(0, g, world);
        const std::uint32_t colour = look.chosen ? kChosenColour + *look.chosen : look.accent;
        const auto [found, fresh] = colourNumbers_.try_emplace(colour,
                                                               static_cast<std::uint32_t>(colours_.size()));
        if (fresh) colours_.push_back(colour);
        groupColours_.push_back(found->second);
    }
}

void CrowdTrack::frame(const ExportFrame& frame) {
    passed_ = samples_ == 0 ? 0.0 : frame.time - time_;
    time_ = frame.time;
    findColours(*frame.world);
    const std::vector<std::uint32_t> before = [&] {
        std::vector<std::uint32_t> ids;
        for (const Member& member : members_) ids.push_back(member.id);
        return ids;
    }();
    changeMembers(frame);
    std::size_t old = 0;
    for (std::size_t i = 0; i < members_.size(); ++i) {
        while (old < before.size() && before[old] < members_[i].id) ++old;
        if (old < before.size() && before[old] == members_[i].id) move(members_[i], frame.characters[i]);
    }
    samples_ += members_.size();
    most_ = std::max(most_, members_.size());
}

void CrowdTrack::changeMembers(const ExportFrame& frame) {
    const auto characters = frame.characters;
    bool same = characters.size() == members_.size();
    for (std::size_t i = 0; same && i < characters.size(); ++i) same = characters[i].id == members_[i].id;
    coder_.bit(changed_, !same);
    if (same) return;
    const auto hasId = [](const auto& list, std::uint32_t id) {
        const auto at = std::lower_bound(list.begin(), list.end(), id,
                                         [](const auto& one, std::uint32_t of) { return one.id < of; });
        return at != list.end() && at->id == id;
    };
    std::vector<std::uint32_t> gone;
    for (std::size_t i = 0; i < members_.size(); ++i)
        if (!hasId(characters, members_[i].id)) gone.push_back(static_cast<std::uint32_t>(i));
    coder_.natural(gone_, static_cast<std::uint32_t>(gone.size()));
    std::uint32_t last = 0;
    for (const std::uint32_t i : gone) coder_.natural(gone_, i - last), last = i;
    std::vector<std::size_t> came;
    for (std::size_t i = 0; i < characters.size(); ++i)
        if (!hasId(members_, characters[i].id)) came.push_back(i);
    coder_.natural(came_, static_cast<std::uint32_t>(came.size()));
    std::erase_if(members_, [&](const Member& member) { return !hasId(characters, member.id); });
    std::uint32_t id = 0;
    for (const std::size_t i : came) {
        coder_.natural(ids_, characters[i].id - id);
        id = characters[i].id;
        come(characters[i], *frame.world);
    }
    std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) { return a.id < b.id; });
}

void CrowdTrack::come(const ExportCharacter& character, const World& world) {
    Member member;
    member.id = character.id;
    const CharacterLook look = characterLook(character.id, character.group, world);
    coder_.bit(body_, look.body == BodyKind::Narrow);
    bodies_[static_cast<std::size_t>(look.body)] = true;
    const auto ids = world.characters().id;
    const auto at = std::lower_bound(ids.begin(), ids.end(), character.id);
    const bool there = at != ids.end() && *at == character.id;
    coder_.whole(scale_, there ? scalePercent(world, static_cast<std::size_t>(at - ids.begin())) - 100 : 0);
    member.colour = groupColours_[character.group];
    coder_.natural(colour_, member.colour);
    member.x.begin(unitsOf(character.position.x, kPositionUnit));
    member.y.begin(unitsOf(character.position.y, kPositionUnit));
    member.yaw.begin(headingUnits(static_cast<double>(character.yaw)));
    coder_.whole(place_, member.x.now - lastPlace_[0]);
    coder_.whole(place_, member.y.now - lastPlace_[1]);
    lastPlace_[0] = member.x.now, lastPlace_[1] = member.y.now;
    coder_.whole(heading_, member.yaw.now);
    member.clip = clipNumber(character.clip);
    coder_.natural(clip_, member.clip);
    member.time = timeUnits(member.clip, character.clipTime);
    coder_.natural(clipTime_, static_cast<std::uint32_t>(member.time));
    member.fade = character.fade;
    members_.push_back(member);
}

std::int32_t CrowdTrack::timeUnits(std::uint32_t clip, float time) const {
    const PlayedClip& played = clips_[clip];
    const std::int32_t units = unitsOf(static_cast<double>(time), 1.0 / kClipSecond);
    if (played.cyclic) return units % played.duration;
    return std::clamp(units, 0, played.duration);
}

void CrowdTrack::move(Member& member, const ExportCharacter& character) {
    const std::int32_t x = unitsOf(character.position.x, kPositionUnit);
    const std::int32_t y = unitsOf(character.position.y, kPositionUnit);
    const std::int32_t byX = x - member.x.next(), byY = y - member.y.next();
    coder_.whole(step_[member.stir], byX);
    coder_.whole(step_[member.stir], byY);
    const std::int32_t stir = std::abs(byX) + std::abs(byY);
    member.stir = stir == 0 ? 0 : stir < 3 ? 1 : 2;
    member.x.go(x);
    member.y.go(y);
    const std::int32_t turn = wrapped(headingUnits(static_cast<double>(character.yaw)) - member.yaw.next(),
                                      kTurn);
    coder_.whole(turn_[member.turned], turn);
    member.turned = stirOf(turn);
    member.yaw.go(member.yaw.next() + turn);
    const std::uint32_t colour = groupColours_[character.group];
    coder_.bit(recoloured_, colour != member.colour);
    if (colour != member.colour) coder_.natural(colour_, colour);
    member.colour = colour;
    play(member, character);
}

void CrowdTrack::play(Member& member, const ExportCharacter& character) {
    const std::uint32_t clip = clipNumber(character.clip);
    const double left = std::max(0.0, static_cast<double>(member.fade) - passed_ / kFadeTime);
    const bool switched = clip != member.clip || static_cast<double>(character.fade) > left + kFadeSlack;
    coder_.bit(switched_[member.switched], switched);
    member.switched = switched ? 1 : 0;
    member.fade = character.fade;
    const PlayedClip before = clips_[member.clip], now = clips_[clip];
    const std::int32_t time = timeUnits(clip, character.clipTime);
    if (switched) {
        coder_.natural(nextClip_[member.clip], clip);
        coder_.natural(fade_, static_cast<std::uint32_t>(
                                  unitsOf(static_cast<double>(character.fade), 1.0 / kFadeSteps)));
        // Steps are in time before and after more often than not.
        const std::int64_t same = static_cast<std::int64_t>(member.time) * now.duration / before.duration;
        coder_.whole(phase_, wrapped(time - static_cast<std::int32_t>(same), now.duration + 1));
    } else {
        std::int32_t by = time - (member.time + member.advance);
        if (now.cyclic) by = wrapped(by, now.duration);
        coder_.whole(pace_[member.paced], by);
        member.paced = stirOf(by);
        member.advance += by;
    }
    member.clip = clip;
    member.time = time;
}

void CrowdTrack::thing(std::size_t which, Vec2 place, double angle) {
    const bool fresh = which >= things_.size();
    if (fresh) things_.resize(which + 1);
    Thing& thing = things_[which];
    const std::int32_t values[] = {unitsOf(place.x, kPositionUnit), unitsOf(place.y, kPositionUnit),
                                   unitsOf(angle / (2.0 * kPi), 1.0 / kThingTurn)};
    Course* const courses[] = {&thing.x, &thing.y, &thing.angle};
    for (int k = 0; k < 3; ++k) {
        coder_.whole(k < 2 ? thingPlace_ : thingAngle_, values[k] - courses[k]->next());
        fresh ? courses[k]->begin(values[k]) : courses[k]->go(values[k]);
    }
}

}  // namespace muster
