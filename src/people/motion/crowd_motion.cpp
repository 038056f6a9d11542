#include "base/maths.h"
#include "muster/motion.h"

#include <algorithm>

#include "engine/formation/places/place_tracker.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"
#include "engine/world/inspect.h"
#include "people/motion/crowd_view.h"
#include "people/motion/head_look.h"
#include "people/motion/player.h"
#include "people/motion/posed_body.h"
#include "people/motion/shown_character.h"

namespace muster {

struct CrowdMotionState {
    Player::Moment player;
    std::vector<MotionState> states;
    std::vector<std::uint32_t> near;
    std::vector<std::uint32_t> nearIds;
    std::vector<PosedBody> bodies;
};

struct CrowdMotion::Impl {
    Impl(const ClipLibrary& clips, const CrowdMotionDef& motionDef)
        : library(&clips), def(motionDef), table(clips), player(table) {}

    void findNear(const Characters& characters);
    void matchBodies();
    void standStill(const Characters& characters);
    void put(std::span<const ShownCharacter> shown, CrowdView& crowd);
    void turnHeads(std::span<const ShownCharacter> shown, float dt);

    const ClipLibrary* library;
    CrowdMotionDef def;
    ClipTable table;
    Player player;
    std::vector<MotionState> states;
    std::vector<std::uint32_t> wanted;   ///< Ids of wanted characters, ascending.
    bool named = false;                  ///< True after setNear().
    std::vector<std::uint32_t> near;     ///< Indices of near characters, ascending.
    std::vector<std::uint32_t> nearIds;  ///< Ids of near characters.
    std::vector<PosedBody> bodies;       ///< Bodies, one per entry of `near`.
    std::vector<PosedBody> spare;
    std::vector<PlacesView> places;                    ///< Places by group.
    std::vector<std::optional<MotionSet>> motionSets;  ///< Motion sets by group.
    Characters put_;                                   ///< The crowd with who is shown otherwise.
    std::vector<std::int32_t> chosen;                  ///< Chosen clips, by index.
    bool looked = false;                               ///< True where somebody looked at something.
};

void CrowdMotion::Impl::findNear(const Characters& characters) {
    near.clear();
    nearIds.clear();
    const bool all = !named && def.allNear;
    std::size_t k = 0;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const std::uint32_t id = characters.id[i];
        while (k < wanted.size() && wanted[k] < id) ++k;
        if (!all && (k == wanted.size() || wanted[k] != id)) continue;
        near.push_back(static_cast<std::uint32_t>(i));
        nearIds.push_back(id);
    }
}

// Matches bodies to the near characters: bodies of characters that remain near continue; the others start
// fresh.
void CrowdMotion::Impl::matchBodies() {
    bool same = bodies.size() == nearIds.size();
    for (std::size_t k = 0; same && k < bodies.size(); ++k) same = bodies[k].id == nearIds[k];
    if (same) return;
    spare.resize(nearIds.size());
    std::size_t old = 0;
    for (std::size_t k = 0; k < nearIds.size(); ++k) {
        while (old < bodies.size() && bodies[old].id < nearIds[k]) ++old;
        const bool kept = old < bodies.size() && bodies[old].id == nearIds[k];
        if (kept) {
            spare[k] = bodies[old];
        } else {
            spare[k].id = nearIds[k];
            spare[k].fresh = true;
        }
    }
    bodies.swap(spare);
}

// Without clips all characters are shown in the rest pose.
void CrowdMotion::Impl::standStill(const Characters& characters) {
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const Vec2 heading = characters.heading[i];
        states[i] = {};
        states[i].position = characters.position[i];
        states[i].yaw = static_cast<float>(arcTangent2(heading.y, heading.x));
        states[i].size = characterSize(characters.id[i]);
    }
    for (PosedBody& body : bodies) body.pose = restPose();
}

CrowdMotion::CrowdMotion(const ClipLibrary& library, const CrowdMotionDef& def)
    : impl_(std::make_unique<Impl>(library, def)) {}
CrowdMotion::~CrowdMotion() = default;
CrowdMotion::CrowdMotion(CrowdMotion&&) noexcept = default;
CrowdMotion& CrowdMotion::operator=(CrowdMotion&&) noexcept = default;

void CrowdMotion::restart() {
    impl_->player.restart();
    impl_->bodies.clear();
}

// The crowd as it is shown, a copy of the world's.
void CrowdMotion::Impl::put(std::span<const ShownCharacter> shown, CrowdView& crowd) {
    put_ = *crowd.characters;
    chosen.assign(put_.size(), -1);
    for (const ShownCharacter& one : shown) {
        const std::int32_t i = put_.indexOf(one.id);
        if (i < 0) continue;
        chosen[i] = one.clip;
        if (!one.moved) continue;
        put_.position[i] = one.position;
        put_.velocity[i] = one.velocity;
        put_.heading[i] = one.heading;
        put_.motion[i] = one.motion;
        put_.phase[i] = one.phase;
        put_.motionTime[i] = one.motionTime;
        put_.patch[i] = one.patch;
        put_.lastSingle[i] = one.lastSingle;
        // It goes on as it goes now: no place of the simulation draws it.
        put_.place[i] = -1;
        const double top = crowd.maxSpeed * crowd.environment->ground(one.position).travelSpeed;
        put_.direction[i] = one.velocity / top;
    }
    crowd.characters = &put_;
    crowd.chosenClips = chosen;
}

