// Made by schema/generate.mjs from schema/messages.txt: change these, not this file.
// clang-format off
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "studio/session/inbox/generated/protocol_parts.h"

namespace muster::protocol {

/// The first answer; again with another number where a take is taken up.
struct Welcome {
    static constexpr std::uint8_t kNumber = 0;  ///< First byte of the message.
    std::uint32_t client = 0;
    std::string version;
    std::vector<ScenarioInfo> scenarios;
    std::vector<SchemeInfo> schemes;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(client, version, scenarios, schemes);
    }
};

/// What stands still or is known for good; again whenever it changes.
struct Scene {
    static constexpr std::uint8_t kNumber = 1;  ///< First byte of the message.
    std::uint32_t revision = 0;
    std::uint32_t world = 0;  ///< Rises with each world that begins; ids begin again then, in the same order.
    std::string name;  ///< The scenario's file name without .json; in folders FOLDER/NAME.
    std::string title;
    std::string description;
    std::string credit;
    bool demonstration = false;  ///< There are touches to watch.
    SceneBox box;
    double cell = 0.0;  ///< Edge of a ground cell [m].
    double radius = 0.0;  ///< Of a character's body [m].
    bool ring = false;  ///< The left and the right side of the box are joined.
    std::vector<SceneClip> clips;
    std::vector<SceneObstacle> obstacles;
    std::vector<ScenePatch> patches;
    std::vector<SceneItem> items;
    std::vector<SceneCheckpoint> checkpoints;
    std::vector<SceneArea> areas;
    std::vector<SceneGroup> groups;
    std::vector<SceneParameter> parameters;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(revision, world, name, title, description, credit, demonstration, box, cell, radius, ring,
                clips, obstacles, patches, items, checkpoints, areas, groups, parameters);
    }
};

/// Skeleton and clips that frames refer to by index; before the first frame that does, again whenever they
/// change.
struct Motions {
    static constexpr std::uint8_t kNumber = 2;  ///< First byte of the message.
    std::vector<JointFrame> joints;
    std::vector<ClipFrames> clips;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(joints, clips);
    }
};

/// Topology of a group's mesh; before the first frame of that version.
struct GroupMesh {
    static constexpr std::uint8_t kNumber = 3;  ///< First byte of the message.
    std::uint32_t group = 0;
    std::uint32_t version = 0;
    std::string formation;
    float spacing = 0.0f;  ///< Between neighbouring places [m].
    std::vector<float> rest;  ///< x, y of the vertices before anything deforms them, in the group's axes: it faces x [m].
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> boundary;  ///< Loops: length, then vertices.
    std::vector<std::uint32_t> placeTriangles;  ///< Per place, index of the triangle it lies in.
    std::vector<float> placeWeights;  ///< Per place, of that triangle's first and second vertex; the third's makes 1.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, version, formation, spacing, rest, triangles, boundary, placeTriangles, placeWeights);
    }
};

/// The world after a step.
struct Frame {
    static constexpr std::uint8_t kNumber = 4;  ///< First byte of the message.
    std::uint32_t frame = 0;
    std::uint32_t step = 0;
    double time = 0.0;
    bool playing = false;
    float speed = 0.0f;
    float recordedSeconds = 0.0f;  ///< Negative: not recording.
    bool replaying = false;
    bool demonstrating = false;  ///< Touches that the scenario carries are still to come.
    double touchEcho = 0.0;  ///< Newest page clock among touches that this frame shows; 0 for none.
    std::uint32_t sceneRevision = 0;
    std::vector<std::uint32_t> ids;  ///< Of characters; empty where unchanged since the last frame sent.
    std::vector<std::uint16_t> group;  ///< Index into groups.
    std::vector<std::uint8_t> unitClass;  ///< Of characters, where ids are known; empty: all are of none.
    std::vector<std::uint8_t> radius;  ///< Of characters, where ids are known [cm]; empty: all have the usual one.
    CrowdFrame crowd;
    std::vector<GroupFrame> groups;
    std::vector<MovingFrame> moving;
    std::vector<std::uint8_t> collected;
    std::vector<AreaFrame> areas;
    float stepMs = 0.0f;
    float lagP95 = 0.0f;
    float swapsPerSecond = 0.0f;  ///< Per character.
    std::vector<EventFrame> events;  ///< Since the last frame sent.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(frame, step, time, playing, speed, recordedSeconds, replaying, demonstrating, touchEcho,
                sceneRevision, ids, group, unitClass, radius, crowd, groups, moving, collected, areas, stepMs,
                lagP95, swapsPerSecond, events);
    }
};

