#include "world/commands/unit_commands.h"

namespace muster {
namespace {

Status notYet() {
    return {StatusCode::Unsupported, "units do not change groups yet"};
}

}  // namespace

Status addCharacters(WorldState&, const AddCharacters&, std::vector<Event>&) {
    return notYet();
}
Status removeCharacters(WorldState&, const RemoveCharacters&, std::vector<Event>&) {
    return notYet();
}
Status transferCharacters(WorldState&, const TransferCharacters&, std::vector<Event>&) {
    return notYet();
}
Status splitGroup(WorldState&, const SplitGroup&, std::vector<Event>&) {
    return notYet();
}
Status mergeGroups(WorldState&, const MergeGroups&, std::vector<Event>&) {
    return notYet();
}

}  // namespace muster
