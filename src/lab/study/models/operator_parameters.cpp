#include "lab/study/models/operator_parameters.h"

#include <array>
#include <charconv>
#include <cstdio>

#include "base/random.h"

namespace muster {
namespace {

constexpr std::uint64_t kHypercubeSeed = 20261124;

DeviceParameters mouseDefaults() {
    return {.pointBase = 0.17,
            .pointSlope = 0.18,
            .press = 0.1,
            .dragBase = 0.135,
            .dragSlope = 0.249,
            .steerBase = 0.1,
            .steerSlope = 0.08,
            .drawSpeed = 400.0,
            .scatterShare = 1.0 / 4.13,
            .wobble = 1.5,
            .latency = 0.03};
}

DeviceParameters touchDefaults() {
    return {.pointBase = 0.2,
            .pointSlope = 0.115,
            .dragBase = 1.18 * 0.135,
            .dragSlope = 1.18 * 0.249,
            .steerBase = 1.2 * 0.1,
            .steerSlope = 1.2 * 0.08,
            .lostWidth = 4.0,
            .drawSpeed = 250.0,
            .scatterShare = 0.0955,
            .scatterLeast = 1.22,
            .wobble = 2.5,
            .latency = 0.08,
            .handOff = 0.4};
}

constexpr std::string_view kOwn = "our own assumption";
constexpr std::string_view
    kFitts = "Yamanaka and MacKenzie 2026 (342 people, neutral instruction), rounded; range over studies";
constexpr std::string_view kTap =
    "three quarters of the mouse at 3 to 4 bits (Sasangohar et al. 2009), and the tablet line of 2016; up to "
    "no gain";
constexpr std::string_view kDrag = "MacKenzie, Sellen and Buxton 1991";
constexpr std::string_view
    kTouchDrag = "1.18 times the mouse (Forlines et al. 2007); 0.84 (Findlater et al. 2013) to 1.35";
constexpr std::string_view
    kSteer = "steering law of Accot and Zhai 1997, 1999; slope between stylus and classroom figures";
constexpr std::string_view kKeystroke = "keystroke-level model, Card, Moran and Newell 1980";
constexpr std::string_view kChoice = "Cockburn et al. 2007";

#define MUSTER_AT(field) [](OperatorParameters& p) -> double& { return p.field; }

constexpr std::array kConstants = std::to_array<OperatorConstant>({
    {"mouse.point-base", "s", 0.1, 0.3, kFitts, MUSTER_AT(mouse.pointBase)},
    {"mouse.point-slope", "s", 0.14, 0.225, kFitts, MUSTER_AT(mouse.pointSlope)},
    {"mouse.press", "s", 0.07, 0.15, kKeystroke, MUSTER_AT(mouse.press)},
    {"mouse.drag-base", "s", 0.1, 0.2, kDrag, MUSTER_AT(mouse.dragBase)},
    {"mouse.drag-slope", "s", 0.2, 0.3, kDrag, MUSTER_AT(mouse.dragSlope)},
    {"mouse.steer-slope", "s", 0.06, 0.15, kSteer, MUSTER_AT(mouse.steerSlope)},
    {"mouse.draw-speed", "mm/s", 200.0, 600.0, kOwn, MUSTER_AT(mouse.drawSpeed)},
    {"mouse.scatter-share", "", 0.121, 0.484, "4 % misses: width over 4.13 (MacKenzie 1992)",
     MUSTER_AT(mouse.scatterShare)},
    {"mouse.latency", "s", 0.01, 0.06, kOwn, MUSTER_AT(mouse.latency)},
    {"touch.point-base", "s", 0.1, 0.336, kTap, MUSTER_AT(touch.pointBase)},
    {"touch.point-slope", "s", 0.073, 0.18, kTap, MUSTER_AT(touch.pointSlope)},
    {"touch.drag-base", "s", 0.113, 0.182, kTouchDrag, MUSTER_AT(touch.dragBase)},
    {"touch.drag-slope", "s", 0.209, 0.336, kTouchDrag, MUSTER_AT(touch.dragSlope)},
    {"touch.steer-slope", "s", 0.06, 0.225, kSteer, MUSTER_AT(touch.steerSlope)},
    {"touch.lost-width", "mm", 0.0, 8.0, kOwn, MUSTER_AT(touch.lostWidth)},
    {"touch.draw-speed", "mm/s", 150.0, 600.0, kOwn, MUSTER_AT(touch.drawSpeed)},
    {"touch.scatter-least", "mm", 0.6, 2.44, "Bi and Zhai 2016", MUSTER_AT(touch.scatterLeast)},
    {"touch.wobble", "mm", 0.0, 5.0, kOwn, MUSTER_AT(touch.wobble)},
    {"touch.latency", "s", 0.02, 0.15, "Ng et al. 2012, devices of 50 to 200 ms", MUSTER_AT(touch.latency)},
    {"touch.hand-off", "s", 0.2, 0.6, kKeystroke, MUSTER_AT(touch.handOff)},
    {"hands", "", 1.0, 2.0, "Kin, Agrawala and DeRose 2009: one finger gives most of the gain",
     MUSTER_AT(hands)},
    {"second-hand", "s", 0.0, 0.5, kOwn, MUSTER_AT(secondHand)},
    {"key", "s", 0.12, 0.28, kKeystroke, MUSTER_AT(key)},
    {"reaction", "s", 0.2, 0.4, "Woods et al. 2015", MUSTER_AT(reaction)},
    {"take-in-item", "s", 0.0, 0.15, kOwn, MUSTER_AT(takeInItem)},
    {"decide", "s", 0.6, 1.35, kKeystroke, MUSTER_AT(decide)},
    {"decide-next", "s", 0.1, 0.6, kOwn, MUSTER_AT(decideNext)},
    {"choose-base", "s", 0.12, 0.48, kChoice, MUSTER_AT(chooseBase)},
    {"attention", "s", 0.2, 1.0, kOwn, MUSTER_AT(attention)},
    {"groups-in-mind", "", 2.0, 6.0, "Alvarez and Franconeri 2007", MUSTER_AT(groupsInMind)},
    {"replan", "s", 0.5, 2.0, kOwn, MUSTER_AT(replan)},
    {"route-detour", "", 0.0, 0.2, "MacGregor and Ormerod 1996; Dry et al. 2006", MUSTER_AT(routeDetour)},
    {"noise", "", 0.0, 0.5, kOwn, MUSTER_AT(noise)},
    {"between", "", 0.1, 0.35, "Rajanna and Hammond 2022, mouse", MUSTER_AT(between)},
});

#undef MUSTER_AT

OperatorParameters defaults() {
    return {.mouse = mouseDefaults(), .touch = touchDefaults()};
}

// Each range is cut into as many strata as there are draws, and each stratum of each range is drawn once.
OperatorParameters hypercubeDraw(std::int32_t row) {
    OperatorParameters p = defaults();
    Random random(kHypercubeSeed);
    for (const OperatorConstant& constant : kConstants) {
        std::array<std::int32_t, kHypercubeDraws> strata{};
        for (std::int32_t i = 0; i < kHypercubeDraws; ++i) strata[i] = i;
        for (std::int32_t i = kHypercubeDraws - 1; i > 0; --i)
            std::swap(strata[i], strata[random.below(static_cast<std::uint32_t>(i) + 1)]);
        std::array<double, kHypercubeDraws> within{};
        for (double& w : within) w = random.uniform();
        const double share = (strata[row] + within[row]) / kHypercubeDraws;
        constant.at(p) = constant.low + share * (constant.high - constant.low);
    }
    return p;
}

Status unknownSetting(const std::string& setting) {
    return {StatusCode::NotFound, "no setting of the operators is called '" + setting.substr(0, 60) +
                                      "'; expected default, equal-motor, NAME=VALUE or draw 0 to " +
                                      std::to_string(kHypercubeDraws - 1)};
}

}  // namespace

std::span<const OperatorConstant> operatorConstants() {
    return kConstants;
}

Result<OperatorParameters> operatorSetting(const std::string& setting) {
    OperatorParameters p = defaults();
    if (setting == "default") return p;
    if (setting == "equal-motor") {
        p.touch = p.mouse;
        p.secondHand = 0.0;
        return p;
    }
    if (setting.starts_with("draw ")) {
        std::int32_t row = -1;
        const char* end = setting.data() + setting.size();
        const auto read = std::from_chars(setting.data() + 5, end, row);
        if (read.ec != std::errc{} || read.ptr != end || row < 0 || row >= kHypercubeDraws)
            return unknownSetting(setting);
        return hypercubeDraw(row);
    }
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) return unknownSetting(setting);
    for (const OperatorConstant& constant : kConstants) {
        if (constant.name != setting.substr(0, equals)) continue;
        const char* end = setting.data() + setting.size();
        double value = 0.0;
        const auto read = std::from_chars(setting.data() + equals + 1, end, value);
        if (read.ec != std::errc{} || read.ptr != end || !(value >= constant.low && value <= constant.high))
            return Status{StatusCode::ParseError, "found " + setting.substr(0, 60) +
                                                      ", expected a value in the range of " +
                                                      std::string(constant.name)};
        constant.at(p) = value;
        return p;
    }
    return unknownSetting(setting);
}

std::vector<std::string> oneAtATimeSettings() {
    std::vector<std::string> settings;
    for (const OperatorConstant& constant : kConstants) {
        for (const double value : {constant.low, constant.high}) {
            char text[80];
            std::snprintf(text, sizeof(text), "%s=%.4g", std::string(constant.name).c_str(), value);
            settings.emplace_back(text);
        }
    }
    return settings;
}

}  // namespace muster
