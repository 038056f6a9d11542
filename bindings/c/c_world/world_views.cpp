// Read-outs of a world's characters, events and numbers.
#include "bindings/c/c_world/command_fields.h"
#include "bindings/c/c_world/generated/view_fields.h"
#include "bindings/c/c_world/layout.h"
#include "bindings/c/c_world/world_handle.h"
#include "muster/parameter_table.h"

namespace muster::c_api {
namespace {

/// The parameter of that name; null where there is none.
const ParameterInfo* findParameter(const char* name) {
    for (const ParameterInfo& info : parameterTable())
        if (info.name == name) return &info;
    return nullptr;
}

}  // namespace

template <class M>
void fields(M& m, C<M, MusterRejection>& c, P<M, Rejection>& p) {
    m.part(c.command, p.command, "command");
    c.status = static_cast<MusterStatus>(p.status.code());
    c.message = p.status.message().c_str();
}

}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterCharacters muster_default_characters(void) {
    MusterCharacters none{};
    none.structVersion = StructVersion<MusterCharacters>::kValue;
    return none;
}

MusterStatus muster_world_step_count(MusterWorldId world, uint32_t* outSteps) {
    return readValue(world, outSteps, "outSteps", [](const World& own) { return own.stepCount(); });
}

MusterStatus muster_world_time(MusterWorldId world, double* outSeconds) {
    return readValue(world, outSeconds, "outSeconds", [](const World& own) { return own.time(); });
}

MusterStatus muster_world_last_command_step(MusterWorldId world, uint32_t* outStep) {
    return readValue(world, outStep, "outStep", [](const World& own) { return own.lastCommandStep(); });
}

MusterStatus muster_world_parameter(MusterWorldId world, const char* name, double* outValue) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status given = needPointers({"name", "outValue"}, name, outValue); !given.ok())
            return given;
        const ParameterInfo* const info = findParameter(name);
        if (info == nullptr) {
            Parameters none;
            return setParameter(none, name, 0.0);
        }
        *outValue = info->get(handle.world().parameters());
        return {};
    });
}

MusterStatus muster_world_characters(MusterWorldId world, MusterCharacters* outCharacters) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status fits = needStruct(outCharacters, "outCharacters"); !fits.ok()) return fits;
        Arena none;
        *outCharacters = writeC<MusterCharacters>(handle.world().characters(), none);
        return {};
    });
}

MusterStatus muster_world_way_ahead(MusterWorldId world, int32_t character, const MusterVec2** outPoints,
                                    int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status given = needPointers({"outPoints", "outCount"}, outPoints, outCount); !given.ok())
            return given;
        const std::size_t count = handle.world().characters().size();
        if (character < 0 || static_cast<std::size_t>(character) >= count)
            return invalidArgument("character: found index " + std::to_string(character) +
                                   ", expected one below " + std::to_string(count));
        const std::vector<Vec2> way = handle.world().wayAhead(static_cast<std::size_t>(character));
        *outPoints = copyOf<MusterVec2>(way, handle.lend(Lent::WayAhead));
        *outCount = static_cast<std::int32_t>(way.size());
        return {};
    });
}

MusterStatus muster_world_standings(MusterWorldId world, const uint8_t** outStandings, int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status given = needPointers({"outStandings", "outCount"}, outStandings, outCount);
            !given.ok())
            return given;
        const std::vector<Standing> standings = handle.world().standings();
        *outStandings = copyOf<std::uint8_t>(standings, handle.lend(Lent::Standings));
        *outCount = static_cast<std::int32_t>(standings.size());
        return {};
    });
}

MusterStatus muster_world_events(MusterWorldId world, const MusterEvent** outEvents, int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) {
        return giveSpan(handle.world().events(), outEvents, "outEvents", outCount);
    });
}

MusterStatus muster_world_rejections(MusterWorldId world, const MusterRejection** outRejections,
                                     int32_t* outCount) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status given = needPointers({"outRejections", "outCount"}, outRejections, outCount);
            !given.ok())
            return given;
        *outRejections = writeAll<MusterRejection>(handle.world().rejections(), handle.lend(Lent::Rejections),
                                                   *outCount);
        return {};
    });
}

MusterStatus muster_world_contacts(MusterWorldId world, MusterContacts* outContacts) {
    return readValue(world, outContacts, "outContacts", [](const World& own) {
        const ContactReport report = own.contacts();
        return MusterContacts{report.overlapPairs, report.worstPenetration};
    });
}

MusterStatus muster_world_stage_times(MusterWorldId world, const MusterStageTime** outStages,
                                      int32_t* outCount, double* outTotal) {
    return readWorld(world, [&](WorldHandle& handle) -> Status {
        if (const Status given = needPointers({"outStages", "outCount", "outTotal"}, outStages, outCount,
                                              outTotal);
            !given.ok())
            return given;
        const StageTimes times = handle.world().stageTimes();
        const std::size_t count = times.milliseconds.size();
        auto* const stages = handle.lend(Lent::StageTimes).make<MusterStageTime>(count);
        for (std::size_t i = 0; i < count; ++i)
            stages[i] = {stepStages()[i].name.data(), times.milliseconds[i]};
        *outStages = stages;
        *outCount = static_cast<std::int32_t>(count);
        *outTotal = times.total;
        return {};
    });
}

const char* muster_event_name(MusterEventKind kind) {
    return kind < MUSTER_EVENT_COUNT ? eventKindName(static_cast<EventKind>(kind)) : nullptr;
}
