#include "studio/session/takes/edit_tracks.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/state/command_order.h"
#include "muster/session.h"
#include "studio/session/history/generated/command_ids.h"
#include "studio/session/takes/run_again.h"
#include "studio/session/takes/take_needs.h"

namespace muster {
namespace {

using protocol::TakeBlockKind;
using protocol::TrackEdit;

constexpr double kLeastTime = 0.2;   // A stretched block takes at least so long [s].
constexpr double kMostStretch = 20;  // And at most so many times as long as before.
constexpr double kLeastWay = 0.5;    // A shorter way has no pace [m].

Status refused(const std::string& sentence) {
    return {StatusCode::Unsupported, sentence};
}

double* timeOf(CommandBody& body) {
    if (auto* touch = std::get_if<Touch>(&body)) return &touch->time;
    if (auto* add = std::get_if<AddControl>(&body)) return &add->time;
    return nullptr;
}

void shift(CommandBody& body, Vec2 by) {
    if (auto* touch = std::get_if<Touch>(&body))
        if (touch->phase == TouchPhase::Down || touch->phase == TouchPhase::Move) touch->position += by;
    if (auto* add = std::get_if<AddControl>(&body))
        for (Vec2& position : add->positions) position += by;
}

/// Carries out one change.
class Editor {
public:
    Editor(const Take& take, const TakePaths& paths, const TakeNews& news, const TrackChange& change)
        : take_(take),
          paths_(paths),
          news_(news),
          change_(change),
          blocks_(takeBlocks(take, paths, news)),
          dt_(take.def.parameters.stepTime),
          steps_(take.steps()) {}

    Result<ChangedTake> changed() {
        if (change_.block >= blocks_.size())
            return invalidArgument("found block " + std::to_string(change_.block) + ", expected one of " +
                                   std::to_string(blocks_.size()));
        block_ = &blocks_[change_.block];
        for (std::size_t k = 0; k < take_.commands.size(); ++k)
            draft_.push_back({take_.commands[k], k, false});
        const Status done = apply();
        if (!done.ok()) return done;
        std::stable_sort(draft_.begin(), draft_.end(), [](const DraftCommand& a, const DraftCommand& b) {
            return comesBefore(a.command, b.command);
        });
        if (const Status met = needsMet(); !met.ok()) return met;
        ChangedTake result{take_, what()};
        result.take.commands.clear();
        for (DraftCommand& one : draft_) result.take.commands.push_back(std::move(one.command));
        runAgain(result.take, steps_);
        return result;
    }

private:
    Status apply() {
        switch (change_.edit) {
            case TrackEdit::Move:
            case TrackEdit::Copy:
                return put(change_.edit == TrackEdit::Copy);
            case TrackEdit::Stretch:
                return stretch();
            default:
                take();
                return {};
        }
    }
    std::string what() const {
        const char* const verb = change_.edit == TrackEdit::Move     ? "Move"
                                 : change_.edit == TrackEdit::Copy   ? "Copy"
                                 : change_.edit == TrackEdit::Remove ? "Remove"
                                                                     : "Retime";
        return std::string(verb) + " “" + block_->label + "”";
    }

    /// The commands of the block, which leave the draft.
    std::vector<DraftCommand> take() {
        const std::set<std::size_t> own(block_->commands.begin(), block_->commands.end());
        std::vector<DraftCommand> taken;
        for (const std::size_t k : block_->commands) taken.push_back(draft_[k]);
        std::erase_if(draft_, [&](const DraftCommand& one) { return own.contains(one.origin); });
        return taken;
    }

    // Another moment.

