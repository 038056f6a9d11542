#include "studio/study/host/trial_screen.h"

#include "studio/gestures/control_scheme.h"

namespace muster {

void describeTrial(const TrialDef& def, protocol::StudyState& state) {
    if (const auto environment = studyEnvironment(def.environment); environment.ok()) {
        state.environment = environment.value().title;
        state.environmentText = environment.value().description;
    }
    if (const auto scheme = namedScheme(def.scheme); scheme.ok()) {
        state.scheme = scheme.value().name;
        state.schemeTitle = scheme.value().title;
        state.schemeText = scheme.value().description;
        state.touch = scheme.value().def.kind == SchemeKind::Touch;
        state.mesh = holdsMesh(scheme.value().def.kind);
    }
    state.items = static_cast<std::uint32_t>(studyRules().items);
    state.limit = studyRules().limit;
}

protocol::TrialEnd endOf(const StudyTrial& trial) {
    if (trial.id == 0) return protocol::TrialEnd::None;
    if (trial.practice) return protocol::TrialEnd::Practised;
    if (trial.result.done) return protocol::TrialEnd::Done;
    return trial.state == RunState::BrokenOff ? protocol::TrialEnd::GivenUp : protocol::TrialEnd::TimeOver;
}

protocol::StudyForm formOf(const Form& form, const std::string& scheme) {
    protocol::StudyForm message;
    message.instrument = form.instrument;
    message.title = form.title;
    message.text = form.text;
    message.source = form.source;
    if (const auto found = namedScheme(scheme); found.ok()) message.schemeTitle = found.value().title;
    for (const Question& question : form.questions) {
        protocol::QuestionFrame frame;
        frame.name = question.name;
        frame.text = question.text;
        frame.kind = static_cast<protocol::QuestionKind>(question.kind);
        frame.low = question.low;
        frame.high = question.high;
        frame.step = question.step;
        frame.lowLabel = question.lowLabel;
        frame.highLabel = question.highLabel;
        for (const std::string_view choice : question.choices) frame.choices.push_back({std::string(choice)});
        frame.needed = question.needed;
        message.questions.push_back(std::move(frame));
    }
    return message;
}

std::vector<StudyAnswer> answersOf(const protocol::AnswerForm& message, const std::string& scheme) {
    std::vector<StudyAnswer> answers;
    for (const protocol::AnswerFrame& frame : message.answers) {
        StudyAnswer answer;
        answer.scheme = scheme;
        answer.instrument = message.instrument;
        answer.item = frame.name;
        answer.text = frame.text;
        answer.number = frame.number;
        answers.push_back(std::move(answer));
    }
    return answers;
}

}  // namespace muster
