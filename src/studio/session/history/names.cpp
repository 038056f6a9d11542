#include "studio/session/history/names.h"

namespace muster {
namespace {

constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;  // Nothing has this id.

template <class Visit>
void visitOrder(Order& order, const Visit& visit) {
    visit(SubjectKind::Group, order.group.value);
    visit(SubjectKind::Character, order.character);
    visit(SubjectKind::Area, order.area.value);
    for (AreaId& exit : order.exits) visit(SubjectKind::Area, exit.value);
}

/// Calls `visit(kind, id)` for all ids that a command has.
template <class Visit>
struct IdVisitor {
    const Visit& visit;

    void operator()(PutThing& c) const {
        if (const auto thing = thingOf(c)) visit(subjectOf(*thing), c.id);
        visit(SubjectKind::Group, c.group.value);
    }
    void operator()(RemoveThing& c) const { visit(subjectOf(c.thing), c.id); }
    void operator()(AddGroup& c) const {
        for (Order& order : c.group.orders) visitOrder(order, visit);
    }
    void operator()(GiveOrder& c) const {
        visit(SubjectKind::Group, c.group.value);
        visitOrder(c.order, visit);
    }
    void operator()(EditQueue& c) const {
        visit(SubjectKind::Group, c.group.value);
        visit(SubjectKind::Order, c.order);
    }
    void operator()(MergeGroups& c) const {
        for (GroupId& group : c.groups) visit(SubjectKind::Group, group.value);
    }
    template <class Body>
    void operator()(Body& c) const {
        if constexpr (requires { c.group.value; }) visit(SubjectKind::Group, c.group.value);
        if constexpr (requires { c.ids; })
            for (std::uint32_t& id : c.ids) visit(SubjectKind::Character, id);
    }
};

/// Names of characters and orders are their ids, until they come back. Histories hold so many of them, and
/// none outlasts a new beginning, that only others are listed.
bool isListed(SubjectKind kind) {
    return kind != SubjectKind::Character && kind != SubjectKind::Order && kind != SubjectKind::Parameter;
}

}  // namespace

std::uint32_t Names::nameOf(SubjectKind kind, std::uint32_t id) {
    if (id == 0) return 0;
    Table& of = table(kind);
    if (const auto found = of.names.find(id); found != of.names.end()) return found->second;
    const std::uint32_t name = of.ids.contains(id) ? ++last_ : id;
    if (name != id || isListed(kind)) bind(kind, name, id);
    return name;
}

std::uint32_t Names::idOf(SubjectKind kind, std::uint32_t name) const {
    const auto found = table(kind).ids.find(name);
    return found == table(kind).ids.end() ? name : found->second;
}

void Names::bind(SubjectKind kind, std::uint32_t name, std::uint32_t id) {
    Table& of = table(kind);
    if (const auto before = of.ids.find(name); before != of.ids.end()) of.names.erase(before->second);
    of.ids[name] = id;
    of.names[id] = name;
}

void Names::renumber(SubjectKind kind, const std::vector<std::uint32_t>& ids) {
    Table next;
    for (std::size_t k = 0; k < ids.size(); ++k) {
        if (ids[k] == 0) continue;
        const std::uint32_t name = nameOf(kind, ids[k]);
        next.ids[name] = static_cast<std::uint32_t>(k + 1);
        next.names[static_cast<std::uint32_t>(k + 1)] = name;
    }
    for (const auto& [name, id] : table(kind).ids) next.ids.try_emplace(name, kNowhere);
    table(kind) = std::move(next);
}

void Names::clear() {
    tables_ = {};
}

void Names::toNames(CommandBody& body) {
    const auto visit = [&](SubjectKind kind, std::uint32_t& id) { id = nameOf(kind, id); };
    std::visit(IdVisitor<decltype(visit)>{visit}, body);
}

void Names::toIds(CommandBody& body) const {
    const auto visit = [&](SubjectKind kind, std::uint32_t& id) { id = idOf(kind, id); };
    std::visit(IdVisitor<decltype(visit)>{visit}, body);
}

void Names::toNames(Order& order) {
    visitOrder(order, [&](SubjectKind kind, std::uint32_t& id) { id = nameOf(kind, id); });
}

void Names::toIds(Order& order) const {
    visitOrder(order, [&](SubjectKind kind, std::uint32_t& id) { id = idOf(kind, id); });
}

}  // namespace muster
