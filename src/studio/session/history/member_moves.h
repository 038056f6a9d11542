// Commands by which characters and groups come, leave and change groups.
#pragma once

#include <cstdint>
#include <vector>

#include "studio/session/history/commands_between.h"

namespace muster {

/// Names of groups to which something happens.
struct MemberMoves {
    std::vector<std::uint32_t> come;     ///< They are not there and are to be.
    std::vector<std::uint32_t> go;       ///< They are there and are not to be.
    std::vector<std::uint32_t> divided;  ///< A part of them becomes a group that comes.
    std::vector<std::uint32_t> changed;  ///< Others belong to them after the commands.
};

/// Adds the commands after which each character is where the difference has it, and which groups there are.
/// Fills in `divided` and `changed`. Characters, too, are noted as they are now.
void leadMembers(Difference& difference, const Scene& scene, MemberMoves& moves, LeadingBatch& batch);

}  // namespace muster
