// What the study keeps: runs, trials, decisions of models, answers of people.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "studio/study/trial/trial.h"

namespace muster {

/// Who directs in a run. They are never mixed.
enum class RunKind : std::uint8_t {
    Models,  ///< Operator models.
    People,  ///< A person.
    Test,    ///< An automatic test of the page: it never counts as a person.
};

/// How far a run or a trial has got.
enum class RunState : std::uint8_t {
    Running,    ///< It goes on, or was cut off without a word.
    Complete,   ///< It has ended as it should.
    BrokenOff,  ///< It was ended early; what there is is kept.
};

/// One person's visit, or one study of operator models.
struct StudyRun {
    std::int64_t id = 0;                 ///< Given by the store.
    RunKind kind = RunKind::Models;      ///< Who directs.
    RunState state = RunState::Running;  ///< How far it has got.
    std::string started;                 ///< UTC, "2026-11-24T06:00:00Z"; empty for models.
    std::string version;                 ///< Of Muster.
    std::int32_t environments = 0;       ///< Version of the environments.
    std::int32_t operators = 0;          ///< Version of the operators' parameters; 0 for people.
    std::int32_t order = 0;              ///< Row of the balanced Latin square; 0 for models.
    std::string note;                    ///< Anything else.
};

/// One trial, of a person or a model.
struct StudyTrial {
    std::int64_t id = 0;   ///< Given by the store.
    std::int64_t run = 0;  ///< Its run.
    TrialDef def;          ///< Environment, crowd, scheme, seed, mirrored.
    /// Settings of the operator: "default", "equal-motor", "draw 17", "touch.drag=0.84"; empty for people.
    std::string setting;
    bool practice = false;               ///< It does not count.
    std::int32_t period = 0;             ///< For people: the block of its control, from 1.
    std::int32_t position = 0;           ///< For people: its number within the block, from 1.
    RunState state = RunState::Running;  ///< How far it has got; Complete also where it was censored.
    TrialResult result;                  ///< How it went; `done` is false where it was censored.
    std::int32_t misses = 0;             ///< For models: gestures that did not what was meant.
    double operatorSeconds = 0.0;        ///< For models: time in which the operator decided or moved [s].
};

/// A decision of an operator model.
struct StudyDecision {
    std::uint32_t step = 0;  ///< When it was made.
    std::string kind;        ///< "plan", "look", "select", "send", "draw", "spread", "tear"...
    double seconds = 0.0;    ///< What it cost the operator [s].
    std::string text;        ///< What was decided, and by which estimate.
};

/// One answer of a person.
struct StudyAnswer {
    std::string scheme;      ///< Control scheme that it is about; empty for none.
    std::string instrument;  ///< "consent", "before", "paper", "sus", "tlx", "ueq-s", "borg", "preference".
    std::string item;        ///< "age", "sus-1"...
    std::string text;        ///< As given.
    double number = 0.0;     ///< As a number, where it is one; else NaN.
};

}  // namespace muster