/// The values asked for, at most five a second.
struct Overlay {
    static constexpr std::uint8_t kNumber = 5;  ///< First byte of the message.
    OverlayKind kind = OverlayKind::None;
    std::uint32_t character = 0;
    float x = 0.0f;  ///< Centre of the first cell.
    float y = 0.0f;
    float cell = 0.0f;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<float> values;  ///< Row-major from the lower left; not finite: not reached.
    float cost = 0.0f;  ///< From here, for Cost.
    float way = 0.0f;  ///< Length of the path [m].
    float straight = 0.0f;  ///< [m].
    std::vector<float> path;  ///< x, y from the character to its place.
    std::vector<float> gaps;  ///< For Reach: x, y and width [m] of each gap between obstacles that is too narrow for anybody.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, character, x, y, cell, width, height, values, cost, way, straight, path, gaps);
        checkChoice(archive, kind);
    }
};

/// Something to tell the person.
struct Notice {
    static constexpr std::uint8_t kNumber = 6;  ///< First byte of the message.
    NoticeLevel level = NoticeLevel::Info;
    std::string code;
    std::string text;  ///< One sentence.
    bool hasPlace = false;  ///< It concerns a spot on the ground.
    float x = 0.0f;  ///< [m].
    float y = 0.0f;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(level, code, text, hasPlace, x, y);
        checkChoice(archive, level);
    }
};

/// Gives back the time of a Ping.
struct Pong {
    static constexpr std::uint8_t kNumber = 7;  ///< First byte of the message.
    double time = 0.0;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(time);
    }
};

/// The path that was asked for, as soon as the take has been read.
struct TakePath {
    static constexpr std::uint8_t kNumber = 8;  ///< First byte of the message.
    std::uint32_t group = 0;
    std::uint32_t character = 0;
    std::uint32_t spacing = 0;  ///< Steps from one point to the next.
    std::vector<float> points;  ///< x, y from the beginning of the take [m]; the last one stands for what follows.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, character, spacing, points);
    }
};

/// What the client can undo and redo; whenever it changes.
struct EditHistory {
    static constexpr std::uint8_t kNumber = 9;  ///< First byte of the message.
    std::uint32_t undo = 0;  ///< Steps that can be taken back.
    std::string undoLabel;  ///< Of the first of them.
    std::uint32_t redo = 0;
    std::string redoLabel;
    bool edited = false;  ///< The place differs from what was opened.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(undo, undoLabel, redo, redoLabel, edited);
    }
};

/// The answers, as far as group and order are still there.
struct Forecasts {
    static constexpr std::uint8_t kNumber = 10;  ///< First byte of the message.
    std::uint32_t number = 0;
    std::vector<ForecastFrame> answers;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, answers);
    }
};

/// The open take; again whenever it changes, and once with open 0 when it is left.
struct TakeState {
    static constexpr std::uint8_t kNumber = 11;  ///< First byte of the message.
    bool open = false;
    std::string name;  ///< Of its file on the shelf; empty: it lies elsewhere.
    std::string title;
    std::uint32_t steps = 0;
    double stepTime = 0.0;  ///< [s].
    std::uint32_t from = 0;
    std::uint32_t to = 0;  ///< Not beyond steps.
    bool loop = false;
    bool stored = false;  ///< This Muster simulates it otherwise: it plays from its stored frames and cannot be changed.
    std::vector<SpeedPiece> speeds;
    std::vector<CameraKey> camera;
    std::vector<TakeMark> marks;
    std::string beneath;  ///< Title of the world from which it was opened, which LeaveTake brings back; empty: there is none.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(open, name, title, steps, stepTime, from, to, loop, stored, speeds, camera, marks, beneath);
    }
};

/// How far the open take has been read: seeks up to there are quick.
struct TakeReady {
    static constexpr std::uint8_t kNumber = 12;  ///< First byte of the message.
    std::uint32_t steps = 0;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(steps);
    }
};

