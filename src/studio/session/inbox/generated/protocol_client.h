// Made by schema/generate.mjs from schema/messages.txt: change these, not this file.
// clang-format off
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "studio/session/inbox/generated/protocol_parts.h"

namespace muster::protocol {

/// The first message of a client.
struct Hello {
    static constexpr std::uint8_t kNumber = 0;  ///< First byte of the message.
    std::string name;  ///< Shown to others.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name);
    }
};

/// Fingers, in the order they were seen.
struct Touches {
    static constexpr std::uint8_t kNumber = 1;  ///< First byte of the message.
    std::vector<TouchEvent> events;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(events);
    }
};

/// Play, pause, one step, from the start, from the start with the touches that the scenario carries, back to
/// the world before, or to the one from which the take was opened.
struct Playback {
    static constexpr std::uint8_t kNumber = 2;  ///< First byte of the message.
    PlaybackAction action = PlaybackAction::Play;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(action);
        checkChoice(archive, action);
    }
};

/// How much faster than real time.
struct SetSpeed {
    static constexpr std::uint8_t kNumber = 3;  ///< First byte of the message.
    float factor = 0.0f;  ///< 0.1 to 8.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(factor);
    }
};

/// Another world for everybody.
struct LoadScenario {
    static constexpr std::uint8_t kNumber = 4;  ///< First byte of the message.
    std::string name;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name);
    }
};

/// Starts or stops the recording clock.
struct Record {
    static constexpr std::uint8_t kNumber = 5;  ///< First byte of the message.
    bool on = false;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(on);
    }
};

/// What to colour the ground by.
struct SetOverlay {
    static constexpr std::uint8_t kNumber = 6;  ///< First byte of the message.
    OverlayKind kind = OverlayKind::None;
    std::uint32_t character = 0;  ///< Id, for Cost.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, character);
        checkChoice(archive, kind);
    }
};

/// Orders and changes of units, controls, counts and parameters.
struct Commands {
    static constexpr std::uint8_t kNumber = 7;  ///< First byte of the message.
    std::vector<std::uint8_t> commands;  ///< In their order. The time of an AddControl is that of the page's clock.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(commands);
    }
};

/// Where this client looks: the characters nearest to it come with whole poses.
struct Attend {
    static constexpr std::uint8_t kNumber = 8;  ///< First byte of the message.
    float x = 0.0f;  ///< [m].
    float y = 0.0f;
    std::uint32_t count = 0;  ///< How many at most; 0 for none.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(x, y, count);
    }
};

/// Frame drawn; the next may come.
struct FrameAck {
    static constexpr std::uint8_t kNumber = 9;  ///< First byte of the message.
    std::uint32_t frame = 0;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(frame);
    }
};

/// Asks for a Pong.
struct Ping {
    static constexpr std::uint8_t kNumber = 10;  ///< First byte of the message.
    double time = 0.0;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(time);
    }
};

/// Goes to a moment of the open take; playing goes on from there.
struct Seek {
    static constexpr std::uint8_t kNumber = 11;  ///< First byte of the message.
    std::uint32_t step = 0;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(step);
    }
};

/// Directs from the present moment of the open take on: a new take with its beginning.
struct TakeAgain {
    static constexpr std::uint8_t kNumber = 12;  ///< First byte of the message.
    bool keep = false;  ///< What was recorded later goes on beneath what is directed now.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(keep);
    }
};

/// Another name, part or speed of the open take; kept with its file.
struct EditTake {
    static constexpr std::uint8_t kNumber = 13;  ///< First byte of the message.
    std::string title;
    std::uint32_t from = 0;  ///< First step of the part that is shown.
    std::uint32_t to = 0;  ///< Its last step; the largest number: the end.
    bool loop = false;  ///< Plays over and over; not kept.
    std::vector<SpeedPiece> speeds;
    std::vector<CameraKey> camera;  ///< Of its film, ascending.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(title, from, to, loop, speeds, camera);
    }
};

/// Would these orders arrive, by which way, when? Nothing changes.
struct AskForecasts {
    static constexpr std::uint8_t kNumber = 14;  ///< First byte of the message.
    std::uint32_t number = 0;  ///< Comes back with the answer.
    std::vector<ForecastAsk> asks;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, asks);
    }
};

