#include "studio/session/history/names.h"

#include "studio/session/history/generated/command_ids.h"

namespace muster {
namespace {

constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;  // Nothing has this id.

/// Calls `visit(kind, id)` for all ids that a command has.
template <class Visit>
void visitAll(CommandBody& body, const Visit& visit) {
    if (auto* put = std::get_if<PutThing>(&body))
        if (const auto thing = thingOf(*put)) visit(subjectOf(*thing), put->id);
    if (auto* remove = std::get_if<RemoveThing>(&body)) visit(subjectOf(remove->thing), remove->id);
    std::visit([&](auto& c) { visitIds(c, visit); }, body);
}

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
    visitAll(body, [&](SubjectKind kind, std::uint32_t& id) { id = nameOf(kind, id); });
}

void Names::toIds(CommandBody& body) const {
    visitAll(body, [&](SubjectKind kind, std::uint32_t& id) { id = idOf(kind, id); });
}

void Names::toNames(QueuedOrder& order) {
    visitIds(order, [&](SubjectKind kind, std::uint32_t& id) { id = nameOf(kind, id); });
}

void Names::toIds(QueuedOrder& order) const {
    visitIds(order, [&](SubjectKind kind, std::uint32_t& id) { id = idOf(kind, id); });
}

}  // namespace muster
