// What the commands of a step change: the definition before and after it, as far as they concern it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "muster/command.h"
#include "muster/world.h"
#include "studio/session/history/definition.h"
#include "studio/session/history/step_births.h"

namespace muster {

/// What a command may change beside what it says itself.
struct Concern {
    /// A property that is read after the step.
    struct Part {
        CommandBody asked;
        bool stays = false;
    };
    std::vector<Part> parts;
    std::vector<GroupId> queues;            ///< Groups whose queues are read after the step.
    std::vector<std::uint32_t> characters;  ///< Ids of those whom it may change.
    std::vector<GroupId> joined;            ///< Groups into which characters may come.
    bool place = false;                     ///< It is an edit of the place.
    std::optional<GroupDef> start;          ///< Of a group that is removed, as the place has it.
};

/// What the command may change in the world as it is. `place`: it is an edit of the place.
Concern concernOf(const CommandBody& body, const World& world, bool place);
/// What presentPart() is asked for all properties of a group.
std::vector<CommandBody> propertiesOf(GroupId group);

/// What is read of the definition while one step is made. Each part is read once, whoever changes it.
class StepRecord {
public:
    /// The command is about to be applied; what it may change is read. `place`: it is an edit of the place.
    Concern read(const CommandBody& body, const Scene& scene, bool place);
    /// The commands, which the world has accepted, have made this difference. Call in the order in which they
    /// were applied.
    Difference changed(const std::vector<CommandBody>& bodies, const std::vector<Concern>& concerns,
                       const Scene& scene, StepBirths& births);
    /// What is changed to take something back is as it leads to.
    void assume(const Difference& difference);
    void clear();

private:
    class Change;
    void readPart(const CommandBody& asked, bool start, const Scene& scene);
    void readQueue(GroupId group, const Scene& scene);

    // As the commands so far have left them; with names in the place of ids.
    std::map<PartKey, std::optional<CommandBody>> parts_;
    std::map<std::uint32_t, QueueState> queues_;
    std::map<std::uint32_t, MemberState> members_;
};

}  // namespace muster
