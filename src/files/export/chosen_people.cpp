#include "files/export/chosen_people.h"

#include <algorithm>

namespace muster {

bool ChosenPeople::inGroup(const World& world, std::uint32_t index) const {
    if (def_.groups.empty()) return true;
    if (index >= world.groupCount()) return false;
    const std::uint32_t id = world.group(index).id.value;
    return std::find(def_.groups.begin(), def_.groups.end(), id) != def_.groups.end();
}

std::size_t ChosenPeople::countIn(const World& world) const {
    const CharactersView view = world.characters();
    std::size_t count = 0;
    for (std::size_t i = 0; i < view.size(); ++i)
        count += inRange(view.id[i]) && inGroup(world, view.group[i]) ? 1 : 0;
    return count;
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
