#include "studio/session/inbox/directors.h"
#include "base/as_mutable.h"
#include "engine/world/inspect.h"

#include <algorithm>
#include <variant>

namespace muster {
namespace {

// The groups that a command changes. Orders that follow another group change only their own.
struct ChangedGroups {
    std::vector<std::uint32_t> operator()(const MergeGroups& merge) const {
        std::vector<std::uint32_t> groups;
        for (const GroupId group : merge.groups) groups.push_back(group.value);
        return groups;
    }
    template <class Body>
    std::vector<std::uint32_t> operator()(const Body& body) const {
        if constexpr (requires { body.group.value; })
            return {body.group.value};
        else
            return {};
    }
};

bool isThere(const World& world, std::uint32_t group) {
    return inspect::indexOfGroup(world, GroupId{group}).has_value();
}

}  // namespace

std::string plainText(const std::string& text, std::size_t mostLetters) {
    std::string plain;
    std::size_t letters = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) continue;
        if (plain.empty() && c == ' ') continue;
        if ((byte & 0xc0) != 0x80 && ++letters > mostLetters) break;
        plain += c;
    }
    while (!plain.empty() && plain.back() == ' ') plain.pop_back();
    return plain;
}

Directors::Director* Directors::find(std::uint32_t client) {
    const auto found = std::find_if(directors_.begin(), directors_.end(),
                                    [&](const Director& one) { return one.client == client; });
    return found == directors_.end() ? nullptr : &*found;
}

const Directors::Director* Directors::find(std::uint32_t client) const {
    return asMutable(*this).find(client);
}

void Directors::join(std::uint32_t client, const std::string& name) {
    std::uint8_t colour = 0;
    const auto taken = [&] {
        return std::any_of(directors_.begin(), directors_.end(),
                           [&](const Director& one) { return one.colour == colour; });
    };
    while (colour + 1 < kColours && taken()) ++colour;
    directors_.push_back({client, {}, colour, {}});
    rename(client, name);
}

void Directors::leave(std::uint32_t client) {
    if (std::erase_if(directors_, [&](const Director& one) { return one.client == client; }) > 0) ++revision_;
}

void Directors::rename(std::uint32_t client, const std::string& name) {
    Director* director = find(client);
    if (director == nullptr) return;
    director->name = plainText(name, kMaxNameLetters);
    if (director->name.empty()) director->name = "Director " + std::to_string(director->colour + 1);
    ++revision_;
}

Status Directors::give(std::uint32_t client, GroupId group) {
    Director* director = find(client);
    if (director == nullptr)
        return {StatusCode::NotFound, "no director has the number " + std::to_string(client)};
    director->groups.clear();
    if (group) director->groups.insert(group.value);
    ++revision_;
    return {};
}

std::string Directors::name(std::uint32_t client) const {
    const Director* director = find(client);
    return director == nullptr ? "Somebody" : director->name;
}

Status Directors::admit(std::uint32_t client, CommandBody& command) const {
    const Director* director = find(client);
    if (director == nullptr || director->groups.empty()) return {};
    if (auto* touch = touchOf(command, TouchPhase::Down); touch != nullptr && !touch->group)
        touch->group = GroupId{*director->groups.begin()};
    for (const std::uint32_t group : std::visit(ChangedGroups{}, command)) {
        if (director->groups.contains(group)) continue;
        return {StatusCode::Unsupported, "group " + std::to_string(group) + " is not yours to direct"};
    }
    return {};
}

bool Directors::observe(const World& world) {
    const std::uint32_t before = revision_;
    for (Director& director : directors_) {
        if (director.groups.empty()) continue;
        const std::set<std::uint32_t> old = director.groups;
        for (const Event& event : world.events()) {
            if (event.kind == EventKind::GroupAdded && director.groups.contains(event.value))
                director.groups.insert(event.subject);
            if (event.kind == EventKind::GroupRemoved && director.groups.contains(event.subject))
                director.groups.insert(event.value);
        }
        std::erase_if(director.groups, [&](std::uint32_t group) { return !isThere(world, group); });
        if (director.groups != old) ++revision_;
    }
    return revision_ != before;
}

void Directors::forgetGroups() {
    for (Director& director : directors_) {
        if (director.groups.empty()) continue;
        director.groups.clear();
        ++revision_;
    }
}

protocol::Directors Directors::message() const {
    protocol::Directors message;
    for (const Director& one : directors_)
        message.directors.push_back(
            {one.client, one.name, one.colour, {one.groups.begin(), one.groups.end()}});
    return message;
}

}  // namespace muster
