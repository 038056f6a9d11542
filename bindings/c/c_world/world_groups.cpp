// Read-outs of a world's groups.
#include "bindings/c/c_world/generated/view_fields.h"
#include "bindings/c/c_world/layout.h"
#include "bindings/c/c_world/world_handle.h"

namespace muster::c_api {

namespace {

Status checkGroup(const World& world, std::int32_t index) {
    if (index >= 0 && static_cast<std::size_t>(index) < world.groupCount()) return {};
    return invalidArgument("group: found index " + std::to_string(index) + ", expected one below " +
                           std::to_string(world.groupCount()));
}

/// The index of a group; -1 where there is none of that id.
std::int32_t indexOfGroup(const World& world, MusterGroupId id) {
    for (std::size_t i = 0; i < world.groupCount(); ++i)
        if (world.group(i).id.value == id) return static_cast<std::int32_t>(i);
    return -1;
}

Status noGroup(MusterGroupId id) {
    return {StatusCode::NotFound, "group: found no group of id " + std::to_string(id) + ", expected one"};
}

std::int32_t sizeOf(std::size_t size) {
    return static_cast<std::int32_t>(size);
}

}  // namespace
}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterGroup muster_default_group(void) {
    MusterGroup none{};
    none.structVersion = StructVersion<MusterGroup>::kValue;
    return none;
}

MusterForecast muster_default_forecast(void) {
    MusterForecast none{};
    none.structVersion = StructVersion<MusterForecast>::kValue;
    return none;
}

MusterStatus muster_world_group_count(MusterWorldId world, int32_t* outCount) {
    return readValue(world, outCount, "outCount", [](const World& own) { return sizeOf(own.groupCount()); });
}

MusterStatus muster_world_group(MusterWorldId world, int32_t index, MusterGroup* outGroup) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status fits = needStruct(outGroup, "outGroup"); !fits.ok()) return fits;
        if (const Status known = checkGroup(handle.world(), index); !known.ok()) return known;
        Arena none;
        *outGroup = writeC<MusterGroup>(handle.world().group(static_cast<std::size_t>(index)), none);
        return {};
    });
}

MusterStatus muster_world_group_index(MusterWorldId world, MusterGroupId group, int32_t* outIndex) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (outIndex == nullptr) return nullArgument("outIndex");
        const std::int32_t index = indexOfGroup(handle.world(), group);
        if (index < 0) return noGroup(group);
        *outIndex = index;
        return {};
    });
}

MusterStatus muster_world_group_def(MusterWorldId world, int32_t index, MusterGroupDef* outDef) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status fits = needStruct(outDef, "outDef"); !fits.ok()) return fits;
        if (const Status known = checkGroup(handle.world(), index); !known.ok()) return known;
        *outDef = writeC<MusterGroupDef>(
            handle.keep(handle.world().groupDef(static_cast<std::size_t>(index))),
            handle.lend(Lent::GroupDef));
        return {};
    });
}

MusterStatus muster_world_group_controls(MusterWorldId world, int32_t index,
                                         const MusterControl** outControls, int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status given = needPointers({"outControls", "outCount"}, outControls, outCount);
            !given.ok())
            return given;
        if (const Status known = checkGroup(handle.world(), index); !known.ok()) return known;
        const GroupView view = handle.world().group(static_cast<std::size_t>(index));
        *outControls = writeAll<MusterControl>(view.controls, handle.lend(Lent::Controls), *outCount);
        return {};
    });
}

MusterStatus muster_world_group_orders(MusterWorldId world, int32_t index,
                                       const MusterQueuedOrder** outOrders, int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status given = needPointers({"outOrders", "outCount"}, outOrders, outCount); !given.ok())
            return given;
        if (const Status known = checkGroup(handle.world(), index); !known.ok()) return known;
        const GroupView view = handle.world().group(static_cast<std::size_t>(index));
        *outOrders = writeAll<MusterQueuedOrder>(view.orders, handle.lend(Lent::Orders), *outCount);
        return {};
    });
}

MusterStatus muster_world_forecast(MusterWorldId world, MusterGroupId group, const MusterOrder* order,
                                   MusterForecast* outForecast) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status fits = needStruct(outForecast, "outForecast"); !fits.ok()) return fits;
        GiveOrder given;
        given.group = {group};
        if (const Status fits = readC(order, given.order, "order"); !fits.ok()) return fits;
        if (indexOfGroup(handle.world(), group) < 0) return noGroup(group);
        if (const Status valid = validateCommand({0, 0, 0, given}); !valid.ok()) return valid;
        const OrderForecast forecast = handle.world().forecast(given.group, given.order);
        MusterForecast& out = *outForecast;
        out.arrives = forecast.arrives;
        out.way = copyOf<MusterVec2>(forecast.way, handle.lend(Lent::Forecast));
        out.wayCount = sizeOf(forecast.way.size());
        out.end = {forecast.end.x, forecast.end.y};
        out.seconds = forecast.seconds;
        return {};
    });
}
