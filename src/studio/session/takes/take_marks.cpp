#include "studio/session/takes/take_player.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "studio/session/inbox/generated/command_traits.h"

namespace muster {
namespace {

using protocol::TakeMark;
using protocol::TakeMarkKind;

constexpr std::size_t kMostMarks = 2000;

/// Collects the marks of a take.
class Collector {
public:
    explicit Collector(const Take& take) : steps_(take.steps()), stepTime_(take.def.parameters.stepTime) {}

    void command(const Command& command) {
        std::visit([&](const auto& body) { accept(command, body); }, command.body);
    }
    void event(const TakeEvent& raised) {
        if (raised.event.kind == EventKind::OrderGiven) return;  // The order itself is marked.
        add(TakeMarkKind::Event, raised.step, eventKindName(raised.event.kind));
    }
    std::vector<TakeMark> finish() {
        // Fingers that are never lifted stay to the end.
        while (!down_.empty()) lift(down_.begin()->first.first, down_.begin()->first.second, steps_);
        std::stable_sort(marks_.begin(), marks_.end(),
                         [](const TakeMark& a, const TakeMark& b) { return a.step < b.step; });
        if (marks_.size() > kMostMarks) thin();
        return std::move(marks_);
    }

private:
    void add(TakeMarkKind kind, std::uint32_t step, std::string label, std::uint32_t length = 0) {
        marks_.push_back({kind, std::min(step, steps_), length, std::move(label)});
    }
    void put(const Command& command, std::uint32_t touch) {
        down_.insert_or_assign(std::pair(command.client, touch), command.step);
    }
    void lift(std::uint32_t client, std::uint32_t touch, std::uint32_t step) {
        const auto found = down_.find({client, touch});
        if (found == down_.end()) return;
        const std::uint32_t begin = std::min(found->second, steps_);
        add(TakeMarkKind::Touch, begin, "touch", std::min(step, steps_) - std::min(begin, step));
        down_.erase(found);
    }

    void accept(const Command& command, const Touch& body) {
        if (body.phase == TouchPhase::Down) put(command, body.touch);
        if (body.phase == TouchPhase::Up || body.phase == TouchPhase::Cancel)
            lift(command.client, body.touch, command.step);
    }
    void accept(const Command& command, const AddControl& body) {
        for (const std::uint32_t touch : body.touches) put(command, touch);
    }
    void accept(const Command& command, const ReleaseClient&) {
        for (auto at = down_.lower_bound({command.client, 0});
             at != down_.end() && at->first.first == command.client;
             at = down_.lower_bound({command.client, 0}))
            lift(command.client, at->first.second, command.step);
    }
    void accept(const Command& command, const GiveOrder& body) {
        add(TakeMarkKind::Order, command.step, orderName(body.order.kind));
    }
    template <class Body>
    void accept(const Command& command, const Body&) {
        const std::string label = traitsOf(command.body).label;
        add(TakeMarkKind::Change, command.step, label.empty() ? words(commandName(command)) : lowered(label));
    }
    /// "change shape" for the label "Change shape".
    static std::string lowered(std::string label) {
        if (label[0] >= 'A' && label[0] <= 'Z') label[0] = static_cast<char>(label[0] - 'A' + 'a');
        return label;
    }
    /// "change group" for "ChangeGroup".
    static std::string words(const std::string& name) {
        std::string text;
        for (const char c : name) {
            const bool capital = c >= 'A' && c <= 'Z';
            if (capital && !text.empty()) text += ' ';
            text += capital ? static_cast<char>(c - 'A' + 'a') : c;
        }
        return text;
    }
    static std::string orderName(OrderKind kind) {
        switch (kind) {
            case OrderKind::Face:
                return "face";
            case OrderKind::Follow:
                return "follow";
            case OrderKind::Guard:
                return "guard";
            case OrderKind::Leave:
                return "leave";
            case OrderKind::Wait:
                return "wait";
            case OrderKind::Walk:
                return "walk";
            case OrderKind::Move:
                break;
        }
        return "move";
    }

    void thin() {
        const auto quarter = static_cast<std::uint32_t>(0.25 / stepTime_);
        std::map<std::pair<TakeMarkKind, std::string>, std::uint32_t> last;
        std::erase_if(marks_, [&](const TakeMark& mark) {
            const auto [found, first] = last.try_emplace({mark.kind, mark.label}, mark.step);
            if (first) return false;
            if (mark.step - found->second < quarter) return true;
            found->second = mark.step;
            return false;
        });
        if (marks_.size() > kMostMarks) marks_.resize(kMostMarks);
    }

    std::uint32_t steps_;
    double stepTime_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> down_;  // Steps, by client and touch.
    std::vector<TakeMark> marks_;
};

}  // namespace

std::vector<TakeMark> takeMarks(const Take& take) {
    Collector collector(take);
    for (const Command& command : take.commands) collector.command(command);
    for (const TakeEvent& event : take.events) collector.event(event);
    return collector.finish();
}

}  // namespace muster
