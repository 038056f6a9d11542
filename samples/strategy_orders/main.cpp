// Two groups under the orders of a strategy game: march along a drawn path, turn into a line, go there and
// face that way.
#include <muster/world.h>

#include <cstdio>
#include <initializer_list>

namespace {

/// Turns orders of one player into commands of a world, which apply in the next step.
class Player {
public:
    Player(muster::World& world, std::uint32_t client) : world_(world), client_(client) {}

    /// Moves the formation to a position at once; the places travel there on paths that people can walk, and
    /// the people follow.
    void goTo(muster::GroupId group, muster::Vec2 position, double facing) {
        send(muster::SetPose{group, position, facing});
    }
    /// Gives the group another formation where it stands.
    void form(muster::GroupId group, muster::FormationKind kind) {
        muster::FormationDef formation;
        formation.kind = kind;
        send(muster::SetFormation{group, formation});
    }
    /// Draws a path from the middle of the group through these points, 1 s each. The formation follows it,
    /// bends past what is in its way, and waits for people who cannot keep up.
    void march(muster::GroupId group, muster::Vec2 from, std::initializer_list<muster::Vec2> points) {
        const std::uint32_t finger = nextFinger_++;
        double time = world_.time();
        send(muster::TouchDown{finger, from, time, group});
        for (const muster::Vec2 point : points) send(muster::TouchMove{finger, point, time += 1.0});
        send(muster::TouchUp{finger, time});
    }
    /// True while the world took every order.
    bool obeyed() const { return obeyed_; }

private:
    void send(muster::CommandBody body) {
        const muster::Status status = world_.submit(
            {world_.stepCount(), client_, sequence_++, std::move(body)});
        if (!status.ok()) std::fprintf(stderr, "%s\n", status.message().c_str());
        obeyed_ = obeyed_ && status.ok();
    }

    muster::World& world_;
    std::uint32_t client_;
    std::uint32_t sequence_ = 0;
    std::uint32_t nextFinger_ = 1;
    bool obeyed_ = true;
};

muster::WorldDef battlefield() {
    muster::WorldDef def;
    def.box = {{-40.0, -40.0}, {40.0, 40.0}};
    muster::ObstacleDef house;
    house.polygon = {{-4.0, -6.0}, {4.0, -6.0}, {4.0, 6.0}, {-4.0, 6.0}};
    def.obstacles.push_back(house);
    for (const double y : {-15.0, 15.0}) {
        muster::GroupDef group;
        group.name = y < 0.0 ? "South" : "North";
        group.count = 36;
        group.position = {-25.0, y};
        def.groups.push_back(group);
    }
    return def;
}

/// Advances and counts orders that the world could not carry out, say for a group that is gone.
std::size_t advance(muster::World& world, double seconds) {
    std::size_t rejected = 0;
    for (const double end = world.time() + seconds; world.time() < end;) {
        world.step();
        for (const muster::Rejection& rejection : world.rejections()) {
            std::fprintf(stderr, "%s\n", rejection.status.message().c_str());
            ++rejected;
        }
    }
    return rejected;
}

}  // namespace

int main() {
    muster::Result<muster::World> made = muster::World::create(battlefield());
    if (!made.ok()) {
        std::fprintf(stderr, "%s\n", made.status().message().c_str());
        return 1;
    }
    muster::World& world = *made;
    const muster::GroupId south = world.group(0).id, north = world.group(1).id;
    Player player(world, 1);
    player.march(south, {-25.0, -15.0}, {{-10.0, -12.0}, {0.0, -14.0}, {15.0, -12.0}});
    player.goTo(north, {20.0, 12.0}, -1.5708);
    std::size_t rejected = advance(world, 5.0);
    player.form(north, muster::FormationKind::Line);  // On the march.
    rejected += advance(world, 40.0);

    bool arrived = player.obeyed() && rejected == 0;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const muster::GroupView group = world.group(g);
        std::printf("%s: %d people, on average %.2f m from their places\n", std::string(group.name).c_str(),
                    group.count, group.meanLag);
        arrived = arrived && group.meanLag < 0.5;
    }
    return arrived ? 0 : 1;
}