/// A recording has ended and is kept.
struct TakeKept {
    static constexpr std::uint8_t kNumber = 13;  ///< First byte of the message.
    std::string name;  ///< Of its file on the shelf; empty: kept in memory only.
    double seconds = 0.0;
    std::string scenario;  ///< Its title.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, seconds, scenario);
    }
};

/// Everybody who is connected, in the order in which they came; again whenever that changes.
struct Directors {
    static constexpr std::uint8_t kNumber = 14;  ///< First byte of the message.
    std::vector<DirectorFrame> directors;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(directors);
    }
};

/// What a control scheme shows of what is being done; whenever it changes.
struct Marks {
    static constexpr std::uint8_t kNumber = 15;  ///< First byte of the message.
    std::string scheme;  ///< Empty: the page judges inputs itself.
    std::vector<std::uint32_t> selected;  ///< Ids of characters, ascending.
    std::vector<float> rectangle;  ///< x, y: the box that is being drawn [m].
    std::vector<float> stroke;  ///< x, y: what a finger draws that moves nothing yet.
    std::vector<float> goals;  ///< x, y: where the selected are on their way to.
    std::vector<float> pointers;  ///< x, y: what is down, in the replay of a trial.
    std::string notice;  ///< What the last gesture missed; empty for nothing.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(scheme, selected, rectangle, stroke, goals, pointers, notice);
    }
};

/// The form that waits.
struct StudyForm {
    static constexpr std::uint8_t kNumber = 16;  ///< First byte of the message.
    std::string instrument;
    std::string title;
    std::string text;
    std::string source;  ///< Where verbatim items come from.
    std::string schemeTitle;  ///< The control that it is about; empty for none.
    std::vector<QuestionFrame> questions;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(instrument, title, text, source, schemeTitle, questions);
    }
};

/// Where a run of the study stands; whenever it changes.
struct StudyState {
    static constexpr std::uint8_t kNumber = 17;  ///< First byte of the message.
    StudyStage stage = StudyStage::Form;
    std::string token;  ///< By which a page goes on with the run.
    std::uint32_t run = 0;  ///< Its number in the database; 0 before consent.
    bool test = false;  ///< It tests the page and counts for nothing.
    std::uint32_t trial = 0;  ///< Which one of all waits or goes on, from 1.
    std::uint32_t trials = 0;
    bool practice = false;
    std::string environment;
    std::string environmentText;
    std::string scheme;
    std::string schemeTitle;
    std::string schemeText;
    bool touch = false;  ///< It is for fingers.
    bool mesh = false;  ///< It takes hold of the mesh.
    std::uint32_t items = 0;
    double limit = 0.0;  ///< The trial ends then [s].
    double least = 0.0;  ///< It may be ended from then on [s].
    double mmPerPixel = 0.0;  ///< Of the display; 0 where unknown.
    TrialEnd ended = TrialEnd::None;  ///< How the trial before this one ended.
    double seconds = 0.0;  ///< How long it took [s].
    std::uint32_t collected = 0;  ///< Items collected in it.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(stage, token, run, test, trial, trials, practice, environment, environmentText, scheme,
                schemeTitle, schemeText, touch, mesh, items, limit, least, mmPerPixel, ended, seconds,
                collected);
        checkChoice(archive, stage);
        checkChoice(archive, ended);
    }
};

/// The answers, as far as the group is still there.
struct Places {
    static constexpr std::uint8_t kNumber = 18;  ///< First byte of the message.
    std::uint32_t number = 0;
    std::vector<PlacesFrame> answers;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, answers);
    }
};

/// How long the stages of a step take: means of 60 steps, to clients that watch them.
struct StageTimes {
    static constexpr std::uint8_t kNumber = 19;  ///< First byte of the message.
    std::uint32_t step = 0;  ///< The last of the steps.
    float total = 0.0f;  ///< Of whole steps [ms].
    std::vector<StageFrame> stages;  ///< In the order of the step.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(step, total, stages);
    }
};

/// All who cannot be in their places: neither there, nor on their way, nor held.
struct Standings {
    static constexpr std::uint8_t kNumber = 20;  ///< First byte of the message.
    std::uint32_t number = 0;
    std::vector<StandingFrame> people;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, people);
    }
};

