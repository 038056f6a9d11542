#include "studio/session/inbox/answers.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "base/maths.h"
#include "engine/state/validation.h"
#include "engine/world/studio_access.h"
#include "muster/views.h"

namespace muster {
namespace {

constexpr double kMostFacing = 1e4;  // Of a question [rad].

std::optional<GroupView> groupViewOf(const World& world, std::uint32_t id) {
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        GroupView view = world.group(g);
        if (view.id.value == id) return view;
    }
    return std::nullopt;
}

protocol::ForecastFrame answer(const World& world, const protocol::ForecastAsk& ask, const Order& order) {
    const GroupId group{ask.group};
    const Pose from{{ask.x, ask.y}, {cosine(ask.facing), sine(ask.facing)}};
    const OrderForecast forecast = ask.placed ? forecastFrom(world, group, order, from)
                                              : world.forecast(group, order);
    protocol::ForecastFrame frame = forecastFrame(group, forecast);
    frame.order = ask.order;
    return frame;
}

}  // namespace

protocol::ForecastFrame forecastFrame(GroupId group, const OrderForecast& forecast) {
    protocol::ForecastFrame frame;
    frame.group = group.value;
    frame.arrives = forecast.arrives;
    frame.seconds = static_cast<float>(forecast.seconds);
    frame.x = static_cast<float>(forecast.end.x);
    frame.y = static_cast<float>(forecast.end.y);
    for (const Vec2 p : forecast.way) {
        frame.way.push_back(static_cast<float>(p.x));
        frame.way.push_back(static_cast<float>(p.y));
    }
    return frame;
}

Result<protocol::Forecasts> answerForecasts(const World& world, const protocol::AskForecasts& message,
                                            const SessionLimits& limits) {
    const auto beyond = [](const char* what, std::size_t found, std::size_t most) {
        return Status(StatusCode::LimitExceeded, "found " + std::to_string(found) + " " + what +
                                                     ", expected at most " + std::to_string(most));
    };
    if (message.asks.size() > limits.forecastsPerMessage)
        return beyond("forecasts", message.asks.size(), limits.forecastsPerMessage);
    protocol::Forecasts answers;
    answers.number = message.number;
    for (const protocol::ForecastAsk& ask : message.asks) {
        if (!std::isfinite(ask.x) || !std::isfinite(ask.y) || !(std::fabs(ask.facing) <= kMostFacing))
            return Status(StatusCode::InvalidArgument, "a forecast from a place that is not finite");
        std::optional<Order> order;
        if (ask.order == 0) {
            if (!ask.asked) return Status(StatusCode::InvalidArgument, "a forecast of no order");
            if (const Status status = validate(*ask.asked); !status.ok()) return status;
            order = ask.asked;
        }
        const std::optional<GroupView> view = groupViewOf(world, ask.group);
        if (!view) continue;
        for (const QueuedOrder& queued : view->orders)
            if (ask.order != 0 && queued.id == ask.order) order = queued.order;
        if (order) answers.answers.push_back(answer(world, ask, *order));
    }
    return answers;
}

}  // namespace muster
