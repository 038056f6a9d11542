// Worlds: making, changing, stepping, ending.
#include "bindings/c/c_world/command_fields.h"
#include "bindings/c/c_world/handle_table.h"
#include "bindings/c/c_world/world_handle.h"

namespace muster::c_api {
namespace {

using Worlds = HandleTable<MusterWorldId, WorldHandle>;

/// Lives as long as the process: programs may end worlds while others end.
Worlds& worlds() {
    static Worlds& table = *new Worlds("world");
    return table;
}

Status readRunner(const MusterTaskRunner* runner, TaskRunner& out) {
    if (const Status usable = needStruct(runner, "runner"); !usable.ok()) return usable;
    out = {runner->threads, runner->context, runner->run, runner->launch, runner->wait};
    return {};
}

/// Makes a world by `make` and gives its handle; none where it fails.
template <class Make>
MusterStatus makeWorld(MusterWorldId* outWorld, Make&& make) noexcept {
    return call([&]() -> Status {
        if (outWorld == nullptr) return nullArgument("outWorld");
        *outWorld = {0, 0};
        Result<World> made = make();
        if (!made.ok()) return made.status();
        *outWorld = addWorld(std::make_unique<WorldHandle>(*std::move(made)));
        return {};
    });
}

/// Calls `make` with a definition and workers: a number of threads, or a runner.
template <class Workers>
Result<World> createFrom(const MusterWorldDef* def, const Workers& workers) {
    WorldDef read;
    if (const Status fits = readC(def, read, "def"); !fits.ok()) return fits;
    return World::create(read, workers);
}

Status checkThreads(std::int32_t threads) {
    if (threads >= 0 && threads <= 256) return {};
    return invalidArgument("threads: found " + std::to_string(threads) + ", expected 0 to 256");
}

Result<std::span<const std::uint8_t>> bytesOf(const std::uint8_t* bytes, std::size_t size) {
    if (bytes == nullptr && size > 0) return nullArgument("snapshot");
    return std::span(bytes, size);
}

template <class Workers>
Result<World> restoreFrom(const std::uint8_t* snapshot, std::size_t size, const Workers& workers) {
    const auto bytes = bytesOf(snapshot, size);
    return bytes.ok() ? World::restore(*bytes, workers) : bytes.status();
}

}  // namespace

MusterWorldId addWorld(std::unique_ptr<WorldHandle> world) {
    return worlds().add(std::move(world));
}
Result<WorldHandle*> findWorld(MusterWorldId id) {
    return worlds().find(id);
}
Status endWorld(MusterWorldId id) {
    return worlds().destroy(id);
}

}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterTaskRunner muster_default_task_runner(void) {
    return {StructVersion<MusterTaskRunner>::kValue, 1, nullptr, nullptr, nullptr, nullptr};
}

MusterStatus muster_world_create(const MusterWorldDef* def, int32_t threads, MusterWorldId* outWorld) {
    return makeWorld(outWorld, [&]() -> Result<World> {
        const Status fits = checkThreads(threads);
        return fits.ok() ? createFrom(def, threads) : fits;
    });
}

MusterStatus muster_world_create_on(const MusterWorldDef* def, const MusterTaskRunner* runner,
                                    MusterWorldId* outWorld) {
    return makeWorld(outWorld, [&]() -> Result<World> {
        TaskRunner read;
        const Status fits = readRunner(runner, read);
        return fits.ok() ? createFrom(def, read) : fits;
    });
}

MusterStatus muster_world_restore(const uint8_t* snapshot, size_t size, int32_t threads,
                                  MusterWorldId* outWorld) {
    return makeWorld(outWorld, [&]() -> Result<World> {
        const Status fits = checkThreads(threads);
        return fits.ok() ? restoreFrom(snapshot, size, threads) : fits;
    });
}

MusterStatus muster_world_restore_on(const uint8_t* snapshot, size_t size, const MusterTaskRunner* runner,
                                     MusterWorldId* outWorld) {
    return makeWorld(outWorld, [&]() -> Result<World> {
        TaskRunner read;
        const Status fits = readRunner(runner, read);
        return fits.ok() ? restoreFrom(snapshot, size, read) : fits;
    });
}

MusterStatus muster_world_destroy(MusterWorldId world) {
    return changeWorld(world, [&](World&) { return endWorld(world); });
}

bool muster_world_is_valid(MusterWorldId world) {
    return findWorld(world).ok();
}

MusterStatus muster_world_rewind(MusterWorldId world, const uint8_t* snapshot, size_t size) {
    return changeWorld(world, [&](World& own) -> Status {
        const auto bytes = bytesOf(snapshot, size);
        return bytes.ok() ? own.rewind(*bytes) : bytes.status();
    });
}

MusterStatus muster_world_submit(MusterWorldId world, const MusterCommand* command) {
    return changeWorld(world, [&](World& own) -> Status {
        Command read;
        const Status fits = readC(command, read, "command");
        return fits.ok() ? own.submit(read) : fits;
    });
}

MusterStatus muster_world_step(MusterWorldId world) {
    return changeWorld(world, [](World& own) -> Status {
        own.step();
        for (const Rejection& rejection : own.rejections())
            log(MUSTER_LOG_INFO, rejection.status.message().c_str());
        return {};
    });
}

MusterStatus muster_world_hash(MusterWorldId world, uint64_t* outHash) {
    return readValue(world, outHash, "outHash", [](const World& own) { return own.hash(); });
}

MusterStatus muster_world_snapshot(MusterWorldId world, MusterBuffer* outBytes) {
    return readValue(world, outBytes, "outBytes", [](const World& own) {
        const std::vector<std::uint8_t> bytes = own.snapshot();
        return makeBuffer(bytes.data(), bytes.size());
    });
}
