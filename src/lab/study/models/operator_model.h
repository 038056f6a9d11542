// An operator model: a stand-in that sees, plans, moves its hands and watches. It is never a person.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lab/study/models/hand_script.h"
#include "lab/study/models/planner.h"
#include "lab/study/models/scene_memory.h"

namespace muster {

/// A decision of a model and what it cost.
struct ModelDecision {
    std::uint32_t step = 0;  ///< Step in which the decision was made.
    /// Kind of the decision: "look", "plan", "cut", "select", "send", "draw", "sweep", "again".
    std::string kind;
    double seconds = 0.0;  ///< Time that decision and movement take [s].
    std::string text;      ///< Words that say what was decided.
};

/// Directs one trial through its inputs alone.
class OperatorModel {
public:
    /// `seed`: seed of its chance, the same for all schemes of one pair.
    OperatorModel(const Trial& trial, const OperatorParameters& parameters, std::uint64_t seed);
    ~OperatorModel();

    /// Looks, decides, moves. Call before every step of the trial.
    void direct(Trial& trial);

    std::span<const ModelDecision> decisions() const { return decisions_; }  ///< All decisions so far.
    /// Number of gestures without the effect that was meant.
    std::int32_t misses() const { return misses_; }
    double busySeconds() const { return busySeconds_; }  ///< Time spent on deciding and moving [s].
    std::int32_t commands() const { return commands_; }  ///< Number of orders that the model meant to give.

private:
    /// Belief of the model about a part that it directs.
    struct Charge {
        PlannedPart plan;
        std::vector<std::int32_t> meant;  ///< Items that it shall collect.
        std::size_t point = 0;            ///< Number of points of its way that were sent.
        double sentAt = -1.0;             ///< Time at which the last point was sent [s]; below 0 for never.
        std::uint8_t digit = 0;           ///< Its control group; 0 for none.
    };
    enum class Act : std::uint8_t { Cut, TakeOut, Send, Point, Call };
    struct Task {
        Act act = Act::Send;
        std::size_t index = 0;  ///< Index of the cut, the charge or the item.
    };

    void play(Trial& trial);
    void think(double now);
    void begin(double now, const SeenScene& scene);
    void watch(double now, const SeenScene& scene);
    void perform(double now, const Task& task);
    void cut(double now, const std::array<Vec2, 2>& line);
    void takeOut(double now, const Charge& charge);
    bool passes(const SeenScene& scene, Vec2 point) const;
    void call(double now, std::int32_t item);
    void send(double now, Charge& charge);
    bool isStop(const PlannedPart& plan, Vec2 point) const;
    void draw(double now, Charge& charge);
    void sweep(double now, Charge& charge);
    double tapTwice(double at, Vec2 where, double millimetres);
    void select(double& at, Charge& charge);
    void point(double& at, Charge& charge, bool add);
    void renew(double now, const SeenScene& scene);
    bool callsFor(std::span<const std::size_t> idles, std::span<const std::int32_t> left, double now);
    void dropPassed(const SeenScene& scene);
    std::vector<std::size_t> freeParts(const SeenScene& scene) const;
    bool active(std::size_t charge, std::span<const std::size_t> idles) const;
    std::vector<std::int32_t> unclaimed(std::span<const std::size_t> idles, const SeenScene& scene) const;
    std::vector<std::int32_t> takenOver(std::span<const std::size_t> idles, const SeenScene& scene);
    void renewPart(std::size_t index, std::span<const std::int32_t> items, double now);
    void adopt(Charge& charge, const SeenScene& scene);
    void adoptSelected(double now, Charge& charge);
    bool idle(const Charge& charge, const SeenScene& now) const;
    bool spent(const Charge& charge, const SeenScene& now) const;
    bool comesOver(const Charge& charge, const SeenPart& part, std::int32_t item) const;
    static bool aheadOfFront(const Charge& charge, const SeenPart& part, Vec2 at, Vec2 to, Vec2 item);
    bool due(const Charge& charge, const SeenScene& scene) const;
    SeenPart seen(const Charge& charge, double at) const;
    std::vector<std::int32_t> openItems(const SeenScene& scene) const;
    std::vector<std::int32_t> sweptBy(const PlannedPart& part, std::span<const std::int32_t> open) const;
    double noisy(double seconds) { return seconds * chance_.gamma(parameters_.noise); }
    double millimetres(Vec2 a, Vec2 b) const { return distance(a, b) * mmPerMetre_; }
    std::size_t freeHand() const;
    double reachHand(double now, Vec2 to, double width, std::size_t hand);
    double delay() const;
    const SeenScene& scene(double now) const { return memory_.at(now - delay()); }
    void note(const char* kind, double from, double to, std::string text);

    OperatorParameters parameters_;
    Chance chance_;
    Motor motor_;
    Repertoire repertoire_;
    SchemeDef scheme_;
    GroundView view_;
    double mmPerMetre_ = 1.0;
    SeenGround ground_;
    TourFinder tours_;
    std::unique_ptr<Planner> planner_;
    HandScript hand_;
    SceneMemory memory_;

    std::vector<Charge> charges_;
    std::vector<std::array<Vec2, 2>> cuts_;
    std::vector<Task> tasks_;            // Tasks, done from the back.
    std::vector<ScriptedInput> script_;  // Events in the order of time.
    std::size_t played_ = 0;
    bool begun_ = false;
    bool divided_ = false;                                 // Whether strokes have divided the crowd.
    double busyUntil_ = 0.0;                               // Time until which the model decides or moves [s].
    double nextPlan_ = 0.0;                                // Earliest time of the next plan [s].
    std::array<double, 2> handFree_{};                     // Time at which each hand can touch again [s].
    std::array<Vec2, 2> handAt_{};                         // Position of each hand [m].
    std::size_t selected_ = static_cast<std::size_t>(-1);  // Charge whose characters are selected.
    std::size_t checkSelection_ = static_cast<std::size_t>(-1);
    double checkAt_ = 0.0;
    std::uint32_t nextPointer_ = 1;
    std::uint32_t step_ = 0;
    std::vector<ModelDecision> decisions_;
    std::int32_t misses_ = 0;
    std::int32_t commands_ = 0;
    double busySeconds_ = 0.0;
};

}  // namespace muster
