// What the simulation of a take tells: orders begun and done, groups that come and go, commands refused.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "muster/take.h"
#include "muster/world.h"

namespace muster {

/// Gathers it while a take is simulated, in any order of its steps.
class TakeNews {
public:
    static constexpr std::uint32_t kNever = 0xffffffff;  ///< A step that does not come.

    /// When an order was given, begun and done.
    struct OrderTimes {
        std::uint32_t id = 0;
        std::uint32_t begun = kNever;
        std::uint32_t ended = kNever;
    };
    /// A group and its time: it takes commands of steps from `from` up to before `to`.
    struct GroupTimes {
        GroupId id;
        std::string name;
        std::uint32_t from = 0;
        std::uint32_t to = kNever;
    };

    explicit TakeNews(const Take& take);

    /// The world has made a step of the take.
    void observe(const World& world);
    /// Of the order that is the nth that the group was given by commands of that step, counted from 0.
    OrderTimes order(GroupId group, std::uint32_t step, std::size_t nth) const;
    /// All groups, by id.
    std::vector<GroupTimes> groups() const;
    /// The number of commands that were refused, and why the first one was.
    std::size_t refused() const { return refused_.size(); }
    std::string firstRefusal() const { return refused_.empty() ? "" : refused_.begin()->second; }

private:
    struct Given {
        GroupId group;
        std::uint32_t id = 0;
    };

    std::map<std::uint32_t, std::vector<Given>> given_;     // By step of the command, as they were given.
    std::map<std::uint32_t, std::uint32_t> begun_, ended_;  // Steps, by id of the order.
    std::map<std::uint32_t, GroupTimes> groups_;            // By id.
    std::map<Command, std::string, bool (*)(const Command&, const Command&)> refused_;
};

}  // namespace muster
