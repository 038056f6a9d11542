// What is in a form of its own among the fields of a whole world.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/scenario/clip_field.h"
#include "files/scenario/describe_forms.h"
#include "files/scenario/gestures_field.h"
#include "muster/parameter_table.h"

namespace muster {

inline std::vector<std::string> clipNames(const std::vector<ClipFacts>& clips) {
    std::vector<std::string> names;
    for (const ClipFacts& clip : clips) names.push_back(clip.name);
    return names;
}

/// The corner points [x, y] of the world box.
template <class Visitor>
void describeBox(Visitor& v, Box& box) {
    std::vector<Vec2> corners{box.min, box.max};
    v.points("box", corners, 2, 2,
             "Lower left and upper right corner of the world; left out: the map's, or 32 x 32 m about the "
             "origin.");
    if constexpr (Visitor::kReading) {
        if (!v.failed()) box = {corners[0], corners[1]};
    }
}

/// The box that the map covers.
Box mapBox(const MapGround& map);

/// Each returns true where a map was read or written.
bool describeMap(FieldReader& v, std::optional<MapGround>& map, const std::string& folder);
bool describeMap(FieldWriter& v, std::optional<MapGround>& map, const std::string& folder);
bool describeMap(FieldSchema& v, std::optional<MapGround>& map, const std::string& folder);

/// The map, which gives the box its size.
template <class Visitor>
void describeGround(Visitor& v, WorldDef& def, const std::string& folder) {
    if (describeMap(v, def.map, folder) && def.map) def.box = mapBox(*def.map);
}

template <class Visitor>
void describeClips(Visitor& v, std::vector<ClipFacts>& clips, const std::string& folder) {
    v.list("clips", clips, 1000,
           "Facts of motion clips; left out: run, walk, duck, crawl, swim, jump, climb, idle.",
           [&](auto& item, ClipFacts& clip) {
               // The first clip is running: all speeds are relative to it.
               const bool running = clips.empty() || &clip == &clips.front();
               describe(item, clip, folder, running ? 0.0 : runSpeed(clips));
           });
}

/// Patches name clips.
template <class Visitor>
void describePatches(Visitor& v, WorldDef& def) {
    const std::vector<std::string> motions = clipNames(def.clips);
    v.list("patches", def.patches, kMaxObstacles, "Ground that asks for another motion.",
           [&](auto& item, PatchDef& patch) { describe(item, patch, motions); });
}

/// Checkpoints name a group by its index, or concern any.
template <class Visitor>
void describeCheckpoints(Visitor& v, WorldDef& def) {
    const auto describeOne = [&](auto& item, FormationCheckpointDef& checkpoint) {
        describe(item, checkpoint, [&] {
            if (!takesPart<Visitor>(checkpoint.group >= 0)) return;
            const double most = Visitor::kSchema ? 999.0 : static_cast<double>(def.groups.size()) - 1.0;
            item.whole("group", checkpoint.group, {-1.0, most},
                       "Index of the group it concerns, from 0; -1 for any.");
        });
    };
    v.list("checkpoints", def.checkpoints, kMaxObstacles, "Spots that change the formation of a group.",
           describeOne);
}

/// Sources name a group by its index.
template <class Visitor>
void describeAreas(Visitor& v, WorldDef& def) {
    const auto describeOne = [&](auto& item, AreaDef& area) {
        describe(item, area, [&] {
            if (!takesPart<Visitor>(area.kind == AreaKind::Source || area.group != 0)) return;
            const double most = static_cast<double>(Visitor::kSchema ? kMaxGroups : def.groups.size()) - 1.0;
            item.whole("group", area.group, {0.0, most},
                       "For source: index of the group whom its people join, from 0.");
        });
    };
    v.list("areas", def.areas, kMaxAreas, "Where people leave, come and wait.", describeOne);
}

template <class Visitor>
void describePreset(Visitor& v, Parameters& parameters) {
    if constexpr (Visitor::kReading || Visitor::kSchema) {
        std::string preset = "units";
        v.choice("preset", preset, {"units", "people", "paper", "muster"},
                 "Where parameters start from; muster is the former name of units.");
        if (const auto found = parameterPreset(preset); found.ok()) parameters = *found;
    }
}

/// One number per parameter, from the table.
template <class Visitor>
void describeValues(Visitor& v, Parameters& parameters) {
    for (const ParameterInfo& info : parameterTable()) {
        double value = info.get(parameters);
        v.number(info.name, value, {info.minimum, info.maximum, info.unit, info.whole()}, info.description);
        if constexpr (Visitor::kReading) info.set(parameters, value);
    }
    if constexpr (Visitor::kReading) {
        double unused = 0.0;
        for (const std::string_view name : retiredParameters()) v.number(name, unused, {-1e9, 1e9, ""}, "");
    }
}

template <class Visitor>
void describeParameters(Visitor& v, Parameters& parameters) {
    describePreset(v, parameters);
    v.object("parameters", "Every number that may be changed.",
             [&](auto& inner) { describeValues(inner, parameters); });
}

}  // namespace muster
