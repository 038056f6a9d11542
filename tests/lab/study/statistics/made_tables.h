// Made tables with known effects.
#pragma once

#include <array>
#include <vector>

#include "base/random.h"
#include "lab/study/statistics/mixed_model.h"

namespace muster::testing {

/// Nearly normal: a sum of twelve uniform numbers.
inline double bell(Random& random) {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += random.uniform();
    return sum;
}

/// How a table is made.
struct TableDef {
    int people = 16;
    std::array<double, 4> effects{0.0, 0.0, 0.0, 0.0};  ///< Of touch, by environment, on log times.
    double person = 0.3, slope = 0.1, layout = 0.1, residual = 0.15;
    bool missing = false;  ///< Every seventh trial is missing.
};

inline std::vector<statistics::MixedRow> madeTable(const TableDef& def, std::uint64_t seed) {
    Random random(seed);
    std::array<double, 8> layouts{};
    for (double& layout : layouts) layout = def.layout * bell(random);
    std::vector<statistics::MixedRow> rows;
    int number = 0;
    for (int person = 0; person < def.people; ++person) {
        const double own = def.person * bell(random), slope = def.slope * bell(random);
        for (int touch = 0; touch < 2; ++touch) {
            for (int e = 0; e < 4; ++e) {
                statistics::MixedRow row{.environment = e,
                                         .touch = touch == 1,
                                         .period = (touch == 1) == (person % 2 == 1) ? 1.0 : 2.0,
                                         .order = 1.0 * (person % 2),
                                         .person = person,
                                         .layout = 2 * e + (person / 2 + touch) % 2};
                row.logTime = 3.5 + 0.2 * e + own - 0.05 * row.period + def.residual * bell(random) +
                              layouts[static_cast<std::size_t>(row.layout)];
                if (row.touch) row.logTime += slope + def.effects[static_cast<std::size_t>(e)];
                if (!def.missing || ++number % 7 != 0) rows.push_back(row);
            }
        }
    }
    return rows;
}

}  // namespace muster::testing
