#include "scale/fine_ground.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"

namespace muster::scale {

Result<FineGround> FineGround::create(const World& world, double factor) {
    const Environment& coarse = inspect::environment(world);
    EnvironmentDef def = coarse.def();
    def.cell *= factor;
    Result<Environment> environment = Environment::create(def);
    if (!environment.ok()) return environment.status().within("judge");
    for (const ObstacleId id : coarse.obstacleIds())
        if (const auto added = environment->addObstacle(*coarse.obstacle(id)); !added.ok())
            return added.status();
    for (const PatchId id : coarse.patchIds())
        if (const auto added = environment->addPatch(*coarse.patch(id)); !added.ok()) return added.status();
    FineGround ground;
    ground.environment_ = *std::move(environment);
    const Parameters& parameters = world.parameters();
    ground.density_ = DensityField(def.box, parameters.density);
    return ground;
}

const UnitCost& FineGround::update(const World& world) {
    environment_.setTime(inspect::environment(world).time());
    density_.splat(world.characters().position, world.characters().velocity);
    builder_.build(world.parameters(), environment_, density_, world.parameters().character.radius, cost_);
    return cost_;
}

}  // namespace muster::scale
