// What a sentence says, before it is asked what that means in the world.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/order.h"
#include "studio/words/known_names.h"

namespace muster::words {

/// A direction of the compass, or one of a group's own.
enum class Heading : std::uint8_t {
    East,
    NorthEast,
    North,
    NorthWest,
    West,
    SouthWest,
    South,
    SouthEast,
    Forward,
    Left,
    Back,
    Right
};
inline bool isCompass(Heading heading) {
    return heading < Heading::Forward;
}

/// Where a spot lies in relation to what it names.
enum class Beside : std::uint8_t { At, Near, Around, InFront, Behind, Off };

enum class SpotKind : std::uint8_t { Point, Thing, Group, Middle, Edge, Shift, Between };

/// A place on the ground.
struct Spot {
    SpotKind kind = SpotKind::Point;
    Beside beside = Beside::At;
    bool crossed = false;              ///< They go over, under or through the thing.
    Vec2 point;                        ///< For Point [m].
    std::vector<ThingSpot> things;     ///< For Thing: of several the nearest; for Between: two.
    GroupId group;                     ///< For Group.
    Heading heading = Heading::North;  ///< For Edge and Shift, and for what lies off.
    std::optional<Heading> corner;     ///< For Edge: the other side of a corner.
    std::optional<double> metres;      ///< For Shift, and from what it names.
    std::string words;                 ///< "Fountain", "the middle".
};

/// Where a group is to face.
struct Facing {
    std::optional<Heading> heading;
    std::optional<Spot> at;
    bool away = false;           ///< From what lies there.
    std::optional<double> turn;  ///< From where it faces now, to the left [rad].
    std::string words;
};

enum class Amount : std::uint8_t { All, Share, Count, Rest };
enum class Side : std::uint8_t { Any, Left, Right, Front, Rear };

/// Who shall do something.
struct Who {
    bool named = false;  ///< It says which groups; else those of before, or the chosen ones.
    bool everybody = false;
    bool sameAgain = false;  ///< "they".
    std::vector<GroupId> groups;
    std::vector<GroupId> except;
    Amount amount = Amount::All;
    double share = 1.0;
    double count = 0.0;
    Side side = Side::Any;
    std::optional<Spot> nearest;  ///< Those who are nearest to it.
};

enum class Verb : std::uint8_t {
    None,
    Move,
    Face,
    Follow,
    Guard,
    Leave,
    Wait,
    Cross,
    Walk,
    Stop,
    Hold,
    Resume,
    Patrol,
    EndPatrol,
    Form,
    Space,
    Split,
    Merge,
    Swap,
    Name,
    Colour,
    Faster,
    Slower,
    Add,
    Reverse,
    Skip,
    Play,
    Pause,
    Restart,
    Undo,
    Redo,
    Pace
};

/// One thing to do, with all that is said about how.
struct Act {
    Verb verb = Verb::None;
    bool then = false;  ///< After what was said before, or after what is under way.
    std::optional<Spot> to;
    std::vector<Spot> via;
    std::optional<FormationKind> form;
    bool linesUp = false;  ///< A line, where no other form is said.
    std::int32_t files = 0;
    std::optional<double> spacing;  ///< [m]
    double spread = 1.0;            ///< Factor of the spacing.
    std::optional<Facing> facing;
    std::optional<double> pace;  ///< [m/s]
    double haste = 1.0;          ///< Share of the usual pace.
    bool freely = false;         ///< Each by the shortest way.
    double seconds = 0.0;
    std::vector<GroupId> others;   ///< Whom to follow, to guard, to join.
    std::optional<double> number;  ///< Of parts, of people, of the speed.
    std::string name;
    std::optional<std::uint32_t> colour;
};

/// What may be said besides a verb, as bits.
enum Part : unsigned {
    kNone = 0,
    kTo = 1,
    kVia = 2,
    kForm = 4,
    kSpacing = 8,
    kFacing = 16,
    kPace = 32,
    kFreely = 64,
    kTime = 128,
    kOthers = 256,
    kNumber = 512,
    kName = 1024,
    kColour = 2048,
    kStand = kForm | kSpacing | kFacing
};
/// All that an act says besides its verb.
unsigned partsOf(const Act& act);

/// Who, and what they shall do.
struct Clause {
    std::optional<Who> who;
    std::vector<Act> acts;
};

}  // namespace muster::words
