// Ten sentences that were written after the grammar: six came to pass at first, the others after corrections
// (docs/method/words.md).
#pragma once

#include "studio/session/words_stage.h"

namespace muster::testing {

using SentenceJudge = bool (*)(WordsStage&);
struct Sentence {
    const char* text;
    double seconds;  ///< Until it is judged.
    SentenceJudge good;
};

// clang-format off
inline const Sentence kUnseenSentences[] = {
    {"take 15 people from the red guard and put them around the town hall", 40, [](WordsStage& s) {
        return s.near("Red guard", {-22, 17}, 10) == 15 && s.stayed("Red guard") == 5; }},
    {"North, march to the south edge in a column", 50, [](WordsStage& s) {
        return s.middle("North").y < -15 && s.group("North").formation == FormationKind::Column; }},
    {"everyone line up facing the fountain", 20, [](WordsStage& s) {
        return s.group("North").formation == FormationKind::Line &&
               s.group("South").formation == FormationKind::Line &&
               s.turned("South", arcTangent2(15, 14)) < 0.15; }},
    {"the red guard should surround South", 30, [](WordsStage& s) {
        return s.near("Red guard", {0, -15}, 10) == 20 && s.stayed("South") == 24; }},
    {"a quarter of North goes 8 m west and forms a wedge", 20, [](WordsStage& s) {
        return s.stayed("North") == 30 && s.world().groupCount() == 4 && s.world().group(3).count == 10 &&
               s.world().group(3).formation == FormationKind::Wedge; }},
    {"South and the red guard join North", 2, [](WordsStage& s) {
        return s.world().groupCount() == 1 && s.group("North").count == 84; }},
    {"evacuate everybody", 80, [](WordsStage& s) {
        return s.left("North") + s.left("South") + s.left("Red guard") == 0; }},
    {"turn South around", 12, [](WordsStage& s) {
        return s.turned("South", -kPi / 2) < 0.1 && distance(s.middle("South"), {0, -15}) < 2; }},
    {"North, walk in front of the town hall and wait there", 40, [](WordsStage& s) {
        return distance(s.middle("North"), {-22, 17}) < 14 && s.stayed("South") == 24; }},
    {"bring 6 of the reds over to South, the remaining ones guard North", 30, [](WordsStage& s) {
        return s.near("Red guard", {0, -15}, 12) == 6 && s.near("Red guard", {0, 15}, 12) == 14; }},
};
// clang-format on

}  // namespace muster::testing
