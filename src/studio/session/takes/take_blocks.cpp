#include "studio/session/takes/take_blocks.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/state/command_order.h"
#include "studio/session/inbox/generated/command_traits.h"
#include "studio/session/takes/block_labels.h"

namespace muster {
namespace {

using protocol::TakeBlockKind;

constexpr double kSlide = 0.5;  // Changes by a slider within this time are one [s].

/// The group that a command says it concerns; none for the place.
GroupId groupOf(const CommandBody& body) {
    return std::visit(
        [](const auto& c) {
            if constexpr (requires { GroupId{c.group}; }) return GroupId{c.group};
            if constexpr (requires { c.groups.front(); })
                return c.groups.empty() ? GroupId{} : GroupId{c.groups.front()};
            return GroupId{};
        },
        body);
}

bool leads(const CommandBody& body) {
    const auto* change = std::get_if<ChangeCharacters>(&body);
    return std::holds_alternative<WriteMotion>(body) || (change != nullptr && change->driver.has_value());
}

/// From here on the orders that the group had before count no more.
bool endsOrders(const CommandBody& body) {
    if (const auto* give = std::get_if<GiveOrder>(&body)) return give->mode == QueueMode::Replace;
    if (const auto* edit = std::get_if<EditQueue>(&body))
        return edit->edit == QueueEdit::Stop || (edit->edit == QueueEdit::Cancel && edit->order == 0);
    return std::holds_alternative<SetPose>(body);
}

/// Puts the commands of a take together.
class BlockReader {
public:
    BlockReader(const Take& take, const TakePaths& paths, const TakeNews& news)
        : take_(take), paths_(paths), news_(news), steps_(take.steps()) {
        for (const TakeNews::GroupTimes& group : news.groups()) ends_[group.id] = group.to;
        for (const std::size_t index : inOrder(take.commands))
            if (const Command& command = take.commands[index]; endsOrders(command.body))
                endings_[groupOf(command.body)].push_back(command.step);
    }

    std::vector<TakeBlock> read() {
        for (const std::size_t index : inOrder(take_.commands)) {
            const Command& command = take_.commands[index];
            std::visit([&](const auto& body) { accept(index, command, body); }, command.body);
        }
        for (Open& one : gestures_) blocks_[one.block].end = steps_;
        for (TakeBlock& block : blocks_)
            if (block.end > block.begin && block.kind == TakeBlockKind::Order) endOrder(block);
        for (TakeBlock& block : blocks_) block.end = std::clamp(block.end, block.begin, steps_);
        std::stable_sort(blocks_.begin(), blocks_.end(),
                         [](const TakeBlock& a, const TakeBlock& b) { return a.begin < b.begin; });
        return std::move(blocks_);
    }

private:
    /// A gesture whose fingers are not all up.
    struct Open {
        std::uint32_t client = 0;
        std::size_t block = 0;
        std::vector<std::uint32_t> fingers;
        std::size_t most = 0;
    };

    TakeBlock& add(std::size_t index, const Command& command, GroupId group, TakeBlockKind kind) {
        TakeBlock block;
        block.group = group;
        block.kind = kind;
        block.begin = block.begun = block.end = command.step;
        block.label = blockLabel(command.body, take_.def);
        block.commands.push_back(index);
        blocks_.push_back(std::move(block));
        return blocks_.back();
    }

    // Gestures.

    Open* gestureOf(std::uint32_t client, std::uint32_t finger) {
        for (Open& one : gestures_)
            if (one.client == client &&
                std::find(one.fingers.begin(), one.fingers.end(), finger) != one.fingers.end())
                return &one;
        return nullptr;
    }
    void down(std::size_t index, const Command& command, GroupId group,
              const std::vector<std::uint32_t>& fingers) {
        const auto same = std::find_if(gestures_.begin(), gestures_.end(), [&](const Open& one) {
            return one.client == command.client && blocks_[one.block].group == group;
        });
        Open* open = same == gestures_.end() ? nullptr : &*same;
        if (open == nullptr) {
            add(index, command, group, TakeBlockKind::Gesture).stretches = true;
            gestures_.push_back({command.client, blocks_.size() - 1, {}, 0});
            open = &gestures_.back();
        } else {
            blocks_[open->block].commands.push_back(index);
        }
        open->fingers.insert(open->fingers.end(), fingers.begin(), fingers.end());
        open->most = std::max(open->most, open->fingers.size());
        if (open->most > 1) blocks_[open->block].label = std::to_string(open->most) + " fingers";
    }
    void up(const Command& command, Open& open, std::uint32_t finger) {
        std::erase(open.fingers, finger);
        blocks_[open.block].end = command.step;
        if (open.fingers.empty()) gestures_.erase(gestures_.begin() + (&open - gestures_.data()));
    }

    void accept(std::size_t index, const Command& command, const Touch& touch) {
        if (touch.phase == TouchPhase::Down) {
            const GroupId held = paths_.heldBy(command.client, touch.touch, command.step);
            return down(index, command, touch.group ? touch.group : held, {touch.touch});
        }
        Open* const open = gestureOf(command.client, touch.touch);
        if (open == nullptr) return;
        blocks_[open->block].commands.push_back(index);
        blocks_[open->block].end = command.step;
        if (touch.phase != TouchPhase::Move) up(command, *open, touch.touch);
    }
    void accept(std::size_t index, const Command& command, const AddControl& add) {
        down(index, command, add.group, add.touches);
    }
    void accept(std::size_t, const Command& command, const ReleaseClient&) {
        for (std::size_t k = gestures_.size(); k-- > 0;) {
            if (gestures_[k].client != command.client) continue;
            blocks_[gestures_[k].block].end = command.step;
            gestures_.erase(gestures_.begin() + static_cast<std::ptrdiff_t>(k));
        }
    }

