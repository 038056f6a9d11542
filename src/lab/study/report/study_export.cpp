#include "lab/study/report/study_report.h"

#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "base/output_file.h"

namespace muster {
namespace {

/// A column: the words of its codebook, and the function that fills a row.
template <class Row>
struct Column {
    const char* name;
    const char* meaning;
    const char* unit;
    const char* values;
    std::string (*text)(const Row&);
};

struct InputRow {
    std::int64_t trial;
    std::size_t number;
    const StampedInput* input;
};
struct DecisionRow {
    std::int64_t trial;
    const StudyDecision* decision;
};
struct AnswerRow {
    std::int64_t run;
    const StudyAnswer* answer;
};

/// All digits that the number has; nothing for NaN.
std::string number(double value) {
    if (!std::isfinite(value)) return {};
    char text[40];
    std::snprintf(text, sizeof(text), "%.17g", value);
    char shorter[40];
    std::snprintf(shorter, sizeof(shorter), "%.15g", value);
    double back = 0.0;
    return std::sscanf(shorter, "%lf", &back) == 1 && back == value ? shorter : text;
}

template <class T>
std::string whole(T value) {
    return std::to_string(value);
}

std::string yes(bool value) {
    return value ? "1" : "0";
}

const PointerEvent* pointer(const InputRow& row) {
    return std::get_if<PointerEvent>(&row.input->event);
}

const KeyEvent* key(const InputRow& row) {
    return std::get_if<KeyEvent>(&row.input->event);
}

std::string modifiers(const InputRow& row) {
    const Modifiers held = pointer(row) != nullptr ? pointer(row)->modifiers
                           : key(row) != nullptr   ? key(row)->modifiers
                                                   : Modifiers{};
    return whole((held.shift ? 1 : 0) + (held.control ? 2 : 0) + (held.alt ? 4 : 0));
}

std::string eventKind(const InputRow& row) {
    static constexpr const char* kPhases[] = {"down", "move", "up", "cancel"};
    if (const PointerEvent* p = pointer(row)) return kPhases[static_cast<std::size_t>(p->phase)];
    return key(row) != nullptr ? "key" : "view";
}

std::string device(const InputRow& row) {
    static constexpr const char* kDevices[] = {"touch", "pen", "mouse"};
    return pointer(row) == nullptr ? "" : kDevices[static_cast<std::size_t>(pointer(row)->device)];
}

std::string button(const InputRow& row) {
    static constexpr const char* kButtons[] = {"left", "middle", "right"};
    return pointer(row) == nullptr ? "" : kButtons[static_cast<std::size_t>(pointer(row)->button)];
}

std::string hashText(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof(text), "%016" PRIx64, hash);
    return text;
}

constexpr Column<StudyRun> kRuns[] = {
    {"run", "Number of the run", "", "whole number", [](const StudyRun& r) { return whole(r.id); }},
    {"kind", "Who directs; models are no people, and tests count as neither", "", "models, people, test",
     [](const StudyRun& r) { return std::string(kindName(r.kind)); }},
    {"state", "How far it has got", "", "running, complete, broken-off",
     [](const StudyRun& r) { return std::string(stateName(r.state)); }},
    {"started", "When it began", "UTC", "ISO 8601; empty for models",
     [](const StudyRun& r) { return r.started; }},
    {"version", "Version of Muster", "", "text", [](const StudyRun& r) { return r.version; }},
    {"environments", "Version of the environments", "", "whole number",
     [](const StudyRun& r) { return whole(r.environments); }},
    {"operators", "Version of the operator models' parameters", "", "whole number; 0 for people",
     [](const StudyRun& r) { return whole(r.operators); }},
    {"order", "Row of the balanced Latin square", "", "whole number; 0 for models",
     [](const StudyRun& r) { return whole(r.order); }},
    {"note", "Anything else", "", "text", [](const StudyRun& r) { return r.note; }},
};

constexpr Column<StudyTrial> kTrials[] = {
    {"trial", "Number of the trial", "", "whole number", [](const StudyTrial& t) { return whole(t.id); }},
    {"run", "Its run", "", "whole number", [](const StudyTrial& t) { return whole(t.run); }},
    {"environment", "Name of the environment", "", "single-block, corridor, multiple-paths, four-blocks",
     [](const StudyTrial& t) { return t.def.environment; }},
    {"crowd", "Number of characters", "", "whole number",
     [](const StudyTrial& t) { return whole(t.def.crowd); }},
    {"scheme", "Control scheme", "", "as docs/method/study.md lists them",
     [](const StudyTrial& t) { return t.def.scheme; }},
    {"seed", "Places the items", "", "whole number", [](const StudyTrial& t) { return whole(t.def.seed); }},
    {"mirrored", "Top and bottom of the layout are swapped", "", "0, 1",
     [](const StudyTrial& t) { return yes(t.def.mirrored); }},
    {"setting", "Settings of the operator model", "", "text; empty for people",
     [](const StudyTrial& t) { return t.setting; }},
    {"practice", "It is practice and does not count", "", "0, 1",
     [](const StudyTrial& t) { return yes(t.practice); }},
    {"period", "Block of its control", "", "from 1; 0 for models",
     [](const StudyTrial& t) { return whole(t.period); }},
    {"position", "Its number within the block", "", "from 1; 0 for models",
     [](const StudyTrial& t) { return whole(t.position); }},
    {"state", "How far it has got", "", "running, complete, broken-off",
     [](const StudyTrial& t) { return std::string(stateName(t.state)); }},
    {"done", "All items were collected; complete and 0: censored at the limit", "", "0, 1",
     [](const StudyTrial& t) { return yes(t.result.done); }},
    {"steps", "Simulated steps", "", "whole number",
     [](const StudyTrial& t) { return whole(t.result.steps); }},
    {"seconds", "Time until all items were collected, or until the end", "s", "number",
     [](const StudyTrial& t) { return number(t.result.seconds); }},
    {"items", "Items in the environment", "", "whole number",
     [](const StudyTrial& t) { return whole(t.result.items); }},
    {"collected", "Items collected", "", "whole number",
     [](const StudyTrial& t) { return whole(t.result.collected); }},
    {"gestures", "Pointers that went down, and keys", "", "whole number",
     [](const StudyTrial& t) { return whole(t.result.gestures); }},
    {"commands", "Commands given, moves of fingers not counted", "", "whole number",
     [](const StudyTrial& t) { return whole(t.result.commands); }},
    {"idle_seconds", "Time in which fewer than a tenth of the characters moved", "s", "number",
     [](const StudyTrial& t) { return number(t.result.idleSeconds); }},
    {"hash", "Hash of the world at the end", "", "16 hexadecimal digits",
     [](const StudyTrial& t) { return hashText(t.result.hash); }},
    {"misses", "Gestures of a model that did not what was meant", "", "whole number; 0 for people",
     [](const StudyTrial& t) { return whole(t.misses); }},
    {"operator_seconds", "Time in which a model decided or moved", "s", "number; 0 for people",
     [](const StudyTrial& t) { return number(t.operatorSeconds); }},
};

constexpr Column<InputRow> kInputs[] = {
    {"trial", "Number of the trial", "", "whole number", [](const InputRow& r) { return whole(r.trial); }},
    {"number", "Number of the input within its trial", "", "from 0",
     [](const InputRow& r) { return whole(r.number); }},
    {"step", "Steps done when it came", "", "whole number",
     [](const InputRow& r) { return whole(r.input->step); }},
    {"event", "What came", "", "down, move, up, cancel, key, view", eventKind},
    {"device", "What points", "", "touch, pen, mouse; empty for keys and views", device},
    {"button", "Button of the mouse", "", "left, middle, right; empty for keys and views", button},
    {"pointer", "Number of the finger", "", "whole number; empty for keys and views",
     [](const InputRow& r) { return pointer(r) != nullptr ? whole(pointer(r)->pointer) : std::string(); }},
    {"x", "From the left of the view", "px", "number; empty for keys and views",
     [](const InputRow& r) { return pointer(r) != nullptr ? number(pointer(r)->screen.x) : std::string(); }},
    {"y", "From the top of the view", "px", "number; empty for keys and views",
     [](const InputRow& r) { return pointer(r) != nullptr ? number(pointer(r)->screen.y) : std::string(); }},
    {"key", "Code of the key", "", "whole number; empty but for keys",
     [](const InputRow& r) { return key(r) != nullptr ? whole(key(r)->key) : std::string(); }},
    {"modifiers", "Keys that are held: 1 shift, 2 control, 4 alt, added", "", "0 to 7", modifiers},
};

constexpr Column<DecisionRow> kDecisions[] = {
    {"trial", "Number of the trial", "", "whole number", [](const DecisionRow& r) { return whole(r.trial); }},
    {"step", "Steps done when it was made", "", "whole number",
     [](const DecisionRow& r) { return whole(r.decision->step); }},
    {"kind", "Kind of the decision", "", "text", [](const DecisionRow& r) { return r.decision->kind; }},
    {"seconds", "What it cost the operator model", "s", "number",
     [](const DecisionRow& r) { return number(r.decision->seconds); }},
    {"text", "What was decided", "", "text", [](const DecisionRow& r) { return r.decision->text; }},
};

constexpr Column<AnswerRow> kAnswers[] = {
    {"run", "Number of the run", "", "whole number", [](const AnswerRow& r) { return whole(r.run); }},
    {"scheme", "Control scheme that it is about", "", "text; empty for none",
     [](const AnswerRow& r) { return r.answer->scheme; }},
    {"instrument", "Questionnaire", "", "consent, before, paper, sus, tlx, ueq-s, borg, preference",
     [](const AnswerRow& r) { return r.answer->instrument; }},
    {"item", "Question", "", "text", [](const AnswerRow& r) { return r.answer->item; }},
    {"text", "Answer as given", "", "text", [](const AnswerRow& r) { return r.answer->text; }},
    {"number", "Answer as a number", "", "number; empty where it is none",
     [](const AnswerRow& r) { return number(r.answer->number); }},
};

std::string line(const std::vector<std::string>& fields) {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i) text += (i > 0 ? "," : "") + csvField(fields[i]);
    return text + "\r\n";
}

