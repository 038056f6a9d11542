// Two groups under the orders of a strategy game: a front drawn by a line, a queue of orders, a group that is
// split and joined again. The world tells by events how the orders get on.
#include <muster/world.h>

#include <array>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using muster::EventKind;
using muster::GroupId;
using muster::Order;

/// One player: orders become commands, which apply at the start of the next step.
class Player {
public:
    explicit Player(muster::World& world) : world_(world) {}

    /// A right click: drops what the group had to do and goes.
    void order(GroupId group, Order order) {
        send(muster::GiveOrder{group, muster::QueueMode::Replace, 0, std::move(order)});
    }
    /// A right click with Shift: comes after what the group has to do.
    void queue(GroupId group, Order order) {
        send(muster::GiveOrder{group, muster::QueueMode::Append, 0, std::move(order)});
    }
    /// Those on the left of a stroke leave the group; the event GroupAdded names their new one.
    void cut(GroupId group, muster::Vec2 from, muster::Vec2 to) {
        muster::SplitGroup split;
        split.group = group;
        split.by = muster::SplitBy::Line;
        split.points = {from, to};
        send(std::move(split));
    }
    /// All join the first group.
    void merge(std::vector<GroupId> groups) { send(muster::MergeGroups{std::move(groups)}); }

private:
    void send(muster::CommandBody body) {
        const muster::Status status = world_.submit({world_.stepCount(), 1, sequence_++, std::move(body)});
        if (!status.ok()) std::fprintf(stderr, "%s\n", status.message().c_str());
    }

    muster::World& world_;
    std::uint32_t sequence_ = 0;
};

/// Steps a world and keeps count of what it tells.
class Watch {
public:
    explicit Watch(muster::World& world) : world_(world) {}

    void run(double seconds) {
        for (const double end = world_.time() + seconds; world_.time() < end;) {
            world_.step();
            for (const muster::Rejection& rejection : world_.rejections())
                std::printf("%5.1f s  refused: %s\n", world_.time(), rejection.status.message().c_str());
            refused += world_.rejections().size();
            for (const muster::Event& event : world_.events()) tell(event);
        }
    }

    std::map<EventKind, int> counts;  ///< How often each kind of event came.
    GroupId newest;                   ///< The last group that was split off.
    std::size_t refused = 0;          ///< Commands that could not be carried out.

private:
    void tell(const muster::Event& event) {
        static const std::set<EventKind> ofInterest{
            EventKind::OrderGiven, EventKind::OrderBegun,   EventKind::OrderDone, EventKind::OrderSkipped,
            EventKind::GroupAdded, EventKind::GroupRemoved, EventKind::Arrived};
        ++counts[event.kind];
        if (event.kind == EventKind::GroupAdded) newest = {event.subject};
        if (ofInterest.contains(event.kind))
            std::printf("%5.1f s  group %u: %s %u\n", world_.time(), event.subject, eventKindName(event.kind),
                        event.value);
    }

    muster::World& world_;
};

muster::WorldDef battlefield() {
    muster::WorldDef def;
    def.box = {{-50.0, -40.0}, {50.0, 40.0}};
    muster::ObstacleDef house;
    house.polygon = {{-4.0, -6.0}, {4.0, -6.0}, {4.0, 6.0}, {-4.0, 6.0}};
    def.obstacles.push_back(house);
    for (const double y : {-15.0, 15.0}) {
        muster::GroupDef group;
        group.name = y < 0.0 ? "South" : "North";
        group.count = 60;
        group.formation.files = 10;
        group.position = {-30.0, y};
        def.groups.push_back(group);
    }
    return def;
}

}  // namespace

int main() {
    muster::Result<muster::World> made = muster::World::create(battlefield());
    if (!made.ok()) {
        std::fprintf(stderr, "%s\n", made.status().message().c_str());
        return 1;
    }
    muster::World& world = *made;
    const GroupId south = world.group(0).id, north = world.group(1).id;
    Player player(world);
    Watch watch(world);

    // The south takes up a front of 12 m; a player drags from its left end to its right end.
    player.order(south, Order::moveToLine({0.0, -12.0}, {0.0, -24.0}));
    // The north has three things to do, one after the other.
    player.order(north, Order::move({-10.0, 20.0}));
    player.queue(north, Order::move({12.0, 20.0}, 0.0));
    player.queue(north, Order::face(-1.5708));
    watch.run(8.0);

    // On the march the south is cut in two along its way; its left half goes elsewhere at a run.
    const muster::Vec2 middle = world.group(0).pose.position;
    player.cut(south, middle, middle + muster::Vec2{1.0, 0.0});
    watch.run(0.1);
    const GroupId scouts = watch.newest;
    if (scouts) player.order(scouts, Order::go({15.0, -5.0}));
    watch.run(30.0);

    // Together again, they go on as one.
    player.merge({south, scouts});
    player.queue(south, Order::move({25.0, -18.0}, 0.0));
    watch.run(40.0);

    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const muster::GroupView group = world.group(g);
        std::printf("%s: %d people, on average %.2f m from their places\n", std::string(group.name).c_str(),
                    group.count, group.meanLag);
    }
    const bool split = watch.counts[EventKind::GroupAdded] == 1 && watch.counts[EventKind::GroupRemoved] == 1;
    return split && watch.refused == 0 && watch.counts[EventKind::OrderDone] >= 5 ? 0 : 1;
}
