// Libraries of clips: Muster's own, and given ones.
#include <set>

#include "bindings/c/c_motion/libraries.h"
#include "bindings/c/c_world/handle_table.h"
#include "muster/own_clips.h"

namespace muster::c_api {

template <class M>
void fields(M& m, C<M, MusterLimbContact>& c, P<M, Contact>& p) {
    m.choice(c.limb, p.limb, Limb::RightKnee, "limb");
    m.plain(c.begin, p.begin);
    m.plain(c.end, p.end);
    m.plain(c.anchor, p.anchor);
}
template <class M>
void fields(M& m, C<M, MusterClip>& c, P<M, Clip>& p) {
    m.template version<MusterClip>(c.structVersion);
    m.text(c.name, p.name);
    m.text(c.motion, p.motion);
    m.plain(c.rate, p.rate);
    m.plain(c.cyclic, p.cyclic);
    m.list(c.poses, c.poseCount, p.poses, "poses");
    m.list(c.travel, c.travelCount, p.travel, "travel");
    m.items(c.contacts, c.contactCount, p.contacts, "contacts");
    m.plain(c.entryPhase, p.entryPhase);
    m.plain(c.exitPhase, p.exitPhase);
    m.plain(c.obstacleHeight, p.obstacle.height);
    m.plain(c.obstacleThickness, p.obstacle.thickness);
}

namespace {

using Libraries = HandleTable<MusterClipLibraryId, LibraryThing>;

Libraries& libraries() {
    static Libraries& table = *new Libraries("clip library");
    return table;
}

MusterClipLibraryId addLibrary(std::shared_ptr<const ClipLibrary> clips) {
    auto thing = std::make_unique<LibraryThing>();
    thing->clips = std::move(clips);
    thing->written = writeAll<MusterClip>(thing->clips->clips, thing->arena, thing->count);
    return libraries().add(std::move(thing));
}

/// Fails where a clip is not usable or has the name of one before it.
Status checkClips(const ClipLibrary& library) {
    std::set<std::string> names;
    for (const Clip& clip : library.clips) {
        if (const Status valid = validate(clip); !valid.ok()) return valid;
        if (!names.insert(clip.name).second)
            return invalidArgument("clips: found two of the name \"" + clip.name + "\", expected one");
    }
    return {};
}

/// Calls `work` with a clip of a library.
template <class Work>
MusterStatus withClip(MusterClipLibraryId library, std::int32_t clip, const void* out, const char* name,
                      Work&& work) noexcept {
    return call([&]() -> Status {
        if (out == nullptr) return nullArgument(name);
        const Result<LibraryThing*> found = findLibrary(library);
        if (!found.ok()) return found.status();
        const LibraryThing& thing = **found;
        if (clip < 0 || clip >= thing.count)
            return invalidArgument("clip: found index " + std::to_string(clip) + ", expected one below " +
                                   std::to_string(thing.count));
        return work(thing, thing.clips->clips[static_cast<std::size_t>(clip)]);
    });
}

Status checkTime(double time) {
    return time > -1e9 && time < 1e9 ? Status{} : invalidArgument("time: found no number from -1e9 to 1e9");
}

}  // namespace

Result<LibraryThing*> findLibrary(MusterClipLibraryId id) {
    return libraries().find(id);
}

}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterClip muster_default_clip(void) {
    static const Clip& standard = *new Clip{};
    static Arena& arena = *new Arena;
    return writeC<MusterClip>(standard, arena);
}

MusterStatus muster_clips_own(MusterClipLibraryId* outLibrary) {
    return call([&]() -> Status {
        if (outLibrary == nullptr) return nullArgument("outLibrary");
        *outLibrary = {0, 0};
        *outLibrary = addLibrary(std::shared_ptr<const ClipLibrary>(std::shared_ptr<void>(), &ownClips()));
        return {};
    });
}

