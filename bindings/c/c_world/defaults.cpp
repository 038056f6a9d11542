// Definitions by hand: parameters, maps, people, orders.
#include "bindings/c/c_world/default_of.h"
#include "bindings/c/c_world/layout.h"
#include "bindings/c/c_world/world_fields.h"
#include "muster/muster.h"
#include "muster/parameter_table.h"

namespace muster::c_api {

void parameterFields(FromC& m, const MusterWorldDef& c, Parameters& p) {
    Result<Parameters> preset = parameterPreset(c.preset == nullptr ? "units" : c.preset);
    if (!preset.ok()) return m.fail(preset.status());
    p = *preset;
    std::vector<MusterParameterValue> values;
    m.list(c.parameters, c.parameterCount, values, "parameters");
    for (std::size_t i = 0; i < values.size(); ++i) {
        const char* const name = values[i].name;
        const Status set = name == nullptr ? nullArgument("name") : setParameter(p, name, values[i].value);
        if (!set.ok()) return m.fail(set.within("parameters[" + std::to_string(i) + "]"));
    }
}

void parameterFields(ToC& m, MusterWorldDef& c, const Parameters& p) {
    const Parameters standard;
    auto* const values = m.arena().make<MusterParameterValue>(parameterTable().size());
    c.preset = nullptr;
    c.parameters = values;
    c.parameterCount = 0;
    for (const ParameterInfo& info : parameterTable())
        if (info.get(p) != info.get(standard)) values[c.parameterCount++] = {info.name.data(), info.get(p)};
}

}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterMapDef muster_default_map_def(void) {
    return defaultOf<MusterMapDef, MapGround>();
}

MusterPeopleDef muster_adults(void) {
    static const PeopleDef& value = *new PeopleDef(adults());
    static Arena& arena = *new Arena;
    static const MusterPeopleDef made = writeC<MusterPeopleDef>(value, arena);
    return made;
}

double muster_walking_speed_at_age(double years) {
    return walkingSpeedAtAge(years);
}

MusterStatus muster_distribution_quantile(const MusterDistribution* distribution, double share,
                                          double* outValue) {
    return call([&]() -> Status {
        if (outValue == nullptr) return nullArgument("outValue");
        Distribution drawn;
        if (const Status fits = readC(distribution, drawn, "distribution"); !fits.ok()) return fits;
        if (!(share > 0.0 && share < 1.0))
            return invalidArgument("share: found " + std::to_string(share) + ", expected a number in (0, 1)");
        *outValue = drawn.quantile(share);
        return {};
    });
}

MusterOrder muster_order_to_line(MusterVec2 left, MusterVec2 right) {
    const Order line = Order::moveToLine({left.x, left.y}, {right.x, right.y});
    MusterOrder order = muster_default_order();
    order.target = {line.target.x, line.target.y};
    order.hasFacing = line.facing.has_value();
    order.facing = line.facing.value_or(0.0);
    order.width = line.width;
    return order;
}

const MusterClipFacts* muster_own_clip_facts(int32_t* outCount) {
    const MusterWorldDef& world = defaultOf<MusterWorldDef, WorldDef>();
    if (outCount != nullptr) *outCount = world.clipCount;
    return world.clips;
}

int32_t muster_parameter_count(void) {
    return static_cast<std::int32_t>(parameterTable().size());
}

MusterStatus muster_parameter_info(int32_t index, MusterParameterInfo* outInfo) {
    return call([&]() -> Status {
        if (outInfo == nullptr) return nullArgument("outInfo");
        if (index < 0 || index >= muster_parameter_count())
            return invalidArgument("parameter: found index " + std::to_string(index) +
                                   ", expected one below " + std::to_string(muster_parameter_count()));
        const ParameterInfo& info = parameterTable()[static_cast<std::size_t>(index)];
        *outInfo = {info.name.data(),       info.unit.data(), info.minimum,           info.maximum,
                    info.get(Parameters{}), info.whole(),     info.description.data()};
        return {};
    });
}

MusterStatus muster_preset_value(const char* preset, const char* name, double* outValue) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"preset", "name", "outValue"}, preset, name, outValue);
            !given.ok())
            return given;
        Result<Parameters> parameters = parameterPreset(preset);
        if (!parameters.ok()) return parameters.status();
        for (const ParameterInfo& info : parameterTable())
            if (info.name == name) {
                *outValue = info.get(*parameters);
                return {};
            }
        return setParameter(*parameters, name, 0.0);
    });
}
