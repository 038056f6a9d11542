#include <doctest.h>

#include "folders.h"
#include "program.h"

using namespace muster::testing;
using muster::sourceFolder;

TEST_CASE("muster study tells bad input in one sentence") {
    const std::string letter = put("letter.db", std::string(300, 'x'));
    for (const std::string command : {"report", "export"}) {
        for (const std::string& db : {std::string("/nowhere/study.db"), letter}) {
            const Outcome outcome = runProgram("study " + command + " --db '" + db + "' -o '" +
                                               (workFolder() / "study").string() + "'");
            CHECK(outcome.code == 1);
            CHECK(outcome.errorLines() == 1);
        }
    }
    CHECK(slurp(letter) == std::string(300, 'x'));
    CHECK(runProgram("study").code == 2);
    CHECK(runProgram("study report").code == 2);
}

TEST_CASE("muster study run and replay tell bad input in one sentence") {
    const std::string letter = put("letter2.db", std::string(300, 'x'));
    const std::string page = " --page '" + sourceFolder() + "/web'";
    for (const std::string& db : {std::string("/nowhere/study.db"), letter}) {
        for (const std::string& command : {std::string("run") + page, std::string("replay --trial 1")}) {
            const Outcome outcome = runProgram("study " + command + " --db '" + db + "'");
            CHECK(outcome.code == 1);
            CHECK(outcome.errorLines() == 1);
        }
    }
    CHECK(slurp(letter) == std::string(300, 'x'));
    const std::string db = (workFolder() / "run.db").string();
    CHECK(runProgram("study run --db '" + db + "' --mouse touch" + page).code == 2);
    CHECK(runProgram("study run --db '" + db + "' --crowd 0" + page).code == 2);
    CHECK(runProgram("study replay --db '" + db + "' --trial 0").code == 2);
    CHECK(runProgram("study replay --db '" + db + "' --trial 1 --port 9000").code == 2);
    // A folder without a page is told before anything is served.
    const Outcome outcome = runProgram("study run --db '" + db + "' --page '" + workFolder().string() + "'");
    CHECK(outcome.code == 1);
    CHECK(outcome.error.find("index.html") != std::string::npos);
    const Outcome none = runProgram("study replay --db '" + db + "' --trial 7");
    CHECK(none.code == 1);
    CHECK(none.error.find("no trial 7") != std::string::npos);
}
