// What a person is asked: consent, questions before, questionnaires, preference.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "muster/status.h"
#include "studio/study/store/records.h"

namespace muster {

/// How a question is answered.
enum class QuestionKind : std::uint8_t {
    Number,  ///< A number from `low` to `high`.
    Scale,   ///< One of the marks from `low` to `high` by `step`, between two poles.
    Choice,  ///< One of `choices`.
    Text,    ///< Free text of at most 2,000 bytes.
};

/// One question.
struct Question {
    std::string_view name;                    ///< As it is stored: "sus-1".
    std::string_view text;                    ///< As it is asked.
    QuestionKind kind = QuestionKind::Scale;  ///< How it is answered.
    double low = 1.0;                         ///< Least answer.
    double high = 5.0;                        ///< Greatest answer.
    double step = 1.0;                        ///< Between the marks of a scale.
    std::string_view lowLabel;                ///< The pole at `low`.
    std::string_view highLabel;               ///< The pole at `high`.
    std::vector<std::string_view> choices;    ///< Of a choice.
    bool needed = true;                       ///< False: it may be left out.
};

/// Questions that are asked together.
struct Form {
    std::string_view instrument;      ///< As it is stored: "sus".
    std::string_view title;           ///< For display.
    std::string_view text;            ///< What stands above the questions.
    std::string_view source;          ///< Where verbatim items come from; empty for our own wording.
    bool perScheme = false;           ///< It is asked once for each control.
    std::vector<Question> questions;  ///< In their order.
};

/// All forms, in the order in which they come: consent, questions before, those of each control, preference.
std::span<const Form> studyForms();
/// Checks one answer of its instrument. Fails with InvalidArgument, naming the question.
Status checkAnswer(const StudyAnswer& answer);
/// Checks the answers to one form: each question is answered at most once, and all that are needed are.
Status checkForm(const Form& form, std::span<const StudyAnswer> answers);

}  // namespace muster
