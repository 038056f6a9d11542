// What directors do, kept with the definition before and after it: edits of the place, which are carried out
// step by step, and acts that direct groups.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "muster/command.h"
#include "muster/world.h"
#include "studio/session/history/commands_between.h"
#include "studio/session/history/drags.h"
#include "studio/session/history/place.h"
#include "studio/session/history/step_births.h"
#include "studio/session/history/step_record.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// What one step of a director's history does.
struct HistoryStep {
    std::string label;            ///< For people: "Move wall".
    std::uint32_t gesture = 0;    ///< Edits with the same number are one step; 0: alone.
    std::uint32_t sentence = 0;   ///< What is done for one sentence is one step; 0: for none.
    bool directs = false;         ///< It directs groups, and leaves the place as it is.
    std::uint32_t step = 0;       ///< Of the world, when it was last done.
    std::uint32_t arrival = 0;    ///< Rises with everything that is done, by whomever.
    std::vector<PartKey> slides;  ///< What it sets, where a slider may set it again and again.
    Difference difference;
    std::size_t bytes = 0;  ///< About how large it is in a history.
};

/// The place, the edits that wait for the next step, and each director's history.
class PlaceEditor {
public:
    /// A step of a history whose commands were given to the world.
    struct Given {
        std::uint32_t client = 0;
        HistoryStep step;
        LeadingBatch batch;
        std::vector<Concern> concerns;         ///< Of each command, where it is done for the first time.
        std::vector<std::uint32_t> sequences;  ///< Of the commands; of the message that ends a drag.
        /// Follow: it belongs to the step before, which needed to know ids first.
        enum class Way : std::uint8_t { Do, Undo, Redo, Follow } way = Way::Do;
        std::uint32_t arrival = 0;  ///< Rises with everything that directors ask for.
        std::uint32_t drag = 0;     ///< Number of the drag to which it belongs; 0 for none.
        bool endsDrag = false;      ///< It is the whole of a drag.
    };

    /// Another world began: all histories end.
    void begin(const WorldDef& def);
    /// The same place begins again in a world whose things have the ids 1, 2, 3... in the order of `before`.
    void beginAgain(const PlaceDefinition& before);
    /// A director has left.
    void forget(std::uint32_t client);
    /// Their numbers have changed: histories end, the place stays.
    void forgetAll() { histories_.clear(); }

    const Place& place() const { return place_; }
    /// An edit for the next step. It takes the place of one that still waits where that is of the same
    /// gesture and does the same to the same things. Fails where it holds what is no edit, or names a thing
    /// twice.
    Status want(std::uint32_t client, std::string label, std::uint32_t gesture,
                std::vector<CommandBody> bodies);
    /// Takes back the director's last step, or does it again, in the next step. Fails where there is none.
    Status wantUndo(std::uint32_t client, bool redo);
    /// True where what would be taken back, or done again, directs groups.
    bool nextDirects(std::uint32_t client, bool redo) const;
    /// These commands of a director were given to the world for the next step, beginning with that number.
    /// Together they become one step of the history; touches become one with all of their drag.
    void acted(std::uint32_t client, const std::vector<CommandBody>& bodies, std::uint32_t firstSequence,
               const World& world);
    /// A number for what comes of a sentence.
    std::uint32_t nextSentence() { return ++lastSentence_; }
    /// What is acted from now on comes of that sentence; 0: of none.
    void speaks(std::uint32_t sentence, const std::string& label) { sentence_ = sentence, said_ = label; }
    /// True where the step that is made may change a history.
    bool acts() const { return births_.begun(); }
    /// True where what the director takes back, or does again, waits for the next step.
    bool undoWaits(std::uint32_t client) const;
    /// True where an edit waits.
    bool waits() const { return !waiting_.empty(); }
    std::size_t waiting() const { return waiting_.size(); }
    /// The edits that can be carried out together now, those that name a thing again wait on. The caller
    /// gives the commands to the world and adds the numbers; or drops the edit.
    std::vector<Given> due(const World& world);
    /// The world has made its step: what it accepted goes into the place and the histories.
    void carriedOut(std::vector<Given> given, const World& world);
    /// What the director can take back and do again, once all that waits is carried out.
    protocol::EditHistory state(std::uint32_t client) const;
    /// Rises with every change of what state() or the place tell.
    std::uint32_t revision() const { return revision_; }
    /// What state() tells has changed.
    void touch(std::uint32_t above) { revision_ = std::max(revision_, above) + 1; }

private:
    struct Waiting {
        std::uint32_t client = 0;
        Given::Way way = Given::Way::Do;
        HistoryStep step;
        std::vector<CommandBody> bodies;  // For Do.
        std::vector<FreshGroup> fresh;    // For Follow.
        bool fetched = false;             // It is out of the history.
        bool behindAct = false;           // Acts of the director in the step that is made come first.
        std::uint32_t arrival = 0;
    };
    /// The steps of a history, once all that waits is carried out.
    struct Foreseen {
        std::vector<const HistoryStep*> done, undone;
    };
    struct History {
        std::deque<HistoryStep> done, undone;
    };

    Status wait(Waiting wanted);
    Foreseen foresee(std::uint32_t client) const;
    bool fetch(Waiting& waiting);
    bool ready(Waiting& waiting, Given& given, const World& world);
    void takeOutOfOthers(std::uint32_t client, HistoryStep& step);
    std::vector<Subject> subjectsOf(const Waiting& waiting);
    std::vector<Subject> subjectsOf(const std::vector<CommandBody>& bodies,
                                    const std::vector<Concern>& concerns);
    void addAct(std::uint32_t client, std::vector<CommandBody> bodies, std::vector<std::uint32_t> sequences,
                std::uint32_t drag, const World& world);
    void endDrag(std::uint32_t client, std::uint32_t drag, std::uint32_t sequence, const World& world);

    // What a step has brought (place_editor_steps.cpp).
    void finish(Given& one, const World& world);
    void finishAct(Given& one, const World& world);
    void finishLead(Given& one, const World& world);
    std::vector<std::size_t> accepted(const Given& one, const World& world) const;
    std::vector<FreshGroup> bindBirths(const Given& one, const std::vector<std::size_t>& accepted,
                                       const World& world);
    void applyToPlace(const Given& one, const std::vector<std::size_t>& accepted, const World& world);
    void keep(Given& given);

    Place place_;
    Names names_;
    std::map<std::uint32_t, History> histories_;  // By client number.
    std::deque<Waiting> waiting_;
    std::vector<Given> acts_;  // Of the step that is about to be made.
    StepRecord record_;        // What these change.
    StepBirths births_;
    Drags drags_;
    std::uint32_t lastArrival_ = 0;
    std::uint32_t lastSentence_ = 0, sentence_ = 0;
    std::string said_;  // The sentence.
    std::uint32_t revision_ = 1;
};

/// True where the command can be taken back by itself. Fingers cannot: what they drag can, as a whole.
bool canTakeBack(const CommandBody& body);
/// What the commands of one message do: "Move", "Change shape".
std::string actLabel(std::span<const CommandBody> bodies, const World& world);
/// True for what a slider sends, again and again.
bool isContinuous(const CommandBody& body);
/// True where both are of one gesture, or of one slider, and are taken back together.
bool joins(const HistoryStep& last, const HistoryStep& next);

}  // namespace muster
