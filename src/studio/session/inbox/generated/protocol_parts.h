// Made by schema/generate.mjs from schema/messages.txt: change these, not this file.
// clang-format off
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/generated/ground_definitions.h"
#include "muster/generated/orders_definitions.h"
#include "muster/generated/world_definitions.h"

namespace muster::protocol {

inline constexpr std::uint32_t kVersion = 18;                 ///< Raised by any change of a message.
inline constexpr const char* kSubprotocol = "muster.v18";  ///< Of the WebSocket.

using muster::ControlKind;
using muster::TouchPhase;
using muster::Stance;
using muster::Standing;
using muster::EventKind;
/// What a person wants of time.
enum class PlaybackAction : std::uint8_t { Play, Pause, SingleStep, Restart, Demonstrate, GoBack, LeaveTake };
/// What the ground is coloured by.
enum class OverlayKind : std::uint8_t { None, Field, Cost, Density, Reach };
/// What moves.
enum class MovingKind : std::uint8_t { Obstacle, Patch };
/// What a mark of a take stands for.
enum class TakeMarkKind : std::uint8_t { Touch, Order, Change, Event };
/// What is wrong with an edited path.
enum class EditFindingKind : std::uint8_t { Person, Obstacle, Outside, Speed };
/// How serious a notice is.
enum class NoticeLevel : std::uint8_t { Info, Warning, Error };
/// What a person uses.
enum class InputKind : std::uint8_t { Pointer, Key };
/// What points.
enum class PointerDevice : std::uint8_t { Touch, Pen, Mouse };
/// Buttons of a pointer.
enum class PointerButton : std::uint8_t { Left, Middle, Right };
/// How a question is answered.
enum class QuestionKind : std::uint8_t { Number, Scale, Choice, Text };
/// Where a run of the study stands.
enum class StudyStage : std::uint8_t { Form, Ready, Trial, Paused, Thanks, BrokenOff, Elsewhere, Replay };
/// What a person wants in a run of the study.
enum class StudyAct : std::uint8_t { Start, GoOn, GiveUp, BreakOff };
/// What is wanted of a sentence.
enum class SayAct : std::uint8_t { Complete, Preview, Do, Look };
/// How a trial ended.
enum class TrialEnd : std::uint8_t { None, Done, TimeOver, GivenUp, Practised };
/// What a director did with the world of all.
enum class WorldChange : std::uint8_t { None, Opened, Restarted, Watched, WentBack };
/// What a block of a take's time line stands for.
enum class TakeBlockKind : std::uint8_t { Order, Gesture, Change };
/// What is done to the blocks of the open take.
enum class TrackEdit : std::uint8_t { Move, Copy, Remove, Stretch, Undo, Redo };

/// How many values an enumeration has.
template <class Choice>
inline constexpr std::size_t kChoices = kCountOf<Choice>;
template <>
inline constexpr std::size_t kChoices<PlaybackAction> = 7;
template <>
inline constexpr std::size_t kChoices<OverlayKind> = 5;
template <>
inline constexpr std::size_t kChoices<MovingKind> = 2;
template <>
inline constexpr std::size_t kChoices<TakeMarkKind> = 4;
template <>
inline constexpr std::size_t kChoices<EditFindingKind> = 4;
template <>
inline constexpr std::size_t kChoices<NoticeLevel> = 3;
template <>
inline constexpr std::size_t kChoices<InputKind> = 2;
template <>
inline constexpr std::size_t kChoices<PointerDevice> = 3;
template <>
inline constexpr std::size_t kChoices<PointerButton> = 3;
template <>
inline constexpr std::size_t kChoices<QuestionKind> = 4;
template <>
inline constexpr std::size_t kChoices<StudyStage> = 8;
template <>
inline constexpr std::size_t kChoices<StudyAct> = 4;
template <>
inline constexpr std::size_t kChoices<SayAct> = 4;
template <>
inline constexpr std::size_t kChoices<TrialEnd> = 5;
template <>
inline constexpr std::size_t kChoices<WorldChange> = 5;
template <>
inline constexpr std::size_t kChoices<TakeBlockKind> = 3;
template <>
inline constexpr std::size_t kChoices<TrackEdit> = 6;

/// Marks the input as bad where an enumeration read from it has no such value.
template <class Archive, class Choice>
void checkChoice(Archive& archive, Choice value) {
    if constexpr (Archive::kReading) {
        if (static_cast<std::size_t>(value) >= kChoices<Choice>) archive.fail();
    }
}

/// Somebody who is connected.
struct DirectorFrame {
    std::uint32_t client = 0;
    std::string name;
    std::uint8_t colour = 0;  ///< 0 to 15; no two have the same.
    std::vector<std::uint32_t> groups;  ///< Ids of the groups that they may direct; empty: all.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(client, name, colour, groups);
    }
};

