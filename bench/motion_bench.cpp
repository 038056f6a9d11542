// Benchmark of whole poses for a crowd: milliseconds per step, median and 95th percentile.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>

#include "base/stopwatch.h"
#include "muster/own_clips.h"
#include "people/motion/parade.h"

namespace {

using muster::testing::Parade;

// `count` characters of whom the first `near` get whole poses.
void motion(benchmark::State& state) {
    const auto count = static_cast<std::uint32_t>(state.range(0));
    Parade parade(count);
    muster::CrowdMotion crowd(muster::ownClips());
    std::vector<std::uint32_t> near(static_cast<std::size_t>(state.range(1)));
    std::iota(near.begin(), near.end(), 1u);
    crowd.setNear(near);
    for (int k = 0; k < 60; ++k) {
        parade.step();
        crowd.update(parade.view());
    }
    std::vector<double> times;
    for (auto _ : state) {
        state.PauseTiming();
        parade.step();
        state.ResumeTiming();
        const muster::Stopwatch watch;
        crowd.update(parade.view());
        times.push_back(watch.milliseconds());
    }
    std::sort(times.begin(), times.end());
    state.counters["p50_ms"] = times[times.size() / 2];
    state.counters["p95_ms"] = times[times.size() * 95 / 100];
}

// The choice of clips alone: nobody near.
void choiceOnly(benchmark::State& state) {
    motion(state);
}

}  // namespace

BENCHMARK(motion)->Args({1000, 1000})->Args({10000, 200})->Unit(benchmark::kMillisecond)->Iterations(600);
BENCHMARK(choiceOnly)->Args({1000, 0})->Args({10000, 0})->Unit(benchmark::kMillisecond)->Iterations(600);
