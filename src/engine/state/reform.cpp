#include "engine/state/reform.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "base/bounds.h"

namespace muster {
namespace {

constexpr std::size_t kSamples = 64;     // Places by which a formation is fitted.
constexpr double kSamePlace = 0.6;       // Places nearer than so many spacings are the same.
constexpr double kFileReach = 2.2;       // Who moves up comes from at most so many spacings behind,
constexpr double kFileWidth = 0.8;       // and so many beside,
constexpr double kLeastRank = 0.3;       // and at least so many behind.
constexpr std::size_t kMostHoles = 64;   // So many places are closed up at most, else all are matched again.
constexpr std::int32_t kAddedRank = 10;  // Points that are added come in ranks of so many.
constexpr double kClearlyBetter = 0.5;   // Of the misfit of another way to fit it.
constexpr double kCentred = 1e-9;        // A formation nearer to its origin is not moved [m].

std::vector<Vec2> restPlacesOf(const Formation& formation) {
    std::vector<Vec2> places;
    for (const MeshPoint& place : formation.places)
        places.push_back(place.position(formation.mesh.triangles, formation.mesh.vertices));
    return places;
}

// Sum of squared distances from some of the places, moved by `shift`, to the nearest points held. At least
// `enough` where it would be that much.
double misfit(std::span<const Vec2> places, Vec2 shift, std::span<const Vec2> held, double enough) {
    const std::size_t stride = std::max<std::size_t>(1, places.size() / kSamples);
    double sum = 0.0;
    for (std::size_t k = 0; k < places.size() && sum < enough; k += stride) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec2 h : held) nearest = std::min(nearest, lengthSquared(places[k] + shift - h));
        sum += nearest;
    }
    return sum;
}

// How far a formation is moved to fit what is held: front on front, unless origin on origin, middle on
// middle, or rear on rear fit clearly better.
Vec2 bestShift(std::span<const Vec2> places, std::span<const Vec2> held) {
    if (held.empty()) return {};
    const Box now = boundsOf(held), next = boundsOf(places);
    const double side = 0.5 * (now.min.y + now.max.y - next.min.y - next.max.y);
    const Vec2 shifts[] = {{now.max.x - next.max.x, side},
                           {0.0, 0.0},
                           {0.5 * (now.min.x + now.max.x - next.min.x - next.max.x), side},
                           {now.min.x - next.min.x, side}};
    Vec2 best;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2 shift : shifts) {
        const double sum = misfit(places, shift, held, kClearlyBetter * least);
        if (sum >= kClearlyBetter * least) continue;
        least = sum;
        best = shift;
    }
    return best;
}

// The place behind a hole whose character moves up; -1 for none.
std::int32_t nextInFile(std::span<const Vec2> rest, double spacing, std::span<const std::uint32_t> occupants,
                        std::int32_t hole) {
    std::int32_t best = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::int32_t k = 0; std::cmp_less(k, rest.size()); ++k) {
        const Vec2 behind = rest[hole] - rest[k];
        if (occupants[k] == 0 || behind.x < kLeastRank * spacing || behind.x > kFileReach * spacing ||
            std::fabs(behind.y) > kFileWidth * spacing || lengthSquared(behind) >= nearest)
            continue;
        nearest = lengthSquared(behind);
        best = k;
    }
    return best;
}

// A character without a place in a new formation, and where it would come from.
struct Newcomer {
    std::uint32_t id = 0;
    Vec2 rest;  // In the axes of the mesh [m].
    PlaceTracker::Origin origin;
};

// Those of the characters who occupy none of the places, with the places that they held or where they stand.
std::vector<Newcomer> newcomersTo(const WorldState& state, const Group& frame, const HeldPlaces& held,
                                  std::span<const std::uint32_t> occupants,
                                  std::span<const std::uint32_t> characters) {
    std::vector<std::uint32_t> placed(occupants.begin(), occupants.end());
    std::sort(placed.begin(), placed.end());
    std::vector<std::uint32_t> missing;
    std::set_difference(characters.begin(), characters.end(), placed.begin(), placed.end(),
                        std::back_inserter(missing));
    std::vector<Newcomer> newcomers;
    std::vector<std::pair<std::uint32_t, std::size_t>> holders;  // Id, and index of its place.
    for (std::size_t k = 0; k < held.occupants.size() && !missing.empty(); ++k)
        holders.emplace_back(held.occupants[k], k);
    std::sort(holders.begin(), holders.end());
    for (const std::uint32_t id : missing) {
        const Vec2 stands = state.characters.position[state.characters.indexOf(id)];
        newcomers.push_back({id, frame.mesh.pose().applyInverse(stands), {nullptr, -1, stands}});
        const auto at = std::lower_bound(holders.begin(), holders.end(), std::pair{id, std::size_t{0}});
        if (at == holders.end() || at->first != id) continue;
        newcomers.back().rest = held.rest[at->second];
        newcomers.back().origin = held.origins[at->second];
    }
    return newcomers;
}

