#include "scale/bench_commands.h"

#include <algorithm>
#include <cstdio>
#include <functional>

#include "base/random.h"
#include "muster/world.h"
#include "scale/meter.h"
#include "scale/stages.h"

namespace muster::scale {
namespace {

constexpr std::int32_t kUnmeasured = 120;  // Steps before the first command.
constexpr std::int32_t kPeriod = 60;       // Steps from command to command.
constexpr std::int32_t kBefore = 10;       // Plain steps before a command, whose median counts.
constexpr std::int32_t kAfter = 15;        // Steps from a command on that count.

/// One kind of command.
struct Kind {
    const char* name;
    std::function<CommandBody(const World&, std::int32_t round)> make;
};

std::int32_t squareRoot(std::int32_t count) {
    std::int32_t root = 1;
    while (root * root < count) ++root;
    return root;
}

Vec2 middleOf(const GroupView& group) {
    Vec2 sum;
    for (const Vec2 v : group.finalMesh) sum += v;
    return sum / static_cast<double>(group.finalMesh.size());
}

std::vector<Kind> kindsOf(const CommandsDef& def) {
    const auto first = [](const World& world) { return world.group(0).id; };
    const auto move = [def, first](const World& world, std::int32_t round) -> CommandBody {
        const double reach = 0.3 * def.side;
        const Vec2 corners[] = {{reach, reach}, {-reach, reach}, {-reach, -reach}, {reach, -reach}};
        Order order = Order::move(corners[round % 4]);
        if (def.free) order.manner = Manner::Free;
        return GiveOrder{first(world), QueueMode::Replace, 0, order};
    };
    const auto death = [](const World& world, std::int32_t round) -> CommandBody {
        const auto ids = world.characters().id;
        return TransferCharacters{{ids[static_cast<std::size_t>(round * 7919) % ids.size()]}, {}};
    };
    const auto join = [first](const World& world, std::int32_t) -> CommandBody {
        return AddCharacters{first(world), {world.characters().position[0] + Vec2{2.0, 1.0}}, {}};
    };
    const auto split = [first](const World& world, std::int32_t) -> CommandBody {
        const Vec2 middle = middleOf(world.group(0));
        const Vec2 along = world.group(0).pose.rotation.apply({1.0, 0.0});
        return SplitGroup{first(world), SplitBy::Line,    {}, {middle - along, middle + along}, {},
                          false,        PartShape::AsHeld};
    };
    const auto merge = [](const World& world, std::int32_t) -> CommandBody {
        return MergeGroups{{world.group(0).id, world.group(1).id}, PartShape::AsHeld};
    };
    const auto form = [move](const World& world, std::int32_t round) -> CommandBody {
        const auto files = squareRoot(static_cast<std::int32_t>(world.characters().id.size()));
        auto order = std::get<GiveOrder>(move(world, round));
        order.order.formation.emplace();
        order.order.formation->files = round % 2 == 0 ? files / 2 : 2 * files;
        return order;
    };
    std::vector<Kind> kinds{
        {"move", move}, {"death", death}, {"join", join}, {"split", split}, {"merge", merge}};
    if (def.formations) kinds.push_back({"form", form});
    return kinds;
}

Result<World> makeWorld(const CommandsDef& def) {
    WorldDef world;
    const double half = 0.5 * def.side;
    world.box = {{-half, -half}, {half, half}};
    GroupDef& group = world.groups.emplace_back();
    group.count = def.count;
    group.position = {-0.3 * def.side, -0.3 * def.side};
    Random random(1);
    for (std::int32_t k = 0; k < def.obstacles; ++k) {
        ObstacleDef disc;
        disc.centre = {random.uniform(-0.9 * half, 0.9 * half), random.uniform(-0.9 * half, 0.9 * half)};
        disc.radius = 0.5;
        if (distance(disc.centre, group.position) > 30.0) world.obstacles.push_back(disc);
    }
    return World::create(world);
}

/// The stages of the last step that took long.
/// One run; each step's time is lowered to the least over the runs so far.
Status run(const CommandsDef& def, const std::vector<Kind>& kinds, std::vector<double>& times,
           std::vector<std::string>& stages, std::uint64_t& hash) {
    Result<World> world = makeWorld(def);
    if (!world.ok()) return world.status();
    const auto commands = static_cast<std::int32_t>(kinds.size()) * def.rounds;
    const std::int32_t steps = kUnmeasured + commands * kPeriod;
    times.resize(static_cast<std::size_t>(steps), 1e9);
    for (std::int32_t s = 0; s < steps; ++s) {
        if (s >= kUnmeasured && (s - kUnmeasured) % kPeriod == 0) {
            const std::int32_t k = (s - kUnmeasured) / kPeriod;
            const Kind& kind = kinds[static_cast<std::size_t>(k) % kinds.size()];
            const std::int32_t round = k / static_cast<std::int32_t>(kinds.size());
            const Status given = world->submit({world->stepCount(), 1, 0, kind.make(*world, round)});
            if (!given.ok()) return given.within(kind.name);
        }
        times[s] = std::min(times[s], timedStep(*world));
        if (s >= kUnmeasured && (s - kUnmeasured) % kPeriod == 0)
            stages[static_cast<std::size_t>((s - kUnmeasured) / kPeriod) % kinds.size()] = stagesText(
                world->stageTimes(), 0.2);
        if (!world->rejections().empty()) return world->rejections()[0].status;
    }
    const std::uint64_t last = hash;
    hash = world->hash();
    return last == 0 || last == hash ? Status() : Status(StatusCode::Corrupt, "two equal runs differ");
}

}  // namespace

Result<std::vector<CommandRow>> measureCommands(const CommandsDef& def) {
    const std::vector<Kind> kinds = kindsOf(def);
    std::vector<double> times;
    std::uint64_t hash = 0;
    std::vector<std::string> stages(kinds.size());
    for (std::int32_t k = 0; k < def.runs; ++k)
        if (Status status = run(def, kinds, times, stages, hash); !status.ok()) return status;
    std::vector<CommandRow> rows;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        std::vector<double> over;
        CommandRow& row = rows.emplace_back();
        row.name = kinds[kind].name;
        row.stages = stages[kind];
        for (std::int32_t round = 0; round < def.rounds; ++round) {
            const auto at = times.begin() + kUnmeasured +
                            (round * static_cast<std::int32_t>(kinds.size()) +
                             static_cast<std::int32_t>(kind)) *
                                kPeriod;
            const double plain = quantile({at - kBefore, at}, 0.5);
            over.push_back(*std::max_element(at, at + kAfter) - plain);
            row.first = std::max(row.first, *at - plain);
        }
        row.median = quantile(over, 0.5);
        row.worst = quantile(over, 1.0);
    }
    return rows;
}

std::string commandsText(const CommandsDef& def, const std::vector<CommandRow>& rows) {
    char line[200];
    std::snprintf(line, sizeof line, "%d characters, %d discs, %.0f m: time above a plain step [ms]\n",
                  def.count, def.obstacles, def.side);
    std::string text = line;
    for (const CommandRow& row : rows) {
        std::snprintf(line, sizeof line,
                      "%-6s in its step at most %5.2f; within 15 steps median %5.2f, worst %5.2f (",
                      row.name.c_str(), row.first, row.median, row.worst);
        text += line + row.stages + ")\n";
    }
    return text;
}

}  // namespace muster::scale