/// How the sender is called from now on.
struct SetName {
    static constexpr std::uint8_t kNumber = 15;  ///< First byte of the message.
    std::string name;  ///< At most 40 characters count; empty: a number.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name);
    }
};

/// What a director may direct: one group and its parts, or everything.
struct GiveGroup {
    static constexpr std::uint8_t kNumber = 16;  ///< First byte of the message.
    std::uint32_t client = 0;
    std::uint32_t group = 0;  ///< 0: everything.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(client, group);
    }
};

/// Inputs shall be judged by this control scheme; empty: by the page itself.
struct SetScheme {
    static constexpr std::uint8_t kNumber = 17;  ///< First byte of the message.
    std::string name;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name);
    }
};

/// How the ground is seen from now on.
struct SetView {
    static constexpr std::uint8_t kNumber = 18;  ///< First byte of the message.
    std::vector<double> matrix;  ///< Nine numbers by rows: from (x, y, 1) on the ground [m] to homogeneous pixels.
    double width = 0.0;  ///< Of the view [px].
    double height = 0.0;
    double mmPerPixel = 0.0;  ///< Of the display.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(matrix, width, height, mmPerPixel);
    }
};

/// Raw inputs, in the order they were seen, for the client's control scheme.
struct Inputs {
    static constexpr std::uint8_t kNumber = 19;  ///< First byte of the message.
    std::vector<RawInput> events;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(events);
    }
};

/// Begins a run of the study, or goes on with one.
struct EnterStudy {
    static constexpr std::uint8_t kNumber = 20;  ///< First byte of the message.
    std::string token;  ///< As StudyState gave it; empty for a new run.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(token);
    }
};

/// The answers to the form that waits.
struct AnswerForm {
    static constexpr std::uint8_t kNumber = 21;  ///< First byte of the message.
    std::string instrument;
    std::vector<AnswerFrame> answers;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(instrument, answers);
    }
};

/// Where a group or a character goes in the open take.
struct AskPath {
    static constexpr std::uint8_t kNumber = 22;  ///< First byte of the message.
    std::uint32_t group = 0;  ///< Id.
    std::uint32_t character = 0;  ///< Id; 0: the group as a whole.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, character);
    }
};

/// Moves that path, and simulates everything again as another take, which opens.
struct BendPath {
    static constexpr std::uint8_t kNumber = 23;  ///< First byte of the message.
    std::uint32_t group = 0;
    std::uint32_t character = 0;
    std::uint32_t step = 0;  ///< Where the path is taken hold of.
    double dx = 0.0;  ///< How far it is moved there [m].
    double dy = 0.0;
    double seconds = 0.0;  ///< So long before and after it moves along, ever less: 0.5 to 60.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, character, step, dx, dy, seconds);
    }
};

/// A change of the place that is being made, which its director can undo.
struct Edit {
    static constexpr std::uint8_t kNumber = 24;  ///< First byte of the message.
    std::string label;  ///< What was done, for the undo: 'Move wall'; at most 80 bytes.
    std::uint32_t gesture = 0;  ///< Edits of one director in a row with the same number are undone together; 0: alone.
    std::vector<std::uint8_t> commands;  ///< Each thing at most once.
    std::vector<GroupBodyEdit> bodies;  ///< Instead of commands: each group at most once.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(label, gesture, commands, bodies);
    }
};

/// Takes back the last thing that the sender did to the place or the crowd, or does it again, by commands at
/// the present step.
struct UndoEdit {
    static constexpr std::uint8_t kNumber = 25;  ///< First byte of the message.
    bool redo = false;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(redo);
    }
};

/// What a person wants in a run of the study.
struct DoInStudy {
    static constexpr std::uint8_t kNumber = 26;  ///< First byte of the message.
    StudyAct act = StudyAct::Start;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(act);
        checkChoice(archive, act);
    }
};

/// Where would everybody stand, and which of these places could they not reach? Nothing changes.
struct AskPlaces {
    static constexpr std::uint8_t kNumber = 27;  ///< First byte of the message.
    std::uint32_t number = 0;  ///< Comes back with the answer.
    std::vector<PlacesAsk> asks;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, asks);
    }
};

