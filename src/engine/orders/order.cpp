#include "muster/order.h"

#include <utility>

#include "base/maths.h"

namespace muster {

Order Order::move(Vec2 target, std::optional<double> facing) {
    Order order;
    order.target = target;
    order.facing = facing;
    return order;
}

Order Order::go(Vec2 target, std::optional<double> facing) {
    Order order = move(target, facing);
    order.manner = Manner::Free;
    return order;
}

Order Order::face(double facing) {
    Order order;
    order.kind = OrderKind::Face;
    order.facing = facing;
    return order;
}

Order Order::follow(GroupId group, Vec2 offset) {
    Order order;
    order.kind = OrderKind::Follow;
    order.group = group;
    order.offset = offset;
    return order;
}

Order Order::followCharacter(std::uint32_t character, Vec2 offset) {
    Order order = follow({}, offset);
    order.character = character;
    return order;
}

Order Order::guard(Vec2 centre, Vec2 halfSize, double facing) {
    Order order;
    order.kind = OrderKind::Guard;
    order.target = centre;
    order.halfSize = halfSize;
    order.facing = facing;
    return order;
}

Order Order::leave(std::vector<AreaId> exits) {
    Order order;
    order.kind = OrderKind::Leave;
    order.exits = std::move(exits);
    return order;
}

Order Order::wait(AreaId area, double seconds) {
    Order order;
    order.kind = OrderKind::Wait;
    order.area = area;
    order.seconds = seconds;
    return order;
}

Order Order::walk(double facing) {
    Order order = face(facing);
    order.kind = OrderKind::Walk;
    return order;
}

Order Order::moveToLine(Vec2 left, Vec2 right) {
    const Vec2 ahead = perpendicular(right - left);  // A viewer who looks ahead has the left end on the left.
    Order order = move(lerp(left, right, 0.5), arcTangent2(ahead.y, ahead.x));
    order.width = distance(left, right);
    return order;
}

}  // namespace muster
