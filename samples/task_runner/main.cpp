// A world whose work is done by the job system of the program around it; Muster starts no thread of its own.
#include <muster/world.h>

#include <atomic>
#include <cstdio>
#include <thread>

namespace {

/// Stands for a game's job system, which would keep its threads.
class Jobs {
public:
    /// The functions that a world calls. The jobs must outlive it.
    muster::TaskRunner runner() {
        return {.threads = 2,
                .context = this,
                .run = [](void* jobs, std::int32_t count, Task task,
                          void* context) { static_cast<Jobs*>(jobs)->run(count, task, context); },
                .launch = [](void* jobs, void (*task)(void*),
                             void* context) { static_cast<Jobs*>(jobs)->launch(task, context); },
                .wait = [](void* jobs) { static_cast<Jobs*>(jobs)->background_.join(); }};
    }
    int rounds() const { return rounds_; }
    int launches() const { return launches_; }

private:
    using Task = void (*)(void* context, std::int32_t item, std::int32_t worker);

    /// Two workers, of which the caller is one, take items in turn.
    void run(std::int32_t count, Task task, void* context) {
        ++rounds_;
        std::atomic<std::int32_t> next{0};
        const auto work = [&](std::int32_t worker) {
            for (std::int32_t item = next++; item < count; item = next++) task(context, item, worker);
        };
        std::thread other(work, 1);
        work(0);
        other.join();
    }
    /// One long piece of work, the plan's, that goes on while the crowd moves.
    void launch(void (*task)(void*), void* context) {
        ++launches_;
        background_ = std::thread(task, context);
    }

    int rounds_ = 0;
    int launches_ = 0;
    std::thread background_;
};

}  // namespace

int main() {
    muster::WorldDef def;
    def.box = {{-32.0, -32.0}, {32.0, 32.0}};
    muster::GroupDef group;
    group.count = 400;  // Small crowds are no work for two.
    def.groups.push_back(group);
    Jobs jobs;
    muster::Result<muster::World> made = muster::World::create(def, jobs.runner());
    muster::Result<muster::World> alone = muster::World::create(def);
    if (!made.ok() || !alone.ok()) {
        std::fprintf(stderr, "%s\n", made.status().message().c_str());
        return 1;
    }
    const muster::GroupId id = made->group(0).id;
    const muster::Command order{0, 1, 0, muster::SetPose{id, {12.0, 0.0}, 0.0}};
    const bool accepted = made->submit(order).ok() && alone->submit(order).ok();
    for (int step = 0; step < 300; ++step) {
        made->step();
        alone->step();
    }
    const bool same = made->hash() == alone->hash();
    std::printf(
        "%d rounds of work and %d pieces in the background by our own threads; the same state as on one "
        "thread: %s\n",
        jobs.rounds(), jobs.launches(), same ? "yes" : "no");
    return accepted && same && jobs.rounds() > 0 && jobs.launches() > 0 ? 0 : 1;
}