/// A file with its heading; rows are added.
template <class Row, std::size_t N>
class Table {
public:
    Table(std::string path, const Column<Row> (&columns)[N]) : path_(std::move(path)), columns_(columns) {}

    Status begin() {
        if (Status s = file_.open(path_); !s.ok()) return s;
        std::vector<std::string> names;
        for (const Column<Row>& column : columns_) names.emplace_back(column.name);
        return file_.write(line(names));
    }
    Status add(const Row& row) {
        std::vector<std::string> fields;
        for (const Column<Row>& column : columns_) fields.push_back(column.text(row));
        return file_.write(line(fields));
    }
    Status commit() { return file_.commit(); }

private:
    std::string path_;
    const Column<Row> (&columns_)[N];
    OutputFile file_;
};

struct Codebook {
    std::string csv = line({"file", "column", "meaning", "unit", "values"});
    std::string
        markdown = "# Codebook\n\nWhat the columns of the study's tables mean. Models are no people.\n";

    template <class Row, std::size_t N>
    void add(const std::string& file, const Column<Row> (&columns)[N]) {
        markdown += "\n## " + file + "\n\n| column | meaning | unit | values |\n| --- | --- | --- | --- |\n";
        for (const Column<Row>& column : columns) {
            csv += line({file, column.name, column.meaning, column.unit, column.values});
            markdown += "| `" + std::string(column.name) + "` | " + column.meaning + " | " + column.unit +
                        " | " + column.values + " |\n";
        }
    }
};

