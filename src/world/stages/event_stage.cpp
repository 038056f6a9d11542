#include "world/stages/event_stage.h"

#include "world/state/group_edits.h"

namespace muster {
namespace {

void collectItems(WorldState& state, std::vector<Event>& events) {
    const Characters& characters = state.characters;
    const std::vector<ItemDef>& items = state.items;
    for (std::size_t k = 0; k < items.size(); ++k) {
        if (state.collected[k] != 0) continue;
        for (std::size_t i = 0; i < characters.size(); ++i) {
            if (distance(characters.position[i], items[k].position) > items[k].radius) continue;
            state.collected[k] = 1;
            events.push_back(
                {EventKind::Collect, characters.id[i], static_cast<std::uint32_t>(k), items[k].position});
            break;
        }
    }
}

void meetCheckpoints(WorldState& state, std::vector<Event>& events) {
    const std::vector<FormationCheckpointDef>& checkpoints = state.checkpoints;
    for (std::size_t c = 0; c < checkpoints.size(); ++c) {
        const FormationCheckpointDef& checkpoint = checkpoints[c];
        for (std::size_t g = 0; g < state.groups.size(); ++g) {
            Group& group = state.groups[g];
            if (state.checkpointGroups[c] && state.checkpointGroups[c] != group.id) continue;
            std::uint8_t& flags = state.checkpointState[g * checkpoints.size() + c];
            const bool inside = distance(group.mesh.pose().position, checkpoint.position) <=
                                checkpoint.radius;
            const bool comes = inside && (flags & 1) == 0 && !(checkpoint.once && (flags & 2) != 0);
            flags = static_cast<std::uint8_t>((flags & 2) | (inside ? 1 : 0));
            if (!comes) continue;
            flags |= 2;
            if (changeFormation(state, group, checkpoint.formation, group.def.count).ok())
                events.push_back({EventKind::FormationChange, group.id.value, static_cast<std::uint32_t>(c),
                                  checkpoint.position});
        }
    }
}

// Places wait for slow ground themselves, so that the lag counts from their goals.
void measureLag(WorldState& state) {
    const Characters& characters = state.characters;
    for (Group& group : state.groups) {
        double sum = 0.0;
        std::int32_t matched = 0;
        for (const std::int32_t i : group.members) {
            if (characters.place[i] < 0) continue;
            sum += distance(characters.position[i], group.places.reachableTargets()[characters.place[i]]);
            ++matched;
        }
        group.meanLag = matched > 0 ? sum / matched : 0.0;
    }
}

}  // namespace

void raiseEvents(WorldState& state, std::span<const MotionEvent> changes, std::vector<Event>& events) {
    const Characters& characters = state.characters;
    for (const MotionEvent& change : changes) {
        // The first kinds of both lists correspond one to one.
        const auto kind = static_cast<EventKind>(change.change);
        const std::int32_t i = change.character;
        events.push_back({kind, characters.id[i], change.value, characters.position[i]});
    }
    collectItems(state, events);
    meetCheckpoints(state, events);
    measureLag(state);
}

}  // namespace muster