    Status put(bool copy) {
        if (!block_->moves)
            return refused("The path that one person was given holds for its own moment only.");
        if (change_.step >= steps_)
            return refused("A block cannot begin after the end of the take at " + clock(steps_) + ".");
        std::vector<DraftCommand> moved;
        if (copy)
            for (const std::size_t k : block_->commands) moved.push_back({take_.commands[k], k, true});
        else
            moved = take();
        const std::int64_t by = std::int64_t{change_.step} - block_->begin;
        for (DraftCommand& one : moved) {
            one.command.step = static_cast<std::uint32_t>(one.command.step + by);
            if (double* time = timeOf(one.command.body)) *time += static_cast<double>(by) * dt_;
        }
        if (copy) aim(moved);
        if (block_->kind == TakeBlockKind::Gesture) lift(moved, block_->end + by);
        if (const Status there = groupsThere(moved); !there.ok()) return there;
        if (copy || block_->kind == TakeBlockKind::Gesture) renumber(moved);
        if (!block_->open) longer(block_->end + by);
        draft_.insert(draft_.end(), moved.begin(), moved.end());
        return {};
    }
    /// A copy is given to its group, and a gesture goes where that group is by then.
    void aim(std::vector<DraftCommand>& moved) {
        const GroupId to = change_.group ? change_.group : block_->group;
        for (DraftCommand& one : moved)
            std::visit(
                [&](auto& c) {
                    visitIds(c, [&](SubjectKind kind, std::uint32_t& id) {
                        if (kind == SubjectKind::Group && id == block_->group.value) id = to.value;
                    });
                },
                one.command.body);
        if (block_->kind != TakeBlockKind::Gesture) return;
        Vec2 from, at;
        if (!middle(block_->group, block_->begin, from) || !middle(to, change_.step, at)) return;
        for (DraftCommand& one : moved) {
            shift(one.command.body, at - from);
            if (auto* down = touchOf(one.command.body, TouchPhase::Down)) down->group = to;
        }
    }
    bool middle(GroupId group, std::uint32_t step, Vec2& at) const {
        std::uint32_t first = 0;
        const std::vector<Vec2> path = paths_.ofGroup(group, first);
        if (path.empty()) return false;
        const std::size_t point = step <= first ? 0 : (step - first) / kPathSpacing;
        at = path[std::min(point, path.size() - 1)];
        return true;
    }
    /// Fingers that only the end of their client lifted come up with the gesture.
    void lift(std::vector<DraftCommand>& moved, std::int64_t end) const {
        std::set<std::uint32_t> down;
        for (const DraftCommand& one : moved) {
            if (const auto* add = std::get_if<AddControl>(&one.command.body))
                down.insert(add->touches.begin(), add->touches.end());
            const auto* touch = std::get_if<Touch>(&one.command.body);
            if (touch == nullptr || touch->phase == TouchPhase::Move) continue;
            if (touch->phase == TouchPhase::Down)
                down.insert(touch->touch);
            else
                down.erase(touch->touch);
        }
        for (const std::uint32_t finger : down) {
            DraftCommand up = moved.back();
            up.command.step = static_cast<std::uint32_t>(end);
            up.command.body = Touch{TouchPhase::Up, finger, {}, static_cast<double>(end) * dt_, {}};
            up.copy = true;
            moved.push_back(std::move(up));
        }
    }
    /// By a client of its own: fingers of others keep theirs.
    void renumber(std::vector<DraftCommand>& moved) const {
        std::uint32_t client = kLastDemonstrator;
        for (const Command& command : take_.commands) client = std::max(client, command.client);
        std::uint32_t sequence = 0;
        for (DraftCommand& one : moved) {
            one.command.client = client + 1;
            one.command.sequence = ++sequence;
        }
    }
    Status groupsThere(std::vector<DraftCommand>& moved) const {
        const auto groups = news_.groups();
        for (DraftCommand& one : moved) {
            Status status;
            const bool ends = std::holds_alternative<MergeGroups>(one.command.body) ||
                              std::holds_alternative<RemoveGroup>(one.command.body);
            const std::uint32_t step = one.command.step;
            const auto visit = [&](SubjectKind kind, std::uint32_t id) {
                if (kind != SubjectKind::Group || id == 0 || !status.ok()) return;
                const auto group = std::find_if(groups.begin(), groups.end(),
                                                [&](const auto& known) { return known.id.value == id; });
                if (group == groups.end())
                    status = refused("There is no group " + std::to_string(id) + ".");
                else if (step < group->from)
                    status = refused("A block cannot begin before its group exists: " + named(*group) +
                                     " comes at " + clock(group->from) + ".");
                else if (step >= group->to && !ends)
                    status = refused("A block cannot begin after its group has ended: " + named(*group) +
                                     " ends at " + clock(group->to) + ".");
            };
            std::visit([&](auto& c) { visitIds(c, visit); }, one.command.body);
            if (!status.ok()) return status;
        }
        return {};
    }

    // Another time.

