#include "studio/session/history/group_fields.h"

#include <algorithm>

#include "engine/state/group_change.h"

namespace muster {
namespace {

/// An archive that leaves some fields as they are, and takes the others away.
struct Keep {
    const std::vector<std::size_t>& fields;
    std::size_t next = 0;

    template <class... T>
    void operator()(T&... values) {
        (keep(values), ...);
    }
    void keep(const GroupId&) {}
    template <class T>
    void keep(std::optional<T>& value) {
        if (std::find(fields.begin(), fields.end(), next++) == fields.end()) value.reset();
    }
};

}  // namespace

std::size_t firstField(const ChangeGroup& change) {
    const std::vector<std::size_t> fields = givenFields(change);
    return fields.empty() ? 0 : fields.front();
}

ChangeGroup sameFields(ChangeGroup whole, const ChangeGroup& asked) {
    const std::vector<std::size_t> fields = givenFields(asked);
    Keep keep{fields};
    whole.visit(keep);
    return whole;
}

std::vector<CommandBody> singleFields(const CommandBody& body) {
    const auto* change = std::get_if<ChangeGroup>(&body);
    if (change == nullptr) return {body};
    std::vector<CommandBody> singles;
    for (const std::size_t field : givenFields(*change)) {
        ChangeGroup single = *change;
        const std::vector<std::size_t> one{field};
        Keep keep{one};
        single.visit(keep);
        singles.emplace_back(std::move(single));
    }
    return singles;
}

}  // namespace muster
