// Key poses: paths of limbs through authored keys, for actions that happen once.
#pragma once

#include <initializer_list>
#include <vector>

#include "muster/clip.h"
#include "people/generator/curve.h"
#include "people/generator/figure.h"
#include "people/generator/leg_track.h"

namespace muster::generator {

/// A path in space; it rests between two equal keys.
class PointCurve {
public:
    struct Point {
        double time;
        Vec3 place;
    };
    explicit PointCurve(const std::vector<Point>& points);
    Vec3 at(double time) const;

private:
    Curve x_, y_, z_;
};

/// A foot at a time: position of the ankle [m], pitch [degrees, positive toes up], direction of the knee.
struct FootKey {
    double time;
    Vec3 ankle;
    double pitch;
    Vec3 knee;
    double toe = 0.0;  ///< Flexion of the toes, downwards relative to the foot [degrees].
};

/// The motion of a leg through keys, in the frame of the keys.
class FootCurve {
public:
    explicit FootCurve(const std::vector<FootKey>& keys);
    Leg at(double time) const;

private:
    PointCurve ankle_, knee_;
    Curve pitch_, toe_;
};

/// A time in which a hand rests on a surface, in the ground frame.
struct HandContact {
    double begin = 0.0;   ///< Begin of the contact [s].
    double end = 0.0;     ///< End of the contact [s].
    Vec3 wrist;           ///< Position of the wrist [m].
    double come = 0.25;   ///< Time before `begin` at which it leaves its free path [s].
    double go = 0.25;     ///< Time after `end` at which it is back on its free path [s].
    bool touches = true;  ///< False for a mere waypoint without contact.
};

/// The target of the arm at a time, through its contacts one after the other.
Reach reachAt(const std::vector<HandContact>& holds, std::size_t side, double time);
/// Adds the contacts that touch to those of a clip.
void addContacts(std::vector<Contact>& contacts, std::size_t side, const std::vector<HandContact>& holds);

/// The keys of a channel: times [s] and values [degrees; m for positions].
struct ChannelKeys {
    Channel channel;
    std::vector<Key> keys;
};

/// Channels through keys; a channel without keys takes its value from `base`.
class BodyKeys {
public:
    explicit BodyKeys(const std::vector<ChannelKeys>& channels);
    ChannelValues at(double time, const ChannelValues& base) const;

private:
    struct Line {
        Channel channel;
        Curve curve;
        double scale;
    };
    std::vector<Line> lines_;
};

/// Transforms a leg from the ground frame to the travelling frame.
Leg fromGround(const Placement& place, const Leg& leg);
Reach fromGround(const Placement& place, Reach reach);

/// The shape of a leg and its rate of change at a time, as the begin or end of a swing; `figure` is in the
/// travelling frame.
LegJoin joinOf(const std::function<Figure(double)>& figure, std::size_t side, double time);

}  // namespace muster::generator
