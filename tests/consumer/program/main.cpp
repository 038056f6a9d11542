// The smallest program a game would start from: a crowd, one finger, ten seconds, on the game's own threads.
#include <muster/world.h>

#include <atomic>
#include <cstdio>
#include <thread>

namespace {

using Task = void (*)(void* context, std::int32_t item, std::int32_t worker);

// Stands for a game's job system.
struct Jobs {
    int runs = 0;
    int launches = 0;
    std::thread beside;
};

// Two workers, one of them the caller, take items in turn.
void runTasks(void* jobs, std::int32_t count, Task task, void* context) {
    ++static_cast<Jobs*>(jobs)->runs;
    std::atomic<std::int32_t> next{0};
    const auto work = [&](std::int32_t worker) {
        for (std::int32_t item = next++; item < count; item = next++) task(context, item, worker);
    };
    std::thread other(work, 1);
    work(0);
    other.join();
}

// One long piece of work that goes on while the game does something else.
void launch(void* jobs, void (*task)(void*), void* context) {
    ++static_cast<Jobs*>(jobs)->launches;
    static_cast<Jobs*>(jobs)->beside = std::thread(task, context);
}

void wait(void* jobs) {
    static_cast<Jobs*>(jobs)->beside.join();
}

}  // namespace

int main() {
    muster::WorldDef def;
    muster::GroupDef group;
    constexpr int kCount = 400;  // Fewer are no work for two.
    group.count = kCount;
    def.box = {{-32.0, -32.0}, {32.0, 32.0}};
    def.groups.push_back(group);
    Jobs jobs;
    muster::Result<muster::World> made = muster::World::create(
        def, muster::TaskRunner{2, &jobs, runTasks, launch, wait});
    if (!made.ok()) {
        std::fprintf(stderr, "%s\n", made.status().message().c_str());
        return 1;
    }
    muster::World& world = *made;
    const muster::Vec2 start = world.group(0).mesh->finalMesh().front();
    const auto submit = [&](std::uint32_t step, std::uint32_t sequence, muster::CommandBody body) {
        return world.submit({step, 1, sequence, std::move(body)});
    };
    bool accepted = submit(0, 0, muster::TouchDown{1, start, 0.0, {}}).ok();
    accepted = accepted && submit(30, 1, muster::TouchMove{1, {start.x + 6.0, start.y}, 0.5}).ok();
    accepted = accepted && submit(31, 2, muster::TouchUp{1, 31.0 / 60.0}).ok();
    for (int i = 0; i < 600; ++i) world.step();
    double mean = 0.0;
    for (const muster::Vec2 p : world.characters().position) mean += p.x / kCount;
    std::printf(
        "%d characters walked %.2f m on average; %d pieces of work were handed over, %d of them to go on "
        "beside\n",
        kCount, mean, jobs.runs + jobs.launches, jobs.launches);
    return accepted && mean > 4.0 && jobs.runs > 0 && jobs.launches > 0 ? 0 : 1;
}