Status writeWhole(const std::string& path, const std::string& text) {
    OutputFile file;
    if (Status s = file.open(path); !s.ok()) return s;
    if (Status s = file.write(text); !s.ok()) return s;
    return file.commit();
}

Status writeCodebook(const std::string& folder) {
    Codebook book;
    book.add("runs.csv", kRuns);
    book.add("trials.csv", kTrials);
    book.add("inputs.csv", kInputs);
    book.add("decisions.csv", kDecisions);
    book.add("answers.csv", kAnswers);
    if (Status s = writeWhole(folder + "/codebook.csv", book.csv); !s.ok()) return s;
    return writeWhole(folder + "/codebook.md", book.markdown);
}

Status writeRuns(StudyStore& store, const std::string& folder) {
    const auto runs = store.runs();
    if (!runs.ok()) return runs.status();
    Table runTable(folder + "/runs.csv", kRuns);
    Table answerTable(folder + "/answers.csv", kAnswers);
    if (Status s = runTable.begin(); !s.ok()) return s;
    if (Status s = answerTable.begin(); !s.ok()) return s;
    for (const StudyRun& run : *runs) {
        if (Status s = runTable.add(run); !s.ok()) return s;
        const auto answers = store.answers(run.id);
        if (!answers.ok()) return answers.status();
        for (const StudyAnswer& answer : *answers)
            if (Status s = answerTable.add({run.id, &answer}); !s.ok()) return s;
    }
    if (Status s = runTable.commit(); !s.ok()) return s;
    return answerTable.commit();
}

