#include "engine/orders/avoidance.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"

namespace muster {

void listCourse(const CourseDef& def, const Manoeuvre& manoeuvre, double until, Course& course,
                double times) {
    course.clear();
    double now = 0.0;
    Vec2 on = def.middle - def.side * def.aside;  // On its way.
    double beside = def.aside;
    const Vec2 offset = def.box.centre - def.middle;
    const auto go = [&](Vec2 velocity, double sideways, double end) {
        end = std::min(end, until);
        if (end <= now) return;
        MovingBox part = def.box;
        part.velocity = velocity + def.side * (times * sideways);
        part.from = now;
        part.to = end;
        part.centre = on + def.side * (def.aside + times * (beside - def.aside)) + offset - part.velocity * now;
        course.push_back(part);
        on += velocity * (end - now);
        beside += sideways * (end - now);
        now = end;
    };
    // A change of speed counts as half of it at the one speed, and half at the other.
    const Vec2 along = normalized(def.ahead.front() - on);
    const double half = 0.5 / def.acceleration;
    if (manoeuvre.wait > 0.0) go(along * def.speed, 0.0, half * def.speed);
    const double speed = manoeuvre.wait > 0.0 ? 0.0 : def.speed;
    go(along * speed, 0.0, manoeuvre.wait + half * std::max(0.0, def.cruise - speed));
    const double off = manoeuvre.aside - beside;
    const double sideways = off < 0.0 ? -kAsideShare * def.cruise : kAsideShare * def.cruise;
    const double shifted = now + off / sideways;
    for (std::size_t k = 0; k < def.ahead.size() && now < until;) {
        const Vec2 leg = def.ahead[k] - on;
        const double part = length(leg);
        const bool shifts = now < shifted;
        const double pace = shifts ? kOnwardShare * def.cruise : def.cruise;
        const double end = now + part / pace;
        if (shifts && shifted < end) {
            go(leg * (pace / part), sideways, shifted);
            now = std::max(now, std::min(shifted, until));
            continue;
        }
        if (part > 0.0) go(leg * (pace / part), shifts ? sideways : 0.0, end);
        ++k;
    }
    go({}, 0.0, until);
}

double firstContact(std::span<const MovingBox> course, std::span<const MovingBox> other, double margin) {
    for (const MovingBox& part : course) {
        double first = kInfiniteCost;
        for (const MovingBox& box : other) {
            const TimeSpan span = contactSpan(part, box, margin);
            if (!span.empty()) first = std::min(first, span.from);
        }
        if (first < kInfiniteCost) return first;
    }
    return kInfiniteCost;
}

double timeLost(const CourseDef& def, const Manoeuvre& manoeuvre) {
    // It goes aside, and back.
    const double aside = std::fabs(manoeuvre.aside - def.aside) + std::fabs(manoeuvre.aside);
    return manoeuvre.wait + aside * (1.0 - kOnwardShare) / (kAsideShare * def.cruise);
}

}  // namespace muster
