// Key poses: paths of limbs by hand-set keys, for actions that happen once.
#pragma once

#include <initializer_list>
#include <vector>

#include "character/generator/curve.h"
#include "character/generator/figure.h"
#include "character/generator/leg_track.h"
#include "muster/clip.h"

namespace muster::generator {

/// A path in space, at rest where two keys are equal.
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

/// A foot at a time: its ankle [m], its pitch with toes up [degrees], and where the knee points.
struct FootKey {
    double time;
    Vec3 ankle;
    double pitch;
    Vec3 knee;
    double toe = 0.0;  ///< Toes bent down against the foot [degrees].
};

/// A leg by keys, in the frame of the keys.
class FootCurve {
public:
    explicit FootCurve(const std::vector<FootKey>& keys);
    Leg at(double time) const;

private:
    PointCurve ankle_, knee_;
    Curve pitch_, toe_;
};

/// A time in which a hand lies flat somewhere, in the ground's frame.
struct HandContact {
    double begin = 0.0;   ///< [s]
    double end = 0.0;     ///< [s]
    Vec3 wrist;           ///< [m]
    double come = 0.25;   ///< It leaves its free way so long before [s].
    double go = 0.25;     ///< And is back so long after [s].
    bool touches = true;  ///< False for a place on the way that holds nothing.
};

/// The hand's reach at a time: its holds one after the other.
Reach reachAt(const std::vector<HandContact>& holds, std::size_t side, double time);
/// The holds as contacts.
void addContacts(std::vector<Contact>& contacts, std::size_t side, const std::vector<HandContact>& holds);

/// A channel's keys: times [s] and values (degrees, or metres for places).
struct ChannelKeys {
    Channel channel;
    std::vector<Key> keys;
};

/// Channels by keys; those without keys keep what `base` says.
class BodyKeys {
public:
    explicit BodyKeys(const std::vector<ChannelKeys>& channels);
    Body at(double time, const Body& base) const;

private:
    struct Line {
        Channel channel;
        Curve curve;
        double scale;
    };
    std::vector<Line> lines_;
};

/// From the ground's frame to the travelling one.
Leg fromGround(const Placement& place, const Leg& leg);
Reach fromGround(const Placement& place, Reach reach);

/// The shape of a leg at a time and how it changes, to begin or end a swing with; `figure` is in the
/// travelling frame.
LegJoin joinOf(const std::function<Figure(double)>& figure, std::size_t side, double time);

}  // namespace muster::generator
