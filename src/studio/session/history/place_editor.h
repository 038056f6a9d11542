// What directors do, kept with what takes it back: edits of the place, which are carried out step by step,
// and acts that direct groups.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "muster/command.h"
#include "muster/world.h"
#include "studio/session/history/place.h"
#include "studio/session/history/place_edit.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// The place, the edits that wait for the next step, and each director's history.
class PlaceEditor {
public:
    /// A step of a history whose commands were given to the world.
    struct Given {
        std::uint32_t client = 0;
        PlaceStep step;
        std::vector<std::uint32_t> sequences;  ///< Of the commands, one for each change.
        /// Follow: it belongs to the step before, which needed to know ids first.
        enum class Way : std::uint8_t { Do, Undo, Redo, Follow } way = Way::Do;
        std::uint32_t arrival = 0;   ///< Rises with everything that directors ask for.
        CrowdCommands crowdChanges;  ///< Those of its changes of the crowd; they come after the changes.
        std::vector<std::uint32_t> changeSequences;  ///< Of these commands.
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
    /// Those that can be taken back become one step of the history.
    void acted(std::uint32_t client, const std::vector<CommandBody>& bodies, std::uint32_t firstSequence,
               const World& world);
    /// True where the step that is made may change a history.
    bool acts() const { return !acts_.empty(); }
    /// True where what the director takes back, or does again, waits for the next step.
    bool undoWaits(std::uint32_t client) const;
    /// True where an edit waits.
    bool waits() const { return !waiting_.empty(); }
    std::size_t waiting() const { return waiting_.size(); }
    /// The edits that can be carried out together now, those that name a thing again wait on. The caller
    /// gives their `redo` commands to the world and adds the numbers; or drops the edit.
    std::vector<Given> due(const World& world);
    /// The world has made its step: what it accepted goes into the place and the histories.
    void carriedOut(std::vector<Given> given, const World& world);
    /// What the director can take back and do again, once all that waits is carried out.
    protocol::EditHistory state(std::uint32_t client) const;
    /// Rises with every change of what state() or the place tell.
    std::uint32_t revision() const { return revision_; }

private:
    struct Waiting {
        std::uint32_t client = 0;
        Given::Way way = Given::Way::Do;
        PlaceStep step;          // For Do: its changes have no `undo` yet.
        bool fetched = false;    // It is out of the history.
        bool behindAct = false;  // Acts of the director in the step that is made come first.
        std::uint32_t arrival = 0;
        CrowdCommands commands;  // For Follow.
    };
    /// The steps of a history, once all that waits is carried out.
    struct Foreseen {
        std::vector<const PlaceStep*> done, undone;
    };
    struct History {
        std::deque<PlaceStep> done, undone;
    };

    Status wait(Waiting wanted);
    Foreseen foresee(std::uint32_t client) const;
    void complete(PlaceStep& step, const World& world) const;
    bool fetch(Waiting& waiting);
    bool ready(Waiting& waiting, Given& given, const World& world);
    bool keepsWaiting(const Waiting& waiting, const std::vector<Thing>& touched) const;
    void keep(Given& given);
    void renameEverywhere(Thing from, std::uint32_t to);
    std::vector<std::uint32_t> goneThings(ThingKind kind, const std::vector<std::uint32_t>& ids);
    template <class Change>
    void eachStep(Change change) {
        for (auto& [client, history] : histories_) {
            for (PlaceStep& step : history.done) change(step);
            for (PlaceStep& step : history.undone) change(step);
        }
        for (Waiting& waiting : waiting_) change(waiting.step);
    }

    // Acts (place_editor_acts.cpp).
    void addCrowdChange(Given& act, const CommandBody& body, std::uint32_t sequence, const World& world);
    void addQueueChange(Given& act, GroupId group, const CommandBody& body, std::uint32_t sequence,
                        const World& world);
    PlaceChange actChange(const Given& act, const CommandBody& body, const World& world) const;
    void nameOrders(std::vector<Given>& given, const World& world);
    void finishCrowdChanges(Given& one, std::vector<Event>& added, const World& world);
    void follow(const Given& one, const DivisionChange& crowdChange, const World& world);
    bool isRefused(const Given& one, std::uint32_t sequence, const World& world) const;
    bool joinsAct(const PlaceStep& last, const PlaceStep& next) const;

    Place place_;
    std::map<std::uint32_t, History> histories_;  // By client number.
    std::deque<Waiting> waiting_;
    std::vector<std::uint32_t> highest_;     // Ids before the step, by ThingKind.
    std::vector<Given> acts_;                // Of the step that is about to be made.
    std::map<GroupId, QueueState> planned_;  // Queues as these acts leave them.
    std::uint32_t lastArrival_ = 0;
    std::uint32_t lastGone_ = kGoneThings;
    std::uint32_t lastUnnamed_ = kUnnamedOrders;
    std::uint32_t revision_ = 1;
};

/// True where the command can be taken back. Fingers cannot: what they move is moved.
bool canTakeBack(const CommandBody& body);
/// What the commands of one message do: "Move", "Change shape".
std::string actLabel(std::span<const CommandBody> bodies, const World& world);
/// True for what a slider sends, again and again.
bool isContinuous(const CommandBody& body);

}  // namespace muster
