#include "studio/session/takes/bend_path.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/ground/environment/environment.h"
#include "studio/session/takes/run_again.h"

namespace muster {
namespace {

constexpr double kArrived = 1.5;     // So near its target a group stands there [m].
constexpr double kSameRoute = 2.0;   // Drawn points so near the old path's point give way to the new one [m].
constexpr double kMostOffset = 1e4;  // [m]

Vec2 between(const std::vector<Vec2>& points, std::uint32_t first, double step) {
    const double at = std::clamp((step - first) / kPathSpacing, 0.0,
                                 static_cast<double>(points.size()) - 1.0);
    const auto k = static_cast<std::size_t>(at);
    const std::size_t next = std::min(k + 1, points.size() - 1);
    return points[k] + (points[next] - points[k]) * (at - static_cast<double>(k));
}

/// Applies a bend to the commands of a take.
class Bender {
public:
    Bender(Take& take, const TakePaths& paths, const PathBend& bend)
        : take_(take),
          paths_(paths),
          bend_(bend),
          dt_(take.def.parameters.stepTime),
          time_(bend.step * dt_) {}

    Status group() {
        std::uint32_t first = 0;
        const std::vector<Vec2> path = paths_.ofGroup(bend_.group, first);
        if (path.empty()) return noPath("group", bend_.group.value);
        const bool moved = moveFingers();
        if (redirect(between(path, first, bend_.step)) || moved) return {};
        return {StatusCode::NotFound, "nothing directs group " + std::to_string(bend_.group.value) +
                                          " around that moment, so its path cannot be changed there"};
    }

    Status character(const Environment& environment) {
        std::uint32_t first = 0;
        const std::vector<Vec2> path = paths_.ofCharacter(bend_.character, first);
        if (path.size() < 2) return noPath("character", bend_.character);
        const std::uint32_t reach = static_cast<std::uint32_t>(bend_.seconds / dt_);
        const std::uint32_t from = std::max(first, bend_.step - std::min(bend_.step, reach));
        const auto lastPoint = first + static_cast<std::uint32_t>(path.size() - 1) * kPathSpacing;
        const std::uint32_t to = std::min({bend_.step + reach, lastPoint, take_.steps()});
        if (from >= to) return noPath("character", bend_.character);
        std::uint32_t client = 0, sequence = 0;
        for (const Command& command : take_.commands) client = std::max(client, command.client);
        ++client;
        const auto give = [&](std::uint32_t step, CommandBody body) {
            take_.commands.push_back({step, client, sequence++, std::move(body)});
        };
        give(from, ChangeCharacters{{bend_.character}, {}, Driver::Outside});
        const double radius = take_.def.parameters.character.radius;
        for (std::uint32_t step = from; step < to; ++step) {
            const double after = (static_cast<double>(step) - bend_.step) * dt_;
            const Vec2 wanted = between(path, first, step + 1.0) +
                                bend_.offset * bendWeight(after, bend_.seconds);
            give(step, WriteMotion{{bend_.character}, {environment.projectToFreeSpace(wanted, radius)}, {}});
        }
        give(to, ChangeCharacters{{bend_.character}, {}, Driver::Muster});
        return {};
    }

private:
    static Status noPath(const char* what, std::uint32_t id) {
        return {StatusCode::NotFound,
                std::string(what) + " " + std::to_string(id) + " has no path at that moment of the take"};
    }

    /// The group that a finger of a command moves.
    GroupId groupOf(const Command& down, std::uint32_t touch, GroupId named) const {
        return named ? named : paths_.heldBy(down.client, touch, down.step);
    }

    bool moveFingers() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, GroupId> held;  // By client and touch.
        bool moved = false;
        for (Command& command : take_.commands) {
            if (const auto* down = touchOf(command.body, TouchPhase::Down))
                held[{command.client, down->touch}] = groupOf(command, down->touch, down->group);
            if (const auto* add = std::get_if<AddControl>(&command.body))
                for (const std::uint32_t touch : add->touches) held[{command.client, touch}] = add->group;
            auto* move = touchOf(command.body, TouchPhase::Move);
            if (move == nullptr) continue;
            const auto holder = held.find({command.client, move->touch});
            if (holder == held.end() || holder->second != bend_.group) continue;
            const double weight = bendWeight(move->time - time_, bend_.seconds);
            move->position += bend_.offset * weight;
            moved = moved || weight > 0.0;
        }
        return moved;
    }

    // The last order that the group was given before that moment leads through the new point.
    bool redirect(Vec2 at) {
        Order* carried = nullptr;
        for (Command& command : take_.commands) {
            auto* give = std::get_if<GiveOrder>(&command.body);
            if (give == nullptr || give->group != bend_.group || command.step > bend_.step) continue;
            if (give->order.kind == OrderKind::Move) carried = &give->order;
        }
        for (std::size_t g = 0; carried == nullptr && g < take_.def.groups.size(); ++g) {
            if (g + 1 != bend_.group.value) continue;
            for (Order& order : take_.def.groups[g].orders)
                if (order.kind == OrderKind::Move && carried == nullptr) carried = &order;
        }
        if (carried == nullptr) return false;
        if (distance(at, carried->target) < kArrived) {
            carried->target += bend_.offset;
            return true;
        }
        std::vector<Vec2>& route = carried->route;
        const auto nearest = std::min_element(route.begin(), route.end(), [&](Vec2 a, Vec2 b) {
            return lengthSquared(a - at) < lengthSquared(b - at);
        });
        auto place = nearest == route.end() ? route.end() : nearest;
        place = route.insert(place, at + bend_.offset);
        const auto index = place - route.begin();
        for (std::ptrdiff_t k = std::ssize(route) - 1; k >= 0; --k)
            if (k != index && distance(route[static_cast<std::size_t>(k)], at) < kSameRoute)
                route.erase(route.begin() + k);
        return true;
    }

    Take& take_;
    const TakePaths& paths_;
    const PathBend& bend_;
    double dt_;
    double time_;
};

Status check(const Take& take, const PathBend& bend) {
    if (!(bend.seconds >= 0.5 && bend.seconds <= 60.0))
        return invalidArgument("found " + std::to_string(bend.seconds) + " s, expected 0.5 to 60");
    if (!(std::fabs(bend.offset.x) <= kMostOffset && std::fabs(bend.offset.y) <= kMostOffset))
        return invalidArgument("found an offset that is not finite or above 10 km");
    if (bend.step > take.steps())
        return invalidArgument("found step " + std::to_string(bend.step) + ", expected at most " +
                               std::to_string(take.steps()));
    return {};
}

}  // namespace

double bendWeight(double after, double seconds) {
    const double share = std::fabs(after) / seconds;
    if (share >= 1.0) return 0.0;
    const double left = 1.0 - share * share;
    return left * left;
}

Result<Take> bendPath(const Take& take, const TakePaths& paths, const Environment& environment,
                      const PathBend& bend) {
    if (const Status good = check(take, bend); !good.ok()) return good;
    Take changed = take;
    Bender bender(changed, paths, bend);
    const Status done = bend.character == 0 ? bender.group() : bender.character(environment);
    if (!done.ok()) return done;
    runAgain(changed, take.steps());
    return changed;
}

}  // namespace muster
