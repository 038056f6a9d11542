#include "studio/study/runs/forms.h"

#include <cmath>
#include <string>

namespace muster {
namespace {

using enum QuestionKind;

Status bad(const StudyAnswer& answer, const std::string& why) {
    return invalidArgument("The answer to '" + answer.instrument + "' '" + answer.item + "' " + why + ".");
}

Status checkNumber(const StudyAnswer& answer, const Question& question) {
    if (!std::isfinite(answer.number) || answer.number < question.low || answer.number > question.high)
        return bad(answer, "is no number of its range");
    const double marks = (answer.number - question.low) / question.step;
    if (question.kind == Scale && marks != std::floor(marks)) return bad(answer, "is no mark of its scale");
    return {};
}

Status checkOne(const StudyAnswer& answer, const Question& question) {
    if (question.kind == Number || question.kind == Scale) return checkNumber(answer, question);
    if (question.kind == Text) {
        if (answer.text.size() > 2000) return bad(answer, "is longer than 2000 bytes");
        return {};
    }
    for (const std::string_view choice : question.choices)
        if (choice == answer.text) return {};
    return bad(answer, "is none of its choices");
}

const Question* find(const Form& form, std::string_view name) {
    for (const Question& question : form.questions)
        if (question.name == name) return &question;
    return nullptr;
}

}  // namespace

Status checkAnswer(const StudyAnswer& answer) {
    for (const Form& form : studyForms()) {
        if (form.instrument != answer.instrument) continue;
        if (form.perScheme == answer.scheme.empty())
            return bad(answer, form.perScheme ? "names no control" : "names a control, but is about none");
        const Question* question = find(form, answer.item);
        if (question == nullptr) return bad(answer, "is to no question that was asked");
        return checkOne(answer, *question);
    }
    return bad(answer, "is of no form of the study");
}

Status checkForm(const Form& form, std::span<const StudyAnswer> answers) {
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (answers[i].instrument != form.instrument) return bad(answers[i], "is of another form");
        if (answers[i].scheme != answers[0].scheme) return bad(answers[i], "is about another control");
        if (const Status status = checkAnswer(answers[i]); !status.ok()) return status;
        for (std::size_t j = 0; j < i; ++j)
            if (answers[j].item == answers[i].item) return bad(answers[i], "is given twice");
    }
    for (const Question& question : form.questions) {
        bool answered = !question.needed;
        for (const StudyAnswer& answer : answers) answered |= answer.item == question.name;
        if (!answered)
            return invalidArgument("The question '" + std::string(form.instrument) + "' '" +
                                   std::string(question.name) + "' is not answered.");
    }
    return {};
}

}  // namespace muster
