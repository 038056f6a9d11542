#include <doctest.h>

#include "run_program.h"
#include "test_folders.h"

using namespace muster::testing;
using muster::sourceFolder;

TEST_CASE("muster study tells bad input in one sentence") {
    const std::string letter = put("letter.db", std::string(300, 'x'));
    for (const std::string command : {"report", "export"}) {
        for (const std::string& db : {std::string("/nowhere/study.db"), letter}) {
            const Outcome outcome = runProgram("study " + command + " --db '" + db + "' -o '" +
                                               path("study") + "'");
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
    const std::string db = path("run.db");
    CHECK(runProgram("study run --db '" + db + "' --mouse touch" + page).code == 2);
    CHECK(runProgram("study run --db '" + db + "' --crowd 0" + page).code == 2);
    CHECK(runProgram("study replay --db '" + db + "' --trial 0").code == 2);
    CHECK(runProgram("study replay --db '" + db + "' --trial 1 --port 9000").code == 2);
    // A folder without a page is told before anything is served.
    const Outcome outcome = runProgram("study run --db '" + db + "' --page '" + workFolder().base.string() +
                                       "'");
    CHECK(outcome.code == 1);
    CHECK(outcome.error.find("index.html") != std::string::npos);
    const Outcome none = runProgram("study replay --db '" + db + "' --trial 7");
    CHECK(none.code == 1);
    CHECK(none.error.find("no trial 7") != std::string::npos);
}

TEST_CASE(
    "muster study models keeps trials, goes on, and gives the same report however it was cut into shards") {
    const std::string series = " --environments single-block --schemes touch,mouse-full-free --threads 2";
    const std::string whole = path("models_whole.db");
    const std::string parts = path("models_parts.db");
    CHECK(runProgram("study models --seeds 1" + series + " --db '" + whole + "'").code == 0);
    const Outcome again = runProgram("study models --seeds 1" + series + " --db '" + whole + "'");
    CHECK(again.code == 0);
    CHECK(again.error.find("2 of 2 trials") != std::string::npos);
    for (const std::string& shard : {std::string("0/2"), std::string("1/2")})
        CHECK(runProgram("study models --seeds 1" + series + " --shard " + shard + " --db '" + parts +
                         shard.substr(0, 1) + "'")
                  .code == 0);
    CHECK(runProgram("study models --merge '" + parts + "1' --merge '" + parts + "0' --db '" + parts + "'")
              .code == 0);
    for (const std::string& db : {whole, parts})
        CHECK(runProgram("study report --db '" + db + "' -o '" + db + ".report'").code == 0);
    CHECK(slurp(whole + ".report/report.html") == slurp(parts + ".report/report.html"));
    CHECK(slurp(whole + ".report/results.json") == slurp(parts + ".report/results.json"));
    CHECK(slurp(whole + ".report/results.json").find("\"models\"") != std::string::npos);
}

TEST_CASE("muster study models writes a job file, and refuses what cannot be") {
    const std::string job = path("job.sh");
    const Outcome written = runProgram(
        "study models --seeds 3 --settings equal-motor --shard 0/8 --db study.db --slurm '" + job + "'");
    CHECK(written.code == 0);
    const std::string text = slurp(job);
    CHECK(text.find("#SBATCH --array=0-7") != std::string::npos);
    CHECK(text.find("--settings 'equal-motor'") != std::string::npos);
    CHECK(text.find("--shard \"$SLURM_ARRAY_TASK_ID/8\"") != std::string::npos);
    for (const std::string& wrong :
         {std::string("--environments nowhere"), std::string("--schemes telepathy"),
          std::string("--shard 3/2"), std::string("--shard half"), std::string("--settings hasty")}) {
        const Outcome outcome = runProgram("study models " + wrong + " --db '" + path("none.db") + "'");
        INFO(wrong);
        CHECK(outcome.code == 1);
        CHECK(outcome.errorLines() == 1);
    }
    CHECK(runProgram("study models").code == 1);
}
