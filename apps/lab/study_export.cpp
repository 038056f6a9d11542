// muster study export
#include <cstdio>
#include <memory>

#include "lab/study/report/study_report.h"
#include "lab_commands.h"
#include "lab_commands_list.h"
#include "report.h"

namespace muster {
namespace {

struct StudyExportOptions {
    std::string db;
    std::string folder;
};

int studyExport(const StudyExportOptions& options) {
    auto store = StudyStore::open(options.db, StoreMode::Existing);
    if (!store.ok()) return reportFailure(store.status());
    if (Status s = exportStudy(*store, options.folder); !s.ok()) return reportFailure(s);
    std::printf("%s/codebook.md\n", options.folder.c_str());
    return kExitOk;
}

}  // namespace

void addStudyExportCommand(Subcommand& study) {
    Subcommand command = study.add(kStudyExportCommand.name, kStudyExportCommand.about);
    auto options = std::make_shared<StudyExportOptions>();
    command.option("--db", options->db, "The study's database.").required();
    command.option("-o,--output", options->folder, "Folder to write to; it is made where it is missing.")
        .required();
    command.footer("Example:\n  muster study export --db study.db -o csv");
    command.run([options] { return studyExport(*options); });
}

}  // namespace muster
