// Who is exported: the choice of an ExportDef.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "files/export/exporter.h"

namespace muster {

/// Tells for one frame after the other who is exported. Who has been chosen once stays chosen, whichever
/// group they join later.
class ChosenPeople {
public:
    explicit ChosenPeople(const ExportDef& def) : def_(def) {}

    /// True where the definition leaves out nobody.
    bool all() const { return def_.groups.empty() && inRange(0) && inRange(0xffffffffu); }
    bool inRange(std::uint32_t id) const { return id >= def_.firstPerson && id <= def_.lastPerson; }
    /// The chosen characters of a world that has not been stepped, ascending.
    std::vector<std::uint32_t> idsIn(const World& world) const;
    /// Takes all others out of the frame's characters, which are in ascending order of ids.
    void keep(const World& world, std::vector<ExportCharacter>& characters);
    bool anyone() const { return anyone_; }  ///< True where somebody has been kept.

private:
    bool inGroup(const World& world, std::uint32_t index) const;

    const ExportDef& def_;
    std::set<std::uint32_t> seen_, chosen_;  ///< Ids.
    bool anyone_ = false;
};

}  // namespace muster
