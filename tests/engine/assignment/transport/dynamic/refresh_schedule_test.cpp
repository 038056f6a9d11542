#include "engine/assignment/transport/dynamic/refresh_schedule.h"

#include <doctest.h>

#include <vector>

using muster::RefreshSchedule;

TEST_CASE("in a period every node is due once, spread evenly over its rounds and steps") {
    std::vector<int> costs(100, 0);
    std::vector<int> heads(100, 0);
    for (std::int32_t round = 0; round < 16; ++round)
        for (std::int32_t step = 0; step < 2; ++step) {
            RefreshSchedule schedule;
            schedule.round = round;
            schedule.first = 50 * step;
            schedule.end = 50 * (step + 1);
            schedule.period = 4;
            schedule.candidatePeriod = 16;
            int due = 0;
            for (std::int32_t node = 0; node < 100; ++node) {
                costs[node] += schedule.costsDue(node) ? 1 : 0;
                heads[node] += schedule.headsDue(node) ? 1 : 0;
                due += schedule.costsDue(node) ? 1 : 0;
            }
            CHECK(due >= 12);
            CHECK(due <= 13);
        }
    CHECK(costs == std::vector<int>(100, 4));
    CHECK(heads == std::vector<int>(100, 1));
}

TEST_CASE("every fourth refresh of a node evaluates all its arcs") {
    for (std::int32_t node = 0; node < 20; ++node) {
        int all = 0;
        for (std::int32_t round = 0; round < 64; ++round) {
            RefreshSchedule schedule;
            schedule.round = round;
            schedule.end = 20;
            schedule.period = 4;
            all += schedule.costsDue(node) && schedule.allArcsDue(node) ? 1 : 0;
        }
        CHECK(all == 4);
    }
}