    Status stretch() {
        if (!block_->stretches)
            return refused("“" + block_->label + "” has no time of its own that could be changed.");
        const double seconds = change_.step * dt_ - block_->begun * dt_;
        const double before = (block_->end - block_->begun) * dt_;
        if (seconds < kLeastTime || seconds > std::max(before, 1.0) * kMostStretch)
            return refused("“" + block_->label + "” can take 0.2 s at least and " +
                           std::to_string(static_cast<int>(kMostStretch)) + " times as long at most.");
        longer(change_.step);
        if (block_->kind == TakeBlockKind::Gesture) return spread();
        for (const std::size_t k : block_->commands)
            if (auto* give = std::get_if<GiveOrder>(&draft_[k].command.body))
                return pace(give->order, seconds, before);
        return {};
    }
    Status spread() {
        if (block_->end == block_->begin)
            return refused("A touch that only comes down and lifts has no time that could be changed.");
        const double share = static_cast<double>(change_.step - block_->begin) /
                             (block_->end - block_->begin);
        const auto spreadFrom = [&](double value, double from) { return from + (value - from) * share; };
        std::vector<DraftCommand> moved = take();
        const double* const began = timeOf(moved.front().command.body);
        const double first = began == nullptr ? block_->begin * dt_ : *began;
        for (DraftCommand& one : moved) {
            const double step = spreadFrom(one.command.step, block_->begin);
            one.command.step = static_cast<std::uint32_t>(std::lround(step));
            if (double* time = timeOf(one.command.body)) *time = spreadFrom(*time, first);
        }
        lift(moved, change_.step);
        renumber(moved);
        draft_.insert(draft_.end(), moved.begin(), moved.end());
        return {};
    }
    Status pace(Order& order, double seconds, double before) const {
        if (order.kind == OrderKind::Wait) {
            order.seconds = std::max(kLeastTime, order.seconds + seconds - before);
            return {};
        }
        if (block_->open)
            return refused("“" + block_->label +
                           "” does not arrive within the take, so it has no time to change.");
        const double way = wayOf(*block_);
        if (way < kLeastWay) return refused("“" + block_->label + "” goes nowhere, so it has no pace.");
        // What does not depend on the pace: setting out, and closing up at the end.
        const double rest = order.pace > 0.0 ? std::max(0.0, before - way / order.pace) : 0.0;
        order.pace = std::clamp(way / std::max(kLeastTime, seconds - rest), 0.05, 100.0);
        return {};
    }
    /// How far the middle of its group goes meanwhile [m].
    double wayOf(const TakeBlock& block) const {
        std::uint32_t first = 0;
        const std::vector<Vec2> path = paths_.ofGroup(block.group, first);
        double way = 0.0;
        for (std::size_t k = 1; k < path.size(); ++k) {
            const std::size_t step = first + k * kPathSpacing;
            if (step > block.begun && step <= block.end + kPathSpacing) way += distance(path[k - 1], path[k]);
        }
        return way;
    }

    // What is needed.

    Status needsMet() const {
        const BrokenNeed broken = brokenNeed(take_, news_, draft_);
        if (broken.needs >= take_.commands.size()) return {};
        const std::string later = called(broken.needs);
        if (change_.edit == TrackEdit::Remove)
            return refused(called(broken.made) + " makes what " + later + " needs; remove that first.");
        if (change_.edit == TrackEdit::Copy)
            return refused("A copy of " + called(broken.made) + " cannot begin before " + later +
                           ", which needs what comes of those before it.");
        return refused(called(broken.made) + " and " + later +
                       " have to stay in this order: the second needs what comes of the first.");
    }
    /// "“Split” at 0:07".
    std::string called(std::size_t command) const {
        for (const TakeBlock& block : blocks_)
            if (std::find(block.commands.begin(), block.commands.end(), command) != block.commands.end())
                return "“" + block.label + "” at " + clock(block.begin);
        return "what was done at " + clock(take_.commands[command].step);
    }
    std::string clock(std::uint32_t step) const {
        const bool before = step < change_.zero;
        return (before ? "−" : "") + clockOf((before ? change_.zero - step : step - change_.zero) * dt_);
    }
    static std::string named(const TakeNews::GroupTimes& group) {
        return group.name.empty() ? "group " + std::to_string(group.id.value) : group.name;
    }
    void longer(std::int64_t end) {
        steps_ = std::max(steps_, static_cast<std::uint32_t>(std::max<std::int64_t>(0, end)));
    }

    const Take& take_;
    const TakePaths& paths_;
    const TakeNews& news_;
    const TrackChange& change_;
    std::vector<TakeBlock> blocks_;
    const TakeBlock* block_ = nullptr;
    double dt_;
    std::uint32_t steps_;
    std::vector<DraftCommand> draft_;
};

}  // namespace

Result<ChangedTake> editTracks(const Take& take, const TakePaths& paths, const TakeNews& news,
                               const TrackChange& change) {
    return Editor(take, paths, news, change).changed();
}

}  // namespace muster
