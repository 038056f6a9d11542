// Things of one kind that C programs know by an id: a slot and a generation.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "muster/status.h"

namespace muster::c_api {

/// Owns things of one kind. `Id` is a C struct of `index1` and `generation`. Any thread may use it.
template <class Id, class Thing>
class HandleTable {
public:
    /// `kind` is the word for messages: "world".
    explicit HandleTable(const char* kind) : kind_(kind) {}

    /// Takes a thing.
    Id add(std::unique_ptr<Thing> thing) {
        const std::lock_guard lock(mutex_);
        std::uint32_t slot = 0;
        while (slot < slots_.size() && slots_[slot].thing != nullptr) ++slot;
        if (slot == slots_.size()) slots_.emplace_back();
        slots_[slot].thing = std::move(thing);
        return {slot + 1, ++slots_[slot].generation};
    }
    /// The thing of that id; NotFound where there is none, or not any more.
    Result<Thing*> find(Id id) const {
        const std::lock_guard lock(mutex_);
        if (!known(id)) return missing(id);
        return slots_[id.index1 - 1].thing.get();
    }
    /// Takes a thing out of the table; NotFound as find().
    Result<std::unique_ptr<Thing>> take(Id id) {
        const std::lock_guard lock(mutex_);
        if (!known(id)) return missing(id);
        return std::move(slots_[id.index1 - 1].thing);
    }
    /// Ends a thing; NotFound as find().
    Status destroy(Id id) { return take(id).status(); }

private:
    struct Slot {
        std::unique_ptr<Thing> thing;
        std::uint32_t generation = 0;
    };

    bool known(Id id) const {
        return id.index1 > 0 && id.index1 <= slots_.size() && slots_[id.index1 - 1].thing != nullptr &&
               slots_[id.index1 - 1].generation == id.generation;
    }
    Status missing(Id id) const {
        if (id.index1 == 0)
            return {StatusCode::NotFound, std::string(kind_) + ": found no handle, expected one"};
        return {StatusCode::NotFound, std::string(kind_) + ": found a handle of slot " +
                                          std::to_string(id.index1) + " and generation " +
                                          std::to_string(id.generation) +
                                          ", expected one that has not been destroyed"};
    }

    const char* kind_;
    mutable std::mutex mutex_;
    std::vector<Slot> slots_;
};

}  // namespace muster::c_api