template <class Inputs, class Decisions>
Status writeTrial(StudyStore& store, std::int64_t trial, Inputs& inputTable, Decisions& decisionTable) {
    const auto inputs = store.inputs(trial);
    if (!inputs.ok()) return inputs.status();
    for (std::size_t i = 0; i < inputs->size(); ++i)
        if (Status s = inputTable.add({trial, i, &(*inputs)[i]}); !s.ok()) return s;
    const auto decisions = store.decisions(trial);
    if (!decisions.ok()) return decisions.status();
    for (const StudyDecision& decision : *decisions)
        if (Status s = decisionTable.add({trial, &decision}); !s.ok()) return s;
    return {};
}

Status writeTrials(StudyStore& store, const std::string& folder) {
    const auto trials = store.trials();
    if (!trials.ok()) return trials.status();
    Table trialTable(folder + "/trials.csv", kTrials);
    Table inputTable(folder + "/inputs.csv", kInputs);
    Table decisionTable(folder + "/decisions.csv", kDecisions);
    if (Status s = trialTable.begin(); !s.ok()) return s;
    if (Status s = inputTable.begin(); !s.ok()) return s;
    if (Status s = decisionTable.begin(); !s.ok()) return s;
    for (const StudyTrial& trial : *trials) {
        if (Status s = trialTable.add(trial); !s.ok()) return s;
        if (Status s = writeTrial(store, trial.id, inputTable, decisionTable); !s.ok()) return s;
    }
    if (Status s = trialTable.commit(); !s.ok()) return s;
    if (Status s = inputTable.commit(); !s.ok()) return s;
    return decisionTable.commit();
}

}  // namespace

const char* kindName(RunKind kind) {
    return kind == RunKind::Models ? "models" : kind == RunKind::People ? "people" : "test";
}

const char* stateName(RunState state) {
    return state == RunState::Running ? "running" : state == RunState::Complete ? "complete" : "broken-off";
}

Status exportStudy(StudyStore& store, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder, error))
        return {StatusCode::IoError, "the folder '" + folder + "' cannot be made"};
    Status status;
    // One transaction, so that all tables are of one moment.
    const Status whole = store.batch([&] {
        status = writeRuns(store, folder);
        if (status.ok()) status = writeTrials(store, folder);
        return status;
    });
    if (!whole.ok()) return whole;
    return writeCodebook(folder);
}

}  // namespace muster
