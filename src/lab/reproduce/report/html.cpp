// The report's page.
#include "files/report/markup.h"
#include "lab/reproduce/report/html_parts.h"
#include "lab/reproduce/reproduce.h"

namespace muster {
namespace {

// The page makes no network request, whatever it contains.
constexpr const char* kHead =
    "<!doctype html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
    "charset=\"utf-8\"/>\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<meta name=\"color-scheme\" "
    "content=\"light dark\"/>\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
    "img-src "
    "data:\"/>\n"
    "<title>Muster: the paper’s experiments</title>\n<style>\n";

constexpr std::int32_t kSeedsAsked = 10;  // Least number of seeds of a reproduction without a caution.

std::string fact(const char* name, const std::string& value) {
    return value.empty() ? std::string()
                         : std::string("<div><dt>") + name + "</dt><dd>" + escaped(value) + "</dd></div>\n";
}

std::string wallTime(double seconds) {
    if (seconds < 120.0) return fixedNumber(seconds, seconds < 10.0 ? 1 : 0) + " s";
    return fixedNumber(seconds, 0) + " s (" + fixedNumber(seconds / 60.0, 1) + " min)";
}

std::string idsOf(const Reproduction& reproduction) {
    std::string ids;
    for (const ExperimentResult& experiment : reproduction.experiments)
        ids += (ids.empty() ? "" : ", ") + experiment.text.id;
    return ids;
}

/// Names of the binding criteria that fail, for the top of the page.
std::string failures(const Reproduction& reproduction) {
    std::string html;
    for (const ExperimentResult& experiment : reproduction.experiments) {
        for (const Verdict& verdict : experiment.verdicts) {
            if (verdict.pass || !verdict.binding) continue;
            html += "<li><a href=\"#" + anchorOf(experiment) + "\">" + escaped(experiment.text.id) + "</a> " +
                    escaped(verdict.criterion) + ": <b>" + escaped(verdictValueText(verdict)) +
                    "</b>, required " + escaped(requirementText(verdict)) + "</li>\n";
        }
    }
    return html.empty() ? html : "<ul class=\"failures\">\n" + html + "</ul>\n";
}

std::string head(const Reproduction& reproduction) {
    const CriteriaCount count = countCriteria(reproduction);
    const std::size_t failed = count.judged - count.passed;
    const bool whole = failed == 0;
    std::string html =
        "<header>\n<h1>The paper’s experiments, run again</h1>\n<p class=\"lede\">J. Henry, H. P. H. Shum "
        "and T. "
        "Komura, “Interactive Formation Control in Complex Environments”, IEEE Transactions on Visualization "
        "and "
        "Computer Graphics 20 (2), 2014, section 7, with Muster.</p>\n";
    html += std::string("<p class=\"headline ") + (whole ? "pass" : "fail") + "\"><b>" + shareText(count) +
            "</b> " + holdText(count);
    if (!whole) html += ", " + std::to_string(failed) + (failed == 1 ? " fails" : " fail");
    html += "</p>\n" + failures(reproduction);
    html += "<dl class=\"facts\">\n" + fact("Muster", reproduction.version) +
            fact("Run on", reproduction.when) + fact("Experiments", idsOf(reproduction)) +
            fact("Seeds of each arm", std::to_string(reproduction.seeds)) +
            fact("Wall time", wallTime(reproduction.seconds)) + "</dl>\n";
    if (reproduction.seeds < kSeedsAsked)
        html += "<p class=\"caution\">Fewer than " + std::to_string(kSeedsAsked) +
                " seeds: a trial, not a reproduction to be cited.</p>\n";
    return html + "</header>\n";
}

std::string contents(const Reproduction& reproduction) {
    std::string html = "<nav aria-label=\"Experiments\"><ul class=\"contents\">\n";
    for (const ExperimentResult& experiment : reproduction.experiments) {
        const CriteriaCount count = countCriteria(experiment);
        const bool whole = count.passed == count.judged;
        html += "<li><a href=\"#" + anchorOf(experiment) + "\"><b>" + escaped(experiment.text.id) +
                "</b> <span>" + escaped(experiment.text.title) + "</span> <em class=\"" +
                (whole ? "pass" : "fail") + "\">" + (whole ? "✓ " : "✗ ") + shareText(count) +
                "</em></a></li>\n";
    }
    return html + "</ul></nav>\n";
}

constexpr const char* kHowToRead =
    "<section class=\"words how\">\n<h2>How to read it</h2>\n"
    "<p>Each experiment runs its scene in one or several ways, its arms, and each arm once per seed. The "
    "seed moves "
    "where "
    "people stand at first and draws all that is left to chance; the same seed gives the same run on every "
    "machine. "
    "Times that an experiment "
    "measures on the clock are the exception.</p>\n"
    "<p>A criterion is judged on the median over the seeds, or on the worst of them where it says “in every "
    "seed”. "
    "A seed without a value makes it fail. Criteria of the preset <i>muster</i> decide; those of the preset "
    "<i>paper</i>, which plans as the paper describes, stand beside them for comparison. The threshold "
    "itself "
    "passes.</p>\n"
    "<p>The paper’s user study (section 7.5) needs people and is not run here.</p>\n</section>\n";

}  // namespace

std::string reportHtml(const Reproduction& reproduction) {
    std::string html = kHead + pageStyle() + "</style>\n</head>\n<body>\n<main>\n" + head(reproduction) +
                       contents(reproduction) + "<section id=\"summary\">\n<h2>All criteria</h2>\n" +
                       summaryTable(reproduction) + "</section>\n" + kHowToRead;
    for (const ExperimentResult& experiment : reproduction.experiments)
        html += chapter(experiment, reproduction.seeds);
    return html + "</main>\n</body>\n</html>\n";
}

}  // namespace muster
