// The page with all tests, their plots and pictures.
#include <algorithm>

#include "files/report/markup.h"
#include "lab/verify/report/words.h"

namespace muster {
namespace {

// The page makes no network request, whatever it contains.
constexpr const char* kPageHead =
    "<!doctype html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
    "charset=\"utf-8\"/>\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<meta name=\"color-scheme\" "
    "content=\"light dark\"/>\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
    "style-src "
    "'unsafe-inline'; img-src data:\"/>\n<title>Muster: standard tests of pedestrian "
    "dynamics</title>\n<style>\n";

std::string anchorFor(const RowResult& row) {
    std::string anchor;
    for (const char c : lowerCase(row.row.id))
        anchor += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '-';
    return anchor;
}

std::string signOf(Outcome outcome) {
    const char* words = outcome == Outcome::Pass   ? "✓ pass"
                        : outcome == Outcome::Fail ? "✗ fail"
                                                   : "– missing";
    const char* kind = outcome == Outcome::Pass ? "pass" : outcome == Outcome::Fail ? "fail" : "none";
    return std::string("<span class=\"sign ") + kind + "\">" + words + "</span>";
}

std::string factOf(const char* name, const std::string& value) {
    return value.empty() ? ""
                         : std::string("<div><dt>") + name + "</dt><dd>" + escaped(value) + "</dd></div>\n";
}

std::string pageTop(const Verification& verification) {
    const std::size_t pass = verification.count(Outcome::Pass), fail = verification.count(Outcome::Fail),
                      missing = verification.count(Outcome::Missing);
    return "<header>\n<h1>Standard tests of pedestrian dynamics</h1>\n<p class=\"lede\">RiMEA 4.1.1, IMO "
           "MSC.1/Circ.1238, NIST TN "
           "1822, ISO 20414 and comparisons with measured data, run with Muster’s preset <i>people</i>: one "
           "set of numbers for "
           "all.</p>\n<p class=\"headline " +
           std::string(fail == 0 ? "pass" : "fail") + "\"><b>" + std::to_string(pass) + " of " +
           std::to_string(verification.rows.size()) + "</b> pass, " + std::to_string(fail) + " fail, " +
           std::to_string(missing) + " are missing</p>\n<dl class=\"facts\">\n" +
           factOf("Muster", verification.version) + factOf("Run on", verification.when) +
           factOf("Wall time", fixedNumber(verification.seconds, 0) + " s") +
           "</dl>\n<p class=\"help\">[own] marks a tolerance that is no standard’s: ours, or that of a "
           "project whose tests are public. The "
           "standards were read through such projects, not in the original (RiMEA 3.0 excepted). Missing "
           "tests count as not "
           "passed.</p>\n</header>\n";
}

std::string pageTable(const Verification& verification) {
    std::string html =
        "<section id=\"summary\">\n<h2>All tests</h2>\n<table class=\"criteria "
        "stack\"><thead><tr><th>Test</th><th>Title</th>"
        "<th>Expected</th><th>Measured</th><th>Seeds</th><th>Result</th></tr></thead><tbody>\n";
    for (const RowResult& row : verification.rows)
        html += "<tr><td data-label=\"Test\"><a href=\"#" + anchorFor(row) + "\">" + escaped(row.row.id) +
                "</a></td><td data-label=\"Title\">" + escaped(row.row.title) +
                "</td><td data-label=\"Expected\">" + escaped(row.row.expected) +
                "</td><td data-label=\"Measured\">" + escaped(decisiveText(row)) +
                "</td><td data-label=\"Seeds\">" + (row.seeds > 0 ? std::to_string(row.seeds) : "–") +
                "</td><td data-label=\"Result\">" + signOf(row.outcome) + "</td></tr>\n";
    html += "</tbody></table>\n";
    if (!verification.others.empty())
        html += "<h2>Beside others</h2>\n<pre>" + escaped(verification.others) + "</pre>\n";
    return html + "</section>\n";
}

std::string checksTable(const RowResult& row) {
    std::string html =
        "<table "
        "class=\"stack\"><thead><tr><th>What</th><th>Measured</th><th>Required</th><th>Whose</th><th></th></"
        "tr></thead><tbody>\n";
    for (const VerifyCheck& check : row.report.checks)
        html += "<tr><td data-label=\"What\">" + escaped(check.what) +
                "</td><td data-label=\"Measured\"><b>" + escaped(valueText(check)) +
                "</b></td><td data-label=\"Required\">" +
                (check.binding ? escaped(limitsText(check)) : "<span class=\"none\">shown</span>") +
                "</td><td data-label=\"Whose\">" + (check.binding ? whoseName(check.whose) : "") +
                "</td><td>" + (check.binding ? signOf(check.pass() ? Outcome::Pass : Outcome::Fail) : "") +
                "</td></tr>\n";
    return html + "</tbody></table>\n";
}

/// Plots, and paths unless an earlier row, `same`, has shown the paths of the same runs.
std::string drawings(const RowResult& row, const RowResult* same) {
    std::string html;
    if (!row.report.plots.empty()) html += "<div class=\"plots charts\">\n";
    for (const VerifyPlot& plot : row.report.plots)
        html += "<figure class=\"plot\"><figcaption>" + escaped(plot.title) + "</figcaption>" +
                plotSvg(plot) + "</figure>\n";
    if (!row.report.plots.empty()) html += "</div>\n";
    if (row.pictures.empty()) return html;
    if (same != nullptr)
        return html + "<p class=\"words\">Paths: see <a href=\"#" + anchorFor(*same) + "\">" +
               escaped(same->row.id) + "</a>, which looks at the same runs.</p>\n";
    html += "<h3>Paths in the first seed</h3>\n<div class=\"frames c3\">\n";
    for (std::size_t k = 0; k < row.pictures.size(); ++k)
        html += "<figure>" +
                nestedPicture(row.pictures[k], " role=\"img\"", anchorFor(row) + std::to_string(k)) +
                "<figcaption>" + escaped(row.pictureTitles[k]) + "</figcaption></figure>\n";
    return html + "</div>\n";
}

/// The first row that looks at the same scene in the same variants, or in more; null for this one itself.
const RowResult* sameBefore(const Verification& verification, const RowResult& row) {
    for (const RowResult& other : verification.rows) {
        if (&other == &row) return nullptr;
        const bool all = std::all_of(
            row.row.variants.begin(), row.row.variants.end(), [&](const auto& variant) {
                return std::find(other.row.variants.begin(), other.row.variants.end(), variant) !=
                       other.row.variants.end();
            });
        if (other.row.scene == row.row.scene && all && !other.pictures.empty()) return &other;
    }
    return nullptr;
}

std::string chapterOf(const RowResult& row, const RowResult* same) {
    std::string html = "<section class=\"chapter\" id=\"" + anchorFor(row) + "\">\n<h2><span class=\"id\">" +
                       escaped(row.row.id) + "</span> " + escaped(row.row.title) + " " + signOf(row.outcome) +
                       "</h2>\n<p class=\"words\"><b>Expected:</b> " + escaped(row.row.expected) + ".</p>\n";
    if (!row.row.missing.empty())
        return html + "<p class=\"words\"><b>Missing:</b> " + escaped(row.row.missing) +
               ".</p>\n</section>\n";
    html += "<p class=\"words\"><b>Set-up:</b> " + escaped(row.row.setup) + "; " +
            counted(static_cast<std::size_t>(row.seeds), "seed", "seeds") + ".</p>\n<p class=\"help\">" +
            escaped(row.row.source) + "</p>\n" + checksTable(row);
    for (const std::string& note : row.report.notes) html += "<p class=\"words\">" + escaped(note) + "</p>\n";
    return html + drawings(row, same) + "</section>\n";
}

}  // namespace

std::string verificationPage(const Verification& verification) {
    std::string html = kPageHead + pageStyle() + "</style>\n</head>\n<body>\n<main>\n" +
                       pageTop(verification) + pageTable(verification);
    for (const RowResult& row : verification.rows) html += chapterOf(row, sameBefore(verification, row));
    return html + "</main>\n</body>\n</html>\n";
}

}  // namespace muster
