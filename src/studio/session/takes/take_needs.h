// What later commands of a take need of earlier ones: ids count up, so that who makes groups, people or
// things has to stay in its order as long as later commands name what came of it.
#pragma once

#include <cstddef>
#include <vector>

#include "muster/take.h"
#include "studio/session/takes/take_news.h"

namespace muster {

/// A command of a changed take.
struct DraftCommand {
    Command command;
    std::size_t origin = 0;  ///< Index of the command in the take that it is, or is a copy of.
    bool copy = false;
};

/// A command that would no longer find what it names.
struct BrokenNeed {
    std::size_t needs = 0;  ///< Index of the command in the take.
    std::size_t made = 0;   ///< Of the one that makes what it names, or that would come between.
};

/// The first need of the take that the draft does not meet; both in the order in which they apply. `needs` is
/// the number of commands where all are met.
BrokenNeed brokenNeed(const Take& take, const TakeNews& news, const std::vector<DraftCommand>& draft);

}  // namespace muster
