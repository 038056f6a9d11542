#include "studio/session/frames/scene_signature.h"

#include "base/archive.h"
#include "base/hash.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

constexpr std::uint32_t kNoColour = 0xFFFFFFFF;
constexpr std::uint8_t kUnchosen = 0xFF;

}  // namespace

std::uint64_t sceneSignature(const World& world) {
    Hash hash;
    hash.add(inspect::environment(world).staticVersion());
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView view = world.group(g);
        hash.add(view.id.value);
        for (const char c : view.name) hash.add(static_cast<std::uint8_t>(c));
        hash.add(view.colour.value_or(kNoColour));
        hash.add(view.build ? static_cast<std::uint8_t>(*view.build) : kUnchosen);
        hash.add(view.motions ? static_cast<std::uint8_t>(*view.motions) : kUnchosen);
    }
    for (std::size_t i = 0; i < world.items().size(); ++i) {
        hash.add(world.itemIds()[i].value);
        hash.add(world.items()[i].position.x);
        hash.add(world.items()[i].position.y);
        hash.add(world.items()[i].radius);
    }
    for (std::size_t c = 0; c < world.checkpoints().size(); ++c) {
        hash.add(world.checkpointIds()[c].value);
        hash.add(world.checkpoints()[c].position.x);
        hash.add(world.checkpoints()[c].position.y);
        hash.add(world.checkpoints()[c].radius);
    }
    for (std::size_t a = 0; a < world.areaCount(); ++a) {
        AreaView area = world.area(a);
        hash.add(area.id.value);
        hash.add(area.group.value);
        Hasher def;
        def(area.def);
        hash.add(def.value());
    }
    for (const ParameterInfo& info : parameterTable()) hash.add(info.get(world.parameters()));
    return hash.value();
}

}  // namespace muster