/// What directors have done with the world that all of them share; whenever it changes.
struct SharedWorld {
    static constexpr std::uint8_t kNumber = 21;  ///< First byte of the message.
    std::uint32_t pausedBy = 0;  ///< Who paused it; 0: nobody who is here.
    std::vector<std::uint32_t> builders;  ///< Who is building: the world waits.
    WorldChange change = WorldChange::None;  ///< What was done last.
    std::uint32_t changedBy = 0;  ///< By whom; 0: somebody who has left.
    std::string changer;  ///< Their name.
    std::string before;  ///< Title of the world before, to which anybody can go back; empty: there is none.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(pausedBy, builders, change, changedBy, changer, before);
        checkChoice(archive, change);
    }
};

/// What another director would like; an empty request: nothing any more.
struct Ask {
    static constexpr std::uint8_t kNumber = 22;  ///< First byte of the message.
    std::uint32_t number = 0;
    std::uint32_t client = 0;
    std::string request;  ///< As in AskOthers.
    float seconds = 0.0f;  ///< So long an answer is waited for [s].

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, client, request, seconds);
    }
};

/// The answer to AskOthers.
struct AskAnswered {
    static constexpr std::uint8_t kNumber = 23;  ///< First byte of the message.
    bool allowed = false;
    std::uint32_t client = 0;  ///< Who minds; 0: nobody.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(allowed, client);
    }
};

/// The scenarios, where they differ from those of Welcome.
struct Scenarios {
    static constexpr std::uint8_t kNumber = 24;  ///< First byte of the message.
    std::vector<ScenarioInfo> scenarios;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(scenarios);
    }
};

/// The answer to KeepPlace.
struct PlaceKept {
    static constexpr std::uint8_t kNumber = 25;  ///< First byte of the message.
    std::string title;  ///< What the place is called now; empty: it was not kept.
    std::string name;  ///< As LoadScenario takes it; empty: the server keeps no places.
    std::string problem;  ///< Why it was not kept: one sentence.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(title, name, problem);
    }
};

/// What a sentence does or would do.
struct Said {
    static constexpr std::uint8_t kNumber = 26;  ///< First byte of the message.
    std::uint32_t number = 0;
    SayAct act = SayAct::Complete;
    std::string sentences;  ///< What each group does, a line each; for Look what is there.
    std::string problem;  ///< One sentence: what is not understood, or cannot be; else empty.
    std::vector<SaidCompletion> completions;  ///< For Complete and Preview: how it may go on.
    std::vector<ForecastFrame> forecasts;  ///< For Preview: what would come of the first order of each part.
    std::vector<PlacesFrame> places;  ///< For Preview: where they would stand.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, act, sentences, problem, completions, forecasts, places);
        checkChoice(archive, act);
    }
};

/// Everything that somebody does in the open take, as soon as it has been read; again whenever it changes.
struct TakeTracks {
    static constexpr std::uint8_t kNumber = 27;  ///< First byte of the message.
    std::uint32_t revision = 0;
    std::vector<TakeTrack> tracks;  ///< In the order of their ids.
    std::vector<TakeBlock> blocks;  ///< In the order in which they begin.
    std::string undo;  ///< What the last change was; empty: there is none to take back.
    std::string redo;  ///< What can be done again.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(revision, tracks, blocks, undo, redo);
    }
};

/// The edits of people in the open take; again whenever they change.
struct TakeEdits {
    static constexpr std::uint8_t kNumber = 28;  ///< First byte of the message.
    std::vector<PeopleEdit> edits;
    std::vector<EditFinding> findings;  ///< As soon as the take has been read.
    bool checked = false;  ///< The findings are complete.
    std::vector<std::string> clips;  ///< Names of the clips that can be chosen.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(edits, findings, checked, clips);
    }
};

/// Any message of the server; the index is its number.
using ServerMessage = std::variant<
    Welcome, Scene, Motions, GroupMesh, Frame, Overlay, Notice, Pong, TakePath, EditHistory, Forecasts,
    TakeState, TakeReady, TakeKept, Directors, Marks, StudyForm, StudyState, Places, StageTimes, Standings,
    SharedWorld, Ask, AskAnswered, Scenarios, PlaceKept, Said, TakeTracks, TakeEdits>;

}  // namespace muster::protocol
