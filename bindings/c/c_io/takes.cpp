// Takes: recording, reading, replaying.
#include "bindings/c/c_io/takes.h"

#include "bindings/c/c_world/world_handle.h"

namespace muster::c_api {

template <class M>
void fields(M& m, C<M, MusterTakeFrame>& c, P<M, TakeFrame>& p) {
    m.plain(c.step, p.step);
    m.list(c.ids, c.idCount, p.ids, "ids");
    m.list(c.positions, c.positionCount, p.positions, "positions");
}

namespace {

static_assert(sizeof(MusterHashMark) == sizeof(HashMark) &&
              offsetof(MusterHashMark, hash) == offsetof(HashMark, hash) &&
              offsetof(MusterHashMark, commands) == offsetof(HashMark, commands));
static_assert(sizeof(MusterTakeEvent) == sizeof(TakeEvent) &&
              offsetof(MusterTakeEvent, event) == offsetof(TakeEvent, event));

using Writers = HandleTable<MusterTakeWriterId, TakeWriter>;
using Takes = HandleTable<MusterTakeId, TakeThing>;

Writers& writers() {
    static Writers& table = *new Writers("take writer");
    return table;
}
Takes& takes() {
    static Takes& table = *new Takes("take");
    return table;
}

/// Takes what `read` gives and gives its handle; none where it fails.
template <class Read>
MusterStatus addTake(MusterTakeId* outTake, Read&& read) noexcept {
    return call([&]() -> Status {
        if (outTake == nullptr) return nullArgument("outTake");
        *outTake = {0, 0};
        Result<Take> take = read();
        if (!take.ok()) return take.status();
        *outTake = takes().add(std::make_unique<TakeThing>(*std::move(take)));
        return {};
    });
}
/// Calls `work` with a take.
template <class Work>
MusterStatus withTake(MusterTakeId id, Work&& work) noexcept {
    return call([&]() -> Status {
        const Result<TakeThing*> found = takes().find(id);
        return found.ok() ? work(**found) : found.status();
    });
}
/// Calls `work` with a writer and a world.
template <class Work>
MusterStatus withWriter(MusterTakeWriterId id, MusterWorldId world, Work&& work) noexcept {
    return call([&]() -> Status {
        const Result<TakeWriter*> writer = writers().find(id);
        if (!writer.ok()) return writer.status();
        const Result<WorldHandle*> found = findWorld(world);
        return found.ok() ? work(**writer, (*found)->world()) : found.status();
    });
}

/// The handle of a world that a replay shows, for as long as it is shown.
class ShownWorld {
public:
    explicit ShownWorld(const World& world) : id_(addWorld(std::make_unique<WorldHandle>(&world))) {}
    ShownWorld(const ShownWorld&) = delete;
    ShownWorld& operator=(const ShownWorld&) = delete;
    ~ShownWorld() { (void)endWorld(id_); }

    MusterWorldId id() const { return id_; }

private:
    MusterWorldId id_;
};

}  // namespace

TakeThing::TakeThing(Take read) : take(std::move(read)) {
    MusterTake& out = written;
    ToC writer(arena);
    out.structVersion = StructVersion<MusterTake>::kValue;
    writer.text(out.scenario, take.scenario);
    writer.part(out.def, take.def, "def");
    writer.items(out.commands, out.commandCount, take.commands, "commands");
    writer.list(out.marks, out.markCount, take.marks, "marks");
    writer.list(out.events, out.eventCount, take.events, "events");
    writer.items(out.frames, out.frameCount, take.frames, "frames");
    writer.text(out.title, take.about.title);
    out.steps = take.steps();
    out.firstStep = take.about.firstStep(out.steps);
    out.lastStep = take.about.lastStep(out.steps);
    writer.list(out.speeds, out.speedCount, take.about.speeds, "speeds");
    out.finished = take.finished;
    out.tornBytes = take.tornBytes;
    out.markedSteps = take.markedSteps();
}

Result<TakeThing*> findTake(MusterTakeId id) {
    return takes().find(id);
}

}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterStatus muster_take_writer_create(const char* path, const MusterWorldDef* def, bool overwrite,
                                       MusterTakeWriterId* outWriter) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"path", "outWriter"}, path, outWriter); !given.ok())
            return given;
        *outWriter = {0, 0};
        WorldDef read;
        if (const Status fits = readC(def, read, "def"); !fits.ok()) return fits;
        Result<TakeWriter> writer = TakeWriter::create(path, read, overwrite);
        if (!writer.ok()) return writer.status();
        *outWriter = writers().add(std::make_unique<TakeWriter>(*std::move(writer)));
        return {};
    });
}