// Gives empty places to those who have none.
void placeNewcomers(std::span<const Vec2> rest, std::span<const Newcomer> newcomers, Reform& reform) {
    std::vector<std::int32_t> empty;
    std::vector<Vec2> to, from;
    for (std::int32_t k = 0; std::cmp_less(k, rest.size()); ++k) {
        if (reform.occupants[k] != 0) continue;
        empty.push_back(k);
        to.push_back(rest[k]);
    }
    for (const Newcomer& newcomer : newcomers) from.push_back(newcomer.rest);
    const std::vector<std::int32_t> match = matchAll(to, from);
    for (std::size_t k = 0; k < match.size(); ++k) {
        if (match[k] < 0) continue;
        const Newcomer& newcomer = newcomers[match[k]];
        reform.occupants[empty[k]] = newcomer.id;
        PlaceTracker::Origin& origin = reform.origins[empty[k]];
        if (origin.tracker == nullptr) origin = newcomer.origin;
    }
}

// Frees the places of all but these characters, whose ids ascend.
void vacate(HeldPlaces& held, std::span<const std::uint32_t> characters) {
    for (std::uint32_t& id : held.occupants)
        if (!std::binary_search(characters.begin(), characters.end(), id)) id = 0;
}

// Points for so many: those held by somebody, without the hindmost holes; or with further ranks behind.
std::vector<Vec2> pointsFor(const HeldPlaces& held, double spacing, std::size_t count) {
    std::vector<std::uint32_t> occupants = held.occupants;
    closeRanks(held.rest, spacing, occupants);
    std::vector<std::int32_t> order(held.rest.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return (occupants[a] != 0) > (occupants[b] != 0);
    });
    std::vector<Vec2> points;
    for (const std::int32_t k : order)
        if (points.size() < count) points.push_back(held.rest[k]);
    if (points.size() == count) return points;
    const Box box = points.empty() ? Box{} : boundsOf(points);
    const double middle = 0.5 * (box.min.y + box.max.y);
    for (std::int32_t k = 0; points.size() < count; ++k) {
        const std::int32_t rank = 1 + k / kAddedRank;
        points.push_back(
            {box.min.x - spacing * rank, middle + spacing * (k % kAddedRank - 0.5 * (kAddedRank - 1))});
    }
    return points;
}

// In the mode of fixed places the k-th member has the k-th place.
void orderByMembers(const WorldState& state, const Group& group, Reform& reform) {
    const std::size_t count = reform.occupants.size();
    std::vector<std::size_t> placeOf(count, count);
    std::vector<std::size_t> empty;
    for (std::size_t p = count; p-- > 0;) {
        const auto at = std::find_if(group.members.begin(), group.members.end(), [&](std::int32_t i) {
            return state.characters.id[i] == reform.occupants[p];
        });
        if (at == group.members.end())
            empty.push_back(p);
        else
            placeOf[at - group.members.begin()] = p;
    }
    Reform ordered = reform;
    for (std::size_t k = 0; k < count; ++k) {
        if (placeOf[k] == count) {
            placeOf[k] = empty.back();
            empty.pop_back();
        }
        ordered.formation.places[k] = reform.formation.places[placeOf[k]];
        ordered.origins[k] = reform.origins[placeOf[k]];
        ordered.occupants[k] = reform.occupants[placeOf[k]];
    }
    reform = std::move(ordered);
}

// Places take their demands along; those that are new demand one unit.
std::vector<double> demandsOf(const WorldState& state, const Reform& reform) {
    std::vector<double> demands;
    const auto hasNone = [](const Group& group) { return group.def.demands.empty(); };
    if (std::all_of(state.groups.begin(), state.groups.end(), hasNone)) return demands;
    for (const PlaceTracker::Origin& origin : reform.origins) {
        const auto from = std::find_if(state.groups.begin(), state.groups.end(),
                                       [&](const Group& group) { return &group.places == origin.tracker; });
        const bool known = from != state.groups.end() && origin.place >= 0 &&
                           std::cmp_less(origin.place, from->def.demands.size());
        demands.push_back(known ? from->def.demands[origin.place] : 1.0);
    }
    if (std::all_of(demands.begin(), demands.end(), [](double demand) { return demand == 1.0; }))
        demands.clear();
    return demands;
}