MusterStatus muster_clips_create(const MusterClip* clips, int32_t clipCount,
                                 MusterClipLibraryId* outLibrary) {
    return call([&]() -> Status {
        if (outLibrary == nullptr) return nullArgument("outLibrary");
        *outLibrary = {0, 0};
        auto library = std::make_shared<ClipLibrary>();
        FromC reader;
        reader.items(clips, clipCount, library->clips, "clips");
        if (!reader.status().ok()) return reader.status();
        if (const Status valid = checkClips(*library); !valid.ok()) return valid;
        *outLibrary = addLibrary(std::move(library));
        return {};
    });
}

MusterStatus muster_clips_destroy(MusterClipLibraryId library) {
    return call([&] { return libraries().destroy(library); });
}

MusterStatus muster_clips_get(MusterClipLibraryId library, const MusterClip** outClips, int32_t* outCount) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"outClips", "outCount"}, outClips, outCount); !given.ok())
            return given;
        const Result<LibraryThing*> found = findLibrary(library);
        if (!found.ok()) return found.status();
        *outClips = (*found)->written;
        *outCount = (*found)->count;
        return {};
    });
}

MusterStatus muster_clips_find(MusterClipLibraryId library, const char* name, int32_t* outIndex) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"name", "outIndex"}, name, outIndex); !given.ok())
            return given;
        const Result<LibraryThing*> found = findLibrary(library);
        if (!found.ok()) return found.status();
        const std::int32_t index = (*found)->clips->indexOf(name);
        if (index < 0)
            return {StatusCode::NotFound, std::string("clip: found no clip \"") + name + "\", expected one"};
        *outIndex = index;
        return {};
    });
}

MusterStatus muster_clip_measures(MusterClipLibraryId library, int32_t clip,
                                  MusterClipMeasures* outMeasures) {
    return withClip(library, clip, outMeasures, "outMeasures",
                    [&](const LibraryThing&, const Clip& found) -> Status {
                        *outMeasures = {found.duration(), found.length(), found.speed()};
                        return {};
                    });
}

MusterStatus muster_clip_sample(MusterClipLibraryId library, int32_t clip, double time,
                                MusterBodyPose* outPose) {
    return withClip(library, clip, outPose, "outPose", [&](const LibraryThing&, const Clip& found) -> Status {
        if (const Status valid = checkTime(time); !valid.ok()) return valid;
        BodyPose pose;
        found.sample(time, pose);
        *outPose = poseOf(pose);
        return {};
    });
}

MusterStatus muster_clip_travel_at(MusterClipLibraryId library, int32_t clip, double time,
                                   MusterTravel* outTravel) {
    return withClip(library, clip, outTravel, "outTravel",
                    [&](const LibraryThing&, const Clip& found) -> Status {
                        if (const Status valid = checkTime(time); !valid.ok()) return valid;
                        const Travel travel = found.travelAt(time);
                        *outTravel = {travel.x, travel.y, travel.yaw};
                        return {};
                    });
}

MusterStatus muster_clip_contact_at(MusterClipLibraryId library, int32_t clip, MusterLimb limb, double time,
                                    const MusterLimbContact** outContact) {
    return withClip(
        library, clip, outContact, "outContact", [&](const LibraryThing& thing, const Clip& found) -> Status {
            if (const Status valid = checkTime(time); !valid.ok()) return valid;
            if (limb >= MUSTER_LIMB_COUNT)
                return invalidArgument("limb: found " + std::to_string(limb) + ", expected 0 to 5");
            const Contact* const contact = found.contactAt(static_cast<Limb>(limb), time);
            *outContact = contact == nullptr
                              ? nullptr
                              : thing.written[clip].contacts + (contact - found.contacts.data());
            return {};
        });
}

MusterStatus muster_clip_bvh(MusterClipLibraryId library, int32_t clip, MusterBuffer* outText) {
    return withClip(library, clip, outText, "outText", [&](const LibraryThing&, const Clip& found) -> Status {
        const std::string text = bvhText(found);
        *outText = makeBuffer(text.data(), text.size());
        return {};
    });
}