/// One finger begins, moves, lifts or is lost, in world coordinates [m].
struct TouchEvent {
    TouchPhase phase = TouchPhase::Down;
    std::uint32_t touch = 0;
    double x = 0.0;
    double y = 0.0;
    double time = 0.0;  ///< Page clock [s]; the session maps it to world time.
    std::uint32_t group = 0;  ///< 0: the nearest mesh within reach.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(phase, touch, x, y, time, group);
        checkChoice(archive, phase);
    }
};

/// A scenario that the server can load.
struct ScenarioInfo {
    std::string name;  ///< File name without .json, after its folder's name and a slash.
    std::string title;
    std::string description;
    std::uint32_t characters = 0;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, title, description, characters);
    }
};

/// A held vertex and the way drawn for it [m].
struct ControlPointFrame {
    std::uint32_t touch = 0;
    bool down = false;
    float x = 0.0f;
    float y = 0.0f;
    std::vector<float> path;  ///< x, y of the checkpoints ahead.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(touch, down, x, y, path);
    }
};

/// A control on a mesh.
struct ControlFrame {
    std::uint32_t id = 0;
    ControlKind kind = ControlKind::Point;
    std::uint32_t client = 0;
    bool pinned = false;
    bool open = false;
    std::vector<ControlPointFrame> points;
    std::vector<float> supplementary;  ///< x, y.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, kind, client, pinned, open, points, supplementary);
        checkChoice(archive, kind);
    }
};

/// An order that a group might get, or has in its queue, and where the group would begin it.
struct ForecastAsk {
    std::uint32_t group = 0;
    std::uint32_t order = 0;  ///< Id of an order in its queue; 0: that of asked.
    std::optional<Order> asked = {};  ///< None where it asks for an order of the queue.
    bool placed = false;  ///< It would begin at x, y, facing; else where the formation is.
    double x = 0.0;  ///< [m].
    double y = 0.0;
    double facing = 0.0;  ///< [rad].

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, order, asked, placed, x, y, facing);
    }
};

/// What would come of an order.
struct ForecastFrame {
    std::uint32_t group = 0;
    std::uint32_t order = 0;  ///< As asked.
    bool arrives = false;
    float seconds = 0.0f;  ///< Infinite where it never arrives [s].
    float x = 0.0f;  ///< Where the formation would stand: the target, or the nearest ground to it [m].
    float y = 0.0f;
    std::vector<float> way;  ///< x, y of its centre, both ends included.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, order, arrives, seconds, x, y, way);
    }
};

/// A formation that a group might take up, and where, or places on the ground.
struct PlacesAsk {
    std::uint32_t group = 0;
    std::optional<FormationDef> formation = {};  ///< None: the places are given.
    double x = 0.0;  ///< Where the formation's centre would be [m].
    double y = 0.0;
    double facing = 0.0;  ///< [rad].
    std::vector<double> places;  ///< x, y of places on the ground, where there is no formation [m].
    std::uint32_t count = 0;  ///< People in the formation; 0: as many as the group has.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, formation, x, y, facing, places, count);
    }
};