// Members take the places of the reform, and forget what they knew of others.
void takePlaces(WorldState& state, Group& group, const Reform& reform) {
    Characters& characters = state.characters;
    for (const std::int32_t i : group.members) characters.place[i] = -1;
    for (std::size_t k = 0; k < reform.occupants.size(); ++k)
        if (reform.occupants[k] != 0)
            characters.place[characters.indexOf(reform.occupants[k])] = static_cast<std::int32_t>(k);
    std::erase_if(state.ownRoutes, [&](const OwnRoute& route) {
        const std::int32_t i = characters.indexOf(route.character);
        return i < 0 || &state.groups[characters.group[i]] == &group;
    });
    group.lastAssignment.clear();
    for (const std::int32_t i : group.members) group.lastAssignment.push_back(characters.place[i]);
}

}  // namespace

void HeldPlaces::add(const WorldState& state, const Group& group, const Group& frame) {
    std::vector<Vec2> places;
    group.mesh.heldPlaces(places);
    const std::size_t first = rest.size();
    for (std::size_t k = 0; k < places.size(); ++k) {
        rest.push_back(&group == &frame ? places[k]
                                        : frame.mesh.pose().applyInverse(group.mesh.pose().apply(places[k])));
        origins.push_back({&group.places, static_cast<std::int32_t>(k), {}});
    }
    occupants.resize(rest.size(), 0);
    for (const std::int32_t i : group.members)
        if (const std::int32_t place = state.characters.place[i]; place >= 0)
            occupants[first + static_cast<std::size_t>(place)] = state.characters.id[i];
}

void HeldPlaces::keep(std::span<const std::uint32_t> ids) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < rest.size(); ++k) {
        if (!std::binary_search(ids.begin(), ids.end(), occupants[k])) continue;
        rest[kept] = rest[k];
        occupants[kept] = occupants[k];
        origins[kept++] = origins[k];
    }
    rest.resize(kept);
    occupants.resize(kept);
    origins.resize(kept);
}

FormationDef resized(const Group& group, const HeldPlaces& held, std::span<const std::uint32_t> characters,
                     bool scaled) {
    FormationDef def = group.def.formation;
    const std::size_t count = characters.size();
    if (def.kind == FormationKind::Points) {
        HeldPlaces now = held;
        vacate(now, characters);
        def.points = pointsFor(now, def.spacing, count);
    }
    if (def.kind != FormationKind::Square || group.def.count < 1 || count == 0) return def;
    const std::int32_t files = def.files > 0 ? def.files : squareFiles(group.def.count);
    const double growth = std::sqrt(static_cast<double>(count) / group.def.count);
    if (!scaled)
        def.files = files;
    else if (def.files > 0)
        def.files = std::max(1, static_cast<std::int32_t>(std::floor(files * growth + 0.5)));
    return def;
}

Result<Reform> refit(const WorldState& state, const Group& frame, const HeldPlaces& held,
                     const FormationDef& def, std::span<const std::uint32_t> characters) {
    Reform reform;
    reform.def = def;
    if (characters.empty()) return reform;
    HeldPlaces now = held;
    vacate(now, characters);
    Result<Formation> formation = makeFormation(reform.def, static_cast<std::int32_t>(characters.size()));
    if (!formation.ok()) return formation.status();
    reform.formation = std::move(*formation);
    if (def.kind != FormationKind::Points) {
        const Vec2 shift = bestShift(restPlacesOf(reform.formation), now.rest);
        reform.unmoved = reform.formation.mesh.vertices;
        for (Vec2& v : reform.formation.mesh.vertices) v += shift;
    }
    const std::vector<Vec2> rest = restPlacesOf(reform.formation);
    const std::vector<std::int32_t> match = matchNear(rest, now.rest, kSamePlace * def.spacing);
    reform.occupants.assign(rest.size(), 0);
    reform.origins.assign(rest.size(), {});
    for (std::size_t k = 0; k < rest.size(); ++k) {
        if (match[k] < 0) continue;
        reform.occupants[k] = now.occupants[match[k]];
        reform.origins[k] = now.origins[match[k]];
    }
    closeRanks(rest, def.spacing, reform.occupants);
    std::vector<Newcomer> newcomers = newcomersTo(state, frame, now, reform.occupants, characters);
    if (newcomers.size() > std::max(kMostHoles, characters.size() / 4)) {
        // Another shape, or another place: who stood in front stays in front as far as that is short.
        reform.occupants.assign(rest.size(), 0);
        reform.origins.assign(rest.size(), {});
        newcomers = newcomersTo(state, frame, now, reform.occupants, characters);
    }
    placeNewcomers(rest, newcomers, reform);
    // New places begin where those stand who get them.
    for (std::size_t k = 0; k < rest.size(); ++k) {
        if (reform.origins[k].tracker != nullptr) continue;
        const std::uint32_t id = reform.occupants[k];
        reform.origins[k].position = id != 0 ? state.characters.position[state.characters.indexOf(id)]
                                             : frame.mesh.pose().apply(rest[k]);
    }
    return reform;
}

