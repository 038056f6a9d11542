// Who is connected to a session: names, colours, and what each may direct.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "muster/command.h"
#include "muster/world.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// Text without what cannot be seen and without blanks at both ends; cut between letters.
std::string plainText(const std::string& text, std::size_t mostLetters);

/// All directors of a session. A director is a client that has said Hello. Not thread-safe.
class Directors {
public:
    static constexpr std::uint8_t kColours = 16;        ///< Colours go round after so many directors.
    static constexpr std::size_t kMaxNameLetters = 40;  ///< Longer names are cut.

    /// Somebody comes. They get the first colour that nobody has, and may direct everything.
    void join(std::uint32_t client, const std::string& name);
    /// Somebody leaves.
    void leave(std::uint32_t client);
    /// Another name; without letters it becomes "Director" and a number.
    void rename(std::uint32_t client, const std::string& name);
    /// From now on `client` may direct that group and the parts that it is divided into, or, with none,
    /// everything. Fails with NotFound where there is no such director.
    Status give(std::uint32_t client, GroupId group);
    /// The name; "Somebody" for who is not there.
    std::string name(std::uint32_t client) const;

    /// Checks a command of a director and, where it is a touch that names no group, lets it take one of the
    /// director's. Fails with Unsupported where it is about another group.
    Status admit(std::uint32_t client, CommandBody& command) const;
    /// Call after each step: parts belong to whom the whole belonged; who has lost all groups may direct
    /// everything again. True where that changed something.
    bool observe(const World& world);
    /// Another world has begun: everybody may direct everything.
    void forgetGroups();

    /// Grows with each change.
    std::uint32_t revision() const { return revision_; }
    /// All of them, as clients learn of them.
    protocol::Directors message() const;

private:
    struct Director {
        std::uint32_t client = 0;
        std::string name;
        std::uint8_t colour = 0;
        std::set<std::uint32_t> groups;  // Empty: all.
    };
    Director* find(std::uint32_t client);
    const Director* find(std::uint32_t client) const;

    std::vector<Director> directors_;  // In the order in which they came.
    std::uint32_t revision_ = 1;
};

}  // namespace muster
