#include "scale/quality.h"

#include <algorithm>
#include <cstdio>

#include "base/stopwatch.h"

namespace muster::scale {
namespace {

constexpr std::uint32_t kFirstLook = 2;

}  // namespace

Committed committedBy(const World& world) {
    const CharactersView characters = world.characters();
    Committed plan;
    for (const std::int32_t i : world.group(0).members) {
        plan.characters.push_back(characters.position[i]);
        plan.placeOf.push_back(characters.place[i]);
    }
    const std::span<const Vec2> places = world.group(0).placePositions;
    plan.places.assign(places.begin(), places.end());
    plan.exponent = world.parameters().plan.exponent;
    return plan;
}

std::int32_t looksEvery(std::int32_t every, const SceneDef& scene) {
    return every * std::max(1, scene.count / (scene.regime == Regime::Far ? 250 : 10000));
}

QualityPass::QualityPass(std::int32_t every, std::string label, ThreadPool& pool)
    : every_(every), label_(std::move(label)), pool_(pool) {}

void QualityPass::observe(const World& world) {
    const bool first = world.stepCount() == kFirstLook;
    if (!status_.ok() || (!first && world.stepCount() % static_cast<std::uint32_t>(every_) != 0)) return;
    look(world);
}

const UnitCost* QualityPass::costFor(const World& world, const Committed& plan) {
    double sum = 0.0;
    std::int32_t matched = 0;
    for (std::size_t i = 0; i < plan.placeOf.size(); ++i) {
        if (plan.placeOf[i] < 0) continue;
        sum += distance(plan.characters[i], plan.places[plan.placeOf[i]]);
        ++matched;
    }
    const bool far = sum > kCoarseDistance * matched;
    std::optional<FineGround>& ground = far ? coarse_ : fine_;
    if (!ground) {
        Result<FineGround> made = FineGround::create(world, far ? 1.0 : 0.5);
        status_ = made.status();
        if (!status_.ok()) return nullptr;
        ground = *std::move(made);
    }
    return &ground->update(world);
}

void QualityPass::look(const World& world) {
    const Stopwatch watch;
    const Committed plan = committedBy(world);
    const UnitCost* cost = costFor(world, plan);
    if (cost == nullptr) return;
    const bool exact = static_cast<std::int32_t>(plan.characters.size()) <= kMostExact;
    Verdict verdict;
    if (exact) {
        Result<Verdict> judged = judgeExactly(*cost, plan, pool_);
        status_ = judged.status();
        if (!status_.ok()) return;
        verdict = *judged;
    } else {
        verdict = judgeByBound(*cost, plan, pool_);
    }
    const double gap = 100.0 * verdict.gap(plan.exponent);
    quality_.judge = exact ? "exact" : "bound";
    if (world.stepCount() == kFirstLook) {
        quality_.gapCold = gap;
    } else {
        const double looks = ++quality_.looks;
        quality_.gapMax = std::max(quality_.gapMax, gap);
        quality_.gapMean += (gap - quality_.gapMean) / looks;
        quality_.objectiveMean += (verdict.committed / std::max(1, verdict.matched) -
                                   quality_.objectiveMean) /
                                  looks;
    }
    if (label_.empty()) return;
    std::fprintf(stderr, "%s: step %u: gap %.4f %%, objective %.4f each of %d, %d rounds, %.0f ms\n",
                 label_.c_str(), world.stepCount(), gap, verdict.committed / std::max(1, verdict.matched),
                 verdict.matched, verdict.rounds, watch.milliseconds());
}

}  // namespace muster::scale
