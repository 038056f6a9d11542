// Sentences as players, animators and teachers type them, each judged by what has become of the people.
#include "studio/session/unseen_sentences.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr Vec2 kFountain{14, 0}, kHall{-22, 17}, kPool{-16, -20};

// clang-format off
const Sentence kSentences[] = {
    // Players.
    {"red guard, go to the fountain", 25, [](WordsStage& s) {
        return s.near("Red guard", kFountain, 12) == 20 && s.stayed("North") == 40; }},
    {"all units hold", 3, [](WordsStage& s) {
        return s.group("North").held && s.group("South").held && s.group("Red guard").held; }},
    {"north follow south", 2, [](WordsStage& s) {
        const auto orders = s.group("North").orders;
        return orders.size() == 1 && orders[0].order.kind == OrderKind::Follow &&
               orders[0].order.group == s.group("South").id && s.group("South").orders.empty(); }},
    {"guard the fountain with the red guard", 30, [](WordsStage& s) {
        const auto orders = s.group("Red guard").orders;
        return orders.size() == 1 && orders[0].order.kind == OrderKind::Guard &&
               s.near("Red guard", kFountain, 6) == 20; }},
    {"red guard patrol between the fountain and the town hall", 2, [](WordsStage& s) {
        const GroupView guard = s.group("Red guard");
        return guard.patrols && guard.orders.size() == 2 &&
               distance(guard.orders[0].order.target, kFountain) < 14 &&
               distance(guard.orders[1].order.target, kHall) < 14; }},
    {"send the red ones to 5, -8", 25, [](WordsStage& s) {
        return distance(s.middle("Red guard"), {5, -8}) < 1 && s.stayed("South") == 24; }},
    {"south: wedge formation, face east", 10, [](WordsStage& s) {
        return s.group("South").formation == FormationKind::Wedge && s.turned("South", 0.0) < 0.1 &&
               distance(s.middle("South"), {0, -15}) < 3; }},
    {"move red guard back 10 m", 20, [](WordsStage& s) {
        return distance(s.middle("Red guard"), {-22, 0}) < 1; }},
    {"everybody except the red guard to the waiting room", 40, [](WordsStage& s) {
        return s.near("North", {21, 21}, 9) == 40 && s.near("South", {21, 21}, 9) == 24 &&
               s.stayed("Red guard") == 20; }},
    {"pause", 1, [](WordsStage& s) { return !s.session.playing(); }},
    // Animators.
    {"half of North to the fountain, in a ring, the rest hold", 30, [](WordsStage& s) {
        return s.near("North", kFountain, 8) == 20 && s.stayed("North") == 20 &&
               s.world().groupCount() == 4 && s.group("North").held &&
               s.world().group(3).formation == FormationKind::Ring; }},
    {"send 10 of South to the town hall and the others to the main exit", 70, [](WordsStage& s) {
        return s.left("South") == 10 && s.near("South", kHall, 13) == 10; }},
    {"North walks 12 metres east, then turns to face the fountain", 30, [](WordsStage& s) {
        return distance(s.middle("North"), {12, 15}) < 1.5 &&
               s.turned("North", arcTangent2(-15, 2)) < 0.15; }},
    {"form a circle around the fountain with everybody in South", 30, [](WordsStage& s) {
        return s.near("South", kFountain, 8) == 24 && distance(s.middle("South"), kFountain) < 1.5; }},
    {"spread North out to 2 m spacing", 15, [](WordsStage& s) {
        return s.spacing("North") > 1.7 && s.spacing("North") < 2.4; }},
    {"tighten up the red guard", 12, [](WordsStage& s) { return s.spacing("Red guard") < 0.85; }},
    {"make South a column", 15, [](WordsStage& s) {
        return s.group("South").formation == FormationKind::Column; }},
    {"split North into three", 2, [](WordsStage& s) {
        return s.world().groupCount() == 5 && s.group("North").count >= 13 && s.group("North").count <= 14; }},
    {"merge South into North", 2, [](WordsStage& s) {
        return s.world().groupCount() == 2 && s.group("North").count == 64 && !s.isThere("South"); }},
    {"South go to the pool by way of the red guard in a column", 45, [](WordsStage& s) {
        return distance(s.middle("South"), kPool) < 4 &&
               s.group("South").formation == FormationKind::Column; }},
    {"the 5 people nearest to the fountain go to the pool", 40, [](WordsStage& s) {
        return s.near("North", kPool, 5) + s.near("South", kPool, 5) + s.near("Red guard", kPool, 5) == 5; }},
    {"left half of North to the pool, right half to the fountain", 40, [](WordsStage& s) {
        return s.near("North", kPool, 8) == 20 && s.near("North", kFountain, 12) == 20; }},
    // Teachers.
    {"please have the south group wait in the waiting room", 40, [](WordsStage& s) {
        return s.near("South", {21, 21}, 9) == 24 && s.stayed("North") == 40; }},
    {"Could everybody come to the middle?", 25, [](WordsStage& s) {
        return distance(s.middle("North"), {0, 0}) < 10 && distance(s.middle("South"), {0, 0}) < 10 &&
               distance(s.middle("Red guard"), {0, 0}) < 10; }},
    {"a third of everybody leaves by the side exit", 60, [](WordsStage& s) {
        return s.left("North") == 27 && s.left("South") == 16 && s.left("Red guard") == 13; }},
    {"South, line up facing north", 15, [](WordsStage& s) {
        return s.group("South").formation == FormationKind::Line && s.turned("South", kPi / 2) < 0.1; }},
    {"North and South swap places", 40, [](WordsStage& s) {
        return distance(s.middle("North"), {0, -15}) < 3 && distance(s.middle("South"), {0, 15}) < 3; }},
    {"rename North to Choir", 1, [](WordsStage& s) {
        return s.isThere("Choir") && s.group("Choir").count == 40 && !s.isThere("North"); }},
    {"20% of south go left 5 metres, the rest stay where they are", 15, [](WordsStage& s) {
        return s.stayed("South") == 19 && s.middle("South").x < -0.5; }},
    {"North slowly to the fountain at 1 m/s", 8, [](WordsStage& s) {
        return s.middle("North").y > 6.5 && s.middle("North").y < 14.5; }},
};
// clang-format on

std::size_t rightOf(std::span<const Sentence> sentences) {
    std::size_t right = 0;
    for (const Sentence& sentence : sentences) {
        WordsStage stage;
        const protocol::Said said = stage.say(sentence.text);
        stage.settle(sentence.seconds);
        const bool good = said.problem.empty() && stage.client.noticed("rejected").empty() &&
                          sentence.good(stage);
        right += good ? 1u : 0u;
        WARN_MESSAGE(good, std::string(sentence.text)
                               << " -> " << said.problem << " " << stage.client.noticed("rejected"));
    }
    return right;
}

}  // namespace

TEST_CASE("sentences: what people type comes to pass") {
    CHECK(rightOf(kSentences) == std::size(kSentences));
}

TEST_CASE("sentences: those come to pass that were written after the grammar") {
    CHECK(rightOf(kUnseenSentences) == std::size(kUnseenSentences));
}
