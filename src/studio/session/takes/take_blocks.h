// The commands of a take as blocks on the rows of a time line: one for each thing that a group does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/take.h"
#include "studio/session/inbox/protocol.h"
#include "studio/session/takes/take_news.h"
#include "studio/session/takes/take_paths.h"

namespace muster {

/// What people do not take apart: an order, a gesture from the first finger down to the last one up, or a
/// change.
struct TakeBlock {
    GroupId group;  ///< Whose; none for the place and for nobody in particular.
    protocol::TakeBlockKind kind{};
    std::uint32_t begin = 0;  ///< Step of its first command.
    std::uint32_t begun = 0;  ///< Step from which it is carried out.
    std::uint32_t end = 0;    ///< Step in which it is done or gives way to another one.
    bool open = false;        ///< It goes on to the end of the take.
    bool moves = true;        ///< It can begin at another time.
    bool stretches = false;   ///< It can take another time.
    std::string label;        ///< As people say it.
    std::vector<std::size_t>
        commands;  ///< Indices into the take's commands, in the order in which they apply.
};

/// All blocks of a take that has been simulated, in the order in which they begin.
std::vector<TakeBlock> takeBlocks(const Take& take, const TakePaths& paths, const TakeNews& news);

/// Indices of a take's commands in the order in which they apply.
std::vector<std::size_t> inOrder(const std::vector<Command>& commands);

/// A time of a take: "0:07", "1:02:05".
std::string clockOf(double seconds);

}  // namespace muster
