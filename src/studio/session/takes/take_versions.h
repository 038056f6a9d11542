// The open take as it was before changes of its blocks, and after those that were taken back.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "muster/take.h"

namespace muster {

/// A take that was open.
struct TakeVersion {
    std::shared_ptr<Take> take;
    TakeAbout about;
    std::string fileName;             ///< Its name on the shelf; empty where it lies elsewhere.
    std::vector<std::uint8_t> bytes;  ///< Its file.
    bool marked = true;               ///< False where it was not simulated to its end.
    std::string what;                 ///< The change that leads on from it, or back to it.
};

/// A history of such takes. The one that is shown is the caller's.
class TakeVersions {
public:
    static constexpr std::size_t kMost = 100;  ///< Changes that can be taken back.

    /// The take changes: this is how it was.
    void changed(TakeVersion before) {
        undone_.clear();
        done_.push_back(std::move(before));
        if (done_.size() > kMost) done_.erase(done_.begin());
    }
    /// The take before the last change, or after the one taken back last; `present` is the one shown, whose
    /// `what` need not be set. None where there is none.
    std::optional<TakeVersion> step(TakeVersion present, bool redo) {
        auto &from = redo ? undone_ : done_, &to = redo ? done_ : undone_;
        if (from.empty()) return std::nullopt;
        TakeVersion shown = std::move(from.back());
        from.pop_back();
        present.what = shown.what;
        to.push_back(std::move(present));
        return shown;
    }
    void clear() {
        done_.clear();
        undone_.clear();
        fileName.clear();
    }
    std::string undo() const { return done_.empty() ? "" : done_.back().what; }  ///< What was done last.
    std::string redo() const {
        return undone_.empty() ? "" : undone_.back().what;
    }  ///< What can be done again.

    std::string fileName;  ///< The file on the shelf that changes are written to; empty before the first.

private:
    std::vector<TakeVersion> done_, undone_;
};

}  // namespace muster