/// Where each would stand.
struct PlacesFrame {
    std::uint32_t group = 0;
    std::vector<float> places;  ///< x, y on the ground [m].
    std::vector<std::uint8_t> unfit;  ///< Per place a Standing: 0 where it can be reached, else what keeps people from there.
    std::string problem;  ///< One sentence: why it is no formation; else empty.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, places, unfit, problem);
    }
};

/// Somebody who cannot be in its place.
struct StandingFrame {
    std::uint32_t id = 0;
    Standing standing = Standing::InPlace;  ///< What keeps it from there.
    float x = 0.0f;  ///< Where its formation wants it [m].
    float y = 0.0f;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, standing, x, y);
        checkChoice(archive, standing);
    }
};

/// A group's mesh, places and controls [m].
struct GroupFrame {
    std::uint32_t id = 0;
    std::uint32_t meshVersion = 0;
    float lag = 0.0f;  ///< Mean distance to places [m].
    float walkSum = 0.0f;  ///< Of all walks, as the last plan knows them.
    float walkSquares = 0.0f;  ///< Sum of their squares.
    float walkLongest = 0.0f;
    std::vector<float> vertices;  ///< x, y of Vf.
    std::vector<std::uint32_t> moved;  ///< Places with another offset than in the last frame sent.
    std::vector<std::int16_t> offsets;  ///< x, y per such from their points of the mesh [cm].
    std::vector<std::uint8_t> unfit;  ///< A bit per place, the lowest first, 1: no room for anyone; empty where unchanged.
    std::vector<std::uint32_t> standings;  ///< How many stand as each Standing tells, in its order; empty where unchanged.
    std::vector<ControlFrame> controls;
    float x = 0.0f;  ///< Where its formation has its centre [m].
    float y = 0.0f;
    float facing = 0.0f;  ///< [rad].
    bool queued = false;  ///< Its queue follows; false: it is as in the last frame sent.
    std::vector<QueuedOrder> orders;  ///< Its queue, where it follows.
    std::vector<float> way;  ///< x, y: the rest of the way of the order that is carried out.
    bool held = false;  ///< It waits; the queue stays.
    bool patrols = false;  ///< Orders that are done come last again.
    Stance stance = Stance::Normal;
    float cohesion = 0.0f;  ///< 0 to 1.
    float squeeze = 0.0f;  ///< Share of its width that it may give up.
    bool avoids = false;  ///< Its mesh gives way to others.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, meshVersion, lag, walkSum, walkSquares, walkLongest, vertices, moved, offsets, unfit,
                standings, controls, x, y, facing, queued, orders, way, held, patrols, stance, cohesion,
                squeeze, avoids);
        checkChoice(archive, stance);
    }
};

/// All characters, in some four bytes each: see docs/protocol.md.
struct CrowdFrame {
    std::uint32_t count = 0;
    double x0 = 0.0;  ///< Where x is 0 [m].
    double y0 = 0.0;
    float quantum = 0.0f;  ///< What 1 is in x and y [m]; a power of two.
    std::vector<std::uint16_t> x;  ///< Of everybody, or empty where steps follow.
    std::vector<std::uint16_t> y;
    std::vector<std::int8_t> stepX;  ///< Since the last frame sent.
    std::vector<std::int8_t> stepY;
    std::vector<std::uint32_t> jumped;  ///< Indices of those who moved too far for a step.
    std::vector<std::uint16_t> jumpedX;  ///< Where they are.
    std::vector<std::uint16_t> jumpedY;
    std::vector<std::uint8_t> heading;  ///< Whole 256ths of a turn.
    std::vector<std::uint8_t> headingFine;  ///< 256ths of these; empty in large crowds.
    std::vector<std::uint32_t> changed;  ///< Indices of those who play another clip than in the last frame sent.
    std::vector<std::uint8_t> clip;  ///< Index into Motions: theirs, or everybody's where x is.
    std::vector<std::uint8_t> phase;  ///< Whole 256ths of the clip.
    std::vector<std::uint8_t> phaseFine;  ///< 256ths of these; empty in large crowds.
    std::vector<std::uint32_t> near;  ///< Indices of those who come with whole poses.
    std::vector<float> nearPlaces;  ///< Per such x, y [m], heading [rad].
    std::vector<std::int16_t> nearPoses;  ///< Per such: hips x, y, z [mm], then three numbers per joint, for a body of size 1.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(count, x0, y0, quantum, x, y, stepX, stepY, jumped, jumpedX, jumpedY, heading, headingFine,
                changed, clip, phase, phaseFine, near, nearPlaces, nearPoses);
    }
};

