// Checks of orders, bodies and roles.
#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"

namespace muster {
namespace {

constexpr double kLeastRadius = 0.05, kMostRadius = 1.5;  // Of a body [m].
constexpr double kMostSize = 1e5;                         // Of a front or a rectangle [m].

Status validateBody(const Body& body) {
    return first(
        {isOwn("radius", body.radius, kLeastRadius, kMostRadius),
         isOwn("maxSpeed", body.maxSpeed, 0.01, 50.0), isOwn("acceleration", body.acceleration, 0.01, 1000.0),
         inRange("mass", body.mass, 0.01, 1000.0), inRange("supply", body.supply, 1e-3, 1000.0),
         isOwn("headway", body.headway, 0.02, 5.0), inRange("premovement", body.premovement, 0.0, 1e7),
         isOwn("upstairs", body.upstairs, 0.01, 1.0), isOwn("downstairs", body.downstairs, 0.01, 1.0)});
}

// What orders without places name.
Status validateGoals(const Order& order) {
    if (order.choice > ExitChoice::Nearest) return invalidArgument("choice is not known");
    if (order.exits.size() > kMaxAreas)
        return {StatusCode::LimitExceeded, "exits are more than " + std::to_string(kMaxAreas)};
    if (!order.attractions.empty() && order.attractions.size() != order.exits.size())
        return invalidArgument("found " + std::to_string(order.attractions.size()) +
                               " attractions, expected one for each of " +
                               std::to_string(order.exits.size()) + " exits");
    for (const double attraction : order.attractions)
        if (Status s = inRange("attraction", attraction, -1e6, 1e6); !s.ok()) return s;
    if (order.kind == OrderKind::Wait && !order.area) return invalidArgument("it names no waiting area");
    return first({inRange("herding", order.herding, 0.0, 1e6),
                  inRange("misjudgement", order.misjudgement, 0.0, 1e6),
                  inRange("seconds", order.seconds, 0.0, 1e9)});
}

}  // namespace

Status validateOrder(const Order& order) {
    if (order.kind > OrderKind::Walk) return invalidArgument("kind of order is not known");
    if (order.manner > Manner::Continuum) return invalidArgument("manner is not known");
    if (order.turn > Turn::Flow) return invalidArgument("turn is not known");
    const bool heads = order.kind == OrderKind::Face || order.kind == OrderKind::Walk;
    if (heads && !order.facing) return invalidArgument("facing is missing");
    if (order.kind == OrderKind::Follow && !order.group && order.character == 0)
        return invalidArgument("it names neither a group nor a character to follow");
    if (order.route.size() > kMaxCorners)
        return {StatusCode::LimitExceeded, "route has " + std::to_string(order.route.size()) +
                                               " points, at most " + std::to_string(kMaxCorners) +
                                               " are allowed"};
    if (order.formation)
        if (Status s = validateFormation(*order.formation); !s.ok()) return s.within("formation");
    if (Status s = validateGoals(order); !s.ok()) return s;
    return first({isPlace("target", order.target), inRange("facing", order.facing.value_or(0.0), -1e6, 1e6),
                  inRange("width", order.width, 0.0, kMostSize), arePlaces("route", order.route),
                  inRange("pace", order.pace, 0.0, 100.0), inRange("share", order.share, 1e-6, 1.0),
                  isPlace("offset", order.offset), inRange("halfSize", order.halfSize.x, 0.0, kMostSize),
                  inRange("halfSize", order.halfSize.y, 0.0, kMostSize), isPath(order.path).within("path")});
}

Status validateConduct(const Conduct& conduct) {
    if (conduct.stance > Stance::Yield) return invalidArgument("stance is not known");
    return first(
        {inRange("cohesion", conduct.cohesion, 0.0, 1.0), inRange("squeeze", conduct.squeeze, 0.0, 1.0)});
}

Status validateBodies(const std::vector<Body>& bodies, std::size_t count, bool optional) {
    const bool suits = bodies.size() == 1 || bodies.size() == count || (optional && bodies.empty());
    if (!suits)
        return invalidArgument("found " + std::to_string(bodies.size()) + " bodies, expected 1 or " +
                               std::to_string(count));
    for (std::size_t k = 0; k < bodies.size(); ++k)
        if (Status s = validateBody(bodies[k]); !s.ok()) return s.within("bodies[" + std::to_string(k) + "]");
    return {};
}

Status validateRoles(const std::vector<RoleDef>& roles) {
    constexpr std::size_t kMaxRoles = 255;
    if (roles.size() > kMaxRoles) return {StatusCode::LimitExceeded, "there are more than 255 roles"};
    for (std::size_t k = 0; k < roles.size(); ++k) {
        const std::string where = "roles[" + std::to_string(k) + "]";
        if (roles[k].area > RoleArea::Flanks) return invalidArgument("area is not known").within(where);
        if (roles[k].unitClass == 0) return invalidArgument("class is 0, expected 1 to 255").within(where);
    }
    return {};
}

Status validateDemands(const std::vector<double>& demands) {
    if (demands.size() > static_cast<std::size_t>(kMaxCharacters))
        return {StatusCode::LimitExceeded, "there are more demands than places"};
    for (std::size_t k = 0; k < demands.size(); ++k)
        if (Status s = inRange("demand", demands[k], 0.0, 1000.0); !s.ok())
            return s.within("demands[" + std::to_string(k) + "]");
    return {};
}

}  // namespace muster
