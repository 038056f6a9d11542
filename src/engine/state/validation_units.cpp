// What the fields of orders have to be together; checks of lists of bodies, roles and demands.
#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"

namespace muster {

Status relations(const Order& d) {
    const bool heads = d.kind == OrderKind::Face || d.kind == OrderKind::Walk;
    if (heads && !d.facing) return invalidArgument("facing is missing");
    if (d.kind == OrderKind::Follow && !d.group && d.character == 0)
        return invalidArgument("it names neither a group nor a character to follow");
    if (!d.attractions.empty() && d.attractions.size() != d.exits.size())
        return invalidArgument("found " + std::to_string(d.attractions.size()) +
                               " attractions, expected one for each of " + std::to_string(d.exits.size()) +
                               " exits");
    if (d.kind == OrderKind::Wait && !d.area) return invalidArgument("it names no waiting area");
    return {};
}

Status validateBodies(const std::vector<Body>& bodies, std::size_t count, bool optional) {
    const bool suits = bodies.size() == 1 || bodies.size() == count || (optional && bodies.empty());
    if (!suits)
        return invalidArgument("found " + std::to_string(bodies.size()) + " bodies, expected 1 or " +
                               std::to_string(count));
    for (std::size_t k = 0; k < bodies.size(); ++k)
        if (Status s = validate(bodies[k]); !s.ok()) return s.within("bodies[" + std::to_string(k) + "]");
    return {};
}

Status validateRoles(const std::vector<RoleDef>& roles) {
    return each("roles", roles, 255);
}

Status validateDemands(const std::vector<double>& demands) {
    return eachInRange("demands", demands, kMaxCharacters, 0.0, 1000.0);
}

}  // namespace muster