/// Whether the sender wants to know how long the stages of steps take.
struct WatchStages {
    static constexpr std::uint8_t kNumber = 28;  ///< First byte of the message.
    bool on = false;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(on);
    }
};

/// Who cannot be in its place, and why?
struct AskStandings {
    static constexpr std::uint8_t kNumber = 29;  ///< First byte of the message.
    std::uint32_t number = 0;  ///< Comes back with the answer.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number);
    }
};

/// Would the others mind? Who does not answer in time agrees.
struct AskOthers {
    static constexpr std::uint8_t kNumber = 30;  ///< First byte of the message.
    std::string request;  ///< What the sender would like: 'open Market square'; at most 100 letters count. Empty: never mind.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(request);
    }
};

/// Whether the sender minds.
struct AnswerAsk {
    static constexpr std::uint8_t kNumber = 31;  ///< First byte of the message.
    std::uint32_t number = 0;  ///< Of the question.
    bool allow = false;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, allow);
    }
};

/// Begins or ends building: the world waits meanwhile, and goes on if it went on before.
struct Build {
    static constexpr std::uint8_t kNumber = 32;  ///< First byte of the message.
    bool on = false;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(on);
    }
};

/// Keeps the place under that name, which it has from now on.
struct KeepPlace {
    static constexpr std::uint8_t kNumber = 33;  ///< First byte of the message.
    std::string title;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(title);
    }
};

/// A sentence that directs: what would it do, or do it; how may it go on; or what is there to see?
struct Say {
    static constexpr std::uint8_t kNumber = 34;  ///< First byte of the message.
    std::uint32_t number = 0;  ///< Comes back with the answer.
    SayAct act = SayAct::Complete;
    std::string text;  ///< At most 1,000 bytes; not read for Look.
    std::vector<std::uint32_t> chosen;  ///< Ids of the groups that it is about where it names none.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(number, act, text, chosen);
        checkChoice(archive, act);
    }
};

/// Whether the sender wants to know the tracks of the open take.
struct WatchTracks {
    static constexpr std::uint8_t kNumber = 35;  ///< First byte of the message.
    bool on = false;

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(on);
    }
};

/// Changes a block of the open take and simulates everything again as another take, which opens; or takes
/// such a change back.
struct EditTrack {
    static constexpr std::uint8_t kNumber = 36;  ///< First byte of the message.
    std::uint32_t revision = 0;  ///< Of the TakeTracks that the block is from.
    TrackEdit edit = TrackEdit::Move;
    std::uint32_t block = 0;  ///< Its id.
    std::uint32_t step = 0;  ///< Where it begins then; for Stretch, where it ends.
    std::uint32_t group = 0;  ///< For Copy: whose the copy is; 0: the same group's.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(revision, edit, block, step, group);
        checkChoice(archive, edit);
    }
};

/// How these people of the open take are shown from now on; each of them leaves the edit that it had.
/// Everybody else keeps everything.
struct EditPeople {
    static constexpr std::uint8_t kNumber = 37;  ///< First byte of the message.
    PeopleEdit edit;  ///< Without pins, clock, clips and looks: as recorded.
    std::uint32_t gesture = 0;  ///< Edits in a row with the same number are undone together; 0: alone.
    bool kept = false;  ///< The hand has lifted: it is kept with the take's file.
    bool clear = false;  ///< Pins are moved out of obstacles.

    /// Lets an archive read or write the fields.
    template <class Archive>
    void visit(Archive& archive) {
        archive(edit, gesture, kept, clear);
    }
};

/// Any message of the page; the index is its number.
using ClientMessage = std::variant<
    Hello, Touches, Playback, SetSpeed, LoadScenario, Record, SetOverlay, Commands, Attend, FrameAck, Ping,
    Seek, TakeAgain, EditTake, AskForecasts, SetName, GiveGroup, SetScheme, SetView, Inputs, EnterStudy,
    AnswerForm, AskPath, BendPath, Edit, UndoEdit, DoInStudy, AskPlaces, WatchStages, AskStandings, AskOthers,
    AnswerAsk, Build, KeepPlace, Say, WatchTracks, EditTrack, EditPeople>;

}  // namespace muster::protocol
