// The table for a terminal, and the results as JSON.
#include <algorithm>
#include <cmath>

#include "files/report/markup.h"
#include "json/json.h"
#include "lab/verify/report/words.h"

namespace muster {
namespace {

struct TextColumn {
    const char* title;
    std::size_t width;
};
constexpr TextColumn kTextColumns[] = {{"Test", 16},  {"", 8},          {"Seeds", 6},
                                       {"Title", 26}, {"Expected", 44}, {"Measured", 60}};

std::string filled(const std::string& text, std::size_t width) {
    const std::size_t length = letters(text);
    return text + std::string(length < width ? width - length : 0, ' ');
}

/// One row of the table, its cells broken into lines.
std::string tableRow(const std::vector<std::string>& cells) {
    std::vector<std::vector<std::string>> lines;
    std::size_t most = 1;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        lines.push_back(wrapped(cells[k], kTextColumns[k].width - 1));
        most = std::max(most, lines.back().size());
    }
    std::string text;
    for (std::size_t i = 0; i < most; ++i) {
        std::string line;
        for (std::size_t k = 0; k < cells.size(); ++k)
            line += filled(i < lines[k].size() ? lines[k][i] : "", kTextColumns[k].width);
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string countsText(const Verification& verification) {
    return std::to_string(verification.count(Outcome::Pass)) + " pass, " +
           std::to_string(verification.count(Outcome::Fail)) + " fail, " +
           std::to_string(verification.count(Outcome::Missing)) + " missing";
}

Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace

std::string verificationText(const Verification& verification) {
    std::vector<std::string> titles;
    std::size_t width = 0;
    for (const TextColumn& column : kTextColumns) titles.push_back(column.title), width += column.width;
    std::string text = tableRow(titles) + std::string(width - 1, '-') + "\n";
    std::string suite = verification.rows.empty() ? "" : verification.rows.front().row.suite;
    for (const RowResult& row : verification.rows) {
        if (row.row.suite != suite) text += "\n";
        suite = row.row.suite;
        const std::string outcome = row.outcome == Outcome::Fail ? "FAIL" : outcomeName(row.outcome);
        text += tableRow({row.row.id, outcome, row.seeds > 0 ? std::to_string(row.seeds) : "-", row.row.title,
                          row.row.expected, decisiveText(row)});
    }
    if (!verification.others.empty()) text += "\n" + verification.others;
    text += "\n[own]: a tolerance that is no standard's. Missing tests count as not passed.\n";
    return text + countsText(verification) + "; " + fixedNumber(verification.seconds, 0) + " s\n";
}

std::string verificationJson(const Verification& verification) {
    Json rows = Json::array();
    for (const RowResult& row : verification.rows) {
        Json checks = Json::array();
        for (const VerifyCheck& check : row.report.checks)
            checks.push({{"what", check.what},
                         {"value", finite(check.value)},
                         {"low", finite(check.low)},
                         {"high", finite(check.high)},
                         {"unit", check.unit},
                         {"whose", check.binding ? whoseName(check.whose) : "shown"},
                         {"binding", check.binding},
                         {"pass", !check.binding || check.pass()}});
        rows.push({{"id", row.row.id},
                   {"suite", row.row.suite},
                   {"title", row.row.title},
                   {"source", row.row.source},
                   {"setup", row.row.setup},
                   {"expected", row.row.expected},
                   {"outcome", outcomeName(row.outcome)},
                   {"missing", row.row.missing},
                   {"seeds", row.seeds},
                   {"checks", checks},
                   {"notes", Json::arrayOf(row.report.notes)}});
    }
    const Json all = {{"version", verification.version},
                      {"when", verification.when},
                      {"seconds", verification.seconds},
                      {"pass", verification.count(Outcome::Pass)},
                      {"fail", verification.count(Outcome::Fail)},
                      {"missing", verification.count(Outcome::Missing)},
                      {"rows", rows}};
    return indentedJson(all, 2) + "\n";
}

std::string verificationMarkdown(const Verification& verification) {
    std::string text = "| Test | Expected | Measured | Seeds | Result |\n| --- | --- | --- | ---: | --- |\n";
    for (const RowResult& row : verification.rows) {
        const std::string outcome = row.outcome == Outcome::Fail ? "**fail**" : outcomeName(row.outcome);
        text += "| " + markdownCell(row.row.id + " " + row.row.title) + " | " +
                markdownCell(row.row.expected) + " | " + markdownCell(decisiveText(row)) + " | " +
                (row.seeds > 0 ? std::to_string(row.seeds) : "") + " | " + outcome + " |\n";
    }
    return text;
}

}  // namespace muster