/// Where an obstacle or a patch that moves stands now.
struct MovingFrame {
    MovingKind kind = MovingKind::Obstacle;
    std::uint32_t id = 0;
    float x = 0.0f;  ///< Offset from the defined placement.
    float y = 0.0f;
    float angle = 0.0f;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, id, x, y, angle);
        checkChoice(archive, kind);
    }
};

/// What an exit or a source has seen.
struct AreaFrame {
    std::uint32_t id = 0;
    std::uint32_t passed = 0;  ///< Who have left by it, or come by it.
    std::uint32_t waiting = 0;  ///< Of a source: for whom there is no room yet.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, passed, waiting);
    }
};

/// A joint of the characters' skeleton in the rest pose; parents come before their children.
struct JointFrame {
    std::string name;
    std::uint32_t parent = 0;  ///< Index; its own for the first.
    float x = 0.0f;  ///< Offset from the parent [m].
    float y = 0.0f;
    float z = 0.0f;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, parent, x, y, z);
    }
};

/// A motion clip as baked poses, in the character's own frame (x forward, y left, z up, on the ground below
/// it).
struct ClipFrames {
    std::string name;
    std::string motion;  ///< What it belongs to: run, crawl...
    float rate = 0.0f;  ///< Poses a second.
    bool cyclic = false;  ///< After the last pose comes the first.
    std::uint32_t poses = 0;
    std::vector<float> hips;  ///< x, y, z per pose [m].
    std::vector<std::int16_t> rotations;  ///< Per pose and joint x, y, z, w over 32767, relative to the parent.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, motion, rate, cyclic, poses, hips, rotations);
    }
};

/// A part of a take that plays faster or slower.
struct SpeedPiece {
    double from = 0.0;  ///< Time of the take [s].
    double to = 0.0;
    double speed = 0.0;  ///< 0.1 to 8.
    double ease = 0.0;  ///< In which it comes and goes [s].

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(from, to, speed, ease);
    }
};

/// Where the film camera of a take is at a moment.
struct CameraKey {
    std::uint32_t step = 0;
    double x = 0.0;  ///< The point on the ground that it looks at [m].
    double y = 0.0;
    double distance = 0.0;  ///< From there [m].
    double turn = 0.0;  ///< [rad].
    double pitch = 0.0;  ///< [rad].
    bool cut = false;  ///< It is here at once; otherwise it comes from the one before.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(step, x, y, distance, turn, pitch, cut);
    }
};

/// Something that happens in a take, for its time line.
struct TakeMark {
    TakeMarkKind kind = TakeMarkKind::Touch;
    std::uint32_t step = 0;
    std::uint32_t length = 0;  ///< Steps that a finger is down.
    std::string label;  ///< In one or two words.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, step, length, label);
        checkChoice(archive, kind);
    }
};

/// A row of an open take: all that concerns one group.
struct TakeTrack {
    std::uint32_t group = 0;  ///< Id; 0: what concerns the place or nobody in particular.
    std::string name;
    std::uint32_t from = 0;  ///< Step in which the group comes.
    std::uint32_t to = 0;  ///< In which it ends; the take's steps where it stays.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, name, from, to);
    }
};

