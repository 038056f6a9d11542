// The function of the WebAssembly module that makes an export (web/src/link/engine), in a worker of its own,
// which ends with it.
#include <emscripten.h>

#include <string>

#include "base/text_file.h"
#include "export_order.h"
#include "json/json.h"
#include "last_text.h"
#include "scenario_folder.h"
#include "take_shelf.h"

namespace {

using namespace muster;

// The page ends a worker that is to stop.
EM_JS(void, tellProgress, (double share), { Module["onProgress"](share); });

Result<std::string> writeFile(const std::string& request, const std::string& path) {
    TakeShelf shelf("/takes");
    const ScenarioFolder folder = ScenarioFolder::scan("/scenarios");
    const auto order = readExportOrder(request, shelf);
    if (!order.ok()) return order.status();
    const auto clips = [&](const std::string& name, const WorldDef& def) { return folder.clips(name, def); };
    const ExportTools tools{clips, "/player"};
    if (order->estimate) {
        const auto known = estimateExport(*order, tools, path, [] { return true; });
        if (!known.ok()) return known.status();
        const Status wrote = writeTextFile(path,
                                           compactJson({{"bytes", known->bytes}, {"people", known->people}}));
        return wrote.ok() ? Result<std::string>(std::string("estimate")) : wrote;
    }
    const Status status = writeExport(*order, tools, path, [](double share) {
        tellProgress(share);
        return true;
    });
    return status.ok() ? exportFileName(*order) : status;
}

}  // namespace

extern "C" {

/// Makes the file of an export of a take in /takes, with the scenarios in /scenarios and, for pages with a
/// player, what they are made of in /player. Returns 0 with the name to save it by in muster_text(), or 1
/// with a sentence there. Of an estimate the file says what ExportEstimate holds.
EMSCRIPTEN_KEEPALIVE int muster_export(const char* order, const char* path) {
    const auto name = writeFile(order, path);
    lastText() = name.ok() ? *name : name.status().message();
    return name.ok() ? 0 : 1;
}

}  // extern "C"
