// The report's style sheet: the studio's colours and letters, for screens, phones, dark surroundings and A4.
#include "files/report/chart_parts.h"
#include "files/report/markup.h"

namespace muster {
namespace {

constexpr const char* kLight =
    "--ground:#FFFFFF;--panel:#F7F5F1;--ink:#171B20;--ink2:#545C66;--line:#DDD8CF;--edge:#777166;--pass:#"
    "016553;--fail:"
    "#C3123A;"
    "--link:#1D5FD1;";
constexpr const char* kDark =
    "--ground:#171B20;--panel:#1F2429;--ink:#EEF1F4;--ink2:#B1B9C2;--line:#39414A;--edge:#6C7884;--pass:#"
    "90FBC9;--fail:"
    "#FF5C77;"
    "--link:#74A9FF;";

constexpr const char* kRules = R"css(
*{box-sizing:border-box}
html{color-scheme:light dark;-webkit-text-size-adjust:100%;scroll-padding-top:16px}
body{margin:0;background:var(--ground);color:var(--ink);font:400 15px/1.5 Inter,"Helvetica Neue",Helvetica,Arial,sans-serif;font-variant-numeric:tabular-nums}
main{max-width:1180px;margin:0 auto;padding:40px 24px 80px}
h1{font-size:30px;line-height:1.2;font-weight:650;letter-spacing:-.01em;margin:0 0 8px;text-wrap:balance}
h2{font-size:22px;line-height:1.25;font-weight:600;margin:0 0 8px;text-wrap:balance}
h3{font-size:15px;line-height:20px;font-weight:600;margin:28px 0 8px;break-after:avoid}
h4{font-size:14px;line-height:20px;font-weight:550;margin:16px 0 8px;break-after:avoid}
h4 small,th small{color:var(--ink2);font-weight:450}
p{margin:0 0 8px}
small{font-size:13px}
a{color:var(--link);text-decoration-thickness:1px;text-underline-offset:2px}
a:focus-visible{outline:2px solid var(--ink);outline-offset:2px}
code,pre{font:13px/1.5 ui-monospace,SFMono-Regular,Menlo,Consolas,"DejaVu Sans Mono",monospace}
pre{margin:0 0 12px;padding:8px 12px;background:var(--panel);border:1px solid var(--line);border-radius:8px;white-space:pre-wrap;overflow-wrap:anywhere}
.words{max-width:72ch}
.pair{display:grid;grid-template-columns:1fr 1fr;gap:0 48px}
.pair>div{max-width:72ch}
.lede,.help,.unit,.none{color:var(--ink2)}
.lede{max-width:76ch}
.help{font-size:13px;line-height:18px;max-width:80ch}
.unit{font-weight:400}
.pass{color:var(--pass)}
.fail,.missing,.caution{color:var(--fail)}
.caution{font-weight:550}
.headline{font-size:20px;line-height:28px;margin:24px 0 8px}
.headline b{font-size:30px;font-weight:650}
.verdict{font-weight:550}
.failures{margin:0 0 16px;padding-left:20px}
.facts{display:flex;flex-wrap:wrap;gap:12px 32px;margin:20px 0 16px}
.facts dt{font-size:12px;line-height:16px;font-weight:500;color:var(--ink2)}
.facts dd{margin:0;font-weight:550;overflow-wrap:anywhere}
.contents{list-style:none;margin:24px 0 40px;padding:0;display:grid;grid-template-columns:repeat(auto-fill,minmax(min(270px,100%),1fr));gap:8px}
.contents a{display:flex;gap:10px;align-items:baseline;min-height:44px;height:100%;padding:10px 14px;border:1px solid var(--line);border-radius:12px;background:var(--panel);color:var(--ink);text-decoration:none}
.contents a:hover{border-color:var(--edge)}
.contents b{min-width:2.1em}
.contents span{flex:1}
.contents em{font-style:normal;font-weight:550;font-size:13px;white-space:nowrap}
#summary,.how{margin-bottom:40px}
.chapter{border-top:1px solid var(--edge);margin-top:56px;padding-top:28px}
.chapter h2 .id{color:var(--ink2);font-weight:500;margin-right:4px}
table{border-collapse:collapse;width:100%;font-size:14px;line-height:20px;margin:0 0 8px}
th,td{text-align:left;vertical-align:top;padding:7px 16px 7px 0;border-bottom:1px solid var(--line)}
thead th{font-size:12px;line-height:16px;font-weight:550;color:var(--ink2);vertical-align:bottom;border-bottom-color:var(--edge)}
thead th small{font-size:12px}
tbody th{font-weight:450}
th:last-child,td:last-child{padding-right:0}
td small{color:var(--ink2);white-space:nowrap}
td small.missing{color:var(--fail);white-space:normal}
td b{font-weight:600}
.summary td.number b,.summary .sign,.criteria .sign{white-space:nowrap}
.summary td.name{min-width:7em}
.summary td.name small{display:block;white-space:normal}
.summary td.number small{display:block}
.summary tr:not(.first) td.name>*{visibility:hidden}
.summary tr:not(.first) td.name{line-height:0;font-size:0}
.summary tr.aside td{color:var(--ink2)}
.summary tr.aside td b{font-weight:450}
.criteria td.words{width:34%}
.criteria td:nth-child(2){width:19%}
.criteria td small{display:block;white-space:normal}
.sign{font-weight:600}
.sign.fail{border:1.5px solid;border-radius:6px;padding:0 5px;margin-left:-6px}
.sign.aside{font-weight:450}
.criteria .sign.fail{margin-left:0}
.figures{width:auto;min-width:min(100%,560px)}
.figures th:first-child{min-width:11em}
.figures .number{min-width:7.5em}
.figures td small{display:block}
.hashes{width:auto}
.hashes td,.hashes th{padding-right:28px}
.scroll{overflow-x:auto;margin:0 0 8px}
figure{margin:0;break-inside:avoid}
.films.n1,.films.n2{display:grid;gap:0 16px;grid-template-columns:repeat(auto-fill,minmax(min(270px,100%),1fr))}
.films.n2{grid-template-columns:repeat(auto-fill,minmax(min(540px,100%),1fr))}
.frames{display:grid;gap:16px;margin:0 0 8px}
.frames.c1{grid-template-columns:minmax(0,440px)}
.frames.c2{grid-template-columns:repeat(2,minmax(0,440px))}
.frames.c3{grid-template-columns:repeat(3,minmax(0,440px))}
.frames.c4{grid-template-columns:repeat(4,minmax(0,1fr))}
.frames svg{display:block;width:100%;height:auto;border-radius:6px}
figcaption{font-size:13px;line-height:18px;margin-top:6px}
.plot figcaption{font-size:14px;line-height:20px;font-weight:550;margin:0 0 8px}
.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(320px,100%),1fr));gap:28px 36px;margin:16px 0}
.charts{grid-template-columns:repeat(auto-fill,minmax(min(420px,100%),1fr))}
.chart{display:block;width:100%;max-width:520px;height:auto;overflow:visible;fill:var(--ink)}
.chart text{fill:var(--ink)}
.chart .note{fill:var(--ink2)}
.chart .grid{stroke:var(--line)}
.chart .axis{stroke:var(--ink2)}
.chart .median{stroke:var(--ink)}
.chart .hollow{fill:var(--ground)}
)css";

