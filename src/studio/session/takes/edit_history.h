// What was done to people of the open take, for undo and redo.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/take.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// The edits with those of `edit`'s people replaced by it; without content they have none any more.
std::vector<TakeEdit> withEdit(const std::vector<TakeEdit>& edits, const TakeEdit& edit);
/// What differs between both, in words: "path of person 12", "time of 3 people".
std::string whatChanges(const std::vector<TakeEdit>& before, const TakeEdit& edit);

/// The states of the edits before the present one and after it.
class EditHistoryList {
public:
    /// `before` gives way to something else. Changes in a row with the same gesture, unless 0, are one.
    void add(std::vector<TakeEdit> before, std::string label, std::uint32_t gesture);
    /// Goes back, or forward with `redo`: `now` becomes the edits then. False where there is nothing.
    bool go(bool redo, std::vector<TakeEdit>& now);
    /// Changes in a row end here.
    void rest() { gesture_ = 0; }
    /// What the page knows of it.
    protocol::EditHistory state() const;

private:
    struct Entry {
        std::vector<TakeEdit> edits;
        std::string label;
    };
    std::vector<Entry> undo_, redo_;
    std::uint32_t gesture_ = 0;
};

}  // namespace muster
