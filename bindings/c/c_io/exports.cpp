// Export of takes.
#include "bindings/c/c_io/takes.h"
#include "bindings/c/c_motion/libraries.h"
#include "muster/export.h"

namespace muster::c_api {

template <class M>
void fields(M& m, C<M, MusterExportDef>& c, P<M, ExportDef>& p) {
    m.template version<MusterExportDef>(c.structVersion);
    m.plain(c.from, p.from);
    m.plain(c.to, p.to);
    m.plain(c.fps, p.fps);
    m.plain(c.threads, p.threads);
    m.list(c.speeds, c.speedCount, p.speeds, "speeds");
}

namespace {

static_assert(sizeof(MusterExportFormat) == sizeof(ExportFormat) &&
              offsetof(MusterExportFormat, about) == offsetof(ExportFormat, about));

}  // namespace
}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

const MusterExportFormat* muster_export_formats(int32_t* outCount) {
    const std::span<const ExportFormat> formats = exportFormats();
    if (outCount != nullptr) *outCount = static_cast<std::int32_t>(formats.size());
    return reinterpret_cast<const MusterExportFormat*>(formats.data());
}

MusterStatus muster_export_format(const char* name, MusterExportFormat* outFormat) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"name", "outFormat"}, name, outFormat); !given.ok())
            return given;
        const Result<ExportFormat> format = exportFormat(name);
        if (format.ok()) *outFormat = {format->name, format->ending, format->about};
        return format.status();
    });
}

MusterExportDef muster_default_export_def(void) {
    static const ExportDef& standard = *new ExportDef{};
    Arena none;
    return writeC<MusterExportDef>(standard, none);
}

MusterStatus muster_export_take(MusterTakeId take, MusterClipLibraryId library, const char* format,
                                const char* path, const MusterExportDef* def, MusterProgressFunction progress,
                                void* context) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"format", "path"}, format, path); !given.ok()) return given;
        const Result<TakeThing*> found = findTake(take);
        if (!found.ok()) return found.status();
        const Result<LibraryThing*> clips = findLibrary(library);
        if (!clips.ok()) return clips.status();
        ExportDef read;
        if (def != nullptr)
            if (const Status fits = readC(def, read, "def"); !fits.ok()) return fits;
        if (const Status valid = checkTakeThreads(read.threads); !valid.ok()) return valid;
        ExportProgress show;
        if (progress != nullptr) show = [&](double share) { return progress(context, share); };
        return exportTake((*found)->take, *(*clips)->clips, format, path, read, show);
    });
}
