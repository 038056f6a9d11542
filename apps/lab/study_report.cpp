// muster study report
#include <cstdio>
#include <memory>

#include "lab/study/report/study_report.h"
#include "lab_commands.h"
#include "lab_commands_list.h"
#include "report.h"

namespace muster {
namespace {

struct StudyReportOptions {
    std::string db;
    std::string folder;
};

int studyReport(const StudyReportOptions& options) {
    auto store = StudyStore::open(options.db, StoreMode::Existing);
    if (!store.ok()) return reportFailure(store.status());
    if (Status s = writeStudyReport(*store, options.folder, MUSTER_VERSION); !s.ok()) return reportFailure(s);
    std::printf("%s/report.html\n%s/results.json\n", options.folder.c_str(), options.folder.c_str());
    return kExitOk;
}

}  // namespace

void addStudyReportCommand(Subcommand& study) {
    Subcommand command = study.add(kStudyReportCommand.name, kStudyReportCommand.about);
    auto options = std::make_shared<StudyReportOptions>();
    command.option("--db", options->db, "The study's database.").required();
    command.option("-o,--output", options->folder, "Folder to write to; it is made where it is missing.")
        .required();
    command.footer("Example:\n  muster study report --db study.db -o report");
    command.run([options] { return studyReport(*options); });
}

}  // namespace muster