/// One thing that a group does in the open take, with all commands that belong to it.
struct TakeBlock {
    std::uint32_t id = 0;  ///< Valid until the take changes.
    std::uint32_t group = 0;
    TakeBlockKind kind = TakeBlockKind::Order;
    std::uint32_t begin = 0;  ///< Step of its first command.
    std::uint32_t begun = 0;  ///< Step from which it is carried out: later for orders in a queue.
    std::uint32_t end = 0;
    std::string label;  ///< As people say it: 'Move to Fountain'.
    bool moves = false;  ///< It can begin at another time, and be copied.
    bool stretches = false;  ///< It can take another time.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, group, kind, begin, begun, end, label, moves, stretches);
        checkChoice(archive, kind);
    }
};

/// Holds a path at another place at one moment of the own clock.
struct EditPin {
    double time = 0.0;  ///< On the own clock [s].
    double x = 0.0;  ///< How far from where they were then [m].
    double y = 0.0;
    double seconds = 0.0;  ///< So long before and after the path moves along [s].

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(time, x, y, seconds);
    }
};

/// A moment of the take at which another one of the recording is shown.
struct EditClock {
    double time = 0.0;  ///< [s].
    double own = 0.0;  ///< Time of the recording [s].

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(time, own);
    }
};

/// A time in which a clip is played.
struct EditClip {
    std::string name;
    double from = 0.0;  ///< [s].
    double to = 0.0;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, from, to);
    }
};

/// A time in which somebody looks at something.
struct EditLook {
    std::uint32_t person = 0;  ///< At whom; 0: at a point.
    double x = 0.0;  ///< [m].
    double y = 0.0;
    double height = 0.0;
    double from = 0.0;  ///< [s].
    double to = 0.0;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(person, x, y, height, from, to);
    }
};

/// What is changed afterwards in how some people of a take are shown.
struct PeopleEdit {
    std::vector<std::uint32_t> people;  ///< In ascending order.
    std::vector<EditPin> pins;
    std::vector<EditClock> clock;
    std::vector<EditClip> clips;
    std::vector<EditLook> looks;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(people, pins, clock, clips, looks);
    }
};

/// Something wrong with the path of an edited person.
struct EditFinding {
    std::uint32_t person = 0;
    EditFindingKind kind = EditFindingKind::Person;
    std::uint32_t other = 0;  ///< The other person, or the obstacle.
    double from = 0.0;  ///< [s].
    double to = 0.0;
    double x = 0.0;  ///< Where it is worst [m].
    double y = 0.0;
    std::string text;  ///< In words, without the person.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(person, kind, other, from, to, x, y, text);
        checkChoice(archive, kind);
    }
};

/// What a person does with fingers, mouse and keys, before anything judges it.
struct RawInput {
    InputKind kind = InputKind::Pointer;
    TouchPhase phase = TouchPhase::Down;
    PointerDevice device = PointerDevice::Touch;
    PointerButton button = PointerButton::Left;  ///< The one that went down.
    std::uint32_t pointer = 0;  ///< Number of the finger; the same from Down to Up.
    std::uint8_t key = 0;  ///< '0' to '9', 'A' to 'Z', 27 for Escape, 127 for Delete.
    double x = 0.0;  ///< From the upper left corner of the view [px].
    double y = 0.0;
    double time = 0.0;  ///< Page clock [s]; it is mapped to world time.
    bool shift = false;
    bool control = false;  ///< Ctrl, or the command key.
    bool alt = false;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, phase, device, button, pointer, key, x, y, time, shift, control, alt);
        checkChoice(archive, kind);
        checkChoice(archive, phase);
        checkChoice(archive, device);
        checkChoice(archive, button);
    }
};

/// A control scheme that a client may choose.
struct SchemeInfo {
    std::string name;
    std::string title;
    std::string description;
    bool mesh = false;  ///< It takes hold of the mesh.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, title, description, mesh);
    }
};

/// One of the answers to choose from.
struct ChoiceFrame {
    std::string text;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(text);
    }
};