MusterStatus muster_take_writer_command(MusterTakeWriterId writer, const MusterCommand* command) {
    return call([&]() -> Status {
        const Result<TakeWriter*> found = writers().find(writer);
        if (!found.ok()) return found.status();
        Command read;
        if (const Status fits = readC(command, read, "command"); !fits.ok()) return fits;
        const Status valid = validateCommand(read);
        return valid.ok() ? (*found)->command(read) : valid;
    });
}

MusterStatus muster_take_writer_observe(MusterTakeWriterId writer, MusterWorldId world) {
    return withWriter(writer, world, [](TakeWriter& take, const World& own) { return take.observe(own); });
}

MusterStatus muster_take_writer_finish(MusterTakeWriterId writer, MusterWorldId world) {
    return withWriter(writer, world, [&](TakeWriter& take, const World& own) {
        const Status finished = take.finish(own);
        const Status ended = writers().destroy(writer);
        return finished.ok() ? ended : finished;
    });
}

MusterStatus muster_take_writer_destroy(MusterTakeWriterId writer) {
    return call([&] { return writers().destroy(writer); });
}

MusterTake muster_default_take(void) {
    MusterTake none{};
    none.structVersion = StructVersion<MusterTake>::kValue;
    return none;
}

MusterStatus muster_take_read(const char* path, MusterTakeId* outTake) {
    return addTake(outTake,
                   [&]() -> Result<Take> { return path == nullptr ? nullArgument("path") : readTake(path); });
}

MusterStatus muster_take_parse(const uint8_t* bytes, size_t size, const char* sourceName,
                               MusterTakeId* outTake) {
    return addTake(outTake, [&]() -> Result<Take> {
        if (const Status given = needPointers({"bytes", "sourceName"}, bytes, sourceName); !given.ok())
            return given;
        return parseTake({bytes, size}, sourceName);
    });
}

MusterStatus muster_take_destroy(MusterTakeId take) {
    return call([&] { return takes().destroy(take); });
}

MusterStatus muster_take_get(MusterTakeId take, MusterTake* outTake) {
    return withTake(take, [&](TakeThing& thing) -> Status {
        if (const Status fits = needStruct(outTake, "outTake"); !fits.ok()) return fits;
        *outTake = thing.written;
        return {};
    });
}

MusterStatus muster_take_speed_at(MusterTakeId take, double seconds, double* outSpeed) {
    return withTake(take, [&](TakeThing& thing) -> Status {
        if (outSpeed == nullptr) return nullArgument("outSpeed");
        *outSpeed = thing.take.about.speedAt(seconds);
        return {};
    });
}

MusterStatus muster_take_simulates_alike(MusterTakeId take, int32_t threads, bool* outAlike) {
    return withTake(take, [&](TakeThing& thing) -> Status {
        if (outAlike == nullptr) return nullArgument("outAlike");
        if (const Status valid = checkTakeThreads(threads); !valid.ok()) return valid;
        *outAlike = simulatesAlike(thing.take, threads);
        return {};
    });
}

MusterStatus muster_take_replay(MusterTakeId take, int32_t threads, MusterReplayFrom from,
                                MusterReplayFunction observe, void* context, MusterReplayReport* outReport) {
    return withTake(take, [&](TakeThing& thing) -> Status {
        if (outReport == nullptr) return nullArgument("outReport");
        if (const Status valid = checkTakeThreads(threads); !valid.ok()) return valid;
        if (from > MUSTER_REPLAY_FRAMES)
            return invalidArgument("from: found " + std::to_string(from) + ", expected 0 or 1");
        std::function<bool(const World&)> show;
        if (observe != nullptr)
            show = [&](const World& world) { return observe(context, ShownWorld(world).id()); };
        const Result<ReplayReport> report = replayTake(thing.take, threads, show,
                                                       static_cast<ReplayFrom>(from));
        if (!report.ok()) return report.status();
        *outReport = {report->steps, report->compared, report->unmarked, report->hash};
        return {};
    });
}
