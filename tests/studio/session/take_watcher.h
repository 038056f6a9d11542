// A studio in which a take is open, for tests that change it.
#pragma once

#include <doctest.h>

#include <vector>

#include "studio/session/fake_client.h"
#include "studio/session/memory_shelf.h"
#include "studio/session/takes/take_paths.h"

namespace muster::testing {

/// A studio in which a take is open and read.
struct Watcher {
    explicit Watcher(const std::vector<std::uint8_t>& bytes) : session(def(shelf)), client(session) {
        REQUIRE(session.openTake(bytes, "take").ok());
        read();
    }
    static SessionDef def(MemoryShelf& shelf) {
        SessionDef def = sessionDef();
        shelf.serve(def);
        return def;
    }
    void read() {
        run(session, 0.1, {&client});  // It goes to the moment that is to be shown first.
        while (session.preparing()) session.prepare();
        session.prepare();
        client.poll();
    }
    /// The points of a path.
    std::vector<Vec2> path(std::uint32_t group, std::uint32_t character = 0) {
        client.path.reset();
        client.send(protocol::AskPath{group, character});
        run(session, 0.5, {&client});
        REQUIRE(client.path.has_value());
        std::vector<Vec2> points;
        for (std::size_t k = 0; k + 1 < client.path->points.size(); k += 2)
            points.push_back({client.path->points[k], client.path->points[k + 1]});
        return points;
    }
    void bend(const protocol::BendPath& bend) { change(bend); }
    /// The tracks of the take.
    protocol::TakeTracks tracks() {
        client.tracks.reset();
        client.send(protocol::WatchTracks{true});
        run(session, 0.1, {&client});
        REQUIRE(client.tracks.has_value());
        return *client.tracks;
    }
    void edit(protocol::TrackEdit edit, std::uint32_t block = 0, std::uint32_t step = 0,
              std::uint32_t group = 0) {
        change(protocol::EditTrack{tracks().revision, edit, block, step, group});
    }
    template <class Message>
    void change(const Message& message) {
        client.notices.clear();
        client.send(message);
        read();
        run(session, 0.2, {&client});
    }

    MemoryShelf shelf;
    Session session;
    FakeClient client;
};

}  // namespace muster::testing