/// One question of a form.
struct QuestionFrame {
    std::string name;
    std::string text;
    QuestionKind kind = QuestionKind::Number;
    double low = 0.0;
    double high = 0.0;
    double step = 0.0;  ///< Between the marks of a scale.
    std::string lowLabel;
    std::string highLabel;
    std::vector<ChoiceFrame> choices;
    bool needed = false;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, text, kind, low, high, step, lowLabel, highLabel, choices, needed);
        checkChoice(archive, kind);
    }
};

/// The answer to one question.
struct AnswerFrame {
    std::string name;  ///< Of the question.
    std::string text;  ///< As given.
    double number = 0.0;  ///< Where it is one.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, text, number);
    }
};

/// A stage of the step and how long it takes.
struct StageFrame {
    std::string name;
    std::string about;  ///< What it does, in one sentence.
    float milliseconds = 0.0f;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, about, milliseconds);
    }
};

/// Something that happened.
struct EventFrame {
    EventKind kind = EventKind::EnterPatch;
    std::uint32_t subject = 0;
    std::uint32_t value = 0;
    float x = 0.0f;
    float y = 0.0f;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, subject, value, x, y);
        checkChoice(archive, kind);
    }
};

/// How a sentence may go on.
struct SaidCompletion {
    std::string words;  ///< What comes next, for people.
    std::string whole;  ///< The sentence with it.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(words, whole);
    }
};

/// Numbers of a body for all present members of a group.
struct GroupBodyEdit {
    std::uint32_t group = 0;
    std::optional<double> radius = {};  ///< None to leave it as it is [m].
    std::optional<double> maxSpeed = {};  ///< [m/s].
    std::optional<std::uint8_t> unitClass = {};

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, radius, maxSpeed, unitClass);
    }
};

/// Extent of the ground.
struct SceneBox {
    Vec2 min;  ///< [m].
    Vec2 max;  ///< [m].

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(min, max);
    }
};

/// A motion clip, which patches name by its index.
struct SceneClip {
    std::string name;
    double speed = 0.0;  ///< Travel speed relative to running.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, speed);
    }
};

/// An obstacle of the world.
struct SceneObstacle {
    std::uint32_t id = 0;
    ObstacleDef definition;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, definition);
    }
};

/// A patch of the world.
struct ScenePatch {
    std::uint32_t id = 0;
    PatchDef definition;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, definition);
    }
};

/// An item of the world.
struct SceneItem {
    std::uint32_t id = 0;
    ItemDef definition;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, definition);
    }
};

/// A checkpoint of the world.
struct SceneCheckpoint {
    std::uint32_t id = 0;
    FormationCheckpointDef definition;
    std::uint32_t group = 0;  ///< Id of the group that it applies to; 0 for all groups.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, definition, group);
    }
};

/// An area of the world.
struct SceneArea {
    std::uint32_t id = 0;
    AreaDef definition;
    std::uint32_t group = 0;  ///< Of a source: id of the group whom its people join.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, definition, group);
    }
};

/// What all in a group have in common; none of a number in which they differ.
struct GroupBody {
    std::optional<double> radius = {};  ///< [m].
    std::optional<double> maxSpeed = {};  ///< [m/s].
    std::optional<std::uint8_t> unitClass = {};  ///< 0 for none.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(radius, maxSpeed, unitClass);
    }
};

/// A group of the world.
struct SceneGroup {
    std::uint32_t id = 0;
    std::uint8_t accent = 0;  ///< Index of the accent: blue, ember, green, plum, ochre, slate.
    std::uint32_t count = 0;  ///< Who are in it now.
    std::string formation;  ///< What it is in now.
    bool placed = false;  ///< The place has it; else it is a part of others.
    GroupDef definition;  ///< How the place has it: what another one like it begins as.
    GroupBody body;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, accent, count, formation, placed, definition, body);
    }
};

/// A parameter of behaviour.
struct SceneParameter {
    std::string name;
    double value = 0.0;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, value);
    }
};

}  // namespace muster::protocol
