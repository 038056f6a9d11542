#include <doctest.h>

#include "program.h"

using namespace muster::testing;

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
