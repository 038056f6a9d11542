#include "files/export/chosen_people.h"

#include <algorithm>

namespace muster {

bool ChosenPeople::inGroup(const World& world, std::uint32_t index) const {
    if (def_.groups.empty()) return true;
    if (index >= world.groupCount()) return false;
    const std::uint32_t id = world.group(index).id.value;
    return std::find(def_.groups.begin(), def_.groups.end(), id) != def_.groups.end();
}

std::vector<std::uint32_t> ChosenPeople::idsIn(const World& world) const {
    const CharactersView view = world.characters();
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < view.size(); ++i)
        if (inRange(view.id[i]) && inGroup(world, view.group[i])) ids.push_back(view.id[i]);
    return ids;
}

void ChosenPeople::keep(const World& world, std::vector<ExportCharacter>& characters) {
    if (!all()) {
        std::erase_if(characters, [&](const ExportCharacter& c) {
            if (seen_.insert(c.id).second && inRange(c.id) && inGroup(world, c.group)) chosen_.insert(c.id);
            return !chosen_.contains(c.id);
        });
    }
    anyone_ = anyone_ || !characters.empty();
}

}  // namespace muster
