#include "studio/session/history/place_editor.h"

#include <algorithm>

#include "engine/world/inspect.h"
#include "studio/session/inbox/generated/command_traits.h"

namespace muster {
namespace {

template <std::size_t N, class Value>
const char* labelOf(const std::array<const char*, N>& labels, Value value) {
    return labels[static_cast<std::size_t>(value)];
}

const char* conductLabel(const ChangeGroup& change, const World& world) {
    const auto g = inspect::indexOfGroup(world, change.group);
    if (!g) return "Conduct";
    const Conduct &is = *change.conduct, &was = inspect::groupDef(world, *g).conduct;
    if (is.cohesion != was.cohesion) return "Cohesion";
    if (is.squeeze != was.squeeze) return "Squeeze";
    if (is.stance != was.stance) return "Stance";
    if (is.avoids != was.avoids) return "Give way";
    return "Conduct";
}

const char* kindLabel(const CommandBody& body) {
    const char* const label = traitsOf(body).label;
    return *label != '\0' ? label : nullptr;
}

/// The labels of commands that depend on what they say; others have that of their kind.
struct Label {
    const World& world;

    const char* operator()(const GiveOrder& give) const { return labelOf(kOrderKindLabels, give.order.kind); }
    const char* operator()(const EditQueue& edit) const { return labelOf(kQueueEditLabels, edit.edit); }
    const char* operator()(const ChangeGroup& change) const {
        return change.conduct && !change.formation && !change.count ? conductLabel(change, world)
                                                                    : kindLabel(change);
    }
    const char* operator()(const TransferCharacters& transfer) const {
        return transfer.group ? kindLabel(transfer) : "Remove people";
    }
    const char* operator()(const EditControl& c) const { return labelOf(kControlEditLabels, c.edit); }
    template <class Other>
    const char* operator()(const Other& other) const {
        return kindLabel(other);
    }
};

}  // namespace

bool canTakeBack(const CommandBody& body) {
    const auto* control = std::get_if<EditControl>(&body);
    return traitsOf(body).undoable && (control == nullptr || control->edit != ControlEdit::Remove);
}

std::string actLabel(std::span<const CommandBody> bodies, const World& world) {
    const auto has = [&](auto kind) {
        return std::any_of(bodies.begin(), bodies.end(), [&](const CommandBody& body) {
            return std::holds_alternative<decltype(kind)>(body);
        });
    };
    if (has(GiveOrder{}) && has(EditQueue{})) return "Change orders";
    for (const CommandBody& body : bodies)
        if (const char* label = std::visit(Label{world}, body)) return label;
    return "Change";
}

bool isContinuous(const CommandBody& body) {
    return traitsOf(body).slides;
}

}  // namespace muster