constexpr const char* kNarrow = R"css(
@media (max-width:900px){
.pair{grid-template-columns:1fr}
.frames.c3,.frames.c4{grid-template-columns:repeat(2,minmax(0,1fr))}
}
@media screen and (max-width:640px){
main{padding:24px 16px 56px}
h1{font-size:25px}
.frames,.frames.c1,.frames.c2,.frames.c3,.frames.c4{display:flex;gap:12px;overflow-x:auto;scroll-snap-type:x proximity;margin:0 -16px 8px;padding:0 16px 6px}
.frames figure{flex:0 0 82%;scroll-snap-align:center}
.frames figure:only-child{flex-basis:100%}
.stack,.stack tbody,.stack tr,.stack td{display:block;width:auto}
.stack thead{display:none}
.stack tr{border-bottom:1px solid var(--edge);padding:10px 0}
.stack td,.criteria td.words,.criteria td:nth-child(2){border:0;padding:2px 0;display:grid;grid-template-columns:6.5em 1fr;column-gap:12px;width:auto}
.stack td::before{content:attr(data-label);color:var(--ink2);font-size:12px;line-height:20px;font-weight:500}
.stack td>*{justify-self:start}
.stack td>*{grid-column:2}
.summary tr:not(.first) td.name{display:none}
.stack td small{white-space:normal}
.sign.fail{margin-left:0}
.hashes td,.hashes th{padding-right:12px}
.hashes code{font-size:11px;overflow-wrap:anywhere}
}
)css";

constexpr const char* kPrint = R"css(
@page{size:A4;margin:14mm 14mm 16mm}
@media print{
html{color-scheme:light}
body{font-size:9.5pt;line-height:1.4;print-color-adjust:exact;-webkit-print-color-adjust:exact}
main{max-width:none;padding:0}
h1{font-size:20pt}
h2{font-size:15pt}
h3{font-size:10.5pt;margin:14pt 0 4pt}
h4{font-size:9.5pt;margin:8pt 0 4pt}
a{color:inherit;text-decoration:none}
small,.help,figcaption{font-size:8pt;line-height:1.35}
.contents{grid-template-columns:repeat(3,1fr);margin:12pt 0}
.contents a{min-height:0;padding:4pt 6pt;background:none}
table{font-size:8.5pt;line-height:1.35}
thead{display:table-header-group}
thead th,thead th small{font-size:7.5pt}
tr{break-inside:avoid}
th,td{padding:3pt 8pt 3pt 0}
.figures th:first-child{min-width:0}
.figures .number{min-width:0}
.scroll{overflow:visible}
h2,.help,.headline,.verdict{break-after:avoid}
.criteria,.figures,.hashes{break-inside:avoid}
.films.n1,.films.n2{display:block}
.chapter{break-before:page;border:0;margin:0;padding:0}
.words{max-width:none}
.frames,.frames.c1,.frames.c2,.frames.c3,.frames.c4{gap:8pt}
.frames.c1,.frames.c2,.frames.c3,.frames.c4{grid-template-columns:repeat(3,minmax(0,1fr))}
.plots{grid-template-columns:repeat(2,1fr);gap:12pt 18pt}
.plot figcaption{font-size:9pt}
.chart{max-width:none}
pre{padding:3pt 6pt;margin-bottom:6pt}
.again{break-inside:avoid}
}
)css";

}  // namespace

std::string pageStyle() {
    const std::string light = std::string(":root{") + kLight + seriesVariables(false) + "}\n";
    const std::string dark = std::string(":root{") + kDark + seriesVariables(true) + "}\n";
    return light + "@media screen and (prefers-color-scheme:dark){\n" + dark + "}\n" + kRules +
           seriesRules() + kNarrow + kPrint;
}

}  // namespace muster
