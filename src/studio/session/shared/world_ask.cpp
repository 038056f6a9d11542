#include "studio/session/shared/world_ask.h"

#include <utility>

namespace muster {

void WorldAsk::begin(std::uint32_t asker, std::set<std::uint32_t> others, double now) {
    asker_ = asker;
    minds_ = 0;
    ++number_;
    due_ = now + kSeconds;
    silent_ = std::move(others);
}

void WorldAsk::answer(std::uint32_t client, std::uint32_t number, bool allows) {
    if (!open() || number != number_ || silent_.erase(client) == 0) return;
    if (!allows && minds_ == 0) minds_ = client;
}

void WorldAsk::leave(std::uint32_t client) {
    silent_.erase(client);
    withdraw(client);
}

void WorldAsk::withdraw(std::uint32_t client) {
    if (client != asker_) return;
    asker_ = 0;
    silent_.clear();
}

std::optional<WorldAsk::End> WorldAsk::end(double now) {
    if (!open() || (minds_ == 0 && !silent_.empty() && now < due_)) return std::nullopt;
    const End end{asker_, minds_};
    withdraw(asker_);
    return end;
}

}  // namespace muster
