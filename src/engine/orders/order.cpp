#include "muster/order.h"

#include "base/maths.h"

namespace muster {

Order Order::moveToLine(Vec2 left, Vec2 right) {
    const Vec2 ahead = perpendicular(right - left);  // A viewer who looks ahead has the left end on the left.
    Order order = move(lerp(left, right, 0.5), arcTangent2(ahead.y, ahead.x));
    order.width = distance(left, right);
    return order;
}

}  // namespace muster
