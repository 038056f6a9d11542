// A session in which two groups are directed, to take back what was done.
#pragma once

#include <doctest.h>

#include <string>
#include <vector>

#include "muster/take.h"
#include "studio/session/fake_client.h"

namespace muster::testing {

/// Sixteen in a square and nine in a wedge.
inline WorldDef twoGroups() {
    WorldDef def = smallFloor();
    def.box = {{-30, -30}, {30, 30}};
    def.groups[0].name = "Blue";
    GroupDef other = def.groups[0];
    other.name = "Orange";
    other.colour = 0x440E93u;
    other.count = 9;
    other.formation.kind = FormationKind::Wedge;
    other.position = {10, 8};
    other.conduct.cohesion = 0.25;
    def.groups.push_back(other);
    return def;
}

/// A session with one greeted director and two groups.
struct UndoDesk {
    Session session{sessionDef()};
    FakeClient client{session};

    UndoDesk() {
        REQUIRE(session.load("two", twoGroups()).ok());
        settle();
    }
    void settle(double seconds = 0.2) { run(session, seconds, {&client}); }
    void act(const std::string& events) {
        client.send(commandsOf("[" + events + "]"));
        settle();
    }
    void move(double x, double y, const std::string& more = "") {
        act(R"({"kind":"move","group":1,"x":)" + std::to_string(x) + R"(,"y":)" + std::to_string(y) + more +
            "}");
    }
    void undo(bool redo = false) {
        client.send(protocol::UndoEdit{redo});
        settle();
    }
    const World& world() const { return *session.world(); }
    GroupView group(std::size_t g = 0) const { return world().group(g); }
    /// Where the orders of the first group lead, in their order.
    std::vector<double> targets() const {
        std::vector<double> xs;
        for (const QueuedOrder& order : group().orders) xs.push_back(order.order.target.x);
        return xs;
    }
    /// What the world or the session refused.
    std::string trouble() const {
        return client.noticed("rejected") + client.noticed("Edit") + client.noticed("UndoEdit");
    }
    const protocol::EditHistory& history() const { return client.history; }
    void replays() const {
        const auto bytes = session.take();
        REQUIRE(bytes.ok());
        const auto take = parseTake(*bytes, "take");
        REQUIRE_MESSAGE(take.ok(), take.status().message());
        const auto played = replayTake(*take);
        CHECK_MESSAGE(played.ok(), played.status().message());
    }
};

}  // namespace muster::testing
