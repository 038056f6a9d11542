#include "studio/session/history/place_edit.h"

#include <algorithm>
#include <utility>

namespace muster {
namespace {

/// The same, and what takes them back is of one kind too.
bool replaces(const PlaceChange& later, const PlaceChange& earlier) {
    return doesTheSame(later, earlier) && later.undo.index() == earlier.undo.index() && !adds(later.undo);
}

/// Makes a thing as it was changed right after it was made. False where the later change does something else.
bool addsChanged(PlaceChange& earlier, const PlaceChange& later) {
    if (!(later.thing == earlier.thing) || later.thing.id == 0) return false;
    if (auto* add = std::get_if<AddObstacle>(&earlier.redo))
        if (const auto* change = std::get_if<ChangeObstacle>(&later.redo))
            return add->obstacle = change->obstacle, true;
    if (auto* add = std::get_if<AddPatch>(&earlier.redo))
        if (const auto* change = std::get_if<ChangePatch>(&later.redo))
            return add->patch = change->patch, true;
    if (auto* add = std::get_if<AddItem>(&earlier.redo))
        if (const auto* change = std::get_if<ChangeItem>(&later.redo)) return add->item = change->item, true;
    if (auto* add = std::get_if<AddCheckpoint>(&earlier.redo))
        if (const auto* change = std::get_if<ChangeCheckpoint>(&later.redo))
            return add->checkpoint = change->checkpoint, add->group = change->group, true;
    if (auto* add = std::get_if<PutArea>(&earlier.redo); add != nullptr && !add->id)
        if (const auto* change = std::get_if<PutArea>(&later.redo))
            return add->area = change->area, add->group = change->group, true;
    return false;
}

bool equal(const FormationCheckpointDef& a, const FormationCheckpointDef& b) {
    const FormationDef &f = a.formation, &g = b.formation;
    return a.position == b.position && a.radius == b.radius && a.once == b.once && a.trigger == b.trigger &&
           a.share == b.share && f.kind == g.kind && f.kind != FormationKind::Outline &&
           f.spacing == g.spacing && f.opening == g.opening && f.points == g.points && f.files == g.files;
}

/// True where the thing is as it was before: a drag was given up, or led back.
bool leadsBack(const PlaceChange& change) {
    if (const auto* to = std::get_if<ChangeObstacle>(&change.redo))
        return to->obstacle == std::get<ChangeObstacle>(change.undo).obstacle;
    if (const auto* to = std::get_if<ChangePatch>(&change.redo))
        return to->patch == std::get<ChangePatch>(change.undo).patch;
    if (const auto* to = std::get_if<ChangeItem>(&change.redo)) {
        const ItemDef& from = std::get<ChangeItem>(change.undo).item;
        return to->item.position == from.position && to->item.radius == from.radius;
    }
    if (const auto* to = std::get_if<ChangeCheckpoint>(&change.redo)) {
        const auto& from = std::get<ChangeCheckpoint>(change.undo);
        return to->group == from.group && equal(to->checkpoint, from.checkpoint);
    }
    if (const auto* to = std::get_if<PlaceGroup>(&change.redo)) {
        const auto& from = std::get<PlaceGroup>(change.undo);
        return to->position == from.position && to->angle == from.angle;
    }
    if (const auto* to = std::get_if<PutArea>(&change.redo); to != nullptr && to->id) {
        const auto& from = std::get<PutArea>(change.undo);
        return to->area == from.area && to->group == from.group;
    }
    return false;
}

}  // namespace

bool doesTheSame(const PlaceChange& later, const PlaceChange& earlier) {
    if (!(later.thing == earlier.thing) || later.redo.index() != earlier.redo.index() || adds(later.redo))
        return false;
    if (later.thing.id != 0) return true;
    if (const auto* set = std::get_if<SetBodies>(&later.redo))
        return set->ids == std::get<SetBodies>(earlier.redo).ids;
    if (const auto* set = std::get_if<SetParameter>(&later.redo))
        return set->name == std::get<SetParameter>(earlier.redo).name;
    return false;
}

bool overtakes(const std::vector<PlaceChange>& later, const std::vector<PlaceChange>& waiting) {
    return std::equal(later.begin(), later.end(), waiting.begin(), waiting.end(), doesTheSame);
}

void join(PlaceStep& step, std::vector<PlaceChange> later) {
    std::vector<PlaceChange>& before = step.changes;
    for (PlaceChange& change : later) {
        if (std::any_of(before.begin(), before.end(),
                        [&](PlaceChange& earlier) { return addsChanged(earlier, change); }))
            continue;
        const auto same = std::find_if(before.begin(), before.end(),
                                       [&](const PlaceChange& earlier) { return replaces(change, earlier); });
        if (same == before.end())
            before.push_back(std::move(change));
        else if (same->redo = std::move(change.redo); leadsBack(*same))
            before.erase(same);
    }
}

}  // namespace muster
