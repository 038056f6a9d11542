#include "studio/session/takes/edit_history.h"

#include <algorithm>
#include <utility>

namespace muster {
namespace {

constexpr std::size_t kMostUndone = 1000;

bool concerns(const TakeEdit& edit, std::uint32_t id) {
    return std::binary_search(edit.people.begin(), edit.people.end(), id);
}

}  // namespace

std::vector<TakeEdit> withEdit(const std::vector<TakeEdit>& edits, const TakeEdit& edit) {
    std::vector<TakeEdit> all;
    for (TakeEdit one : edits) {
        std::erase_if(one.people, [&](std::uint32_t id) { return concerns(edit, id); });
        if (!one.people.empty()) all.push_back(std::move(one));
    }
    if (!edit.empty()) all.push_back(edit);
    return all;
}

std::string whatChanges(const std::vector<TakeEdit>& before, const TakeEdit& edit) {
    TakeEdit old;
    for (const TakeEdit& one : before)
        if (!edit.people.empty() && concerns(one, edit.people.front())) old = one;
    std::string what = "changes";
    if (!edit.empty()) {
        if (edit.looks != old.looks) what = "look";
        if (edit.clips != old.clips) what = "clip";
        if (edit.clock != old.clock) what = "time";
        if (edit.pins != old.pins) what = "path";
    }
    if (edit.people.size() == 1) return what + " of person " + std::to_string(edit.people.front());
    return what + " of " + std::to_string(edit.people.size()) + " people";
}

void EditHistoryList::add(std::vector<TakeEdit> before, std::string label, std::uint32_t gesture) {
    redo_.clear();
    const bool same = gesture != 0 && gesture == gesture_;
    gesture_ = gesture;
    if (same) return;
    undo_.push_back({std::move(before), std::move(label)});
    if (undo_.size() > kMostUndone) undo_.erase(undo_.begin());
}

bool EditHistoryList::go(bool redo, std::vector<TakeEdit>& now) {
    std::vector<Entry>&from = redo ? redo_ : undo_, &to = redo ? undo_ : redo_;
    if (from.empty()) return false;
    Entry entry = std::move(from.back());
    from.pop_back();
    std::swap(entry.edits, now);
    to.push_back(std::move(entry));
    gesture_ = 0;
    return true;
}

protocol::EditHistory EditHistoryList::state() const {
    protocol::EditHistory state;
    state.undo = static_cast<std::uint32_t>(undo_.size());
    state.redo = static_cast<std::uint32_t>(redo_.size());
    if (!undo_.empty()) state.undoLabel = undo_.back().label;
    if (!redo_.empty()) state.redoLabel = redo_.back().label;
    return state;
}

}  // namespace muster