    // Orders and changes.

    template <class Body>
    void accept(std::size_t index, const Command& command, const Body&) {
        constexpr bool gives = std::is_same_v<Body, GiveOrder>;
        constexpr bool orders = gives || std::is_same_v<Body, EditQueue>;
        const GroupId group = groupOf(command.body);
        TakeBlock* const same = leads(command.body) ? led(command) : beside(command, group, gives);
        if (same != nullptr) {
            same->commands.push_back(index);
            if (same->kind != TakeBlockKind::Order) same->end = command.step;
            if (gives) order(*same, command);
            return;
        }
        TakeBlock& block = add(index, command, group, orders ? TakeBlockKind::Order : TakeBlockKind::Change);
        if (leads(command.body)) {
            block.moves = false;
            led_[command.client] = blocks_.size() - 1;
        }
        if (gives) order(block, command);
    }
    void order(TakeBlock& block, const Command& command) {
        const Order& given = std::get<GiveOrder>(command.body).order;
        block.kind = TakeBlockKind::Order;
        block.label = blockLabel(command.body, take_.def);
        block.stretches = (given.kind == OrderKind::Move && given.manner == Manner::March) ||
                          (given.kind == OrderKind::Wait && given.seconds > 0.0);
        const std::size_t nth = given_[{block.group, command.step}]++;
        const auto [id, begun, ended] = news_.order(block.group, command.step, nth);
        block.end = std::max(ended, block.begin);
        // The event tells of the step's end.
        block.begun = begun == TakeNews::kNever ? block.end : begun - 1;
    }
    /// Where somebody is led on.
    TakeBlock* led(const Command& command) {
        const auto found = led_.find(command.client);
        return found == led_.end() ? nullptr : &blocks_[found->second];
    }
    /// A block of the same moment, or moved by the same slider.
    TakeBlock* beside(const Command& command, GroupId group, bool gives) {
        const auto soon = static_cast<std::uint32_t>(kSlide / take_.def.parameters.stepTime);
        for (std::size_t k = blocks_.size(); k-- > 0;) {
            TakeBlock& block = blocks_[k];
            const Command& before = take_.commands[block.commands.back()];
            if (block.begin + soon < command.step && before.step + soon < command.step) return nullptr;
            if (block.group != group || block.kind == TakeBlockKind::Gesture) continue;
            if (before.client != command.client || leads(before.body)) continue;
            if (gives && std::holds_alternative<GiveOrder>(before.body)) return nullptr;
            if (before.step == command.step) return &block;
            const bool slides = traitsOf(command.body).slides && before.step + soon >= command.step;
            const bool alike = blockLabel(before.body, take_.def) == blockLabel(command.body, take_.def);
            return slides && alike && before.body.index() == command.body.index() ? &block : nullptr;
        }
        return nullptr;
    }

    /// An order that others end before it is done, or that goes on.
    void endOrder(TakeBlock& block) const {
        block.end = std::min({block.end, steps_, endOf(block.group)});
        const std::uint32_t given = take_.commands[block.commands.back()].step;
        const auto endings = endings_.find(block.group);
        if (endings != endings_.end())
            if (const auto next = std::upper_bound(endings->second.begin(), endings->second.end(), given);
                next != endings->second.end())
                block.end = std::min(block.end, *next);
        block.open = block.end >= steps_;
        block.begun = std::clamp(block.begun, block.begin, std::max(block.begin, block.end));
    }
    std::uint32_t endOf(GroupId group) const {
        const auto found = ends_.find(group);
        return found == ends_.end() ? TakeNews::kNever : found->second;
    }

    const Take& take_;
    const TakePaths& paths_;
    const TakeNews& news_;
    std::uint32_t steps_;
    std::map<GroupId, std::uint32_t> ends_;
    std::vector<TakeBlock> blocks_;
    std::vector<Open> gestures_;
    std::map<std::uint32_t, std::size_t> led_;               // Blocks, by client.
    std::map<GroupId, std::vector<std::uint32_t>> endings_;  // Steps in which the orders of before end.
    std::map<std::pair<GroupId, std::uint32_t>, std::size_t> given_;  // Orders, by group and step.
};

}  // namespace

std::vector<std::size_t> inOrder(const std::vector<Command>& commands) {
    std::vector<std::size_t> order(commands.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return comesBefore(commands[i], commands[j]); });
    return order;
}

std::vector<TakeBlock> takeBlocks(const Take& take, const TakePaths& paths, const TakeNews& news) {
    return BlockReader(take, paths, news).read();
}

std::string clockOf(double seconds) {
    const auto whole = static_cast<std::uint32_t>(seconds);
    const auto two = [](std::uint32_t value) { return (value < 10 ? "0" : "") + std::to_string(value); };
    const std::uint32_t minutes = whole / 60;
    if (minutes < 60) return std::to_string(minutes) + ":" + two(whole % 60);
    return std::to_string(minutes / 60) + ":" + two(minutes % 60) + ":" + two(whole % 60);
}

}  // namespace muster