// Who stands, walks or runs turns the head; other motions keep theirs.
void CrowdMotion::Impl::turnHeads(std::span<const ShownCharacter> shown, float dt) {
    if (shown.empty() && !looked) return;
    looked = !shown.empty();
    std::size_t at = 0;
    for (PosedBody& body : bodies) {
        while (at < shown.size() && shown[at].id < body.id) ++at;
        const bool named = at < shown.size() && shown[at].id == body.id;
        const Mover& mover = player.movers()[near[static_cast<std::size_t>(&body - bodies.data())]];
        const ClipEntry& entry = table[mover.clip];
        std::optional<Vec3> target = named ? shown[at].look : std::nullopt;
        if (entry.use != ClipUse::Locomotion) target.reset();
        turnHead(mover, target, dt, !entry.handsTouch, body);
        looked = looked || body.lookYaw != 0.0f || body.lookPitch != 0.0f;
    }
}

void CrowdMotion::update(const World& world) {
    update(world, {});
}

void CrowdMotion::update(const World& world, std::span<const ShownCharacter> shown) {
    impl_->places.clear();
    impl_->motionSets.clear();
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const PlaceTracker& places = inspect::places(world, g);
        impl_->places.push_back({places.positions(), places.velocities()});
        impl_->motionSets.push_back(inspect::groupDef(world, g).motions);
    }
    CrowdView crowd;
    crowd.characters = &inspect::characters(world);
    crowd.environment = &inspect::environment(world);
    crowd.places = impl_->places;
    crowd.motionSets = impl_->motionSets;
    crowd.stepTime = world.parameters().stepTime;
    crowd.maxSpeed = world.parameters().character.maxSpeed;
    crowd.directReach = world.parameters().character.directReach;
    if (!shown.empty()) impl_->put(shown, crowd);
    update(crowd);
    if (impl_->table.size() > 0) impl_->turnHeads(shown, static_cast<float>(crowd.stepTime));
}

void CrowdMotion::forget(std::span<const std::uint32_t> ids) {
    impl_->player.forget(ids);
}

void CrowdMotion::update(const CrowdView& crowd) {
    Impl& m = *impl_;
    const Characters& characters = *crowd.characters;
    m.states.resize(characters.size());
    m.findNear(characters);
    m.matchBodies();
    if (m.table.size() == 0) return m.standStill(characters);
    m.player.update(crowd);
    const std::vector<Mover>& movers = m.player.movers();
    for (std::size_t i = 0; i < movers.size(); ++i) {
        const Mover& v = movers[i];
        m.states[i] = {v.clip, v.fromClip, v.time, v.fromTime, v.fade, v.position, v.yaw, v.size};
    }
    const auto dt = static_cast<float>(crowd.stepTime);
    const auto decay = static_cast<float>(exponential(static_cast<double>(-kInertialisationRate * dt)));
    for (std::size_t k = 0; k < m.bodies.size(); ++k) {
        const Mover& mover = movers[m.near[k]];
        if (mover.fresh) m.bodies[k].fresh = true;
        solveBody(m.table, mover, dt, decay, m.bodies[k]);
    }
}

std::shared_ptr<const CrowdMotionState> CrowdMotion::state() const {
    const Impl& m = *impl_;
    return std::make_shared<const CrowdMotionState>(
        CrowdMotionState{m.player.moment(), m.states, m.near, m.nearIds, m.bodies});
}

void CrowdMotion::goBack(const CrowdMotionState& state) {
    Impl& m = *impl_;
    m.player.goBack(state.player);
    m.states = state.states;
    m.near = state.near;
    m.nearIds = state.nearIds;
    m.bodies = state.bodies;
}

std::size_t CrowdMotion::sizeOf(const CrowdMotionState& state) {
    return state.player.movers.size() * sizeof(Mover) + state.states.size() * sizeof(MotionState) +
           state.near.size() * 2 * sizeof(std::uint32_t) + state.bodies.size() * sizeof(PosedBody);
}

void CrowdMotion::setNear(std::span<const std::uint32_t> ids) {
    impl_->wanted.assign(ids.begin(), ids.end());
    std::sort(impl_->wanted.begin(), impl_->wanted.end());
    impl_->named = true;
}

std::span<const MotionState> CrowdMotion::states() const {
    return impl_->states;
}
std::span<const std::uint32_t> CrowdMotion::near() const {
    return impl_->near;
}
std::uint32_t CrowdMotion::nearId(std::size_t k) const {
    return impl_->nearIds[k];
}
const BodyPose& CrowdMotion::pose(std::size_t k) const {
    return impl_->bodies[k].pose;
}

bool CrowdMotion::locked(std::size_t k, Limb limb) const {
    for (std::size_t h = 0; h < kLockableLimbCount; ++h)
        if (kLockableLimbs[h] == limb) return impl_->bodies[k].limbs[h].locked;
    return false;
}

const ClipLibrary& CrowdMotion::library() const {
    return *impl_->library;
}

void worldJoints(const MotionState& state, const BodyPose& pose, JointTransforms& joints) {
    const Quat turn = yawTurn(static_cast<double>(state.yaw));
    jointTransforms(pose, {turn, {}}, joints);
    const Vec3 at{static_cast<float>(state.position.x), static_cast<float>(state.position.y), 0.0f};
    for (Transform& joint : joints) joint.translation = at + joint.translation * state.size;
}

}  // namespace muster
