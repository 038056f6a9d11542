// Edits of the place by directors: carried out step by step, kept with what takes them back.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "session/place.h"
#include "session/place_edit.h"
#include "session/protocol.h"

namespace muster {

/// The place, the edits that wait for the next step, and each director's history.
class PlaceEditor {
public:
    /// An edit whose commands were given to the world.
    struct Given {
        std::uint32_t client = 0;
        PlaceStep step;
        std::vector<std::uint32_t> sequences;  ///< Of the commands, one for each change.
        enum class Way : std::uint8_t { Do, Undo, Redo } way = Way::Do;
    };

    /// Another world began: all histories end.
    void begin(const WorldDef& def);
    /// The same place begins again in a world whose things have the ids 1, 2, 3... in the order of `before`.
    void beginAgain(const PlaceDefinition& before);
    /// A director has left.
    void forget(std::uint32_t client) { histories_.erase(client); }
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
    /// True where an edit waits.
    bool waits() const { return !waiting_.empty(); }
    std::size_t waiting() const { return waiting_.size(); }
    /// The edits that can be carried out together now, those that name a thing again wait on. The caller
    /// gives their `redo` commands to the world and adds the numbers; or drops the edit.
    std::vector<Given> due(const World& world);
    /// The world has made its step: what it accepted goes into the place and the histories.
    void carriedOut(std::vector<Given> given, const World& world);
    /// What the director can take back and do again.
    protocol::EditHistory state(std::uint32_t client) const;
    /// Rises with every change of what state() or the place tell.
    std::uint32_t revision() const { return revision_; }

private:
    struct Waiting {
        std::uint32_t client = 0;
        Given::Way way = Given::Way::Do;
        PlaceStep step;        // For Do: its changes have no `undo` yet.
        bool fetched = false;  // It is out of the history.
    };
    struct History {
        std::deque<PlaceStep> done, undone;
    };

    Status wait(Waiting wanted);
    void complete(PlaceStep& step, const World& world) const;
    bool fetch(Waiting& waiting);
    void keep(Given& given);
    void renameEverywhere(Thing from, std::uint32_t to);

    Place place_;
    std::map<std::uint32_t, History> histories_;  // By client number.
    std::deque<Waiting> waiting_;
    std::vector<std::uint32_t> highest_;  // Ids before the step, by ThingKind.
    std::uint32_t revision_ = 1;
};

}  // namespace muster