Result<Reform> asHeld(const WorldState& state, const Group& frame, const HeldPlaces& held,
                      std::span<const std::uint32_t> characters) {
    Reform reform;
    reform.def = frame.def.formation;
    reform.def.kind = FormationKind::Points;
    reform.def.outline = {};
    reform.def.files = 0;
    reform.def.points.clear();
    for (std::size_t k = 0; k < held.rest.size(); ++k) {
        if (!std::binary_search(characters.begin(), characters.end(), held.occupants[k])) continue;
        reform.def.points.push_back(held.rest[k]);
        reform.occupants.push_back(held.occupants[k]);
        reform.origins.push_back(held.origins[k]);
    }
    for (const Newcomer& one : newcomersTo(state, frame, held, reform.occupants, characters)) {
        reform.def.points.push_back(one.rest);
        reform.occupants.push_back(one.id);
        reform.origins.push_back(one.origin);
    }
    if (characters.empty()) return reform;
    Result<Formation> formation = makeFormation(reform.def, static_cast<std::int32_t>(characters.size()));
    if (!formation.ok()) return formation.status();
    reform.formation = std::move(*formation);
    return reform;
}

void applyReform(WorldState& state, Group& group, Reform reform, const FormationMesh& mesh) {
    if (state.parameters.plan.mode == PlanMode::Fixed) orderByMembers(state, group, reform);
    group.def.demands = demandsOf(state, reform);
    group.places.assemble(reform.origins);
    group.def.count = static_cast<std::int32_t>(group.members.size());
    if (group.def.bodies.size() > 1) {
        group.def.bodies.clear();
        for (const std::int32_t i : group.members) group.def.bodies.push_back(state.characters.body[i]);
    }
    if (reform.formation.places.empty()) {
        group.mesh.setPlaces({});
    } else {
        group.def.formation = reform.def;
        const Status changed = group.mesh.changeFrom(mesh, reform.formation);
        MUSTER_ASSERT(changed.ok());
        (void)changed;
        group.controls.rebind(group.mesh.formation().mesh, group.mesh.userMesh());
    }
    takePlaces(state, group, reform);
    group.plan->forget();
    // The fast plan goes on from the places that all have; the exact one has no fields to lead anybody.
    group.planNow = !group.members.empty() && state.parameters.plan.solver == PlanSolver::Exact;
    group.provisional = false;
    group.slice = 0;
    group.slices = 1;
    group.refitted = true;
    if (group.order.arrival == ArrivalWatch::Raised) group.order.arrival = ArrivalWatch::Idle;
    group.order.judged = false;
    ++group.formationVersion;
}

void closeRanks(std::span<const Vec2> rest, double spacing, std::span<std::uint32_t> occupants) {
    std::vector<std::int32_t> holes;
    for (std::int32_t k = 0; std::cmp_less(k, rest.size()); ++k)
        if (occupants[k] == 0) holes.push_back(k);
    if (holes.size() > kMostHoles) return;
    std::stable_sort(holes.begin(), holes.end(),
                     [&](std::int32_t a, std::int32_t b) { return rest[a].x > rest[b].x; });
    for (std::int32_t hole : holes)
        for (std::int32_t next; (next = nextInFile(rest, spacing, occupants, hole)) >= 0; hole = next)
            std::swap(occupants[hole], occupants[next]);
}

void recentreFormation(Group& group) {
    if (!group.refitted) return;
    std::vector<Vec2> rest;
    group.mesh.restPlaces(rest);
    if (rest.empty()) return;
    group.refitted = false;
    const Vec2 middle = std::accumulate(rest.begin(), rest.end(), Vec2{}) / static_cast<double>(rest.size());
    if (length(middle) > kCentred) group.mesh.recentre(middle);
}

}  // namespace muster
